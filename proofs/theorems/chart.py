"""The chart of sphere A and its inverse, as far as they are algebraic: the angles' cosines and sines, and N."""

from proofs.engine.half_turns import atan2pi, cospi, sinpi
from proofs.formulas.chart import chart, chart_inverse, chart_radians, theta, u_closed
from proofs.formulas.tangent_frame import unit_normal
from proofs.theorems.frame import at_angle, on_circles
from proofs.theorems.language import *

turn = real("turn")  # θ/π in (−1, 1], the value of atan2pi
_of_angles = {atan2pi(sin_theta, cos_theta): turn, atan2pi(sin_phi, cos_phi): phi / pi}
_by_turns = chain("by_turns", {s: e.xreplace(_of_angles) for s, e in chart.definitions})
_range = Claim(
    "range", (u >= 0, greater(1, u), v >= 0, at_least(1, v)), (turn > -1, turn <= 1, phi >= 0, phi <= pi), _by_turns
)
_seam = Claim("seam", zero(u), equation(turn, 1), _by_turns)
_inside = Claim("inside", (equation(u, u_closed), equation(chart_radians[theta], pi * turn)), turn < 1, _by_turns)


_round_trip = Claim(
    "round_trip",
    equations(chart_inverse.outputs, [cospi(turn), sinpi(turn), cos(phi), sin(phi)]),
    lines=chart_inverse.at({u: _by_turns.expand(u_closed), v: _by_turns.expand(v)}),
)
_on_the_seam = Claim(
    "on_the_seam", equations(chart_inverse.outputs[:2], [cospi(1), sinpi(1)]), lines=chart_inverse.at({u: S.Zero})
)

_nx, _ny, _ = normal
_across = sqrt(_nx**2 + _ny**2)
_recovered = Claim(
    "recovered",
    (
        equation(_across**2, sin_phi**2),
        equation(_across, sin_phi),
        equations((_nx / _across, _ny / _across), (cos_theta, sin_theta)),
    ),
    (on_circles[0], sin_phi > 0),
    unit_normal,
)
_from_chart = unit_normal.expand(normal).xreplace(dict(chart_inverse.definitions))
_unit = Claim("unit", equation(squared(_from_chart), 1))
_formula = Claim(
    "formula",
    equations(normal, [-sin(pi * v) * cos(2 * pi * u), -sin(pi * v) * sin(2 * pi * u), cos(pi * v)]),
    lines=chain("normal_from_chart", chart_inverse, unit_normal),
)

forward = Theorem(
    "chart",
    "The chart of sphere A",
    r"""For $\theta \in (-\pi, \pi]$ and $\varphi \in [0, \pi]$: $u \in [0, 1)$ and $v \in [0, 1]$; $u =
    (\theta+\pi)/2\pi$ where $\theta < \pi$, and $\theta = \pi$ gives $u = 0$, not 1. Back from $(u, v)$ come the
    same cosines and sines of $\theta$ and $\varphi$, on the seam too.""",
    hypotheses=r"""$\theta = \pi\,\mathrm{atan2pi}(\sin\theta, \cos\theta) \in (-\pi, \pi]$, $\varphi$ likewise:
    the meaning of atan2""",
    claims=(_range, _inside, _seam, _round_trip, _on_the_seam),
    steps={
        r"$0 < (1+\theta/\pi)/2 \le 1$, and 1 is replaced by 0": "the case of the reduction",
        r"$\cos(2\pi u-\pi) = \cos\theta$": "addition formulas",
        r"at $u = 0$: $(\cos\theta, \sin\theta) = (-1, 0)$": r"as at $\theta = \pi$",
    },
    mutants=(
        variant("u ≤ 1/2", _range, at_least(HALF, u)),
        variant("u is (θ + π)/2π on the seam as well", _seam, equation(u, u_closed)),
        variant("back with cos 2πu, without the minus", _round_trip, negated(_round_trip)),
    ),
    side_conditions=SideCondition(r"$\theta < \pi$", "inside", holds={turn: "12/13", phi: 0}, fails={turn: 1, phi: 0}),
)

inverse = Theorem(
    "chart_inverse",
    "The inverse of the chart",
    r"""$N(u, v) = (-\sin\pi v\cos 2\pi u, -\sin\pi v\sin 2\pi u, \cos\pi v)$ has length 1. Where $\sin\varphi >
    0$, $N$, whose $N_z$ is $\cos\varphi$, gives back $\sin\varphi = \sqrt{N_x^2+N_y^2}$, $\cos\theta =
    N_x/\sin\varphi$, $\sin\theta = N_y/\sin\varphi$.""",
    hypotheses=r"$\sin\varphi > 0$ for the way back",
    claims=(_formula, _unit, _recovered),
    steps={
        r"$\theta = 2\pi u-\pi$, $\varphi = \pi v$": "the chart, solved",
        r"$N_x^2+N_y^2 = \sin^2\varphi$": r"$\cos^2\theta+\sin^2\theta = 1$",
        "the root and the quotients": r"$\sin\varphi > 0$",
    },
    mutants=(
        variant("N_x = + sin πv cos 2πu", _formula, negated(_formula)),
        variant("whatever the sign of sin φ", _recovered, given=on_circles),
    ),
    side_conditions=SideCondition(
        r"$\sin\varphi > 0$", "recovered", fails=at_angle("3/5", "-4/5"), undefined=at_angle(1, 0)
    ),
)
