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
    DiracDelta,
    Dummy,
    Expr,
    Function,
    Heaviside,
    Mul,
    Piecewise,
    Rational,
    S,
    cancel,
    denom,
    diff,
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


def _is_straight(factor):
    return isinstance(factor, sinpi) and not any(diff(factor.args[0], c).has(u, v) for c in (u, v))


@dataclass(frozen=True)
class HeightField:
    """A height field, by its expression, from which all the rest is derived.

    name: identifier. expression: h in u, v, k_u, k_v. seam: whether h may differ at u = 0 and u = 1 where k_u is even
    and k_v whole. Raises ValueError where the name or the expression is not allowed, or the creases are not known.

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
        self.creases  # noqa: B018  (refused where they are not known)

    @workdps(DIGITS)
    def _check_ends(self):
        value = values_of(self.expression, (u, *PERIODIC[0]))
        for at in PERIODIC:
            first, last = (float(value(*map(mpmathify, (end, *at.values())))) for end in (0, 1))
            if not abs(first - last) < 1e-12:
                raise self._refused(f"it is {first:.3g} at u = 0 and {last:.3g} at u = 1, {at}, without seam=True")

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

    @evaluated
    def gradient(self) -> tuple[Expr, Expr]:
        """Return (∂h/∂u, ∂h/∂v) by differentiation; valid off the creases, with sign 0 = 0 on them."""
        slopes = (diff(self.expression, coordinate) for coordinate in (u, v))
        without_jumps = (slope.replace(DiracDelta, lambda *_: S.Zero) for slope in slopes)
        return tuple(s.replace(Heaviside, lambda x, _: (1 + sign(x)) / 2) for s in without_jumps)

    @property
    def depends_on_u(self) -> bool:
        """True if h depends on u."""
        return self.expression.has(u)

    @cached_property
    @evaluated
    def creases(self) -> tuple[Expr, ...]:
        """The factors sinpi(w), w linear in u and v, at whose zeros a slope of h jumps, or h itself.

        Raises ValueError where one may jump elsewhere.
        """
        piecewise = self.expression.replace(cospi, lambda w: sinpi(w + Rational(1, 2))).rewrite(Piecewise)
        jumping = []
        for choice in ordered(piecewise.atoms(Piecewise)):
            zeros = {relation.lhs - relation.rhs for relation in choice.atoms(Relational)}
            factors = {part.as_base_exp()[0] for zero in zeros for part in Mul.make_args(zero)}
            for (one, _), (other, _) in combinations(choice.args, 2):
                apart = piecewise.xreplace({choice: one}) - piecewise.xreplace({choice: other})
                jumps = [f for f in ordered(factors) if denom(cancel(apart / f**2)).has(u, v)]  # elsewhere slopes agree
                if jumps and (len(zeros) > 1 or apart.has(Piecewise) or not all(map(_is_straight, jumps))):
                    allowed = "creases have to be where sinpi or cospi of a u + b v + c is 0, whatever else holds"
                    raise self._refused(f"{allowed}; one may be where {jumps[0]} = 0")
                jumping += jumps
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
