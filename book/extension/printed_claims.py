"""A claim as mathematics, printed from the object that the kernel checks: what is given, its lines, what it shows."""

import re
from collections.abc import Iterator
from typing import NamedTuple

from sympy import Basic, Mul, Pow, Symbol
from sympy.printing.latex import LatexPrinter

from book.extension.points import tex_name
from proofs.engine.claim import AnyClaim, Claim, Encloses, Induction, Rounded, Separation

MOST = Mul(Symbol("n"), Pow(2, -53, evaluate=False), evaluate=False)


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


DIGIT = re.compile(r"(?<!cases)([)}]|\\pi) (?=\d)")  # a factor that begins with one, but the first of a list of cases
OVER = re.compile(r"\\frac\{(\w+)\}\{(\d{5,})\}")


def tex(term: Basic | int) -> str:
    """A term in TeX; a dot stands before a number in a product, and what is over a large power of 2 is times it."""
    return DIGIT.sub(r"\1 \\cdot ", OVER.sub(_times, ClaimPrinter().doprint(term)))


def _times(fraction):
    count, whole = fraction[1], int(fraction[2])
    if whole & (whole - 1):
        return fraction[0]
    return ("" if count == "1" else rf"{count} \cdot ") + f"2^{{-{whole.bit_length() - 1}}}"


def rows(claim: AnyClaim | Rounded | Encloses, by_definition: tuple[str, ...] = (), refuted: bool = False) -> list[Row]:
    """A claim's rows: lines and states, what is given, what is cited, and what it shows.

    by_definition: relations, as text, that say nothing. refuted: what is shown is what a counterexample denies.
    """
    if isinstance(claim, Separation):
        of, avoided = (", ".join(map(tex, symbols)) for symbols in (claim.outputs, claim.avoid))
        return [Row("of", of), Row("none reads", avoided)]
    shown = "false" if refuted else "shows"
    if isinstance(claim, Rounded | Encloses):
        given = [Row("given", tex(relation)) for relation in claim.given]
        kernel, lines, bounds = claim.program.name, [], getattr(claim, "bounds", ())
        if isinstance(claim, Encloses):  # by a count of roundings, n
            lines = [Row("let", rf"{tex(s)} := {tex(line)}") for s, line in claim.program.definitions]
            bounds = [(s, MOST) for s in claim.program.outputs]
        within = [Row(shown, rf"\lvert \mathrm{{fl}}({tex(s)}) - {tex(s)} \rvert \leq {tex(e)}") for s, e in bounds]
        return [Row("in float64", tex_name(kernel)), *lines, *given, *within]
    return [
        *(_lines(claim) if isinstance(claim, Claim) else _states(claim)),
        *(Row("given", tex(relation)) for relation in claim.given),
        *(Row("by definition" if str(relation) in by_definition else shown, tex(relation)) for relation in claim.shows),
    ]


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
