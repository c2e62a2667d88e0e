"""The surface that the bump pretends to be: its normal and Blinn's, where the chapter's agrees, and the angle (F18)."""

from proofs.formulas.bump import bumped_normal, g, m
from proofs.formulas.displacement import (
    blinn_normal,
    displaced,
    displaced_normal,
    h_phi,
    h_theta,
    lift,
    slope_phi,
    slope_theta,
    surface_normal,
)
from proofs.formulas.tangent_frame import e_phi, e_theta
from proofs.theorems.frame import angles, at_angle, frame, on_circles
from proofs.theorems.language import *

theta_0, phi_0 = real("theta_0 phi_0")
_field = h + h_theta * (theta - theta_0) + h_phi * (phi - phi_0)  # any field, to first order around a point


def _along(angle):
    """Return ∂(P + βhN)/∂angle on the unit sphere."""
    return [Derivative(s, angle) for s in (1 + beta * _field) * frame.expand(normal).xreplace(angles)]


_in_angles = displaced_normal.expand(displaced, until=(h_theta, h_phi)).xreplace(angles)
_scaled = (1 + beta * h) * sin(phi) * _in_angles
_product = Claim(
    "product",
    equations(cross(_along(phi), _along(theta)), _scaled),
    (equations((theta, phi), (theta_0, phi_0)), sin(phi) > 0),
)
_off_the_poles = (on_circles, sin_phi > 0)
raised = (_off_the_poles, 1 + beta * h > 0)
_outward = Claim(
    "outward", (equation(dot(displaced, normal), lift), dot(displaced, normal) > 0), raised, displaced_normal
)
_slopes = h_theta / sin_phi * e_theta + h_phi * e_phi
_blinn = blinn_normal.expand(displaced, until=(*normal, *e_theta, *e_phi, h_theta, h_phi))
_first_order = Claim(
    "first_order",
    (
        equations(lift * _blinn - displaced, -(beta**2) * h * _slopes),
        equation(squared(_slopes), (h_theta / sin_phi) ** 2 + h_phi**2),
        equations(cross(displaced, _blinn), -(beta**2) * h * cross(normal, _slopes)),
    ),
    _off_the_poles,
    displaced_normal,
)

displaced_theorem = Theorem(
    "displaced_normal",
    "The displaced surface's normal, and Blinn's",
    {
        r"""The surface $(1+\beta h)N$ over the unit sphere has $\partial_\varphi \times \partial_\theta = (1+\beta
        h)\sin\varphi\, D$ with $D = (1+\beta h)N - \beta G$, $G = \tfrac{h_u}{2\pi\sin\varphi}e_\theta +
        \tfrac{h_v}{\pi}e_\varphi$, and $D\cdot N = 1+\beta h > 0$: outwards. Blinn's $B = N - \beta G$ has $D \times
        B = -\beta^2 h\, N\times G$: the same direction to first order in $\beta$.""": (
            _product,
            _outward,
            _first_order,
            coq("displaced_normal__any_field 651f549b238968e9"),
        )
    },
    hypotheses=(r"$\sin\varphi > 0$", r"$1+\beta h > 0$", r"$h$ is differentiable"),
    steps={
        r"$\partial_\theta = \beta h_\theta N + (1+\beta h)\sin\varphi\,e_\theta$, $\partial_\varphi$ likewise": (
            "product rule"
        ),
        "their product, component by component": (r"the circle equations of $\theta$ and $\varphi$", "tangent_frame"),
        r"$h_\theta = h_u/2\pi$, $h_\varphi = h_v/\pi$": r"$u = (\theta+\pi)/2\pi$, $v = \varphi/\pi$",
        r"$(1+\beta h)B - D = -\beta^2 h G$": "expansion",
    },
    mutants=(
        variant("inwards: ∂θ × ∂φ", _product, equations(cross(_along(theta), _along(phi)), _scaled)),
        variant(
            "without the metric factor sin φ",
            _product,
            equations(cross(_along(phi), _along(theta)), _scaled / sin(phi)),
        ),
        variant("Blinn's is the displaced normal", _first_order, zero(cross(displaced, _blinn))),
    ),
    side_conditions=(
        SideCondition(r"$\sin\varphi > 0$", "first_order", undefined={**at_angle(1, 0), (h, h_u, h_v, beta): 1}),
        SideCondition(r"$1+\beta h > 0$", "outward", fails={**at_angle(0, 1), h: -1, (h_u, h_v, beta): 1}),
    ),
)


