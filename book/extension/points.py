"""Points as the reader sees them: {"normal_x": "0", …} becomes N = (0, 0, 1)."""

import re
from fractions import Fraction

import mpmath
from docutils import nodes
from sympy import Symbol, latex, sympify

from proofs.formulas.symbols import TEX_NAMES

TEX = {symbol.name: tex for symbol, tex in TEX_NAMES.items()}
EXPRESSION = re.compile(r"(?:pi|sqrt|[\d+\-*/() ])+")  # what a point may have beside rationals
LONG = 10**9  # numerators and denominators above are given to six digits


def tex_name(name: str) -> str:
    """A symbol's name in TeX: the chapter's letter, a letter with an index, or a word, upright."""
    if name in TEX:
        return TEX[name]
    base, _, index = name.partition("_")
    if not name.isidentifier() or (_is_word(base) and len(index) > 1):
        return rf"\mathrm{{{name}}}".replace("_", r"\_")
    letter, *below = [
        rf"\mathrm{{{part}}}" if _is_word(part) else latex(Symbol(part)) for part in (base, index) if part
    ]
    return letter + "".join(f"_{{{part}}}" for part in below)


def _is_word(part):
    return len(part) > 1 and "_" not in part and latex(Symbol(part)) == part


def tex_value(text: str) -> str:
    """A rational as it stands, one of many digits to six of them; roots and π typeset."""
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
    """Equations in TeX, one a variable; three coordinates make one vector."""
    left, equations = dict(at), []
    for name, value in at.items():
        if name not in left:
            continue
        base = re.sub(r"_x$", "", name)
        names = [f"{base}_{axis}" for axis in "xyz"]
        if base != name and all(n in left for n in names):
            values = ", ".join(tex_value(left.pop(n)) for n in names)
            vector = re.sub("_x$", "", TEX[name]) if name in TEX else tex_name(base)
            equations.append(f"{vector} = ({values})")
        else:
            equations.append(f"{tex_name(name)} = {tex_value(left.pop(name) and value)}")
    return equations


def point(at: dict) -> list[nodes.Node]:
    """A point as mathematics, one equation after the other; of a path, its name. Keys and values may be SymPy's."""
    at = {str(name): str(value) for name, value in at.items()}
    if "path" in at:
        return [nodes.literal("", at["path"])]
    equations = tex_point(at)
    tex = [f"{equation}," for equation in equations[:-1]] + equations[-1:]
    return [node for part in tex for node in (nodes.math("", part), nodes.Text(" "))][:-1]
