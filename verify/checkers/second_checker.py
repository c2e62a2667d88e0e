"""A second checker of certificates, independent of `proofs.engine.kernel`: from the JSON alone, with FLINT's
polynomials.

It shares no code with the kernel, neither its arithmetic (fmpq_mpoly) nor its reading of the data.
"""

import re
from collections.abc import Callable, Iterable
from typing import Any

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx


class Refused(Exception):
    """The certificate proves nothing; the message says why, with the difference where two sides differ."""


WORD = r"(?:[A-Za-z][A-Za-z0-9_]{0,99}|(?:cos|sin)\([-A-Za-z0-9_*/()+]{1,99}\))"
MONOMIAL = re.compile(rf"(?:{WORD}(?:\^(?:[2-9]|[1-9][0-9][0-9]?))?(?: (?!$)|$))*")
RATIONAL = re.compile(r"(-?[0-9]{1,500})(?:/([0-9]{1,500}))?")
MOST = 10**5


def _need(condition, what):
    if not condition:
        raise Refused(what)


# The form


def _form(data: Any, shape: Any) -> None:
    """Refuse what has not a shape: a test, {key: shape}, [the shape of each item], (the shapes of the items, …)."""
    match shape:
        case dict():
            _need(type(data) is dict and sorted(data) == sorted(shape), f"other keys than {', '.join(shape)}")
            for key, of in shape.items():
                _form(data[key], of)
        case list() | tuple():
            lengths = range(MOST + 1) if isinstance(shape, list) else (len(shape),)
            _need(type(data) is list and len(data) in lengths, "not a list of that length")
            for i, item in enumerate(data):
                _form(item, shape[0] if isinstance(shape, list) else shape[i])
        case test:
            test(data)


def _one_of(*texts):
    return lambda data: _need(type(data) is str and data in texts, f"{data!r} is not one of {', '.join(texts)}")


def _rational(text):
    parts = RATIONAL.fullmatch(text) if type(text) is str else None
    _need(parts, f"{text!r} is no number")
    value = fmpq(int(parts[1]), int(parts[2] or 1))
    _need(str(value) == text, f"{text} is not in lowest terms")
    return value


def _name(text):
    _need(type(text) is str and re.fullmatch(WORD, text), f"{text!r} is no name")


def _index(i):
    _need(type(i) is int and 0 <= i <= MOST, f"{i!r} is no index")


def _polynomial(p):
    _need(type(p) is dict and len(p) <= MOST, "not a polynomial")
    for monomial, coefficient in p.items():
        _need(type(monomial) is str and MONOMIAL.fullmatch(monomial), f"{monomial!r} is no product of powers")
        words = [factor.partition("^")[0] for factor in monomial.split()]
        _need(len(words) == len(set(words)), f"{monomial} names something twice")
        _need(_rational(coefficient) != 0, "a term without a coefficient")


def _by_name(test):
    def each(data):
        _need(type(data) is dict and len(data) <= MOST, "not an object")
        for name, value in data.items():
            _name(name)
            test(value)

    return each


def _proof(data):
    rule, shape = data["rule"], {"rule": _one_of("ideal", "contradiction"), "cofactors": [(_index, _polynomial)]}
    if rule == "contradiction":
        shape |= {"positive": [_index], "sum": [(_rational, _polynomial, [_index])]}
    _form(data, shape)


def _step(data):
    kind = data["step"]
    rest = {"is": _relation} if kind in ("assume", "show") else {"new": _name}
    _form(data, {"step": _one_of("assume", "show", "define", "root", "inverse"), "of": _polynomial} | rest)


_relation = _one_of("=", "!=", ">", ">=")
STEPS = {"variables": [_name], "steps": [_step]}
STATE = {"state": [_name], "start": _by_name(_polynomial), "next": _by_name(_polynomial)}
FACTS = {"variables": [_name], "assume": [{"of": _polynomial, "is": _relation}], "show": [_polynomial]}
LINES = {"lines": [(_name, [_name])], "outputs": [_name], "avoid": [_name]}

