"""The points of its creases at which ridges is differentiable: their crossings, and no others."""

from proofs.theorems.language import *

to_u, to_v, m, n = real("to_u to_v m n")  # the step from the crossing u = m/k_u, v = n/k_v
_crossing = ridges.expression.subs({u: m / k_u + to_u, v: n / k_v + to_v})
_sine_u, _sine_v = sin(pi * k_u * to_u), sin(pi * k_v * to_v)
_whole = zero(sin(pi * m), sin(pi * n))

_crossed = Claim(
    "crossing",
    (
        equation(_crossing**2, (_sine_u * _sine_v) ** 2),
        (_sine_u**2 + _sine_v**2) ** 2 >= 4 * _crossing**2,
        (pi * k_u * to_u) ** 2 + (pi * k_v * to_v) ** 2 >= _sine_u**2 + _sine_v**2,
    ),
    (k_u > 0, k_v > 0, _whole),
    squares=named(_sine_u) ** 2 - named(_sine_v) ** 2,
    cited=[CitedLemma((pi * k * d) ** 2 >= sin(pi * k * d) ** 2, "DLMF") for k, d in ((k_u, to_u), (k_v, to_v))],
)
_a, _b, _h, _steepest, _distance, _small_enough = real("a b h steepest distance small_enough")
_flat = Claim(
    "flat",
    (_a**2 + _b**2 >= 2 * _h, (_steepest * _distance) ** 2 >= (2 * _h) ** 2, _small_enough**2 * _distance >= _h**2),
    (
        _h >= 0,
        (_a**2 + _b**2) ** 2 >= 4 * _h**2,
        _steepest * _distance >= _a**2 + _b**2,
        _distance >= 0,
        4 * _small_enough**2 >= _steepest**2 * _distance,
    ),
)


def _either_side(name, along, k, step, across):
    """Return the claim about a crease along = m/k, at a distance `step` on both sides, where `across` is sin πk'v."""
    beside = [{along: m / k + side * step} for side in (1, -1)]
    sides = [ridges.expression.xreplace(at) for at in beside]
    (factor,) = (crease for crease in ridges.creases if crease.has(along))
    factors = [Abs(factor.xreplace(at)) for at in beside]
    angle, slope = pi * k * step, pi * k * Abs(across)
    return Claim(
        name,
        (
            [(f >= sin(angle), sin(angle) >= f, equation(f, sin(angle))) for f in factors],
            [equation(side, sin(angle) * Abs(across)) for side in sides],
            slope * step >= sides[0],
            sides[0] >= slope * step * (1 - angle**2 / 6),
        ),
        (k > 0, step > 0, k * step <= 1, zero(sin(pi * m))),
        cited=(sine_of_half_turn(k * step), sine_below(angle), sine_above(angle)),
    )


_on_u = _either_side("crease_in_u", u, k_u, to_u, sin(pi * k_v * v))
_on_v = _either_side("crease_in_v", v, k_v, to_v, sin(pi * k_u * u))
_right, _left, _slope, _angle = real("right left slope angle")  # ±h(m/k_u ± s)/s, πk_u |sin πk_v v|, πk_u s
_differ = Claim(
    "differ",
    (6 * _right >= 5 * _slope, _right - _left > _slope),
    (_slope > 0, _angle**2 <= 1, 6 * _right >= _slope * (6 - _angle**2), equation(_left, -_right)),
)
_level = {(_right, _left, _slope): 0, _angle: 1}
_beyond = [ridges.expression.subs(u, m / k_u + side * to_u) for side in (1, -1)]


def _at(whole_u, whole_v):
    """Return a point at half a wave from u = whole_u, v = whole_v."""
    return {(k_u, k_v): 1, m: whole_u, n: whole_v, (to_u, to_v): "1/2"}


