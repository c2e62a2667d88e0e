"""Claims of a theorem, before translation: SymPy relations over the lines of a straight-line program."""

from dataclasses import dataclass, replace
from typing import Any, Self

from sympy import Basic, Integer, Rational, Symbol, sympify
from sympy.core.relational import Eq, GreaterThan, StrictGreaterThan

from proofs.engine.program import Program, Some, chain, evaluated, flat, pairs, put


def equation(left: Basic | int, right: Basic | int) -> Basic:
    """Return left = right that SymPy leaves as it is, so that the kernel decides it.

    >>> from proofs.theorems.language import equation, real
    >>> x = real("x")
    >>> equation((x + 1) ** 2, x**2 + 2 * x + 1)
    Eq((x + 1)**2, x**2 + 2*x + 1)
    """
    return Eq(left, right, evaluate=False)


def greater(left: Basic | int, right: Basic | int) -> Basic:
    """Return left > right that SymPy leaves as it is, so that the kernel decides it.

    >>> from proofs.theorems.language import greater
    >>> greater(2, 1)
    2 > 1
    """
    return StrictGreaterThan(left, right, evaluate=False)


def at_least(left: Basic | int, right: Basic | int) -> Basic:
    """Return left ≥ right that SymPy leaves as it is, so that the kernel decides it.

    >>> from proofs.theorems.language import at_least, real
    >>> at_least(real("x") ** 2, 0)
    x**2 >= 0
    """
    return GreaterThan(left, right, evaluate=False)


@evaluated
def number(value: Basic | int | str) -> Basic:
    """Return SymPy's exact number for a range or a point: a decimal's fraction, the result of arithmetic.

    >>> from proofs.theorems.language import number
    >>> number("0.1"), number(3)
    (1/10, 3)
    """
    return Rational(value) if isinstance(value, str) else sympify(value, strict=True).doit()


def point(values: Any) -> tuple[tuple[Symbol, Basic], ...]:
    """Return ((symbol, exact number), …) of {symbol, or several: value of each, or values}, or of such pairs."""
    items = [(flat(symbols), value) for symbols, value in dict(values).items()]
    each = {symbols: value if isinstance(value, tuple | list) else [value] * len(symbols) for symbols, value in items}
    return tuple((symbol, number(value)) for symbol, value in pairs(each))


SEVERAL = {
    *("shows", "given", "squares", "cited", "outputs", "avoid"),  # of claims
    *("uses", "claims", "holds", "fails", "undefined", "mutants", "steps", "hypotheses", "side_conditions", "rounded"),
}
"""The fields that may be given as one thing or several (Some)."""


@dataclass(frozen=True)
class Parts:
    """The base of claims, theorems and their parts: each field of SEVERAL is a tuple once it is made."""

    cited = squares = ()  # for claims without them

    def __post_init__(self):
        put(self, **{name: flat(value) for name, value in vars(self).items() if name in SEVERAL})

    def but(self, **changes: Any) -> Self:
        """Return the same with some fields changed: how a mutant is made."""
        return replace(self, **changes)


@dataclass(frozen=True)
class CitedLemma(Parts):
    """A relation that is taken from a source, a key of the bibliography, and not proved here.

    A theorem that cites it is “proved, given the source”. given: the source's own conditions, all of them; a claim that
    cites it has to prove each, and samples test the relation under them alone.

    >>> from proofs.theorems.language import CitedLemma, at_least, real, sin
    >>> x = real("x")
    >>> CitedLemma(at_least(x, sin(x)), "NIST:DLMF", x >= 0).given
    (x >= 0,)
    """

    relation: Basic
    source: str
    given: Some = ()

    @property
    def text(self) -> str:
        """The relation as text, for the report."""
        return str(self.relation)


