"""A second checker of certificates, independent of `proofs.engine.kernel`: from the JSON alone, with FLINT's
polynomials.

It shares no code with the kernel, neither its arithmetic (fmpq_mpoly) nor its reading of the data.
"""

import re
from collections.abc import Iterable

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx


class Refused(Exception):
    """The certificate proves nothing; the message says why, with the difference where two sides differ."""


WORD = r"(?:[A-Za-z][A-Za-z0-9_]{0,99}|(?:cos|sin)\([-A-Za-z0-9_*/()+]{1,99}\))"
MONOMIAL = re.compile(rf"(?:{WORD}(?:\^(?:[2-9]|[1-9][0-9][0-9]?))?(?: (?!$)|$))*")
RATIONAL = re.compile(r"(-?[0-9]{1,500})(?:/([0-9]{1,500}))?")
MOST = 10**5
RELATIONS = ("=", "!=", ">", ">=")


def _need(condition, what):
    if not condition:
        raise Refused(what)


def _rational(text):
    parts = RATIONAL.fullmatch(text) if type(text) is str else None
    _need(parts, f"{text!r} is no number")
    value = fmpq(int(parts[1]), int(parts[2] or 1))
    _need(str(value) == text, f"{text} is not in lowest terms")
    return value


def _keys(data, *keys):
    _need(type(data) is dict and sorted(data) == sorted(keys), f"other keys than {', '.join(keys)}")


def _list(data, length=None):
    _need(type(data) is list and len(data) <= MOST and length in (None, len(data)), "not a list of that length")
    return data


def _name(text):
    _need(type(text) is str and re.fullmatch(WORD, text), f"{text!r} is no name")
    return text


def _names(data):
    return [_name(text) for text in _list(data)]


def _fact(facts, i):
    _need(type(i) is int and 0 <= i < len(facts), f"there is no fact {i}")
    return facts[i]


def _well_formed(p):
    """Refuse what is no polynomial, whatever its names stand for."""
    _need(type(p) is dict and len(p) <= MOST, "not a polynomial")
    for monomial, coefficient in p.items():
        _need(type(monomial) is str and MONOMIAL.fullmatch(monomial), f"{monomial!r} is no product of powers")
        words = [factor.partition("^")[0] for factor in monomial.split()]
        _need(len(words) == len(set(words)), f"{monomial} names something twice")
        _need(_rational(coefficient) != 0, "a term without a coefficient")


def _proof_form(proof):
    rule = proof["rule"]
    _need(rule in ("ideal", "contradiction"), f"unknown rule {rule}")
    _keys(proof, "rule", "cofactors", *(("positive", "sum") if rule == "contradiction" else ()))
    for entry in _list(proof["cofactors"]):
        _well_formed(_list(entry, 2)[1])
    for entry in _list(proof.get("sum", [])):
        _rational(_list(entry, 3)[0])
        _well_formed(entry[1])
        _list(entry[2])
    _list(proof.get("positive", []))
    indices = [*proof.get("positive", []), *(i for i, _ in proof["cofactors"])]
    for i in [*indices, *(i for _, _, factors in proof.get("sum", []) for i in factors)]:
        _need(type(i) is int and 0 <= i <= MOST, f"{i!r} is no index")


class Names:
    """All names of a statement as the variables of one FLINT ring, and which of them may be used yet."""

    def __init__(self, free: Iterable[str], new: Iterable[str]):
        self.all = [*free, *new]
        if len(set(self.all)) != len(self.all):
            raise Refused(f"a name is introduced twice among {self.all}")
        self.ring = fmpq_mpoly_ctx.get([f"v{i}" for i in range(len(self.all))] or ["v0"], Ordering.degrevlex)
        self.value = {n: self.ring.gen(i) for i, n in enumerate(self.all)}
        self.open = set(free)

    def constant(self, text: str) -> fmpq_mpoly:
        return self.ring.constant(_rational(text))

    def __call__(self, data: dict[str, str]) -> fmpq_mpoly:
        total = self.ring.constant(0)
        _well_formed(data)
        for monomial, coefficient in data.items():
            term = self.constant(coefficient)
            for factor in monomial.split():
                name, _, power = factor.partition("^")
                _need(name in self.open, f"{name} is used before it is introduced")
                term *= self.value[name] ** int(power or 1)
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
                kind, q = _fact(facts, i)
                if kind not in (">", "!="):
                    raise Refused(f"fact {i} need not be positive")
                left *= q * q if kind == "!=" else q
            for coefficient, root, factors in proof["sum"]:
                if _rational(coefficient) < 0:
                    raise Refused("a negative weight")
                term = names.constant(coefficient) * names(root) ** 2
                for i in factors:
                    if _fact(facts, i)[0] not in (">", ">="):
                        raise Refused(f"fact {i} may be negative")
                    term *= facts[i][1]
                left += term
            _zero(left - _combination(names, facts, proof["cofactors"]), "contradiction")


