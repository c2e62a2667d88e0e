"""The seam u = 0: the fields that are continuous across it, and those that are differentiable there (F11)."""

from proofs.engine.half_turns import sinpi
from proofs.theorems.language import *

n, alternating = real("n alternating")
_whole, _in_v = zero(sin(pi * k_u)), sinpi(k_v * v)
_turned = sine.expression.subs(u, u + 1)


def _jump(expression):
    """Return the change of an expression in u across the seam: at u = 0 less at u = 1."""
    return expression.subs(u, 0) - expression.subs(u, 1)


_slope = sine.gradient()[0]
_parity = Induction(
    "parity",
    n,
    (equation(cos(pi * n), alternating), zero(sin(pi * n)), equation(cos(2 * pi * n), 1)),
    ((alternating, 1, -alternating),),
)
h_jump, slope_jump = real("h_jump slope_jump")
_sine = Claim(
    "sine",
    (
        equation(h_jump, -sin(pi * k_u) * _in_v),
        equation(slope_jump, pi * k_u * (1 - cos(pi * k_u)) * _in_v),
        equation(_turned, cos(pi * k_u) * sine.expression + sin(pi * k_u) * cos(pi * k_u * u) * _in_v),
    ),
    lines=chain("jumps", {h_jump: _jump(sine.expression), slope_jump: _jump(_slope)}),
)
_even = Claim(
    "even",
    (zero([_jump(f) for f in (sine.expression, *sine.gradient())]), equation(_turned, sine.expression)),
    equation(cos(pi * k_u), 1),
)
_odd = Claim(
    "odd", (zero(_jump(sine.expression)), equation(_jump(_slope), 2 * pi * k_u * _in_v)), equation(cos(pi * k_u), -1)
)
_half = {(k_u, k_v): 1, (u, v): HALF}
_ends = real("h_first h_last")
_at_ends = chain("ends", {_ends: [ridges.at(at, v) for at in (S.Zero, S.One)]})
_ridges = Claim("ridges", zero(_ends), _whole, _at_ends)
_step = real("step")
_after, _before = (ridges.at(at, v) for at in (_step, 1 - _step))
_crease = Claim(
    "ridges_crease",
    (
        equation(_after**2, sin(pi * k_u * _step) ** 2 * _in_v**2),
        equation(_before**2, _after**2),
        _after >= _before,
        _before >= _after,
    ),
    _whole,
)
_broken = Claim(
    "ridges_jump",
    positive(-_jump(ridges.expression)),
    (sin(pi * k_u) ** 2 > 0, _in_v**2 > 0),
    ranges={(k_u, k_v, v): ("1/8", "7/8")},  # samples keep off the zeros
)
_smooth = Claim("rings", zero(Derivative(rings.expression, u)))

theorem = Theorem(
    "seam",
    "Which fields cross the seam smoothly",
    {
        r"$\cos\pi n = (-1)^n$ and $\sin\pi n = 0$ for whole $n \ge 0$.": _parity,
        r"""Across $u = 0$, sine's height jumps by $-\sin\pi k_u\,\sin\pi k_v v$ and its slope by $\pi
        k_u(1-\cos\pi k_u)\sin\pi k_v v$:""": _sine,
        "not at all for even $k_u$, where $h(u+1, v) = h(u, v)$ and both slopes are continuous;": _even,
        r"for odd $k_u$ in its slope alone, by $2\pi k_u\sin\pi k_v v$.": _odd,
        r"""Ridges is 0 on the seam for whole $k_u$, and even about it, $h^2 = \sin^2\pi k_u s\,\sin^2\pi k_v v$
        at $s$ from it, as on a crease;""": (_ridges, _crease),
        r"it jumps where neither $\sin\pi k_u$ nor $\sin\pi k_v v$ is 0.": _broken,
        "Rings does not depend on $u$: its slope is 0 there and everywhere.": _smooth,
    },
    short={
        r"""Across the seam sine is smooth for even $k_u$; where $\sin\pi k_v v \ne 0$ it has a crease for odd $k_u$ and
        a jump for a fractional one.""": (_sine, _even, _odd),
        r"Ridges is creased there for every whole $k_u \ne 0$, where $\sin\pi k_v v \ne 0$.": (_ridges, _crease),
    },
    hypotheses=r"""$k_u$ is whole: $\sin\pi k_u = 0$; even: $\cos\pi k_u = 1$; odd: $\cos\pi k_u = -1$, of either
    sign: $\cos$ is even""",
    steps={
        r"$\cos\pi n = (-1)^n$, $\sin\pi n = 0$": "induction",
        r"$h(0,v)-h(1,v)$ and $h_u(0,v)-h_u(1,v)$": "the field and its derivative at both ends",
        r"$h(s, v)^2 = h(1-s, v)^2 = \sin^2\pi k_u s\,\sin^2\pi k_v v$": "ridges, whole $k_u$; both are $\\ge 0$",
        "the slopes on either side are opposite and not zero": ("as on every crease", "ridges_on_creases"),
    },
    mutants=(
        variant("C¹ for odd k_u", _even, given=_odd.given, at=_half),
        variant("continuous for every k_u", _sine, zero(h_jump)),
        variant("ridges continuous for every k_u", _ridges, given=()),
        variant("h(u + 1) = h for whole k_u", _even, given=_whole, at=_half),
    ),
    side_conditions=SideCondition(
        "$k_u$ is even",
        "even",
        holds={k_u: 2, k_v: 1, u: "1/3", v: "1/2"},
        fails=({k_u: 1, k_v: 1, u: "1/3", v: "1/2"}, {k_u: "3/2", k_v: 1, u: "1/3", v: "1/2"}),
    ),
)

_periodic = Claim("slope", zero(_jump(without(pi, _slope))), _whole)

seam_saved = Theorem(
    "periodic_u_saves_the_seam",
    "Periodic in u, so smooth across the seam",
    r"For whole $k_u$ sine is differentiable across $u = 0$: its slope is the same on both sides.",
    hypotheses="$k_u$ is whole",
    claims=_periodic,
    refuted_at={k_u: 1, k_v: 1, v: "1/2"},
    steps={r"$k_u = 1$, $v = 1/2$, $k_v = 1$: the slope is $\pi$ at $u = 0$, $-\pi$ at $u = 1$": "arithmetic"},
    mutants=(
        variant("true for even k_u", _periodic, given=equation(cos(pi * k_u), 1)),
        variant("true for the height", Claim("height", zero(_jump(sine.expression)), _whole)),
    ),
)
