"""The central difference beside a crease of |sin πku|: its value in place of a derivative, and its mean square."""

from proofs.formulas.difference_cases import inside
from proofs.formulas.step_bounds import (
    crease_rms,
    creases,
    distance,
    frequency,
    rest,
    root_mean_square,
    slope_bound,
    steepest,
    tent,
    tent_bound,
    third_derivative,
    truncation,
    truncation_bound,
)
from proofs.theorems.language import *

delta, m = real("delta m")
rate = slope_bound[steepest].xreplace({frequency: k_u})
half = {v: 1, k_v: HALF}  # sin πk_v v = 1
ranges = {delta: ("-1/4", "1/4"), epsilon: (0, "1/4"), k_u: (0, 4)}
straddles = (epsilon > 0, k_u > 0, epsilon - delta > 0, epsilon + delta > 0)
reach = (1 - k_u * (epsilon + delta) >= 0, 1 - k_u * (epsilon - delta) >= 0)

across = inside(ridges).expand(h_u).subs(half).subs(u, delta)
straddled = cos(rate * epsilon) * sin(rate * delta) / epsilon

_value = Claim(
    "value",
    equation(across, straddled),
    (straddles, reach),
    cited=[sine_of_half_turn(k_u * w) for w in (epsilon + delta, epsilon - delta)],
    ranges=ranges,
)
_period = Claim("every_crease", equation(Abs(sin(pi * m + delta)), Abs(sin(delta))), zero(sin(pi * m)))

theorem = Theorem(
    "straddling",
    "A difference that straddles a crease",
    {
        r"""At distance $\delta$ from a crease of $h = |\sin\pi k u|$, if $|\delta| < \varepsilon$ and $\varepsilon +
        |\delta| \le 1/k$: $D_\varepsilon h = \cos(\pi k\varepsilon)\sin(\pi k\delta)/\varepsilon$, which is 0 at the
        crease, for every $\varepsilon$,""": (_value, _period, coq("straddling__of_the_difference bf460f9cd0908a38")),
        r"whereas the slope is $\pm\pi k\cos\pi k\delta$ on either side.": (
            coq("straddling__of_the_slope dd38cfc7019a7aef")
        ),
        r"Beside the crease the error, slope less difference, tends to $\pi k$ as $\delta \to 0$ from above.": coq(
            "straddling__error a44c510a266abd3f"
        ),
    },
    hypotheses=(
        r"$k > 0$, $|\delta| < \varepsilon$, $\varepsilon + |\delta| \le 1/k$",
        r"ridges in $u$ where $|\sin\pi k_v v| = 1$; elsewhere, and in $v$, times $|\sin|$ of the other argument",
        r"""inside the chart nothing wraps or clamps, or $k$ is whole, as in the last sentence; the slope at $0
        < |\delta| < 1/k$""",
        r"$\sin x \ge 0$ for $0 \le x \le \pi$ (cited)",
    ),
    steps={
        r"$|\sin(\pi m + x)| = |\sin x|$": r"$\sin\pi m = 0$, so $\cos^2\pi m = 1$: all are alike",
        r"$h(\delta\pm\varepsilon) = \pm\sin\pi k(\delta\pm\varepsilon)$": (
            r"$0 \le \varepsilon \pm \delta \le 1/k$: the signs of the sines"
        ),
        r"$\sin(a+b) + \sin(a-b) = 2\sin a\cos b$": "the addition formulas",
        r"$\pm\pi k\cos\pi k\delta$": "the gradient of ridges, with the sign decided",
    },
    mutants=(
        variant("sine and cosine swapped", _value, equation(across, sin(rate * epsilon) * cos(rate * delta) / epsilon)),
        variant(
            "ε + |δ| ≤ 2/k",
            _value,
            given=(straddles, [r.func(r.lhs + 1, 0) for r in reach]),
            cited=(),
            at={k_u: 1, epsilon: "5/4", delta: "1/4"},
        ),
        variant("|sin(πm + x)| for any m", _period, given=m > 0),
    ),
    side_conditions=(
        SideCondition(
            r"$|\delta| < \varepsilon$: the crease lies strictly between the samples",
            "value",
            holds={k_u: 1, epsilon: "1/8", delta: "1/8"},
            fails={k_u: 1, epsilon: "1/8", delta: "1/4"},
        ),
        SideCondition(
            r"$\varepsilon + |\delta| \le 1/k$: only one crease does",
            "value",
            holds={k_u: 1, epsilon: "3/4", delta: "1/4"},
            fails={k_u: 1, epsilon: "7/8", delta: "1/4"},
        ),
    ),
)

