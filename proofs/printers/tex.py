"""Printer of claims as TeX, from the object that the kernel checks: its lines, hypotheses and conclusions."""

import re
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from sympy import Basic, Mul, Pow, Symbol, latex
from sympy.printing.latex import LatexPrinter

from proofs.engine.claim import AnyClaim, Claim, Encloses, Induction, Rounded, Separation

MOST = Mul(Symbol("n"), Pow(2, -53, evaluate=False), evaluate=False)
DIGIT = re.compile(r"(?<!cases)([)}]|\\pi) (?=\d)")  # a factor that begins with one, but the first of a list of cases


class Row(NamedTuple):
    """A line of a printed claim: its role, and its TeX."""

    role: str
    tex: str


class ClaimPrinter(LatexPrinter):
    """A printer of a term as its file writes it: no sum or product is put in another order.

    names: {symbol's name: its TeX} of those that a chapter has a letter for.
    """

    def __init__(self, names: Mapping[str, str]):
        super().__init__({"order": "none", "inv_trig_style": "full"})
        self.names = names

    def name(self, name: str) -> str:
        """Return a symbol's name in TeX: the chapter's letter, a letter with an index, or a word, upright."""
        if name in self.names:
            return self.names[name]
        base, _, index = name.partition("_")
        if not name.isidentifier() or (_is_word(base) and len(index) > 1):
            return rf"\mathrm{{{name}}}".replace("_", r"\_")
        letter, *below = [
            rf"\mathrm{{{part}}}" if _is_word(part) else latex(Symbol(part)) for part in (base, index) if part
        ]
        return letter + "".join(f"_{{{part}}}" for part in below)

    def _print_Symbol(self, symbol):
        name = self.name(symbol.name)
        return f"({name})" if name.startswith((r"\cos", r"\sin")) else name

    def _print_Integer(self, number):
        power = int(number).bit_length() - 1
        return f"2^{{{power}}}" if power > 16 and number == 2**power else str(number)

    def tex(self, term: Basic | int) -> str:
        """Return a term in TeX; a dot stands before a number in a product."""
        return DIGIT.sub(r"\1 \\cdot ", self.doprint(term))

    def rows(self, claim: AnyClaim | Rounded | Encloses, refuted: bool = False) -> list[Row]:
        """Return a claim's rows: lines and states, hypotheses, cited lemmas, and conclusions.

        refuted: a counterexample denies the conclusion.
        """
        shown, tex = "false" if refuted else "shows", self.tex
        if isinstance(claim, Separation):
            parts = ("of", claim.outputs), ("none reads", claim.avoid)
            return [Row(role, ", ".join(map(tex, symbols))) for role, symbols in parts]
        given = [Row("given", tex(relation)) for relation in claim.given]
        if isinstance(claim, Rounded | Encloses):
            program, lines, bounds = claim.program, [], getattr(claim, "bounds", ())
            if isinstance(claim, Encloses):  # by a count of roundings, n
                lines = [Row("let", rf"{tex(s)} := {tex(line)}") for s, line in program.definitions]
                bounds = [(s, MOST) for s in program.outputs]
            within = [Row(shown, rf"\lvert \mathrm{{fl}}({tex(s)}) - {tex(s)} \rvert \leq {tex(e)}") for s, e in bounds]
            return [Row("in float64", self.name(program.name)), *lines, *given, *within]
        last = [Row(shown, tex(each)) for each in claim.shows]
        return [*(self._lines(claim) if isinstance(claim, Claim) else self._states(claim)), *given, *last]

    def _lines(self, claim: Claim) -> Iterator[Row]:
        _, program = claim.names()
        for symbol, line in program.definitions if program else ():
            yield Row("let", rf"{self.tex(symbol)} := {self.tex(line)}")
        for lemma in claim.cited:
            yield Row("cited", self.tex(lemma.relation))

    def _states(self, claim: Induction) -> Iterator[Row]:
        yield Row("for", rf"{self.tex(claim.n)} = 0, 1, 2, \ldots")
        for state, start, following in claim.states:
            name = self.tex(state)
            yield Row("state", rf"{name} = {self.tex(start)},\quad {name} \leftarrow {self.tex(following)}")


def _is_word(part):
    return len(part) > 1 and "_" not in part and latex(Symbol(part)) == part
