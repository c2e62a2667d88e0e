"""A claim as mathematics, with the chapter's letters, and points: {"normal_x": "0", …} becomes N = (0, 0, 1)."""

import re
from fractions import Fraction
from pkgutil import resolve_name

import mpmath
from docutils import nodes
from sympy import latex, sympify

from book.extension.elements import Nodes
from proofs.engine.project import PROJECT
from proofs.printers.tex import ClaimPrinter

TEX = {symbol.name: tex for symbol, tex in (resolve_name(PROJECT.tex) if PROJECT.tex else {}).items()}
PRINTER = ClaimPrinter(TEX)
rows, tex = PRINTER.rows, PRINTER.tex
EXPRESSION = re.compile(r"(?:pi|sqrt|[\d+\-*/() ])+")  # what a point may have beside rationals
LONG = 10**9  # numerators and denominators above are given to six digits


def tex_value(text: str) -> str:
    """Return a rational as it stands, one of many digits to six of them; roots and π typeset."""
    try:
        value = Fraction(text)
    except ValueError:
        if EXPRESSION.fullmatch(text):
            return latex(sympify(text))
        return rf"\texttt{{{text}}}".replace("_", r"\_")
    if max(abs(value.numerator), value.denominator) < LONG:
        return str(value)
    digits = mpmath.nstr(mpmath.mpf(value.numerator) / value.denominator, 6)
    mantissa, _, exponent = digits.partition("e")
    if not exponent:
        return mantissa + r"\ldots"
    front = "" if mantissa in ("1.0", "1") else rf"{mantissa.removesuffix('.0')}\cdot "
    return rf"{front}10^{{{int(exponent)}}}"


def tex_point(at: dict[str, str]) -> list[str]:
    """Return a point as equations in TeX, one a variable; three coordinates make one vector."""
    equations = []
    for name, value in at.items():
        stem, _, axis = name.rpartition("_")
        vector = [f"{stem}_{each}" for each in "xyz"]
        if name not in vector or not at.keys() >= {*vector}:
            equations.append(f"{PRINTER.name(name)} = {tex_value(value)}")
        elif axis == "x":
            letter = TEX[name].removesuffix("_x") if name in TEX else PRINTER.name(stem)
            equations.append(f"{letter} = ({', '.join(tex_value(at[each]) for each in vector)})")
    return equations


def point(at: dict) -> Nodes:
    """Return a point as mathematics, equation by equation; of a path, its name. Keys and values may be SymPy's."""
    at = {str(name): str(value) for name, value in at.items()}
    if "path" in at:
        return [nodes.literal("", at["path"])]
    equations = tex_point(at)
    tex = [f"{equation}," for equation in equations[:-1]] + equations[-1:]
    return [node for part in tex for node in (nodes.math("", part), nodes.Text(" "))][:-1]