omega = real("omega")
_gap = Abs(-omega)  # at the crease, with ω for πk: the difference is 0 there
_steps = (omega > 0, epsilon > 0)
_descends = Claim("descends", truncation_bound[truncation].xreplace({third_derivative: omega**3}) >= _gap, _steps)

supremum = Theorem(
    "seed_truncation_slope",
    "The seed's descent of the truncation slope, at a crease",
    r"""The error of the central difference of ridges is at most $\frac{\varepsilon^2}{6}\omega^3$, $\omega = \pi
    k$, as for a sine: its supremum falls with $\varepsilon$.""",
    hypotheses=r"$\omega > 0$, $\varepsilon > 0$; beside a crease, against the slope after it",
    claims=_descends,
    refuted_at={omega: 1, epsilon: "1/2"},
    steps={
        r"at the crease $D_\varepsilon h = 0$, the slope after it is $\omega$": "equal heights on either side",
        r"the error is $\omega = 1$, the bound $1/24$ at $\varepsilon = 1/2$": "arithmetic",
    },
    mutants=(
        variant("it is ω, whatever ε", _descends, equation(_gap, omega)),
        variant("true where (ωε)² ≥ 6", _descends, given=(_steps, omega**2 * epsilon**2 >= 6)),
    ),
)


x, y = rate * epsilon, rate * delta
_at = {frequency: k_u, distance: delta}
_tent, _room = -tent_bound[tent].xreplace(_at) / rate, tent_bound[rest].xreplace(_at) / rate
_sin_y, _cos_y, _cos_x = sin(y), cos(y), cos(x)
_rest = straddled / rate - _cos_y - _tent
_near_tent = Claim(
    "tent",
    (
        nonnegative(1 - _cos_y, 1 - _cos_x),
        positive(rate, x),
        equation(x * _rest, x * (1 - _cos_y) - (y - _cos_x * _sin_y)),
        nonnegative(
            x - y,
            x**2 - y**2,
            x**3 / 6 - (y - _sin_y),
            x**2 / 2 - (1 - _cos_y),
            _sin_y * (1 - _cos_x),
            x**3 / 2 - _sin_y * (1 - _cos_x),
        ),
        both_ways(_room * x, x * _rest),
        both_ways(_room, _rest),
    ),
    (epsilon > 0, k_u > 0, delta > 0, epsilon - delta >= 0, reach[0]),
    squares=named(sin(x)),
    cited=(sine_below(y), sine_above(y), cosine_above(y), cosine_above(x), sine_of_half_turn(k_u * delta)),
)
_primitive = (delta - epsilon) ** 3 / (3 * epsilon**2)
_square = v / 2 - sin(2 * pi * k_v * v) / (4 * pi * k_v)
_area = _primitive.subs(delta, epsilon) - _primitive.subs(delta, 0)
_tents = Claim(
    "tents", (equation(Derivative(_primitive, delta), _tent**2), equation(_area, epsilon / 3)), (epsilon > 0, k_u > 0)
)
_means = Claim(
    "mean_of_a_square",
    (equation(Derivative(_square, v), sin(pi * k_v * v) ** 2), equation(_square.subs(v, 1) - _square.subs(v, 0), HALF)),
    (k_v > 0, zero(sin(pi * k_v))),
)


def _mean_square(name, k, number, constant=None):
    """Return the claim that the tents at so many creases have the mean square constant²."""
    constant = constant or crease_rms[root_mean_square].xreplace({frequency: k, creases: number})
    total = number * (pi * k) ** 2 * 2 * _area * HALF
    shows = (
        pi * k > 0,
        nonnegative(number * epsilon, total, constant),
        equation(total, constant**2),
        sqrt(total) >= constant,
        constant >= sqrt(total),
        equation(sqrt(total), constant),
    )
    return Claim(name, shows, (k >= 1, epsilon > 0))


