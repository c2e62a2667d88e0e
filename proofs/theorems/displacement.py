"""The surface that the bump pretends to be: its normal, Blinn's, and the chapter's, which is neither (F18)."""

from sympy import Function, diff, pi, sin

from proofs.engine.claim import Claim, equation
from proofs.engine.theorem import SideCondition, Step, Theorem, variant
from proofs.formulas.displacement import blinn_normal, displaced, displaced_normal, h_phi, h_theta, lift
from proofs.formulas.symbols import beta, cross, dot, h, h_u, h_v, normal, phi, sin_phi, theta
from proofs.formulas.tangent_frame import e_phi, e_theta
from proofs.theorems.frame import angles, at_angle, frame, on_circles
from proofs.theorems.relations import equations

_field = Function("field")(theta, phi)
_values = {diff(_field, theta): h_theta, diff(_field, phi): h_phi, _field: h}


def _along(angle):
    """Return ∂(P + βhN)/∂angle on the unit sphere, for any field h(θ, φ)."""
    surface = (1 + beta * _field) * frame.expand(normal).xreplace(angles)
    return [diff(s, angle).subs(_values) for s in surface]


def _in_angles(program, names):
    return program.expand(names, until=(h_theta, h_phi)).xreplace(angles)


_scaled = (1 + beta * h) * sin(phi) * _in_angles(displaced_normal, displaced)
_product = Claim("product", equations(cross(_along(phi), _along(theta)), _scaled), (sin(phi) > 0,))
_u, _v = (theta + pi) / (2 * pi), phi / pi
_chart_scale = Claim(
    "chart_scale",
    (equation(h_theta, h_u * diff(_u, theta)), equation(h_phi, h_v * diff(_v, phi))),
    (),
    displaced_normal,
)
raised = (*on_circles, sin_phi > 0, 1 + beta * h > 0)
_outward = Claim(
    "outward", (equation(dot(displaced, normal), lift), dot(displaced, normal) > 0), raised, displaced_normal
)
_slopes = h_theta / sin_phi * e_theta + h_phi * e_phi
_blinn = blinn_normal.expand(displaced, until=(*normal, *e_theta, *e_phi, h_theta, h_phi))
_first_order = Claim(
    "first_order",
    (
        *equations(lift * _blinn - displaced, -(beta**2) * h * _slopes),
        equation(dot(_slopes, _slopes), (h_theta / sin_phi) ** 2 + h_phi**2),
        *equations(cross(displaced, _blinn), -(beta**2) * h * cross(normal, _slopes)),
    ),
    (*on_circles, sin_phi > 0),
    displaced_normal,
)

displaced_theorem = Theorem(
    id="displaced_normal",
    title="The displaced surface's normal, and Blinn's",
    statement=r"The surface $(1+\beta h)N$ over the unit sphere has $\partial_\varphi \times \partial_\theta = "
    r"(1+\beta h)\sin\varphi\, D$ with $D = (1+\beta h)N - \beta G$, $G = \tfrac{h_u}{2\pi\sin\varphi}e_\theta + "
    r"\tfrac{h_v}{\pi}e_\varphi$, and $D\cdot N = 1+\beta h > 0$: outwards. Blinn's $B = N - \beta G$ has $D \times B "
    r"= -\beta^2 h\, N\times G$: the same direction to first order in $\beta$.",
    hypotheses=(r"$\sin\varphi > 0$", r"$1+\beta h > 0$", r"$h$ is differentiable"),
    claims=(_product, _chart_scale, _outward, _first_order),
    steps=(
        Step(
            r"$\partial_\theta = \beta h_\theta N + (1+\beta h)\sin\varphi\,e_\theta$, $\partial_\varphi$ likewise",
            "product rule",
        ),
        Step(
            "their product, component by component",
            r"the circle equations of $\theta$ and $\varphi$",
            uses=("tangent_frame",),
        ),
        Step(r"$h_\theta = h_u/2\pi$, $h_\varphi = h_v/\pi$", r"$u = (\theta+\pi)/2\pi$, $v = \varphi/\pi$"),
        Step(r"$(1+\beta h)B - D = -\beta^2 h G$", "expansion"),
    ),
    mutants=(
        variant("inwards: ∂θ × ∂φ", _product, *equations(cross(_along(theta), _along(phi)), _scaled)),
        variant(
            "without the metric factor sin φ",
            _product,
            *equations(cross(_along(phi), _along(theta)), _scaled / sin(phi)),
        ),
        variant("Blinn's is the displaced normal", _first_order, *equations(cross(displaced, _blinn), (0, 0, 0))),
        variant("h_φ = h_v/2π", _chart_scale, equation(2 * pi * h_phi, h_v)),
    ),
    side_conditions=(
        SideCondition(
            r"$\sin\varphi > 0$", "first_order", undefined=[(*at_angle(1, 0), (h, 1), (h_u, 1), (h_v, 1), (beta, 1))]
        ),
        SideCondition(r"$1+\beta h > 0$", "outward", fails=[(*at_angle(0, 1), (h, -1), (h_u, 1), (h_v, 1), (beta, 1))]),
    ),
)
