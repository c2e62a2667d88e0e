"""The central difference that straddles a crease of |sin πku|: what it is instead of a derivative."""

from sympy import Abs, Rational, cos, pi, sin

from proofs.engine.claim import Claim, at_least, equation
from proofs.engine.theorem import SideCondition, Step, Theorem, variant
from proofs.formulas.difference_cases import inside
from proofs.formulas.half_turns import ordinary
from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.symbols import epsilon, h_u, k_u, k_v, real, u, v
from proofs.theorems.cited import sine_of_half_turn

ridges = HEIGHT_FIELDS["ridges"]
delta, m = real("delta m")
rate = pi * k_u
half = ((v, 1), (k_v, Rational(1, 2)))  # sin πk_v v = 1
ranges = ((delta, (Rational(-1, 4), Rational(1, 4))), (epsilon, (0, Rational(1, 4))), (k_u, (0, 4)))
straddles = (epsilon > 0, k_u > 0, epsilon - delta > 0, epsilon + delta > 0)
reach = (1 - k_u * (epsilon + delta) >= 0, 1 - k_u * (epsilon - delta) >= 0)
signs = tuple(sine_of_half_turn(k_u * w) for w in (epsilon + delta, epsilon - delta))

across = inside(ridges).expand(h_u).subs(half).subs(u, delta)
straddled = cos(rate * epsilon) * sin(rate * delta) / epsilon
slope = ridges.gradient()[0].subs(half).subs(u, delta)
slope_after = rate * cos(rate * delta)  # where sin πkδ > 0, as a claim below says; before the crease, its negative

_value = Claim("value", (equation(across, straddled),), (*straddles, *reach), cited=signs, ranges=ranges)
_centre = Claim(
    "at_the_crease",
    (equation(across.subs(delta, 0), 0), equation((straddled - slope_after).subs(delta, 0), -rate)),
    (epsilon > 0,),
)
_period = Claim("every_crease", (equation(Abs(sin(pi * m + delta)), Abs(sin(delta))),), (equation(sin(pi * m), 0),))
_slopes = tuple(
    Claim(f"slope_{name}", (equation(slope, side * slope_after),), (side * sin(rate * delta) > 0,), ranges=ranges)
    for name, side in (("after", 1), ("before", -1))
)

theorem = Theorem(
    id="straddling",
    title="A difference that straddles a crease",
    statement=r"At distance $\delta$ from a crease of $h = |\sin\pi k u|$, if $|\delta| < \varepsilon$ and "
    r"$\varepsilon + |\delta| \le 1/k$: $D_\varepsilon h = \cos(\pi k\varepsilon)\sin(\pi k\delta)/\varepsilon$, "
    r"whereas the slope is $\pm\pi k\cos\pi k\delta$ on either side. At the crease $D_\varepsilon h$ is 0, for "
    r"every $\varepsilon$, and the error beside it comes to $\pi k$, slope less difference at $\delta = 0$.",
    hypotheses=(
        r"$k > 0$, $|\delta| < \varepsilon$, $\varepsilon + |\delta| \le 1/k$",
        r"ridges in $u$, where $|\sin\pi k_v v| = 1$; elsewhere that factor multiplies both sides",
        r"$\sin x \ge 0$ for $0 \le x \le \pi$ (cited)",
    ),
    claims=(_value, _centre, _period, *_slopes),
    steps=(
        Step(r"$|\sin(\pi m + x)| = |\sin x|$", r"$\sin\pi m = 0$, so $\cos^2\pi m = 1$: all are alike"),
        Step(
            r"$h(\delta\pm\varepsilon) = \pm\sin\pi k(\delta\pm\varepsilon)$",
            r"$0 \le \varepsilon \pm \delta \le 1/k$: the signs of the sines",
        ),
        Step(r"$\sin(a+b) + \sin(a-b) = 2\sin a\cos b$", "the addition formulas"),
        Step(r"$\pm\pi k\cos\pi k\delta$", "the gradient of ridges, with the sign decided"),
    ),
    mutants=(
        variant("sine and cosine swapped", _value, equation(across, sin(rate * epsilon) * cos(rate * delta) / epsilon)),
        variant(
            "ε + |δ| ≤ 2/k",
            _value,
            given=(*straddles, *(r.func(r.lhs + 1, 0) for r in reach)),
            cited=(),
            at=((k_u, 1), (epsilon, Rational(5, 4)), (delta, Rational(1, 4))),
        ),
        variant("one slope on both sides", _slopes[1], equation(slope, slope_after)),
        variant("|sin(πm + x)| for any m", _period, given=(m > 0,)),
    ),
    side_conditions=(
        SideCondition(
            r"$|\delta| < \varepsilon$: the crease lies strictly between the samples",
            "value",
            holds=[((k_u, 1), (epsilon, Rational(1, 8)), (delta, Rational(1, 8)))],
            fails=[((k_u, 1), (epsilon, Rational(1, 8)), (delta, Rational(1, 4)))],
        ),
        SideCondition(
            r"$\varepsilon + |\delta| \le 1/k$: only one crease does",
            "value",
            holds=[((k_u, 1), (epsilon, Rational(3, 4)), (delta, Rational(1, 4)))],
            fails=[((k_u, 1), (epsilon, Rational(7, 8)), (delta, Rational(1, 4)))],
        ),
    ),
)

omega = real("omega")
_at_crease = {k_u: omega / pi, delta: 0}
_gap = Abs(ordinary(across.subs(_at_crease)) - slope_after.subs(_at_crease))
_steps = (omega > 0, epsilon > 0)
_descends = Claim("descends", (at_least(omega**3 * epsilon**2 / 6, _gap),), _steps)

supremum = Theorem(
    id="seed_truncation_slope",
    title="The seed's descent of the truncation slope, at a crease",
    statement=r"The error of the central difference of ridges is at most $\frac{\varepsilon^2}{6}\omega^3$, "
    r"$\omega = \pi k$, as for a sine: its supremum falls with $\varepsilon$.",
    hypotheses=(r"$\omega > 0$, $\varepsilon > 0$; beside a crease, against the slope after it",),
    claims=(_descends,),
    refuted_at=((omega, 1), (epsilon, Rational(1, 2))),
    steps=(
        Step(r"at the crease $D_\varepsilon h = 0$, the slope after it is $\omega$", "equal heights on either side"),
        Step(r"the error is $\omega = 1$, the bound $1/24$ at $\varepsilon = 1/2$", "arithmetic"),
    ),
    mutants=(
        variant("it is ω, whatever ε", _descends, equation(_gap, omega)),
        variant("true where (ωε)² ≥ 6", _descends, given=(*_steps, omega**2 * epsilon**2 >= 6)),
    ),
)