@dataclass(frozen=True)
class Claim(Parts):
    """A claim: for all real values of the inputs, if `given` holds, every relation of `shows` holds.

    shows: relations, in order; one that is proved may be used for the next. given: relations over the names of
    `lines` and further free symbols. lines: the program whose names the relations use. squares: polynomials whose
    squares the search may use in an inequality. cited: lemmas whose relations are used here. ranges: {symbol, or
    several: (low, high)} for sampling; once made, pairs.

    >>> from proofs.theorems.language import Claim, at_least, real
    >>> x, y = real("x y")
    >>> means = Claim("means", at_least(x**2 + y**2, 2 * x * y), ranges={(x, y): (-1, 1)})
    >>> means.shows, means.ranges
    ((x**2 + y**2 >= 2*x*y,), ((x, (-1, 1)), (y, (-1, 1))))
    >>> means.but(given=x > 0).given
    (x > 0,)
    """

    name: str
    shows: Some
    given: Some = ()
    lines: Program | None = None
    squares: Some = ()
    ranges: Any = ()
    cited: Some = ()

    def __post_init__(self):
        super().__post_init__()
        put(
            self,
            shows=tuple(sympify(relation, strict=True) for relation in self.shows),
            given=tuple(sympify(relation, strict=True) for relation in self.given),
            ranges=tuple(
                (s, tuple(map(number, ends))) for several, ends in dict(self.ranges).items() for s in flat(several)
            ),
        )

    def everywhere(self) -> list[Basic]:
        """Return the claim's other expressions: every line of its program, and symbols that have a range."""
        lines = (self.lines.definitions, self.lines.inputs) if self.lines else ()
        return [*flat(lines), *dict(self.ranges)]

    def names(self) -> tuple[set[Symbol], Program | None]:
        """Return the defined names that the claim needs, and the program kept to them (None without one)."""
        cited = [(lemma.relation, lemma.given) for lemma in self.cited]
        used = set().union(*(r.free_symbols for r in flat((self.shows, self.given, cited))))
        if self.lines is None:
            return used, None
        return used, self.lines.keep(*(s for s in dict(self.lines.definitions) if s in used))


@dataclass(frozen=True)
class Separation(Parts):
    """A claim of independence: in the program `lines`, none of `outputs` depends on any of `avoid`.

    >>> from proofs.theorems.language import Program, Separation, real
    >>> x, y, s, t = real("x y s t")
    >>> Separation("s_without_y", Program("sums", (x, y), {s: 2 * x, t: s + y}), s, y).outputs
    (s,)
    """

    name: str
    lines: Program
    outputs: Some
    avoid: Some


@dataclass(frozen=True)
class Induction(Parts):
    """A claim for every whole n ≥ 0: `shows`, equations over n, the parameters and the states of recurrences.

    states: (symbol, value at n = 0, value at n + 1 in terms of the values at n). cos and sin of n·α are states too, by
    the addition formulas. given: relations over the parameters.

    >>> from proofs.theorems.language import Induction, Symbol, equation, real
    >>> n, total = Symbol("n", integer=True, nonnegative=True), real("total")
    >>> odd = Induction("odd_numbers", n, equation(total, n**2), ((total, 0, total + 2 * n + 1),))
    >>> odd.of(2).lines.expand(odd.of(2).shows[0].lhs)
    4
    """

    name: str
    n: Symbol
    shows: Some
    states: tuple[tuple[Symbol, Basic, Basic], ...] = ()
    given: Some = ()

    def of(self, number: int) -> Claim:
        """Return the Claim for one number n: of the states after n steps from the start."""
        states: dict[Basic, Any] = {symbol: sympify(start) for symbol, start, _ in self.states}
        lines = []
        for before in range(number):
            now = states | {self.n: Integer(before)}
            states = {symbol: Symbol(f"{symbol}_{before + 1}", real=True) for symbol in states}
            lines += [{states[symbol]: sympify(following).xreplace(now) for symbol, _, following in self.states}]
        now = states | {self.n: Integer(number)}
        shows = [equation(*(side.xreplace(now) for side in shown.args)) for shown in self.shows]
        return Claim(self.name, shows, self.given, chain("states", *lines) if any(lines) else None)


@dataclass(frozen=True)
class Rounded(Parts):
    """A claim of accuracy: if `given` holds, a program in float64 is near its value in real numbers.

    program: one whose float64 operations are printed for Coq, which alone proves it. bounds: {output: how far it is
    off at most}. given: relations over the inputs, which are finite.

    >>> from proofs.theorems.language import Program, Rational, Rounded, real
    >>> x, y, s = real("x y s")
    >>> Rounded("sum", Program("sum", (x, y), {s: x + y}), {s: Rational(1, 2**53) * abs(x + y)}).bounds
    ((s, Abs(x + y)/9007199254740992),)
    """

    name: str
    program: Program
    bounds: Any
    given: Some = ()

    def __post_init__(self):
        super().__post_init__()
        put(self, bounds=pairs(self.bounds))


@dataclass(frozen=True)
class Encloses(Parts):
    """A claim of enclosure: if `given` holds, a rule of the enclosing machine bounds the error of its result.

    program: one of `proofs.formulas.enclosed`, whose rule is printed for Coq, which alone proves it. given: relations
    over its inputs, as NAME; over the counts of roundings that bound them, NAME_error; and over the exact numbers that
    they stand for, NAME_exact.

    >>> from proofs.theorems.language import Encloses, real
    >>> from proofs.formulas.enclosed import RULES
    >>> Encloses("root", RULES["enclosed_root"], real("x_exact") >= 0).given
    (x_exact >= 0,)
    """

    name: str
    program: Program
    given: Some = ()


AnyClaim = Claim | Separation | Induction
