"""A claim as mathematics, printed from the object that the kernel checks: what is given, its lines, what it shows.

And points as the reader sees them: {"normal_x": "0", …} becomes N = (0, 0, 1).
"""

import re
from collections.abc import Iterator
from fractions import Fraction
from pkgutil import resolve_name
from typing import NamedTuple

import mpmath
from docutils import nodes
from sympy import Basic, Mul, Pow, Symbol, latex, sympify
from sympy.printing.latex import LatexPrinter

from book.extension.elements import Nodes
from proofs.engine.claim import AnyClaim, Claim, Encloses, Induction, Rounded, Separation
from proofs.engine.project import PROJECT

TEX = {symbol.name: tex for symbol, tex in (resolve_name(PROJECT.tex) if PROJECT.tex else {}).items()}
EXPRESSION = re.compile(r"(?:pi|sqrt|[\d+\-*/() ])+")  # what a point may have beside rationals
LONG = 10**9  # numerators and denominators above are given to six digits
MOST = Mul(Symbol("n"), Pow(2, -53, evaluate=False), evaluate=False)


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


class Row(NamedTuple):
    """A line of a printed claim: what it is to the claim, and itself in TeX."""

    role: str
    tex: str


class ClaimPrinter(LatexPrinter):
    """Prints a term as its file writes it: no sum or product is put in another order."""

    def __init__(self):
        super().__init__({"order": "none", "inv_trig_style": "full"})

    def _print_Symbol(self, symbol):
        name = tex_name(symbol.name)
        return f"({name})" if name.startswith((r"\cos", r"\sin")) else name

    def _print_Integer(self, number):
        power = int(number).bit_length() - 1
        return f"2^{{{power}}}" if power > 16 and number == 2**power else str(number)


DIGIT = re.compile(r"(?<!cases)([)}]|\\pi) (?=\d)")  # a factor that begins with one, but the first of a list of cases


def tex(term: Basic | int) -> str:
    """A term in TeX; a dot stands before a number in a product."""
    return DIGIT.sub(r"\1 \\cdot ", ClaimPrinter().doprint(term))


def rows(claim: AnyClaim | Rounded | Encloses, by_definition: tuple[str, ...] = (), refuted: bool = False) -> list[Row]:
    """A claim's rows: lines and states, what is given, what is cited, and what it shows.

    by_definition: relations, as text, that say nothing. refuted: what is shown is what a counterexample denies.
    """
    shown = "false" if refuted else "shows"
    if isinstance(claim, Separation):
        return [
            Row(said, ", ".join(map(tex, some))) for said, some in (("of", claim.outputs), ("none reads", claim.avoid))
        ]
    given = [Row("given", tex(relation)) for relation in claim.given]
    if isinstance(claim, Rounded | Encloses):
        program, lines, bounds = claim.program, [], getattr(claim, "bounds", ())
        if isinstance(claim, Encloses):  # by a count of roundings, n
            lines = [Row("let", rf"{tex(s)} := {tex(line)}") for s, line in program.definitions]
            bounds = [(s, MOST) for s in program.outputs]
        within = [Row(shown, rf"\lvert \mathrm{{fl}}({tex(s)}) - {tex(s)} \rvert \leq {tex(e)}") for s, e in bounds]
        return [Row("in float64", tex_name(program.name)), *lines, *given, *within]
    said = [Row("by definition" if str(each) in by_definition else shown, tex(each)) for each in claim.shows]
    return [*(_lines(claim) if isinstance(claim, Claim) else _states(claim)), *given, *said]


def _lines(claim: Claim) -> Iterator[Row]:
    _, program = claim.names()
    for symbol, line in program.definitions if program else ():
        yield Row("let", rf"{tex(symbol)} := {tex(line)}")
    for id, name in claim.borrowed:
        yield Row("from", rf"\text{{{id}: {name}}}".replace("_", r"\_"))
    for lemma in claim.cited:
        yield Row("cited", tex(lemma.relation))


def _states(claim: Induction) -> Iterator[Row]:
    yield Row("for", rf"{tex(claim.n)} = 0, 1, 2, \ldots")
    for state, start, following in claim.states:
        yield Row("state", rf"{tex(state)} = {tex(start)},\quad {tex(state)} \leftarrow {tex(following)}")


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
    equations = []
    for name, value in at.items():
        stem, _, axis = name.rpartition("_")
        vector = [f"{stem}_{each}" for each in "xyz"]
        if name not in vector or not at.keys() >= {*vector}:
            equations.append(f"{tex_name(name)} = {tex_value(value)}")
        elif axis == "x":
            letter = TEX[name].removesuffix("_x") if name in TEX else tex_name(stem)
            equations.append(f"{letter} = ({', '.join(tex_value(at[each]) for each in vector)})")
    return equations


def point(at: dict) -> Nodes:
    """A point as mathematics, one equation after the other; of a path, its name. Keys and values may be SymPy's."""
    at = {str(name): str(value) for name, value in at.items()}
    if "path" in at:
        return [nodes.literal("", at["path"])]
    equations = tex_point(at)
    tex = [f"{equation}," for equation in equations[:-1]] + equations[-1:]
    return [node for part in tex for node in (nodes.math("", part), nodes.Text(" "))][:-1]
