"""The height fields h(u, v). A field is its expression: add an entry here, and its gradient, its creases, its kernels,
the scene's and the command line's choices and the book's tables follow from it.
"""

from dataclasses import dataclass
from functools import cached_property
from itertools import combinations, product
from typing import Any

from mpmath import iv, mpmathify, workdps
from sympy import (
    Abs,
    Dummy,
    Expr,
    Function,
    Heaviside,
    Max,
    Min,
    Mul,
    Piecewise,
    Rational,
    S,
    diff,
    floor,
    ordered,
    sign,
    sqrt,
)
from sympy.core.relational import Relational

from proofs.engine.half_turns import cospi, sinpi
from proofs.engine.program import Program, evaluated
from proofs.engine.registry import by_name, check_name, not_allowed
from proofs.engine.vectors import real
from proofs.formulas.ranges import DIGITS, enclosure, values_of
from proofs.formulas.symbols import h, h_u, h_v, k_u, k_v, u, v

sin_u, cos_u, sin_v, cos_v = real("sin_u cos_u sin_v cos_v")
IN_CHART = (u, v, k_u, k_v)
CHART = dict.fromkeys((u, v), iv.mpf([0, 1])) | dict.fromkeys((k_u, k_v), iv.mpf([-64, 64]))
"""Where an entry and its slopes have to be finite: the chart, and wave numbers up to `MAX_WAVE_NUMBER`."""
PERIODIC = [
    {v: Rational(number % 6 + 1, 7), k_u: even, k_v: whole}
    for number, (even, whole) in enumerate(product((2, 4, -6), (1, 2, -3)))
]
"""Points at which an entry's height at u = 1 has to be that at u = 0, unless it has a seam: k_u is even, k_v whole."""


_CHOICES = (Abs, sign, Max, Min, Piecewise, floor)


def _zeros_and_values(choice):
    """Return (the expressions at whose zeros a choice changes, the values that it chooses from)."""
    first, *_ = values = choice.args
    match choice:
        case Piecewise():
            relations = {relation for _, condition in values for relation in condition.atoms(Relational)}
            return [relation.lhs - relation.rhs for relation in relations], [value for value, _ in values]
        case Max() | Min():
            return [one - other for one, other in combinations(values, 2)], values
        case floor():
            return [sinpi(first)], ((whole := Dummy(real=True)), whole + 1)
    return [first], (first, -first) if isinstance(choice, Abs) else (S.One, S.NegativeOne)


class _Size(Function):
    """|x| of a real x: SymPy's own slope of it is long where it does not know that x is real."""

    is_real = True

    def fdiff(self, argindex: int = 1) -> Expr:
        return sign(self.args[0])


@dataclass(frozen=True)
class HeightField:
    """A height field, by its expression, from which all the rest is derived.

    name: identifier. expression: h in u, v, k_u, k_v. seam: whether h may differ at u = 0 and u = 1 where k_u is even
    and k_v whole. Raises ValueError where the name or the expression is not allowed.

    >>> from proofs.formulas.height_fields import HeightField, k_u, sinpi, u
    >>> waves = HeightField("waves", abs(sinpi(k_u * u)))
    >>> waves.creases, waves.depends_on_u
    ((sinpi(k_u*u),), True)
    >>> HeightField("slope", u)
    Traceback (most recent call last):
    ValueError: expression = u is not allowed: it is 0 at u = 0 and 1 at u = 1, ...
    """

    name: str
    expression: Expr
    seam: bool = False

    @evaluated
    def __post_init__(self):
        check_name(self.name)
        if not isinstance(self.expression, Expr):
            raise self._refused("an expression of SymPy")
        try:
            self.largest()
        except ValueError as error:
            raise self._refused(f"{error}") from None
        if not self.seam:
            self._check_ends()

    @workdps(DIGITS)
    def _check_ends(self):
        value = values_of(self.expression, (u, *PERIODIC[0]))
        for at in PERIODIC:
            first, last = (float(value(*map(mpmathify, (end, *at.values())))) for end in (0, 1))
            if not abs(first - last) < 1e-12:
                raise self._refused(
                    f"it is {first:.3g} at u = 0 and {last:.3g} at u = 1, {at}, without seam=True: "
                    "let u stand in sines and cosines of 2*pi*u, 4*pi*u and so on, or give seam=True"
                )

    def largest(self, ku: Any = CHART[k_u], kv: Any = CHART[k_v]) -> list[float]:
        """Return upper bounds of |h|, |∂h/∂u| and |∂h/∂v|, at wave numbers or in intervals of them.

        Raises ValueError where they are not shown to be finite.
        """
        box = CHART | {k_u: iv.mpf(ku), k_v: iv.mpf(kv)}
        return [float(abs(enclosure(formula, box)).b) for formula in (self.expression, *self.gradient())]

    def __str__(self):
        return self.name

    def _refused(self, why):
        return not_allowed("expression", self.expression, why)

    def at(self, at_u: Expr, at_v: Expr) -> Expr:
        """Return h at another place of the chart."""
        return self.expression.xreplace({u: at_u, v: at_v})

    def gradient(self) -> tuple[Expr, Expr]:
        """Return (∂h/∂u, ∂h/∂v) by differentiation; valid off the creases, with sign 0 = 0 on them."""
        return self._slopes

    @cached_property
    @evaluated
    def _slopes(self):
        levels = {level: Dummy(real=True) for level in self.expression.atoms(sign, floor)}
        put_back = {fixed: level for level, fixed in levels.items()}
        sizes = self.expression.xreplace(levels).replace(Abs, _Size)
        slopes = (diff(sizes, c).replace(_Size, Abs).xreplace(put_back) for c in (u, v))
        return tuple(slope.replace(Heaviside, lambda x, _: (1 + sign(x)) / 2) for slope in slopes)

    @property
    def depends_on_u(self) -> bool:
        """True if h depends on u."""
        return self.expression.has(u)

    @cached_property
    @evaluated
    def creases(self) -> tuple[Expr, ...]:
        """The factors at whose zeros a slope of h, or h itself, may jump: those of its choices, and sinpi(w) of ⌊w⌋.

        One is left out that is not 0 on the chart, or that is squared in what a choice changes: the slopes agree there.
        """
        expression = self.expression.replace(cospi, lambda w: sinpi(w + Rational(1, 2)))
        marks = {choice: Dummy(real=True) for choice in ordered(expression.atoms(*_CHOICES))}
        flat = {choice: mark for choice, mark in marks.items() if isinstance(choice, floor | sign)}
        marked, jumping = expression.xreplace(marks), []
        for choice, mark in marks.items():
            zeros, values = _zeros_and_values(choice)
            factors = {part.as_base_exp()[0] for zero in zeros for part in Mul.make_args(zero)}
            for sides in combinations([value.xreplace(marks) for value in values], 2):
                one, other = (marked.xreplace({mark: side}) for side in sides)
                powers = (one - other).as_powers_dict()  # 1 - 1, of a choice in another, of which nothing is known
                for factor in ordered(factors):
                    squared = max(powers[side * factor.xreplace(marks)] for side in (1, -1)) >= 2
                    if not squared and factor.xreplace(flat).has(u, v) and 0 in enclosure(factor, CHART):
                        jumping.append(factor)
        return tuple(dict.fromkeys(jumping))

    @cached_property
    @evaluated
    def wave_numbers(self) -> tuple[Expr, Expr] | None:
        """(a, b) if h depends on u and v through the sine and cosine of πa u and πb v alone, else None.

        0 where it does not depend on that coordinate. A field that has them has the algebraic form.
        """
        waves = self.expression.atoms(sinpi, cospi)
        rates = [{wave.args[0] / c for wave in waves if wave.has(c)} for c in (u, v)]
        if self.expression.xreplace({wave: Dummy() for wave in waves}).has(u, v) or max(map(len, rates)) > 1:
            return None
        numbers = tuple(rate.pop() if rate else S.Zero for rate in rates)
        return None if any(rate.has(u, v) for rate in numbers) else numbers


