"""Exact counterexamples: a rational point at which a claim's hypotheses hold and its conclusion does not."""

import re
from collections.abc import Mapping
from fractions import Fraction
from math import isqrt

from sympy import Expr, Symbol, cos, sin, sympify

from proofs.engine import kernel

CIRCLE = re.compile(r"(cos|sin)\((.*)\)")


class NotRational(ValueError):
    """The error that at a point an expression has no rational value, or a hypothesis fails."""


def rational_root(value: Fraction) -> Fraction:
    """Return √value of a Fraction, or raise NotRational."""
    if value >= 0:
        root = Fraction(isqrt(value.numerator), isqrt(value.denominator))
        if root * root == value:
            return root
    raise NotRational(f"√({value}) is not rational")


def refutation(statements: list[dict], point: Mapping[Symbol, Expr | Fraction | int]) -> tuple[dict, dict] | None:
    """Return (statement, certificate) of kind "refutation" that the kernel accepts, or None.

    statements: derivations, whose last goal is to fail; their other goals, under which expressions have a value, are to
    hold. point: {symbol: exact value} of the inputs, angles too. Only a symbol is a coordinate: π is one number.
    """
    if not all(symbol.is_Symbol for symbol in point):
        return None
    at = {symbol.name: sympify(str(value)) for symbol, value in point.items()}
    for statement in statements:
        try:
            values = _complete(statement, at)
        except (ValueError, KeyError, ZeroDivisionError):
            continue
        refuted = statement | {"kind": "refutation"}
        new = {s["new"] for s in refuted["steps"] if s["step"] in ("root", "inverse")}
        names = new.union(statement["variables"])
        certificate = {"point": {n: str(v) for n, v in sorted(values.items()) if n in names}}
        if kernel.check(refuted, certificate) is None:
            return refuted, certificate
    return None


def _complete(statement, at):
    """Return the values {name: Fraction} of every name of a derivation; KeyError where a name has none.

    A defined name has the value of its definition, not one of `at`.
    """
    defined = {step.get("new") for step in statement["steps"]}
    at = {name: value for name, value in at.items() if name not in defined}
    values = {name: _coordinate(name, at) for name in statement["variables"]}
    for step in statement["steps"]:
        if "new" in step:
            numbers = {name: kernel.multiply(value) for name, value in values.items()}
            value = Fraction(kernel.read(step["of"], numbers).get((), 0))
            values[step["new"]] = {"root": rational_root, "inverse": lambda p: 1 / p}.get(step["step"], Fraction)(value)
    return values


def _coordinate(name, at):
    """Return a name's value at the point; that of a cosine or a sine is computed from its angle."""
    value = at.get(name)
    if circle := CIRCLE.fullmatch(name):
        symbols = {s: Symbol(s, real=True) for s in re.findall(r"[A-Za-z_]\w*", circle[2]) if s != "pi"}
        angle = sympify(circle[2], locals=symbols)
        value = {"cos": cos, "sin": sin}[circle[1]](angle.subs({s: at[s.name] for s in angle.free_symbols}))
    if value is None or not value.is_Rational:
        raise NotRational(f"{name} is {value}")
    return Fraction(str(value))
