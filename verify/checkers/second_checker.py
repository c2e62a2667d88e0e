"""A second checker of certificates, independent of `proofs.engine.kernel`: from the JSON alone, with FLINT's
polynomials.

It shares no code with the kernel, neither its arithmetic (fmpq_mpoly) nor its reading of the data.
"""

from flint import Ordering, fmpq, fmpq_mpoly_ctx


class Refused(Exception):
    """The certificate proves nothing; the message says why, with the difference where two sides differ."""


def _rational(text):
    top, _, bottom = text.partition("/")
    return fmpq(int(top), int(bottom or 1))


class Names:
    """All names of a statement as the variables of one FLINT ring, and which of them may be used yet."""

    def __init__(self, free, new):
        self.all = [*free, *new]
        if len(set(self.all)) != len(self.all):
            raise Refused(f"a name is introduced twice among {self.all}")
        self.ring = fmpq_mpoly_ctx.get([f"v{i}" for i in range(len(self.all))] or ["v0"], Ordering.degrevlex)
        self.value = {n: self.ring.gen(i) for i, n in enumerate(self.all)}
        self.open = set(free)

    def constant(self, text):
        return self.ring.constant(_rational(text))

    def __call__(self, data):
        total = self.ring.constant(0)
        for monomial, coefficient in data.items():
            term = self.constant(coefficient)
            for factor in monomial.split():
                name, sign, power = factor.partition("^")
                if name not in self.open:
                    raise Refused(f"{name} is used before it is introduced")
                exponent = int(power) if sign else 1
                if exponent < 1:
                    raise Refused(f"{factor} is not a power with a positive exponent")
                term *= self.value[name] ** exponent
            total += term
        return total


def _zero(p, what):
    if p != 0:
        raise Refused(f"{what}: the difference is {p}")


def _prove(names, facts, goal, proof):
    """facts: [(relation, polynomial)]; goal: (relation, polynomial)."""
    relation, p = goal
    match proof["rule"]:
        case "ideal":
            if relation != "=":
                raise Refused("an ideal proves equations only")
            _zero(p - _combination(names, facts, proof["cofactors"]), "ideal")
        case "contradiction":
            negated = {"=": ("!=", p), "!=": ("=", p), ">": (">=", -p), ">=": (">", -p)}[relation]
            facts = [*facts, negated]
            left = names.constant("1")
            for i in proof["positive"]:
                kind, q = facts[i]
                if kind not in (">", "!="):
                    raise Refused(f"fact {i} need not be positive")
                left *= q * q if kind == "!=" else q
            for coefficient, root, factors in proof["sum"]:
                if _rational(coefficient) < 0:
                    raise Refused("a negative weight")
                term = names.constant(coefficient) * names(root) ** 2
                for i in factors:
                    if facts[i][0] not in (">", ">="):
                        raise Refused(f"fact {i} may be negative")
                    term *= facts[i][1]
                left += term
            _zero(left - _combination(names, facts, proof["cofactors"]), "contradiction")
        case "cases":
            split = names(proof["on"])
            for branch, fact in (("<", (">", -split)), ("=", ("=", split)), (">", (">", split))):
                _prove(names, [*facts, fact], goal, proof["branches"][branch])
        case other:
            raise Refused(f"unknown rule {other}")


def _combination(names, facts, cofactors):
    total = names.constant("0")
    for i, q in cofactors:
        if facts[i][0] != "=":
            raise Refused(f"fact {i} is no equation")
        total += names(q) * facts[i][1]
    return total


def _steps(statement, prove):
    """Go through a derivation; prove(names, facts, goal) is called for each obligation. Return names and facts."""
    steps = statement["steps"]
    names = Names(statement["variables"], [s["new"] for s in steps if "new" in s])
    facts = []
    for s in steps:
        of = names(s["of"])
        match s["step"]:
            case "assume":
                facts.append((s["is"], of))
            case "show":
                prove(names, facts, (s["is"], of))
                facts.append((s["is"], of))
            case "define":
                names.value[s["new"]] = of
                names.open.add(s["new"])
            case "root":
                prove(names, facts, (">=", of))
                names.open.add(s["new"])
                w = names.value[s["new"]]
                facts += [("=", w**2 - of), (">=", w)]
            case "inverse":
                prove(names, facts, ("!=", of))
                names.open.add(s["new"])
                facts.append(("=", names.value[s["new"]] * of - 1))
            case other:
                raise Refused(f"unknown step {other}")
        if facts and facts[-1][0] not in ("=", "!=", ">", ">="):
            raise Refused(f"unknown relation {facts[-1][0]}")
    return names, facts


def _derivation(statement, certificate):
    waiting = list(certificate["proofs"])
    _steps(statement, lambda names, facts, goal: _prove(names, facts, goal, waiting.pop(0)))


def _refutation(statement, certificate):
    if statement["steps"][-1]["step"] != "show":
        raise Refused("nothing is claimed at the end")
    goals = []
    names, facts = _steps(statement, lambda _names, _facts, goal: goals.append(goal))
    point = {names.all.index(n): _rational(v) for n, v in certificate["point"].items()}

    def true_at_point(relation, p):
        free = {i for i, degree in enumerate(p.degrees()) if degree > 0} - point.keys()  # those of 0 are −1
        if free:
            raise Refused("the point leaves a name open")
        value = p(*[point.get(i, fmpq(0)) for i in range(len(names.all) or 1)])
        return {"=": value == 0, "!=": value != 0, ">": value > 0, ">=": value >= 0}[relation]

    if not all(true_at_point(*fact) for fact in [*facts[:-1], *goals[:-1]]):
        raise Refused("a hypothesis fails at the point")
    if true_at_point(*facts[-1]):
        raise Refused("the conclusion holds at the point")


def _induction(statement, certificate):
    names = Names([*statement["variables"], *statement["state"]], [])
    facts = [(a["is"], names(a["of"])) for a in statement["assume"]]
    parameters = Names(statement["variables"], [])
    for a in statement["assume"]:
        parameters(a["of"])  # refuses an assumption about the state
    claims = [names(p) for p in [*statement["show"], *certificate["strengthen"]]]

    def moved(p, key):
        for n in statement["state"]:
            if n not in statement[key]:
                raise Refused(f"{n} has no {key}")
        return p.compose(*[names(statement[key][n]) if n in statement["state"] else names.value[n] for n in names.all])

    if not len(claims) == len(certificate["base"]) == len(certificate["step"]):
        raise Refused("a base or a step is missing")
    for p, base, step in zip(claims, certificate["base"], certificate["step"], strict=True):
        _prove(names, facts, ("=", moved(p, "start")), base)
        _prove(names, [*facts, *(("=", q) for q in claims)], ("=", moved(p, "next")), step)


def _separation(statement, certificate):
    closed = set(certificate["reached"])
    for name, used in statement["lines"]:
        if name in closed and not closed.issuperset(used):
            raise Refused(f"{name} uses {sorted(set(used) - closed)}")
    if not closed.issuperset(statement["outputs"]) or closed.intersection(statement["avoid"]):
        raise Refused("an output is missing, or a name to avoid is there")


def why_refused(statement, certificate):
    """Return None if the certificate proves the statement, else the exception that says why it does not."""
    kinds = {"derivation": _derivation, "refutation": _refutation, "induction": _induction, "separation": _separation}
    try:
        if statement["version"] != 1:
            raise Refused(f"version {statement['version']}")
        kinds[statement["kind"]](statement, certificate)
    except Exception as why:  # malformed data proves nothing either
        return why
    return None
