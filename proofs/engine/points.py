"""The hypotheses that a certificate's proofs use, and a rational point at which these hold.

Nothing here is trusted: the kernels check the shorter certificate, and the point.
"""

import random
import re
from bisect import bisect_left
from contextlib import suppress
from fractions import Fraction

from proofs.check import consistency
from proofs.engine import kernel
from proofs.engine.counterexample import NotRational, rational_root

WHOLE, PARTS = ("0", "1", "2", "3", "10", "1000"), ("1/2", "1/3", "2/3", "1/4", "1/10")
OF_CIRCLES = ("3/5", "4/5", "5/13", "12/13", "3/4", "4/3", "5/12", "24/7")  # sines, cosines and tangents
SIMPLE = [*map(Fraction, (*WHOLE, *OF_CIRCLES, *PARTS))]
TRIES, USUAL, PICKS = 4000, 256, 8  # fewer tries where there are more names times facts than usual


def without_unused(statement: dict, certificate: dict) -> tuple[dict, dict]:
    """Return a derivation and its certificate without the assumptions that no proof uses; circles stay."""
    assumed, used, number, proofs = {}, [], 0, iter(certificate["proofs"])
    for step in statement["steps"]:
        if step["step"] in ("show", "root", "inverse"):
            _renumbered(next(proofs), lambda i, end=number: used.append(i if i < end else None))  # end: what is negated
        elif step["step"] == "assume":
            assumed[number] = step
        number += {"define": 0, "root": 2}.get(step["step"], 1)
    needed = [step for i, step in assumed.items() if i in used or is_circle(step)]
    idle = [i for i, step in assumed.items() if step not in needed]

    steps = [step for step in statement["steps"] if step["step"] != "assume" or step in needed]
    proofs = [_renumbered(proof, lambda i: i - bisect_left(idle, i)) for proof in certificate["proofs"]]
    return statement | {"steps": steps}, {"proofs": proofs}


def _renumbered(proof, number):
    """Return a proof with other numbers of facts."""
    changed = {"cofactors": [[number(i), q] for i, q in proof["cofactors"]]}
    if proof["rule"] == "contradiction":
        changed["positive"] = [number(i) for i in proof["positive"]]
        changed["sum"] = [[c, s, [number(i) for i in h]] for c, s, h in proof["sum"]]
    return proof | changed


def is_circle(step: dict) -> bool:
    """Return whether an assumption is the c² + s² = 1 of an angle's cosine and sine."""
    squares = [monomial for monomial in step["of"] if re.fullmatch(r"(cos|sin)\(\S+\)\^2", monomial)]
    return step["is"] == "=" and len(squares) == 2 and len(step["of"]) == 3


def find_point(statement: dict) -> dict[str, str] | None:
    """Return a point at which the hypotheses of a derivation or an induction hold, {name: rational}, or None."""
    refutation, rng = consistency(statement), random.Random(0)
    *facts, _ = kernel.derive(refutation, lambda *_: None)
    new = [step["new"] for step in refutation["steps"] if step["step"] in ("root", "inverse")]
    names = [*refutation["variables"], *new]
    for _ in range(TRIES * USUAL // max(USUAL, len(names) * len(facts))):
        with suppress(NotRational):
            values = _attempt(names, facts, rng, rng.sample(SIMPLE, rng.randint(1, len(SIMPLE))))
            point = {name: str(value) for name, value in sorted(values.items())}
            if kernel.check(refutation, {"point": point}) is None:
                return point
    return None


def _attempt(names, facts, rng, pool):
    """Return values of all names, by equations where these can be solved, else at random."""
    values, new = {}, {}
    numbers = {name: kernel.variable(name) for name in names}
    while True:
        numbers |= {name: kernel.multiply(value) for name, value in new.items()}
        facts = [(p if new.keys().isdisjoint(_names(p)) else kernel.substitute(p, numbers), r) for p, r in facts]
        if not all(kernel.HOLDS[r](p.get((), 0)) for p, r in facts if not any(p)):
            raise NotRational
        facts = [(p, r) for p, r in facts if any(p)]
        unknown = [name for name in names if name not in values]
        if not unknown:
            return values
        equations = sorted((p for p, r in facts if r == "="), key=lambda p: len(_names(p)))
        new = (equations and _solved(equations[0], rng, pool)) or _chosen(rng.choice(unknown), facts, rng, pool)
        values |= new


def _chosen(name, facts, rng, pool):
    """Return {name: a simple number} by which the facts about the name alone hold, or else the last one tried."""
    alone = [(p, kernel.HOLDS[r]) for p, r in facts if r != "=" and set(_names(p)) == {name}]
    for _ in range(PICKS):
        value = {name: kernel.multiply(_simple(rng, pool))}
        if all(holds(kernel.substitute(p, value).get((), 0)) for p, holds in alone):
            break
    return {name: value[name].get((), 0)}


def _simple(rng, pool):
    return rng.choice(pool) * rng.choice((1, 1, -1))


def _names(p):
    return sorted({name for monomial in p for name in monomial})


def _solved(p, rng, pool):
    """Return rational values of the names of an equation in one name, or of a conic's two; None where neither."""
    c, (x, *others) = Fraction(p.get((), 0)), _names(p)
    if not others and set(p) <= {(), (x,), (x, x)}:
        a, b = Fraction(p.get((x, x), 0)), Fraction(p.get((x,), 0))
        root = rational_root(b * b - 4 * a * c)
        return {x: (-b + rng.choice((1, -1)) * root) / (2 * a) if a else -c / b}
    if len(others) == 1 and set(p) <= {(), (x, x), (others[0], others[0])}:
        (y,), t = others, abs(_simple(rng, pool)) or Fraction(1, 7)
        a, b = Fraction(p[x, x]), Fraction(p[y, y])
        if a * b < 0:  # (ρx − y)(ρx + y) = −c/a·ρ²
            ratio, right = rational_root(-a / b), c / b
            return {y: (t - right / t) / 2, x: (t + right / t) / (2 * ratio)}
        ratio, radius = rational_root(a / b), rational_root(-c / b)
        return {y: radius * (1 - t * t) / (1 + t * t), x: radius * 2 * t / (1 + t * t) / ratio}
    return None
