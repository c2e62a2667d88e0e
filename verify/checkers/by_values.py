"""A judge of certificates that multiplies no polynomials: it puts one random point into both sides of every identity.

Where the values differ, the polynomials differ: "false" is certain, and exact. Where they agree, the identity holds but
for one chance in very many. The judge asks nothing else: whether a rule may be applied is for the checkers to say.
"""

import random
from fractions import Fraction
from math import prod

LARGE = 10**15  # a wrong identity of degree d agrees at a random point with probability < d / LARGE
RELATION = {"=": lambda a: a == 0, "!=": lambda a: a != 0, ">": lambda a: a > 0, ">=": lambda a: a >= 0}
NEGATED = {"=": (1, "!="), "!=": (1, "="), ">": (-1, ">="), ">=": (-1, ">")}


def holds(statement: dict, certificate: dict, seed: int = 0) -> bool:
    """Return False if the evidence is certainly false; True if it holds at a random point (at *the* point, exactly)."""
    kind = statement["kind"]
    if kind == "separation":
        listed = set(certificate["reached"])
        needed = set(statement["outputs"]).union(*(uses for name, uses in statement["lines"] if name in listed))
        return needed <= listed and not listed.intersection(statement["avoid"])
    if kind == "refutation":
        point = {name: _number(value) for name, value in certificate["point"].items()}
        *facts, (claim, relation) = _facts(statement, point, lambda *_: None)
        return all(RELATION[r](a) for a, r in facts) and not RELATION[relation](claim)
    names = [*statement["variables"], *statement.get("state", ()), *(s.get("new") for s in statement.get("steps", ()))]
    rng = random.Random(seed)
    point = {name: rng.randrange(1, LARGE) for name in names}
    if kind == "induction":
        return _induction(statement, certificate, point)
    waiting, agrees = iter(certificate["proofs"]), []
    _facts(statement, point, lambda goal, facts, values: agrees.append(_agrees(goal, facts, next(waiting), values)))
    return all(agrees)


def _number(text):
    """Return the number: whole ones as int, which is quicker."""
    return Fraction(text) if "/" in text else int(text)


def _value(polynomial, values):
    total = 0
    for monomial, coefficient in polynomial.items():
        powers = (factor.partition("^") for factor in monomial.split())
        total += _number(coefficient) * prod(values[name] ** int(power or 1) for name, _, power in powers)
    return total


def _facts(statement, values, met):
    """Return the facts (value, relation) of a derivation; met(goal, facts, values) hears of every goal in its place."""
    facts = []
    for step in statement["steps"]:
        a, new = _value(step["of"], values), step.get("new")
        match step["step"]:
            case "assume":
                facts.append((a, step["is"]))
            case "show":
                met((a, step["is"]), facts, values)
                facts.append((a, step["is"]))
            case "define":
                values[new] = a
            case "root":
                met((a, ">="), facts, values)
                facts += [(values[new] ** 2 - a, "="), (values[new], ">=")]
            case "inverse":
                met((a, "!="), facts, values)
                facts.append((values[new] * a - 1, "="))
    return facts


def _agrees(goal, facts, proof, values):
    """Return whether both sides of every identity of a proof have the same value."""
    left, relation = goal
    if proof["rule"] == "contradiction":
        sign, opposite = NEGATED[relation]
        facts = [*facts, (sign * left, opposite)]
        left = prod(facts[i][0] ** (2 if facts[i][1] == "!=" else 1) for i in proof["positive"])
        for weight, root, factors in proof["sum"]:
            left += _number(weight) * _value(root, values) ** 2 * prod(facts[i][0] for i in factors)
    return left == sum(_value(q, values) * facts[i][0] for i, q in proof["cofactors"])


def _induction(statement, certificate, point):
    start, following = (
        point | {name: _value(p, point) for name, p in statement[key].items()} for key in ("start", "next")
    )
    facts = [(_value(given["of"], point), given["is"]) for given in statement["assume"]]
    claims = statement["show"]
    carried = [*facts, *((_value(p, point), "=") for p in claims)]
    return all(
        _agrees((_value(p, start), "="), facts, base, point)
        and _agrees((_value(p, following), "="), carried, step, point)
        for p, base, step in zip(claims, certificate["base"], certificate["step"], strict=True)
    )
