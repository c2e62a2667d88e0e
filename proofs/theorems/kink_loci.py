"""The images of a field's creases: meridians are rays, parallels are circles; and how many parallels are seen."""

from proofs.formulas import height_fields
from proofs.formulas.camera import parallel_radius, point_on_a
from proofs.theorems.frame import at_angle, on_circles
from proofs.theorems.hits import along
from proofs.theorems.language import *

t, m, crease = real("t m crease")
circle_radius = parallel_radius[rho]

_projection = Claim(
    "projection",
    (
        1 - cos_phi >= 0,
        eye - radius * cos_phi > 0,
        equation(eye * t, eye - radius * cos_phi),
        t > 0,
        equation(x * cos_theta + y * sin_theta, circle_radius),
        equation(x * sin_theta, y * cos_theta),
        x * cos_theta + y * sin_theta >= 0,
        equation(x**2 + y**2, circle_radius**2),
        circle_radius >= 0,
        equation(sqrt(x**2 + y**2), circle_radius),
    ),
    (on_circles, sin_phi >= 0, lengths_of_a, equations(along(t), point)),
    point_on_a,
)
_on_the_axis = {**at_angle(1, 0), eye: 1, x: 0, y: 0}
_elsewhere = [
    Claim(
        f"elsewhere_{name}",
        (
            equation(h, side * sine.expression),
            h > 0,
            equations([Derivative(ridges.expression, c) for c in (u, v)], (h_u, h_v)),
            equations((h_u, h_v), [side * Derivative(sine.expression, c) for c in (u, v)]),
        ),
        side * sine.expression > 0,
        chain("ridges", height_fields.height(ridges), height_fields.gradient(ridges)),
    )
    for name, side in SIDES
]

theorem = Theorem(
    "kink_loci",
    "The creases are rays and circles",
    {
        r"""Seen from $E$ on the axis, the point of A at $(\theta, \varphi)$ is at the image point
        $\rho(\cos\theta, \sin\theta)$ with $\rho = e R\sin\varphi/(e - R\cos\varphi)$: a meridian is a ray, a
        parallel a circle.""": _projection,
        r"""Ridges is 0 exactly on the rays $k_u u = m$ and the circles $k_v v = m$, its creases: across one of them,
        where the sine of the other argument is not 0, it has no derivative.""": coq(
            "kink_loci__zero 3394f9d56bcd306e",
            "kink_loci__creased_in_u 866b44d20bcb8d16",
            "kink_loci__creased_in_v b14fb9afb9eb7a69",
        ),
        r"""Everywhere else $h > 0$, and $h$ and its gradient are those of $p$ or of $-p$, $p = \sin\pi k_u
        u\,\sin\pi k_v v$: no other crease.""": _elsewhere,
    },
    hypotheses=(
        "$e > R > 0$",
        r"$\sin\varphi \ge 0$",
        r"$m$ whole: $\sin\pi m = 0$; no derivative: $k_u \ne 0$, $k_v \ne 0$",
    ),
    steps={
        r"$t = 1 - (R/e)\cos\varphi > 0$": (
            r"the third coordinate of the ray; $e > R$ and $\cos\varphi \le 1$",
            "stable_frame",
        ),
        r"$(x, y) = \rho(\cos\theta, \sin\theta)$": "the other two, divided by $t$",
        r"$\sin\pi m = 0$": "the crease factors",
        "there ridges has no derivative, unless the other factor is 0": ("by its slopes", "ridges_on_creases"),
        r"$|p| = \pm p$ where $p \ne 0$": "by the sign of $p$, which is the same all around",
    },
    mutants=(
        variant(
            "ρ with e + R cos φ",
            _projection,
            equation((eye + radius * cos_phi) * x, eye * radius * sin_phi * cos_theta),
        ),
        variant("ρ = R sin φ", _projection, equation(x**2 + y**2, (radius * sin_phi) ** 2)),
        variant("the ray on the other side", _projection, at_least(0, x * cos_theta + y * sin_theta)),
        variant("the slope of p, whatever its sign", _elsewhere[1], _elsewhere[0].shows[4:5]),
    ),
    side_conditions=SideCondition(
        "$e > R$", "projection", fails={**_on_the_axis, radius: 2, t: -1}, undefined={**_on_the_axis, radius: 1, t: 0}
    ),
)


a, b = real("a b")
_halves = (a + b) / 2, (b - a) / 2
_near, _far = cos(pi * a), cos(pi * b)
_falling = Claim(
    "falling",
    (equation(_near - _far, 2 * sin(pi * _halves[0]) * sin(pi * _halves[1])), _near > _far),
    (a >= 0, b - a > 0, 1 - b >= 0),
    cited=tuple(map(sine_inside_half_turn, _halves)),
)
_nearer = Claim("nearer", eye * _near > radius, (eye > 0, _near > _far, eye * _far >= radius))
_default = Claim(
    "count",
    (cos(pi / 4) > QUARTER, greater(QUARTER, cos(pi / 2)), cos(pi / 2) > cos(3 * pi / 4), cos(3 * pi / 4) > cos(pi)),
)
_poles = Claim("pole", zero(rho), (zero(sin_phi), equation(cos_phi, 1), eye > radius), parallel_radius)

parallels = Theorem(
    "visible_parallels",
    "How many creased parallels are seen",
    {
        r"From pole to pole the cosine falls: $\cos\pi a > \cos\pi b$ for $0 \le a < b \le 1$.": _falling,
        r"""So if the parallel $v = b$ is seen, $\cos\pi b \ge R/e$, so is each nearer the pole: of $v = m/k_v$
        the first ones, up to some $m$.""": _nearer,
        "$m = 0$ is the pole, a point.": _poles,
        r"""In the default scene, $k_v = 4$ and $R/e = \frac14$, one circle is seen: $\cos\frac\pi4 > \frac14 >
        \cos\frac\pi2 > \cos\frac{3\pi}4 > \cos\pi$.""": _default,
    },
    hypotheses=(
        "$e > R > 0$",
        r"a parallel is seen, where no other body hides it, exactly if $\cos\varphi \ge R/e$ (on the rim if equal)",
        r"$\sin\pi x > 0$ for $0 < x < 1$ (cited)",
    ),
    steps={
        r"the parallel $\varphi = \pi m/k_v$ is a circle": (r"$v = \varphi/\pi$", "kink_loci"),
        r"it is seen where $\cos\varphi \ge R/e$": ("the near hit", "visible_iff"),
        r"$\cos\pi a-\cos\pi b = 2\sin\pi\frac{a+b}2\sin\pi\frac{b-a}2 > 0$": "both sines are positive",
        r"$\frac{\sqrt2}2 > \frac14 > 0 > -\frac{\sqrt2}2 > -1$": "the exact values",
    },
    mutants=(
        variant("two circles", _default, cos(pi / 2) > QUARTER),
        variant("the cosine rises", _falling, _far > _near),
        variant("the pole has a circle", _poles, rho > 0),
    ),
)