_both = chain("both", displaced_normal, bumped_normal)
_metric = h_u**2 / (2 * pi * sin_phi) + h_v**2 / pi
_both_scales = lift + 1 / (2 * pi * sin_phi), lift + 1 / pi
_only_where_flat = Claim(
    "only_where_flat",
    (
        positive(1 / sin_phi, 1 / pi, 1 / pi / sin_phi, _both_scales),
        zero(beta * h_u * _both_scales[0], beta * h_v * _both_scales[1], beta * h_u, beta * h_v),
    ),
    (raised, zero(cross(m, displaced))),
    _both,
)
_where_flat = Claim("where_flat", equations(displaced, lift * m), (sin_phi > 0, zero(beta * h_u, beta * h_v)), _both)
_angle = Claim(
    "angle",
    (
        equation(dot(m, displaced), lift - beta**2 * _metric),
        equation(squared(m), 1 + beta**2 * (h_u**2 + h_v**2)),
        equation(squared(displaced), lift**2 + beta**2 * ((h_u / (2 * pi * sin_phi)) ** 2 + (h_v / pi) ** 2)),
    ),
    _off_the_poles,
    _both,
)

difference_theorem = Theorem(
    "bump_is_not_displacement",
    "The bumped normal is not the displaced surface's",
    {
        r"""If $1+\beta h > 0$, $N' = M/|M|$ with $M = N+\beta g$ has the direction of the displaced surface's normal
        $D$ exactly where $\beta g = 0$. The cosine of the angle between them is $\bigl(1+\beta
        h-\beta^2(h_u^2/2\pi\sin\varphi + h_v^2/\pi)\bigr)/|M||D|$, $|M|^2 = 1+\beta^2(h_u^2+h_v^2)$, $|D|^2 =
        (1+\beta h)^2+\beta^2(h_u^2/4\pi^2\sin^2\varphi + h_v^2/\pi^2)$.""": (
            _only_where_flat,
            _where_flat,
            _angle,
            coq("bump_is_not_displacement__cosine 78805213082572ec"),
        )
    },
    short={
        r"""Where $1 + \beta h > 0$, $N'$ has the direction of the displaced surface's normal only where $\beta g =
        0$.""": _only_where_flat
    },
    hypotheses=(r"$\sin\varphi > 0$", r"$1+\beta h > 0$"),
    steps={
        r"$M\times D = 0$ gives $\beta h_u(1+\beta h+1/2\pi\sin\varphi) = 0 = \beta h_v(1+\beta h+1/\pi)$": (
            "the frame's components"
        ),
        r"so $\beta h_u = \beta h_v = 0$": "both factors are positive",
        r"$\beta g = 0$: $D = (1+\beta h)M$": ("$D$ is the displaced surface's normal", "displaced_normal"),
        "the scalar products": "the frame is orthonormal",
    },
    mutants=(
        variant(
            "parallel only if h_u = h_v = 0, whatever β",
            _only_where_flat,
            zero(h_u),
            at={**at_angle(0, 1), (beta, h): 0, (h_u, h_v): 1},
        ),
        variant("the opposite sign, as Blinn's", _angle, equation(dot(m, displaced), 1 + beta**2 * _metric)),
        variant(
            "without the metric",
            _angle,
            equation(dot(m, displaced), lift - beta**2 * (h_u**2 / (2 * pi) + h_v**2 / pi)),
        ),
    ),
)

_half_turns = {slope: without(Pow(pi, -1), displaced_normal[slope]) for slope in (h_theta, h_phi)}
_parallel = Claim(
    "parallel", zero(dot(normal, cross(m, -beta * _slopes.xreplace(_half_turns)))), _off_the_poles, bumped_normal
)