def _combination(names, facts, cofactors):
    total = names.constant("0")
    for i, q in cofactors:
        if _fact(facts, i)[0] != "=":
            raise Refused(f"fact {i} is no equation")
        total += names(q) * facts[i][1]
    return total


def _steps(statement, prove):
    """Go through a derivation; prove(names, facts, goal) is called for each obligation. Return names and facts."""
    _keys(statement, "version", "kind", "variables", "steps")
    steps = _list(statement["steps"])
    names = Names(_names(statement["variables"]), [_name(s["new"]) for s in steps if "new" in s])
    facts = []
    for s in steps:
        _keys(s, "step", "of", "is" if s["step"] in ("assume", "show") else "new")
        _need(s.get("is", "=") in RELATIONS, "unknown relation")
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
    return names, facts


def _derivation(statement, certificate):
    _keys(certificate, "proofs")
    waiting = list(_list(certificate["proofs"]))
    for proof in waiting:
        _proof_form(proof)
    _steps(statement, lambda names, facts, goal: _prove(names, facts, goal, waiting.pop(0)))
    _need(not waiting, "a proof is left over")
    _need("show" in [s["step"] for s in statement["steps"]], "nothing is claimed")


def _refutation(statement, certificate):
    if statement["steps"][-1]["step"] != "show":
        raise Refused("nothing is claimed at the end")
    goals = []
    names, facts = _steps(statement, lambda _names, _facts, goal: goals.append(goal))
    _keys(certificate, "point")
    at = {_name(n): _rational(v) for n, v in certificate["point"].items()}
    _keys(at, *statement["variables"], *(s["new"] for s in statement["steps"] if s["step"] in ("root", "inverse")))
    _need("pi" not in at, "π is one number, and no coordinate")
    for n in at:
        if n.endswith(")"):
            c, s = at[f"cos{n[3:]}"], at[f"sin{n[3:]}"]
            _need(c * c + s * s == 1, f"{n} is not on the circle")
    point = {names.all.index(n): v for n, v in at.items()}

    def true_at_point(relation, p):
        value = p(*[point.get(i, fmpq(0)) for i in range(len(names.all) or 1)])
        return {"=": value == 0, "!=": value != 0, ">": value > 0, ">=": value >= 0}[relation]

    if not all(true_at_point(*fact) for fact in [*facts[:-1], *goals[:-1]]):
        raise Refused("a hypothesis fails at the point")
    if true_at_point(*facts[-1]):
        raise Refused("the conclusion holds at the point")


def _induction(statement, certificate):
    _keys(statement, "version", "kind", "variables", "state", "assume", "start", "next", "show")
    _keys(certificate, "base", "step")
    for proof in [*_list(certificate["base"]), *_list(certificate["step"])]:
        _proof_form(proof)
    state = _names(statement["state"])
    names = Names([*_names(statement["variables"]), *state], [])
    facts = []
    for a in _list(statement["assume"]):
        _keys(a, "of", "is")
        _need(a["is"] in RELATIONS, "unknown relation")
        facts.append((a["is"], names(a["of"])))
    parameters = Names(statement["variables"], [])
    _keys(statement["start"], *state)
    _keys(statement["next"], *state)
    for of in [*(a["of"] for a in statement["assume"]), *statement["start"].values()]:
        parameters(of)  # refuses an assumption about the state, or a start that depends on it
    claims = [names(p) for p in _list(statement["show"])]
    _need(claims, "nothing is claimed")

    def moved(p, key):
        return p.compose(*[names(statement[key][n]) if n in statement["state"] else names.value[n] for n in names.all])

    if not len(claims) == len(certificate["base"]) == len(certificate["step"]):
        raise Refused("a base or a step is missing")
    for p, base, step in zip(claims, certificate["base"], certificate["step"], strict=True):
        _prove(names, facts, ("=", moved(p, "start")), base)
        _prove(names, [*facts, *(("=", q) for q in claims)], ("=", moved(p, "next")), step)


def _separation(statement, certificate):
    _keys(statement, "version", "kind", "lines", "outputs", "avoid")
    _keys(certificate, "reached")
    closed = set(_names(certificate["reached"]))
    for line in _list(statement["lines"]):
        name, used = _list(line, 2)
        _name(name), _names(used)
    _need(_names(statement["outputs"]) and _names(statement["avoid"]), "nothing is claimed")
    for name, used in statement["lines"]:
        if name in closed and not closed.issuperset(used):
            raise Refused(f"{name} uses {sorted(set(used) - closed)}")
    if not closed.issuperset(statement["outputs"]) or closed.intersection(statement["avoid"]):
        raise Refused("an output is missing, or a name to avoid is there")


def why_refused(statement: dict, certificate: dict) -> Exception | None:
    """Return None if the certificate proves the statement, else the exception that says why it does not."""
    kinds = {"derivation": _derivation, "refutation": _refutation, "induction": _induction, "separation": _separation}
    try:
        _need(type(statement["version"]) is int and statement["version"] == 1, "only version 1 is known")
        kinds[statement["kind"]](statement, certificate)
    except Exception as why:  # malformed data proves nothing either
        return why
    return None
