"""The truncation error of the central difference of the smooth fields, with its constant."""

from proofs.formulas.difference_cases import INSIDE, nothing_clamps, nothing_wraps
from proofs.formulas.step_bounds import (
    apart,
    crease_bound,
    frequency as half_turns,
    slope_bound,
    steepest,
    truncation,
    truncation_bound,
)
from proofs.theorems.finite_difference import difference
from proofs.theorems.language import *

_in_u, _in_v = pi * k_u * u, pi * k_v * v


def _bound_at(frequency):
    """Return the bound of the truncation error for a frequency."""
    return truncation_bound.expand(truncation).xreplace({half_turns: frequency})


def _bounded(name, field, output, frequency, factors, squares=(), share=1):
    """Return the claim |D − slope| ≤ share · ε²/6 (π frequency)³; slope = π frequency · factors."""
    coordinate, given = {h_u: (u, nothing_wraps), h_v: (v, nothing_clamps)}[output]
    slope, third = (Derivative(field.expression, coordinate, n) for n in (1, 3))
    rate = slope_bound[steepest].xreplace({half_turns: frequency})
    angle = rate * epsilon
    error, bound = difference(field, output) - slope, share * _bound_at(frequency)
    shows = (
        both_ways(1, factors),
        positive(rate, rate**3),
        equation(third, -(rate**3) * factors),
        both_ways(rate**3, third),
        equation(epsilon * error, factors * (sin(angle) - angle)),
        [epsilon * (bound + s * error) >= 0 for s in (1, -1)],
        [bound + s * error >= 0 for s in (1, -1)],
    )
    (k,) = frequency.free_symbols
    return Claim(
        name, shows, (given, k > 0), None, squares, cited=(sine_below(angle), sine_above(angle)), ranges=INSIDE
    )


_u = _bounded("sine", sine, h_u, k_u, cos(_in_u) * sin(_in_v), (named(sin(_in_u)), named(cos(_in_v))))
_v = _bounded("sine_in_v", sine, h_v, k_v, sin(_in_u) * cos(_in_v), (named(sin(_in_v)), named(cos(_in_u))))
_rings = _bounded("rings", rings, h_v, 2 * k_v, cos(2 * pi * k_v * v))


def _between_creases(name, output, coordinate, given, side):
    """Return the claim that ridges has sine's difference and slope, times `side`, the sign of sine's heights."""
    sines = [sine.expression.subs(coordinate, coordinate + step) for step in (epsilon, -epsilon, 0)]
    slopes = [Derivative(field.expression, coordinate) for field in (ridges, sine)]
    return Claim(
        name,
        equations((difference(ridges, output), slopes[0]), (side * difference(sine, output), side * slopes[1])),
        (given, [side * height >= 0 for height in sines[:2]], side * sines[2] > 0),
        ranges=INSIDE,
    )


_ridges = [
    _between_creases(f"ridges_{coordinate}_{name}", output, coordinate, given, side)
    for output, coordinate, given in ((h_u, u, nothing_wraps), (h_v, v, nothing_clamps))
    for name, side in SIDES
]
_quotient, _slope = real("quotient slope")
_steepest = slope_bound[steepest]
_apart = Claim("apart", both_ways(crease_bound[apart], _quotient - _slope), both_ways(_steepest, _quotient, _slope))
_at_eight = Claim("at_eight", ((8 * pi) ** 3 > 24**3, greater(24**3, 6 * 2000)))
_at_four = Claim("at_four", ((4 * pi) ** 3 > 1728, greater(1987, (4 * pi) ** 3)))

theorem = Theorem(
    "truncation_bound",
    "The truncation error of the central difference",
    {
        r"""$|D_\varepsilon h - h'| \le \frac{\varepsilon^2}{6}(\pi k)^3$ and $|h'''| \le (\pi k)^3$: $k = k_u$
        for sine in $u$, $k_v$ in $v$, $2k_v$ for rings in $v$.""": (_u, _v, _rings),
        r"""Where $\sin\pi k_u u\,\sin\pi k_v v$ has one sign at the three points, ridges' difference and slope
        are sine's, or both their negatives: the same bound.""": _ridges,
        r"""Whatever lies within $\varepsilon$: where $|D_\varepsilon h|$ and $|h'|$ are at most $\pi k$, they are
        at most $2\pi k$ apart.""": _apart,
    },
    hypotheses=(
        r"$\varepsilon > 0$, $k > 0$",
        r"nothing wraps or clamps: $\varepsilon \le u < 1 - \varepsilon$ or $\varepsilon \le v \le 1 - \varepsilon$",
        r"$x - x^3/6 \le \sin x \le x$ for $x \ge 0$ (cited)",
    ),
    steps={
        r"$D_\varepsilon h - h' = h'(\operatorname{sinc}\pi k\varepsilon - 1)$": "the lines; addition formulas",
        r"$0 \le 1 - \operatorname{sinc} x \le x^2/6$": "cited",
        r"$|\cos\pi k_u u\,\sin\pi k_v v| \le 1$": r"$2(1 \mp ca) = (c \mp a)^2 + (1-c^2) + (1-a^2)$",
        r"$|D_\varepsilon h - h'| \le |D_\varepsilon h| + |h'|$": "the triangle's inequality",
    },
    mutants=(
        variant(
            "rings with k_v for 2k_v",
            _rings,
            _bound_at(k_v) - difference(rings, h_v) + rings.gradient()[1] >= 0,
            at={k_v: 2, v: "1/4", epsilon: "1/16"},
        ),
        variant(
            "a seventh for the sixth",
            _bounded("sine", sine, h_u, k_u, cos(_in_u) * sin(_in_v), share=Rational(6, 7)),
            at={k_u: 1, u: "1/16", k_v: 1, v: "1/2", epsilon: "1/100"},
        ),
        variant(
            "no further apart than the steepest slope",
            _apart,
            both_ways(_steepest, _quotient - _slope),
            at={half_turns: 1, _quotient: 3, _slope: -3},
        ),
    ),
    side_conditions=(
        SideCondition(r"$\varepsilon > 0$", "rings", undefined={v: "1/2", epsilon: 0, k_v: 2}),
        SideCondition("$k > 0$", "rings", fails={v: "1/2", epsilon: "1/8", k_v: -2}),
    ),
)

third_derivative = Theorem(
    "third_derivative_at_eight",
    "The third derivative is not 2,000 at k = 8",
    r"$(8\pi)^3 > 13{,}824$, more than six times the 2,000 that the seed gives; $1728 < (4\pi)^3 < 1987$.",
    hypotheses=r"$3 < \pi < 22/7$",
    claims=(_at_eight, _at_four),
    steps={r"$8\pi > 24$ and $24^3 = 13{,}824$": r"$\pi > 3$", r"$(88/7)^3 < 1987$": r"$\pi < 22/7$"},
    mutants=(
        variant("(8π)³ is about 2,000", _at_eight, greater(2100, (8 * pi) ** 3)),
        variant("(4π)³ exceeds 2,000", _at_four, (4 * pi) ** 3 > 2000),
    ),
)
