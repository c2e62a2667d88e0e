"""At the pole: when the chapter's g has a limit, and when the true surface gradient has one (F12)."""

from proofs.formulas.bump import bumped_normal, g
from proofs.formulas.height_fields import gradient
from proofs.theorems.frame import angles, place
from proofs.theorems.language import *


def _at_pole(field):
    """Return the lines of g on the meridian θ as v → 0: those at v = 0, φ = 0."""
    pole = angles | place | {cos_phi: S.One, sin_phi: S.Zero, v: S.Zero}
    return chain("at_pole", gradient(field), bumped_normal.keep(*g)).at(pole)


_turned = k_u * (theta + pi) / 2
_sine = _at_pole(sine)
_meridian_direction = Vector((cos(theta), sin(theta), 0))
_length = Claim(
    "sine",
    (equations(g, pi * k_v * sin(_turned) * _meridian_direction), equation(squared(g), (pi * k_v * sin(_turned)) ** 2)),
    lines=_sine,
)
_vanishes = [
    Claim(f"sine_{name}", zero(g), lines=_sine.at(at))
    for name, at in (("seam", {theta: -pi}), ("k_u_0", {k_u: S.Zero}), ("k_v_0", {k_v: S.Zero}))
]
_differs = Claim(
    "sine_differs",
    (_length.shows[-1], positive((k_v * sin(_turned)) ** 2, squared(g))),
    (k_v**2 > 0, sin(_turned) ** 2 > 0),
    _sine,
)
n, chebyshev, following = real("n chebyshev following")
_two = sine.expression.subs({k_u: 2, k_v: n}).subs(place)
_smooth = Induction(
    "polynomial",
    n,
    (
        equation(sin(n * phi), chebyshev * sin(phi)),
        equation(sin((n + 1) * phi), following * sin(phi)),
        equation(_two, -(sin(phi) * sin(theta)) * chebyshev),
    ),
    ((chebyshev, 0, following), (following, 1, 2 * cos(phi) * following - chebyshev)),
)
# The surface gradient over k_v, at φ → 0: h_θ/sin φ e_θ + h_φ e_φ with sin(k_v φ)/sin φ → k_v.
_along = Vector((-sin(theta), cos(theta))), Vector((cos(theta), sin(theta)))
_surface = real("surface_x surface_y")
_tangential = chain("tangential", {_surface: k_u / 2 * cos(_turned) * _along[0] + sin(_turned) * _along[1]})
_limit = Claim(
    "surface_gradient",
    equation(squared(_surface), k_u**2 / 4 + (1 - k_u**2 / 4) * sin(_turned) ** 2),
    lines=_tangential,
)
_same_limit = [
    Claim(
        f"surface_gradient_{k}".replace("-", "minus_"),
        equations(_surface, limit),
        lines=_tangential.at({k_u: number(k)}),
    )
    for k, limit in ((0, (0, 0)), (2, (0, -1)), (-2, (0, 1)))
]

theorem = Theorem(
    "pole",
    "The gradient at the pole",
    {
        r"""As $v \to 0$ on the meridian $\theta = 2\pi u - \pi$, sine's $g$ tends to $\pi k_v\sin\pi k_u
        u\,(\cos\theta,
        \sin\theta, 0)$, of length $\pi|k_v\sin\pi k_u u|$,""": (_length, coq("pole__sine_limit 5f7416211ef99297")),
        r"""which is 0 everywhere if $k_u k_v = 0$; otherwise it is 0 on $u = 0$ and not 0 where $\sin\pi k_u u \ne 0$,
        so that not all meridians have one limit.""": (_vanishes, _differs, coq("pole__two_limits e82edf6bfec523c6")),
        r"""Rings' tends to $2\pi k_v(\cos\theta, \sin\theta, 0)$: on opposite meridians $4\pi|k_v|$ apart.""": coq(
            "pole__rings_limit 94c53fa30d60f67c"
        ),
        r"""Sine's surface gradient tends to $k_v$ times a vector of squared length $k_u^2/4 +
        (1-k_u^2/4)\sin^2\pi k_u u$:""": (_limit, coq("pole__surface_limit 78a2d00de4d9e8f6")),
        r"""for $k_v \ne 0$ the same on every meridian only if $k_u = 0$, where it is 0, or $k_u = \pm 2$,
        where it is $k_v
        (0, \mp 1, 0)$.""": (_same_limit, coq("pole__one_limit 2768e3b558abf976")),
        r"For $k_u = 2$ and whole $k_v \ge 0$, $h = -y\,U_{k_v-1}(z)$ is a polynomial on the sphere.": _smooth,
    },
    short={
        r"""Toward the pole $g$ has one limit on all meridians only if it is 0 there: for sine if $k_u k_v =
        0$, for rings
        if $k_v = 0$.""": (
            *(_vanishes, _differs),
            coq("pole__two_limits e82edf6bfec523c6", "pole__rings_limit 94c53fa30d60f67c"),
        )
    },
    hypotheses=r"""of the claims, which are steps: the values at $v = 0$, and $k_v$ for $\sin
    k_v\varphi/\sin\varphi$ (assumed)""",
    steps={
        r"""$h_u \to 0$, $h_v \to \pi k_v\sin\pi k_u u$ (rings: $2\pi k_v$), $e_\varphi \to (\cos\theta,
        \sin\theta, 0)$""": "the lines at $v = 0$, $\\varphi = 0$",
        "two meridians, two limits": (
            r"$u = 0$ and one where $\sin\pi k_u u \ne 0$; for rings, $\theta$ and $\theta + \pi$"
        ),
        r"$(h_\theta/\sin\varphi)\,e_\theta + h_\varphi e_\varphi$ at $\varphi \to 0$": (
            "its squared length, and its value for $k_u = \\pm 2$"
        ),
        r"$\sin n\varphi = \sin\varphi\,U_{n-1}(\cos\varphi)$": r"induction: $U_n = 2\cos\varphi\,U_{n-1} - U_{n-2}$",
    },
    mutants=(
        variant("sine's g has a limit", _length, [equation(_sine.expand(s).xreplace({theta: S.Zero}), s) for s in g]),
        variant(
            "the true gradient has one for every k_u",
            _limit,
            equations([_tangential.expand(s).xreplace({theta: S.Zero}) for s in _surface], _surface),
        ),
        variant("h = y U for k_u = 2", _smooth, equation(_two, sin(phi) * sin(theta) * chebyshev)),
    ),
)

_in_y = without(pi, _length.shows[1].rhs)
_same = Claim("one_limit", equation(_in_y, _in_y.xreplace({theta: -pi})))

smooth_everywhere = Theorem(
    "sine_is_smooth_everywhere",
    "Sine is smooth everywhere",
    r"For sine, $g$ tends to the same vector along every meridian as $v \to 0$.",
    claims=_same,
    refuted_at={k_u: 2, k_v: 1, theta: pi / 2},
    steps={r"$k_u = 2$, $k_v = 1$: $(0, -\pi, 0)$ on $\theta = \pi/2$, and $0$ on $\theta = -\pi$": "arithmetic"},
    mutants=(
        variant("true for k_v = 0", _same, given=zero(k_v)),
        variant("true of the surface gradient, k_u = 2", _same_limit[1]),
    ),
)
