"""A second checker of certificates, independent of `proofs.engine.kernel`: from the JSON alone, with FLINT's
polynomials.

It shares no code with the kernel, neither its arithmetic (fmpq_mpoly) nor its reading of the data: what form a
statement and a certificate have says `proofs/certificates.schema.json`.
"""

import json
from collections.abc import Iterable
from pathlib import Path

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx
from jsonschema import Draft202012Validator

SCHEMA = json.loads((Path(__file__).parents[2] / "proofs" / "certificates.schema.json").read_text(encoding="utf-8"))
FORM = Draft202012Validator({"$defs": SCHEMA["$defs"], "$ref": "#/$defs/pair"})
MOST = 10**5


class Refused(Exception):
    """The certificate proves nothing; the message says why, with the difference where two sides differ."""


def _need(condition, what):
    if not condition:
        raise Refused(what)


def _form(statement, certificate):
    """Refuse what has not the schema's form, which takes 1.0 for 1, and in Python lets a line end behind a pattern."""
    point = {} if statement["kind"] == "induction" else None
    pair = {"sha256": "0" * 64, "statement": statement, "certificate": certificate, "point": point}
    _need(FORM.is_valid(pair) and "\\n" not in json.dumps(pair), "another form than the schema's")
    _need(type(statement["version"]) is int, "another version than 1")


def _rational(text):
    value = fmpq(*map(int, text.split("/")))
    _need(str(value) == text, f"{text} is not in lowest terms")
    return value


class Names:
    """All names of a statement as the variables of one FLINT ring, and the values of those that may be used yet."""

    def __init__(self, free: Iterable[str], new: Iterable[str] = ()):
        self.all = [*free, *new]
        _need(len(set(self.all)) == len(self.all), f"a name is introduced twice among {self.all}")
        self.ring = fmpq_mpoly_ctx.get([f"v{i}" for i in range(len(self.all))] or ["v0"], Ordering.degrevlex)
        self.variable = dict(zip(self.all, self.ring.gens(), strict=False))
        self.value = {n: self.variable[n] for n in free}

    def constant(self, text: str) -> fmpq_mpoly:
        return self.ring.constant(_rational(text))

    def __call__(self, data: dict[str, str], values: dict[str, fmpq_mpoly] | None = None) -> fmpq_mpoly:
        values, total = self.value if values is None else values, self.constant("0")
        for monomial, coefficient in data.items():
            term, seen = self.constant(coefficient), set()
            for factor in monomial.split():
                name, _, power = factor.partition("^")
                _need(name not in seen, f"{monomial} names something twice")
                _need(name in values, f"{name} is used before it is introduced")
                seen.add(name)
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
        kind, of, new = s["step"], names(s["of"]), s.get("new")
        goal = ({"root": ">=", "inverse": "!="}.get(kind) or s.get("is"), of)
        if kind in ("show", "root", "inverse"):
            prove(names, facts, goal)
        if new:
            names.value[new] = value = of if kind == "define" else names.variable[new]
        match kind:
            case "assume" | "show":
                facts.append(goal)
            case "root":
                facts += [("=", value**2 - of), (">=", value)]
            case "inverse":
                facts.append(("=", _product(value, of) - 1))
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
    state, assumed = statement["state"], statement["assume"]
    parameters, names = Names(statement["variables"]), Names([*statement["variables"], *state])
    facts = [(a["is"], names(a["of"])) for a in assumed]
    for of in [*(a["of"] for a in assumed), *statement["start"].values()]:
        parameters(of)  # refuses an assumption about the state, or a start that depends on it
    said = statement["show"]
    claims = [("=", names(p)) for p in said]

    def moved(p, values):
        _need(sorted(values) == sorted(state), "a state is not given")
        return "=", names(p, names.value | {n: names(values[n]) for n in state})

    for p, base, step in zip(said, certificate["base"], certificate["step"], strict=True):
        _prove(names, facts, moved(p, statement["start"]), base)
        _prove(names, [*facts, *claims], moved(p, statement["next"]), step)


def _separation(statement, certificate):
    closed = set(certificate["reached"])
    for name, used in statement["lines"]:
        _need(name not in closed or closed.issuperset(used), f"{name} uses what is not listed")
    _need(closed.issuperset(statement["outputs"]), "an output is missing")
    _need(not closed.intersection(statement["avoid"]), "a name to avoid is there")


KINDS = {"derivation": _derivation, "refutation": _refutation, "induction": _induction, "separation": _separation}


def why_refused(statement: dict, certificate: dict) -> Exception | None:
    """Return None if the certificate proves the statement, else the exception that says why it does not."""
    try:
        _form(statement, certificate)
        KINDS[statement["kind"]](statement, certificate)
    except Exception as why:  # malformed data proves nothing either
        return why
    return None