class AnyField(HeightField):
    """A field of which nothing is known: its expression may call a function that stands for any."""

    def __post_init__(self):
        pass


ANY_FIELD = AnyField("any", Function("height")(u, v, k_u, k_v))
_product = sinpi(k_u * u) * sinpi(k_v * v)

HEIGHT_FIELDS: dict[str, HeightField] = by_name((
    HeightField("sine", _product),
    HeightField("ridges", Abs(_product)),
    HeightField("rings", sinpi(2 * k_v * v)),
))  # fmt: skip
"""sine: sin(πk_u u) sin(πk_v v). ridges: its absolute value, creased along u = m/k_u and v = m/k_v.
rings: sin(2πk_v v). Domain: u ∈ [0, 1), v ∈ [0, 1], real k_u and k_v. Source: seed, §2."""


@evaluated
def _named_factors(field):
    """Return {trigonometric factor: its name} for a field with an algebraic form."""
    named = ((u, sin_u, cos_u), (v, sin_v, cos_v))
    waves = [(rate * c, *names) for rate, (c, *names) in zip(field.wave_numbers, named, strict=True) if rate != 0]
    return {f(w): name for w, *names in waves for f, name in zip((sinpi, cospi), names, strict=True)}


def height(field: HeightField) -> Program:
    """Return the program (u, v, k_u, k_v) → h."""
    return Program(f"height_{field.name}", IN_CHART, {h: field.expression})


@evaluated
def factors(field: HeightField) -> Program:
    """Return the program (u, v, k_u, k_v) → the field's trigonometric factors, by name."""
    lines = {name: factor for factor, name in sorted(_named_factors(field).items(), key=lambda p: str(p[1]))}
    return Program(f"factors_{field.name}", IN_CHART, lines, tuple(lines))


@evaluated
def gradient_from_factors(field: HeightField) -> Program:
    """Return the program (factors, k_u, k_v) → h_u, h_v: the derivative with its factors named."""
    slopes = tuple(derivative.subs(_named_factors(field)) for derivative in field.gradient())
    inputs = (sin_u, cos_u, sin_v, cos_v, k_u, k_v)
    return Program(f"gradient_from_factors_{field.name}", inputs, {(h_u, h_v): slopes})


@evaluated
def gradient(field: HeightField) -> Program:
    """Return the program (u, v, k_u, k_v) → h_u, h_v: the general exact gradient, any real k_u and k_v."""
    lines = [((h_u, h_v), field.gradient())]
    if field.wave_numbers is not None:
        lines = [*factors(field).definitions, *gradient_from_factors(field).definitions]
    return Program(f"gradient_{field.name}", IN_CHART, lines, (h_u, h_v))


slope = Program("slope", (h_u, h_v), {real("slope"): sqrt(h_u**2 + h_v**2)})
"""|∇h| = √(h_u² + h_v²), in the chart."""
