"""Tampered certificates: one coefficient or one exponent changed at random, and whether that made the evidence false.

What is changed: a polynomial of the statement (what is shown, what is given and multiplied by a cofactor), a
cofactor, the root of a square, the number at which a counterexample stands; in a separation, which has no
polynomials, what a line uses, what is to be avoided, or what the certificate lists. A coefficient may be one that was
0.

A change that `verify.checkers.by_values` finds harmless, such as −x for x under a square, or of a hypothesis that no
proof uses, leaves a certificate that proves what the statement now says: every kernel has to accept it, and to reject
the others.
"""

import random
from collections.abc import Iterator, Sequence
from fractions import Fraction

from verify.checkers.by_values import holds


def draws(statement: dict, certificate: dict, seed: int | str) -> Iterator[tuple[dict, dict, bool]]:
    """Yield for ever (tampered statement, tampered certificate, whether the evidence still holds); seeded."""
    rng, change_one = random.Random(seed), _separation if statement["kind"] == "separation" else _polynomial
    while True:
        said, shown = change_one((statement, certificate), rng)
        if (said, shown) != (statement, certificate):
            yield said, shown, holds(said, shown, rng.randrange(2**32))


def _places(statement, certificate):
    """Return {what: [path]} of all polynomials, and of the coordinates of a point, in the pair."""
    steps = [(0, "steps", n, "of") for n in range(len(statement.get("steps", ())))]
    parts = [(0, key, name) for key in ("start", "next") for name in statement.get(key, ())]
    parts += [(0, "show", n) for n in range(len(statement.get("show", ())))]
    parts += [(0, "assume", n, "of") for n in range(len(statement.get("assume", ())))]
    places = {"statement": steps + parts, "cofactor": [], "square": []}
    for key in ("proofs", "base", "step"):
        for number, proof in enumerate(certificate.get(key, ())):
            path = (1, key, number)
            places["cofactor"] += [(*path, "cofactors", n, 1) for n, (_, q) in enumerate(proof["cofactors"]) if q]
            places["square"] += [(*path, "sum", n, 1) for n in range(len(proof.get("sum", ())))]
    places["point"] = [(1, "point", name) for name in certificate.get("point", ())]
    return {what: paths for what, paths in places.items() if paths}


def _polynomial(pair, rng):
    """Return the pair with one polynomial, or a coordinate of its point, changed."""
    places = _places(*pair)
    path = rng.choice(places[rng.choice(list(places))])
    old = _at(pair, path)
    if isinstance(old, str):
        return _replaced(pair, path, str(Fraction(old) + _number(rng)))
    names = {factor.partition("^")[0] for monomial in old for factor in monomial.split()}
    return _replaced(pair, path, change(old, sorted(names.union(pair[0]["variables"])), rng))


def change(polynomial: dict[str, str], names: Sequence[str], rng: random.Random) -> dict[str, str]:
    """Return the polynomial with one coefficient or exponent changed; `names` are those that it may use."""
    changed = dict(polynomial)
    if names and (not changed or rng.random() < 0.2):  # the coefficient of a term that is not there
        monomial = _monomial({rng.choice(names): rng.randint(0, 2), rng.choice(names): rng.randint(0, 2)})
        return _with(changed, monomial, _number(rng))
    if not changed:
        return {"": str(_number(rng))}
    monomial = rng.choice(list(changed))
    coefficient = Fraction(changed[monomial])
    if not names or rng.random() < 0.5:
        more = rng.choice([-2 * coefficient, coefficient, 1, -1, _number(rng)])
        return _with(changed, monomial, Fraction(more))
    powers = {name: int(power or 1) for name, _, power in (factor.partition("^") for factor in monomial.split())}
    name = rng.choice([*powers, rng.choice(names)])
    powers[name] = powers.get(name, 0) + rng.choice([1, -1] if name in powers else [1])
    del changed[monomial]
    return _with(changed, _monomial(powers), coefficient)


def _with(polynomial, monomial, more):
    """Return the polynomial with `more` added to a coefficient."""
    total = Fraction(polynomial.get(monomial, 0)) + more
    rest = {key: value for key, value in polynomial.items() if key != monomial}
    return rest | {monomial: str(total)} if total else rest


def _monomial(powers):
    return " ".join(n if e == 1 else f"{n}^{e}" for n, e in sorted(powers.items()) if e)


def _number(rng):
    return Fraction(rng.choice([1, -1]) * rng.randint(1, 99), rng.randint(1, 9))


def _at(tree, path):
    for key in path:
        tree = tree[key]
    return tree


def _replaced(tree, path, value):
    """Return the tree with the value at the path; what the path does not touch is shared."""
    if not path:
        return value
    key, *rest = path
    child = _replaced(tree[key], rest, value)
    if isinstance(tree, dict):
        return tree | {key: child}
    return type(tree)([*tree[:key], child, *tree[key + 1 :]])


def _separation(pair, rng):
    """Return the pair with a use, an output or a name to be avoided added, or a name of the certificate dropped."""
    statement, certificate = pair
    lines, listed = statement["lines"], certificate["reached"]
    names = sorted({name for name, _ in lines}.union(*(uses for _, uses in lines)))
    more, n, dropped = rng.choice(names), rng.randrange(len(lines)), rng.choice(listed)
    kind = rng.choice(["lines", "avoid", "outputs", "reached"])
    if kind == "reached":
        return statement, {"reached": [name for name in listed if name != dropped]}
    if kind == "lines":
        name, uses = lines[n]
        return statement | {"lines": [*lines[:n], [name, [*uses, more]], *lines[n + 1 :]]}, certificate
    return statement | {kind: [*statement[kind], more]}, certificate
