"""The truncation error of the central difference of the smooth fields, with its constant."""

from sympy import Rational, Symbol, cos, diff, pi, sin

from proofs.engine.claim import Claim, at_least, equation, greater
from proofs.engine.theorem import Edge, Mutant, SideCondition, Step, Theorem
from proofs.formulas.difference_cases import nothing_clamps, nothing_wraps
from proofs.formulas.symbols import epsilon, h_u, h_v, k_u, k_v, u, v
from proofs.theorems.cited import sine_above, sine_below
from proofs.theorems.finite_difference import difference, rings, sine

_cos_u, _sin_u, _cos_v, _sin_v = (
    Symbol(str(f).replace(" ", ""), real=True) for w in (pi * k_u * u, pi * k_v * v) for f in (cos(w), sin(w))
)
_sixth = Rational(1, 6)
_squares = {"sine": (_cos_u - _sin_v, _cos_u + _sin_v, _sin_u, _cos_v), "rings": ()}


def _bounded(name, field, output, frequency, given, factors, constant=_sixth):
    """Return the claim |D − slope| ≤ constant · ε² (π frequency)³; slope = π frequency · factors."""
    coordinate = {h_u: u, h_v: v}[output]
    slope, third = (diff(field.expression, coordinate, n) for n in (1, 3))
    rate, angle = pi * frequency, pi * frequency * epsilon
    error, bound = difference(field, output) - slope, constant * epsilon**2 * rate**3
    shows = (
        at_least(1 - factors, 0),
        at_least(1 + factors, 0),
        greater(rate, 0),
        greater(rate**3, 0),
        equation(third, -(rate**3) * factors),
        at_least(rate**3 - third, 0),
        at_least(rate**3 + third, 0),
        equation(epsilon * error, factors * (sin(angle) - angle)),
        *(at_least(epsilon * (bound + s * error), 0) for s in (1, -1)),
        *(at_least(bound + s * error, 0) for s in (1, -1)),
    )
    lemmas = (sine_below(angle), sine_above(angle))
    (k,) = frequency.free_symbols
    step, sine_of_step = (Rational(13, 30), Rational(24, 25)) if k == k_u else (Rational(13, 60), Rational(3, 5))
    example = ((coordinate, Rational(1, 2)), (k, 1), (epsilon, step), (sin(pi * k * epsilon), sine_of_step))
    return Claim(name, shows, (*given, k > 0), squares=_squares[field.name], cited=lemmas, example=example)


_u = _bounded("sine", sine, h_u, k_u, nothing_wraps, cos(pi * k_u * u) * sin(pi * k_v * v))
_rings = _bounded("rings", rings, h_v, 2 * k_v, nothing_clamps, cos(2 * pi * k_v * v))
_at_eight = Claim("at_eight", (greater((8 * pi) ** 3, 24**3), greater(24**3, 6 * 2000)))
_at_four = Claim("at_four", (greater((4 * pi) ** 3, 1728), greater(1987, (4 * pi) ** 3)))
_rings_by_k_v = epsilon**2 / 6 * (pi * k_v) ** 3 - difference(rings, h_v) + rings.gradient()[1]

theorem = Theorem(
    id="truncation_bound",
    title="The truncation error of the central difference",
    section="s4",
    statement=r"$|D_\varepsilon h - h'| \le \frac{\varepsilon^2}{6}(\pi k)^3$ and $|h'''| \le (\pi k)^3$: "
    r"$k = k_u$ for sine in $u$, $k = 2k_v$ for rings in $v$.",
    hypotheses=(
        r"$\varepsilon > 0$, $k > 0$",
        r"nothing wraps or clamps: $\varepsilon \le u < 1 - \varepsilon$ or $\varepsilon \le v \le 1 - \varepsilon$",
        r"$x - x^3/6 \le \sin x \le x$ for $x \ge 0$ (cited)",
    ),
    claims=(_u, _rings),
    steps=(
        Step(r"$D_\varepsilon h - h' = h'(\operatorname{sinc}\pi k\varepsilon - 1)$", "the lines; addition formulas"),
        Step(r"$0 \le 1 - \operatorname{sinc} x \le x^2/6$", "cited"),
        Step(r"$|\cos\pi k_u u\,\sin\pi k_v v| \le 1$", r"$2(1 \mp ca) = (c \mp a)^2 + (1-c^2) + (1-a^2)$"),
    ),
    mutants=(
        Mutant(
            "rings with k_v for 2k_v",
            _rings.but(shows=(at_least(_rings_by_k_v, 0),)),
            at=((k_v, 2), (v, Rational(1, 4)), (epsilon, Rational(1, 16))),
        ),
        Mutant(
            "a seventh for the sixth",
            _bounded("sine", sine, h_u, k_u, nothing_wraps, cos(pi * k_u * u) * sin(pi * k_v * v), Rational(1, 7)),
            at=((k_u, 1), (u, Rational(1, 16)), (k_v, 1), (v, Rational(1, 2)), (epsilon, Rational(1, 100))),
        ),
    ),
    side_conditions=(
        SideCondition(
            r"$\varepsilon > 0$", "rings", (Edge(((v, Rational(1, 2)), (epsilon, 0), (k_v, 2)), "undefined"),)
        ),
        SideCondition(
            "$k > 0$", "rings", (Edge(((v, Rational(1, 2)), (epsilon, Rational(1, 8)), (k_v, -2)), "fails"),)
        ),
    ),
)

third_derivative = Theorem(
    id="third_derivative_at_eight",
    title="The third derivative is not 2,000 at k = 8",
    section="s7",
    statement=r"$(8\pi)^3 > 13{,}824$, more than six times the 2,000 that the seed gives; $1728 < (4\pi)^3 < 1987$.",
    hypotheses=(r"$3 < \pi < 22/7$",),
    claims=(_at_eight, _at_four),
    steps=(Step(r"$8\pi > 24$ and $24^3 = 13{,}824$", r"$\pi > 3$"), Step(r"$(88/7)^3 < 1987$", r"$\pi < 22/7$")),
    mutants=(
        Mutant("(8π)³ is about 2,000", _at_eight.but(shows=(greater(2100, (8 * pi) ** 3),))),
        Mutant("(4π)³ exceeds 2,000", _at_four.but(shows=(greater((4 * pi) ** 3, 2000),))),
    ),
)