_means_square = _mean_square("in_u", k_u, k_u), _mean_square("in_v", k_v, k_v - 1)

_near_all = coq("crease_error_area__near_the_tents 787f98960365521b")

rms = Theorem(
    "crease_error_area",
    "The error beside the creases falls like √ε",
    {
        r"""Within $\varepsilon$ of a crease the error of the central difference of $|\sin\pi k u|$ is $\pi
        k(1 - |\delta|/\varepsilon)$ in size, up to $\tfrac23\pi k(\pi k\varepsilon)^2$.""": (_near_tent, _near_all),
        r"""$(\delta-\varepsilon)^3/3\varepsilon^2$ has the derivative $(\delta/\varepsilon-1)^2$ and grows by
        $\varepsilon/3$; a primitive of $\sin^2\pi k v$ grows by $\tfrac12$ over the chart; tents of these areas
        at $k_u$ and $k_v - 1$ creases have the root mean squares $\pi k_u\sqrt{k_u\varepsilon/3}$ and $\pi
        k_v\sqrt{(k_v-1)\varepsilon/3}$.""": (_tents, _means, _means_square),
        r"""So these are the RMS errors in $h_u$ and $h_v$, by integrals over the chart, each up to $\tfrac23\pi
        k(\pi k\varepsilon)^2$;""": coq("crease_error_area__root_mean_squares 9553670e51360319"),
        r"""and everywhere the error is that of the tents, in $h_u$ at every crease and in $h_v$ at those off the poles,
        times $|\sin|$ of the other argument, up to as much.""": (
            _near_all,
            coq("crease_error_area__of_all_tents bb83709e9ece0e4b"),
        ),
    },
    hypotheses=(
        r"$k_u, k_v \ge 1$ whole, $0 < \varepsilon \le 1/2k$: ridges, $k_u$ creases in $u$, $k_v - 1$ inside in $v$",
        r"bounds of sine and cosine by their Taylor polynomials (cited)",
        r"in the last sentence $0 < v < 1$ for $h_v$",
    ),
    steps={
        r"$\cos x\,\sin y/x - \cos y$, $x = \pi k\varepsilon$, $y = \pi k\delta$": (
            "value and slope, over $\\pi k$",
            "straddling",
        ),
        r"it is $y/x - 1 + r$, $x r = x(1-\cos y) - (y - \cos x\sin y)$, so $|r| \le \tfrac23x^2$": (
            r"$0 \le x(1-\cos y) \le \tfrac12x^3$ and $0 \le y - \cos x\sin y \le \tfrac23x^3$"
        ),
        r"before a crease the error is that after it, with the other sign": "both are odd in $\\delta$",
        r"away from the creases the error is below $\pi k\,x^2/6$": ("smooth there", "truncation_bound"),
        r"at the poles below $\pi k\,x^2/4$": ("odd there", "clamped_difference_of_odd"),
        r"$\int_0^\varepsilon(\delta/\varepsilon-1)^2\,d\delta = \varepsilon/3$": "differentiate the primitive",
        r"the mean of $\sin^2\pi k v$ is $\tfrac12$": r"differentiate the primitive; $\sin\pi k = 0$",
    },
    mutants=(
        variant("√(k_v ε/3) in h_v", _mean_square("in_v", k_v, k_v - 1, pi * k_v * sqrt(k_v * epsilon / 3))),
        variant("∝ ε, not √ε", _mean_square("in_u", k_u, k_u, pi * k_u * epsilon * sqrt(k_u / 3))),
        variant("the mean of sin² is ½ for any k", _means, given=k_v > 0),
        variant("no tent: the error is below (πk)³ε²/6", _near_tent, x**2 / 6 >= _cos_y - straddled / rate, squares=()),
    ),
    side_conditions=(
        SideCondition("$k_v$ whole", "mean_of_a_square", holds={v: 0, k_v: 3}, fails={v: 0, k_v: "5/4"}),
        SideCondition(r"$k_v \ge 1$", "in_v", holds={k_v: 1, epsilon: "1/8"}, undefined={k_v: "1/2", epsilon: "1/8"}),
    ),
)