# The meaning


class Names:
    """All names of a statement as the variables of one FLINT ring, and the values of those that may be used yet."""

    def __init__(self, free: Iterable[str], new: Iterable[str]):
        self.all = [*free, *new]
        _need(len(set(self.all)) == len(self.all), f"a name is introduced twice among {self.all}")
        self.ring = fmpq_mpoly_ctx.get([f"v{i}" for i in range(len(self.all))] or ["v0"], Ordering.degrevlex)
        self.variable = {n: self.ring.gen(i) for i, n in enumerate(self.all)}
        self.value = {n: self.variable[n] for n in free}

    def constant(self, text: str) -> fmpq_mpoly:
        return self.ring.constant(_rational(text))

    def __call__(self, data: dict[str, str], values: dict[str, fmpq_mpoly] | None = None) -> fmpq_mpoly:
        values, total = self.value if values is None else values, self.constant("0")
        for monomial, coefficient in data.items():
            term = self.constant(coefficient)
            for factor in monomial.split():
                name, _, power = factor.partition("^")
                _need(name in values, f"{name} is used before it is introduced")
                for _ in range(int(power or 1)):
                    term = _product(term, values[name])
            total += term
        return total


def _product(p, q):
    """Return a product of polynomials; refuse one that would take more than seconds."""
    terms = len(p) * len(q) * (1 + max(p.total_degree(), 0) + max(q.total_degree(), 0))
    _need(terms <= MOST, f"a product of {len(p)} terms and {len(q)}")
    bits = sum(max((c.height_bits() for c in factor.coeffs()), default=0) for factor in (p, q))
    _need(bits <= MOST, f"a product of numbers of {bits} bits")
    return p * q


def _prove(names, facts, goal, proof):
    """facts: [(relation, polynomial)]; goal: (relation, polynomial)."""
    relation, left = goal
    if proof["rule"] == "ideal":
        _need(relation == "=", "an ideal proves equations only")
    else:
        negated = {"=": ("!=", left), "!=": ("=", left), ">": (">=", -left), ">=": (">", -left)}[relation]
        facts = [*facts, negated]
        left = names.constant("1")
        for i in proof["positive"]:
            kind, q = facts[i]
            _need(kind in (">", "!="), f"fact {i} need not be positive")
            for factor in (q, q) if kind == "!=" else (q,):
                left = _product(left, factor)
        for coefficient, root, factors in proof["sum"]:
            _need(_rational(coefficient) >= 0, "a negative weight")
            square = names(root)
            term = _product(names.constant(coefficient) * square, square)
            for i in factors:
                _need(facts[i][0] in (">", ">="), f"fact {i} may be negative")
                term = _product(term, facts[i][1])
            left += term
    for i, q in proof["cofactors"]:
        _need(facts[i][0] == "=", f"fact {i} is no equation")
        left -= _product(names(q), facts[i][1])
    _need(left == 0, f"{proof['rule']}: the difference is {left}")


def _steps(statement, prove):
    """Go through a derivation; prove(names, facts, goal) is called for each obligation. Return names and facts."""
    steps = statement["steps"]
    names, facts = Names(statement["variables"], [s["new"] for s in steps if "new" in s]), []
    for s in steps:
        of, new = names(s["of"]), s.get("new")
        match s["step"]:
            case "assume":
                facts.append((s["is"], of))
            case "show":
                prove(names, facts, (s["is"], of))
                facts.append((s["is"], of))
            case "define":
                names.value[new] = of
            case "root":
                prove(names, facts, (">=", of))
                names.value[new] = w = names.variable[new]
                facts += [("=", w**2 - of), (">=", w)]
            case "inverse":
                prove(names, facts, ("!=", of))
                names.value[new] = names.variable[new]
                facts.append(("=", _product(names.value[new], of) - 1))
    return names, facts


