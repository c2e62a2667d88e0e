"""Exact counterexamples: a rational point at which a claim's hypotheses hold and its conclusion does not."""

import re
from collections.abc import Mapping
from fractions import Fraction

from sympy import Expr, Symbol, cos, sin, sympify

from proofs.engine import kernel
from proofs.engine.points import NotRational, rational_root

CIRCLE = re.compile(r"(cos|sin)\((.*)\)")


def complete(statement: dict, point: Mapping[Symbol, Expr | Fraction | int]) -> dict[str, Fraction]:
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
    for step in (step for step in statement["steps"] if "new" in step):
        numbers = {name: kernel.multiply(value) for name, value in values.items()}
        value = Fraction(kernel.read(step["of"], numbers).get((), 0))
        if step["step"] == "inverse" and not value:
            raise NotRational(f"{step['new']} is the inverse of zero")
        values[step["new"]] = {"root": rational_root, "inverse": lambda p: 1 / p}.get(step["step"], Fraction)(value)
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