seed_theorem = Theorem(
    "seed_bump_as_displacement",
    "The bumped normal as the displaced surface's",
    r"""$N'$ is the normal of the displaced surface, $D = (1+\beta h)N - \beta G$; in particular $N\cdot(M\times
    D) = N\cdot(M\times -\beta G) = 0$ (in half-turns: $\pi G$ for $G$).""",
    claims=_parallel,
    refuted_at={**at_angle("3/5", "4/5"), (beta, h_u, h_v): 1},
    steps={
        r"$\pi N\cdot(M\times D) = \pm\beta^2h_uh_v(1-1/2\sin\varphi) \ne 0$": (
            r"$\beta = h_u = h_v = 1$, $\sin\varphi = 4/5$: the metric and the chart's scale turn the gradient"
        )
    },
    mutants=(
        variant("true where β = 0", _parallel, given=(_parallel.given, zero(beta))),
        variant("on the same line (not the same way) where h_u = 0", _parallel, given=(_parallel.given, zero(h_u))),
    ),
)


_on_the_sphere = chain("on_the_sphere", displaced_normal.at({beta: beta / radius}), surface_normal)
_others, _off_the_pole = (h, h_u, h_v, beta, radius), (_off_the_poles, radius > 0)
_dropped = Claim(
    "dropped",
    (equation(radius * lift, radius + beta * h), equations(displaced - m, beta / radius * h * normal)),
    _off_the_pole,
    _on_the_sphere,
)
_second_order = Claim(
    "second_order",
    (
        equation(dot(m, displaced), lift + beta**2 * (slope_theta**2 + slope_phi**2)),
        equation(squared(cross(m, displaced)), (beta**2 * h / radius) ** 2 * (slope_theta**2 + slope_phi**2)),
    ),
    _off_the_pole,
    _on_the_sphere,
)
_at_the_pole = Claim("at_the_pole", (zero(g), equations(m, normal)), (on_circles, zero(sin_phi)), surface_normal)

surface_theorem = Theorem(
    "surface_bump",
    "The surface's own bump",
    {
        r"""On the sphere of radius $R$ the bump of the surface has $M = N + \beta(s_\theta e_\theta + s_\varphi
        e_\varphi)$, $s_\theta = -h_\theta/R\sin\varphi$, $s_\varphi = -h_\varphi/R$. The normal of $(R+\beta
        h)N$ is along $D = M + \tfrac{\beta h}{R}N$: the one term that is dropped.""": _dropped,
        r"""$M\cdot D = 1 + \tfrac{\beta h}{R} + \beta^2(s_\theta^2+s_\varphi^2)$ and $|M \times D| = \beta^2
        \tfrac{|h|}{R}\sqrt{s_\theta^2+s_\varphi^2}$: the angle between them is of second order in
        $\beta$.""": _second_order,
        r"At the pole $M = N$.": _at_the_pole,
    },
    hypotheses=(r"$R > 0$; off the pole $\sin\varphi > 0$; of the normal of $(R+\beta h)N$ also $R + \beta h > 0$",),
    steps={
        r"$(R+\beta h)N = R\,(1+\tfrac{\beta}{R}h)N$": (r"the unit sphere's, of $\beta/R$", "displaced_normal"),
        r"$D - M = \tfrac{\beta h}{R}N$": "line by line",
        "the products": "the frame is orthonormal",
        r"at $\sin\varphi = 0$": "the slopes are 0 there, as h has none",
    },
    mutants=(
        variant("with the chapter's sign", _dropped, equations(displaced + m, beta / radius * h * normal)),
        variant("nothing is dropped", _dropped, equations(displaced, m)),
        variant("β is no length", _dropped, equation(lift, radius + beta * h)),
        variant("to first order alone", _second_order, zero(squared(cross(m, displaced)))),
        variant("flat everywhere", _at_the_pole, given=on_circles),
    ),
    side_conditions=(
        SideCondition(r"$\sin\varphi > 0$", "second_order", fails={**at_angle("3/5", "-4/5"), _others: 1}),
        SideCondition("$R > 0$", "dropped", undefined={**at_angle(0, 1), (h, h_u, h_v, beta): 1, radius: 0}),
    ),
)