def _derivation(statement, certificate):
    waiting = list(certificate["proofs"])
    _steps(statement, lambda names, facts, goal: _prove(names, facts, goal, waiting.pop(0)))
    _need(not waiting, "a proof is left over")
    _need("show" in [s["step"] for s in statement["steps"]], "nothing is claimed")


def _refutation(statement, certificate):
    goals = []
    names, facts = _steps(statement, lambda _names, _facts, goal: goals.append(goal))
    _need(statement["steps"][-1]["step"] == "show", "nothing is claimed at the end")
    at = {n: _rational(v) for n, v in certificate["point"].items()}
    new = [s["new"] for s in statement["steps"] if s["step"] in ("root", "inverse")]
    _need(sorted(at) == sorted([*statement["variables"], *new]), "a point of other names")
    _need("pi" not in at, "π is one number, and no coordinate")
    for n in at:
        if n.endswith(")"):
            c, s = at[f"cos{n[3:]}"], at[f"sin{n[3:]}"]
            _need(c * c + s * s == 1, f"{n} is not on the circle")
    point = [at.get(n, fmpq(0)) for n in names.all] or [fmpq(0)]
    digits = max(value.height_bits() for value in point)

    def true_at_point(relation, p):
        _need(p.total_degree() * digits <= MOST, "a number of too many digits")
        value = p(*point)
        return {"=": value == 0, "!=": value != 0, ">": value > 0, ">=": value >= 0}[relation]

    for fact in [*facts[:-1], *goals[:-1]]:
        _need(true_at_point(*fact), "a hypothesis fails at the point")
    _need(not true_at_point(*facts[-1]), "the conclusion holds at the point")


def _induction(statement, certificate):
    state = statement["state"]
    parameters, names = Names(statement["variables"], []), Names([*statement["variables"], *state], [])
    facts = [(a["is"], names(a["of"])) for a in statement["assume"]]
    for of in [*(a["of"] for a in statement["assume"]), *statement["start"].values()]:
        parameters(of)  # refuses an assumption about the state, or a start that depends on it
    said = statement["show"]
    claims = [names(p) for p in said]
    _need(claims, "nothing is claimed")
    _need(len(claims) == len(certificate["base"]) == len(certificate["step"]), "a base or a step is missing")

    def moved(p, values):
        _need(sorted(values) == sorted(state), "a state is not given")
        return names(p, names.value | {n: names(values[n]) for n in state})

    for p, base, step in zip(said, certificate["base"], certificate["step"], strict=True):
        _prove(names, facts, ("=", moved(p, statement["start"])), base)
        _prove(names, [*facts, *(("=", q) for q in claims)], ("=", moved(p, statement["next"])), step)


def _separation(statement, certificate):
    closed = set(certificate["reached"])
    _need(statement["outputs"] and statement["avoid"], "nothing is claimed")
    for name, used in statement["lines"]:
        _need(name not in closed or closed.issuperset(used), f"{name} uses what is not listed")
    _need(closed.issuperset(statement["outputs"]), "an output is missing")
    _need(not closed.intersection(statement["avoid"]), "a name to avoid is there")


KINDS: dict[str, tuple[Callable, dict, dict]] = {
    "derivation": (_derivation, STEPS, {"proofs": [_proof]}),
    "refutation": (_refutation, STEPS, {"point": _by_name(_rational)}),
    "induction": (_induction, FACTS | STATE, {"base": [_proof], "step": [_proof]}),
    "separation": (_separation, LINES, {"reached": [_name]}),
}


def why_refused(statement: dict, certificate: dict) -> Exception | None:
    """Return None if the certificate proves the statement, else the exception that says why it does not."""
    try:
        _need(type(statement["version"]) is int and statement["version"] == 1, "only version 1 is known")
        rule, said, shown = KINDS[statement["kind"]]
        _form(statement, {"version": id, "kind": id} | said)
        _form(certificate, shown)
        rule(statement, certificate)
    except Exception as why:  # malformed data proves nothing either
        return why
    return None
