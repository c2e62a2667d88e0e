"""Exact counterexamples: a rational point at which a claim's hypotheses hold and its conclusion does not."""

import re
from fractions import Fraction
from math import isqrt

from sympy import Expr, Symbol, cos, sin, sympify

from proofs.engine import kernel

CIRCLE = re.compile(r"(cos|sin)\((.*)\)")


class NotRational(ValueError):
    """The point gives no rational value to something that the claim needs."""


def rational_root(value):
    """Return √value of a Fraction, or raise NotRational."""
    if value >= 0:
        above, below = isqrt(value.numerator), isqrt(value.denominator)
        if above * above == value.numerator and below * below == value.denominator:
            return Fraction(above, below)
    raise NotRational(f"√({value}) is not rational")


def complete(statement, point):
    """Return the values {name: Fraction} of every name of a derivation at a point {symbol: exact value}.

    A cosine and a sine are those of their angle there, as SymPy has them in closed form: nobody chooses them.
    Raises NotRational where a value is irrational or a denominator is zero, KeyError where a name has no value.
    """
    if not all(symbol.is_Symbol for symbol in point):
        raise NotRational("only a symbol is a coordinate: π, say, is one number")
    at = {
        symbol.name: sympify(str(value)) if isinstance(value, Fraction) else sympify(value)
        for symbol, value in point.items()
    }
    values = {name: _rational(_coordinate(name, at)) for name in statement["variables"]}
    for step in statement["steps"]:
        if step["step"] not in ("root", "inverse", "define"):
            continue
        value = _evaluate(step["of"], values)
        if step["step"] == "inverse":
            if not value:
                raise NotRational(f"{step['new']} is the inverse of zero")
            value = 1 / value
        values[step["new"]] = rational_root(value) if step["step"] == "root" else value
    return values


def _coordinate(name: str, at: dict[str, Expr]) -> Expr:
    circle = CIRCLE.fullmatch(name)
    if circle is None:
        return at[name]
    angle = sympify(
        circle[2], locals={s: Symbol(s, real=True) for s in re.findall(r"[A-Za-z_]\w*", circle[2]) if s != "pi"}
    )
    return {"cos": cos, "sin": sin}[circle[1]](angle.subs({s: at[s.name] for s in angle.free_symbols}))


def _rational(value: Expr) -> Fraction:
    if not value.is_Rational:
        raise NotRational(f"{value} is not rational")
    return Fraction(value.p, value.q)


def _evaluate(data, values):
    return sum((value for value in [_term(t, c, values) for t, c in data.items()]), Fraction(0))


def _term(text, coefficient, values):
    product = Fraction(coefficient)
    for factor in text.split():
        name, _, power = factor.partition("^")
        product *= values[name] ** int(power or 1)
    return product


def refutation(statements: list[dict], point: dict) -> tuple[dict, dict] | None:
    """Return (statement, certificate) of kind "refutation" that the kernel accepts, or None.

    statements: a claim's derivations. point: {symbol: exact value} of the inputs, angles too.
    The statement ends with the first conclusion that fails.
    """
    for statement in statements:
        try:
            values = complete(statement, point)
        except (NotRational, KeyError):
            continue
        for end, step in enumerate(statement["steps"], 1):
            if step["step"] != "show":
                continue
            refuted = statement | {"kind": "refutation", "steps": statement["steps"][:end]}
            defined = {s["new"] for s in refuted["steps"] if s["step"] == "define"}
            declared = {s["new"] for s in refuted["steps"] if "new" in s} | set(statement["variables"])
            kept = {n: str(v) for n, v in sorted(values.items()) if n in declared - defined}
            if kernel.check(refuted, {"point": kept}) is None:
                return refuted, {"point": kept}
    return None