crossings = Theorem(
    "ridges_at_crossings",
    "Ridges is differentiable where its creases cross",
    {
        r"""At $(a, b)$ from a crossing $u = m/k_u$, $v = n/k_v$ of creases inside the chart, $0 \le h \le
        \pi^2(k_u^2a^2 + k_v^2b^2)/2 \le \tfrac12K(a^2+b^2)$,""": _crossed,
        r"so $h \le \epsilon\sqrt{a^2+b^2}$ wherever $K\sqrt{a^2+b^2} \le 2\epsilon$: the derivative there is 0.": (
            _flat,
            coq("ridges_at_crossings__differentiable 199ff0071468aea8"),
        ),
    },
    hypotheses=("$m$, $n$ whole; $k_u, k_v > 0$", r"$K = \pi^2\max(k_u, k_v)^2$", r"$\sin^2 x \le x^2$ is cited"),
    steps={
        r"$h^2 = (\sin\pi k_u a\,\sin\pi k_v b)^2$": "the addition formulas, $\\sin\\pi m = \\sin\\pi n = 0$",
        r"$2h \le \sin^2\pi k_u a + \sin^2\pi k_v b$": r"$2|pq| \le p^2+q^2$",
        r"$\le \pi^2(k_u^2a^2+k_v^2b^2)$, so $h = o(\sqrt{a^2+b^2})$": r"$\sin^2x \le x^2$",
    },
    mutants=(
        variant("half the bound", _flat, _a**2 + _b**2 >= 4 * _h),
        variant("on one crease only", _crossed, given=(k_u > 0, k_v > 0, _whole[0])),
        variant("the sum for the product", _crossed, equation(_crossing**2, (_sine_u + _sine_v) ** 2), at=_at(1, 1)),
    ),
    side_conditions=SideCondition("$m$, $n$ whole", "crossing", holds=_at(1, 1), fails=_at(1, HALF)),
)

on_creases = Theorem(
    "ridges_on_creases",
    "Ridges is not differentiable elsewhere on its creases",
    {
        r"""At $s$ on either side of a crease $u = m/k_u$, $0 < s \le 1/k_u$: $h(m/k_u \pm s, v) = \sin
        x\,|\sin\pi k_v v|$, $x = \pi k_u s$, and $A(1-x^2/6) \le h/s \le A$ with the slope $A = \pi k_u|\sin\pi
        k_v v|$; the same on $v = n/k_v$.""": (_on_u, _on_v),
        r"""Where $A \ne 0$, the quotients $\pm h/s$ to the right and to the left are more than $A$ apart for
        every $x \le 1$: there is no derivative.""": (
            _differ,
            coq("ridges_on_creases__no_derivative faf2d936a341dffc"),
        ),
    },
    hypotheses=("$m$ whole; $k_u > 0$", r"$\sin x \ge 0$ on $[0, \pi]$ and $x - x^3/6 \le \sin x \le x$ (cited)"),
    steps={
        r"$h^2 = \sin^2x\,\sin^2\pi k_v v$ on both sides": r"the addition formulas, $\sin\pi m = 0$",
        r"$A(1-x^2/6) \le h/s \le A$": "the cited bounds, times $|\\sin\\pi k_v v|/s$",
        "the two quotients have opposite signs and do not tend to 0": r"$A \ne 0$",
    },
    mutants=(
        variant("the sides differ in height", _on_u, _beyond[0] ** 2 > _beyond[1] ** 2, at=_at(1, 1) | {v: HALF}),
        variant("whatever m is", _on_u, given=_on_u.given[:-1]),
        variant("differ at a crossing too", _differ, given=(_slope >= 0, _differ.given[1:]), at=_level),
    ),
    side_conditions=SideCondition(
        r"$A \ne 0$", "differ", holds={_right: 1, _left: -1, _slope: 1, _angle: 0}, fails=_level
    ),
)

_u_slope = without(pi, sine.gradient()[0])  # in half-turns
_one_slope = Claim("one_slope", equation(Abs(_u_slope), -Abs(_u_slope)), zero(sin(pi * k_u * u)))

differentiable = Theorem(
    "ridges_differentiable",
    "Ridges is differentiable",
    r"""On a crease $k_u u = m$ the slopes of ridges to the right and to the left, $+|p_u|$ and $-|p_u|$ with $p =
    \sin\pi k_u u\,\sin\pi k_v v$, are the same.""",
    claims=_one_slope,
    refuted_at={u: "1/4", v: "1/8", k_u: 8, k_v: 4},
    steps={r"$k_u = 8$, $k_v = 4$, $(u, v) = (1/4, 1/8)$: $+8\pi$ and $-8\pi$": "arithmetic"},
    mutants=(
        variant("true at a crossing", _one_slope, given=(_one_slope.given, zero(sin(pi * k_v * v)))),
        variant("true where k_u = 0", _one_slope, given=(_one_slope.given, zero(k_u))),
    ),
)
