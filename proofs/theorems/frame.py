"""The tangent frame of sphere A: tangent, orthonormal, and which way round it is."""

from proofs.formulas.camera import POLE, angles_on_a
from proofs.formulas.tangent_frame import e_phi, e_theta, seed_frame, seed_sin_phi, tangent_frame, unit_normal
from proofs.theorems.hits import met, ray_meets_a, t_a
from proofs.theorems.language import *

frame = chain("frame", unit_normal, tangent_frame)
on_circles = (equation(cos_theta**2 + sin_theta**2, 1), equation(cos_phi**2 + sin_phi**2, 1))
angles = dict(zip(ANGLES, (cos(theta), sin(theta), cos(phi), sin(phi)), strict=True))
place = {u: (theta + pi) / (2 * pi), v: phi / pi}  # in the chart


def at_angle(c: Expr | int, s: Expr | int) -> dict:
    """Return the inputs θ = 0, (cos φ, sin φ) = (c, s)."""
    return {ANGLES: (1, 0, c, s)}


_n, _theta, _phi = (frame.expand(names).xreplace(angles) for names in (normal, e_theta, e_phi))
_along_phi = Claim("e_phi", equations(_phi, [Derivative(n, phi) for n in _n]))
_along_theta = Claim("e_theta", equations(sin(phi) * _theta, [Derivative(n, theta) for n in _n]))
_along = _along_phi.but(name="derivatives", shows=(_along_phi.shows, _along_theta.shows))
_unit = Claim(
    "orthonormal",
    (
        [equation(squared(a), 1) for a in (e_theta, e_phi, normal)],
        [zero(dot(a, b)) for a, b in ((e_theta, e_phi), (e_theta, normal), (e_phi, normal))],
    ),
    on_circles,
    frame,
)
_right_handed = Claim("right_handed", equations(cross(e_phi, e_theta), normal), on_circles[:1], frame)

theorem = Theorem(
    "tangent_frame",
    "The tangent frame",
    r"""$e_\varphi = \partial N/\partial\varphi$ and $\sin\varphi\, e_\theta = \partial N/\partial\theta$;
    $(e_\varphi, e_\theta, N)$ is orthonormal and $e_\varphi \times e_\theta = N$.""",
    hypotheses=r"$\cos^2 + \sin^2 = 1$ for each of $\theta$ and $\varphi$",
    claims=(_along, _unit, _right_handed),
    steps={
        r"$\partial N/\partial\varphi$ is $e_\varphi$ line by line": "differentiation",
        r"$\partial N/\partial\theta$ is $\sin\varphi\, e_\theta$ line by line": "differentiation",
        "the six scalar products": "each is a combination of the two circle equations",
        r"$e_\varphi \times e_\theta = N$": "each component is a combination of the two circle equations",
    },
    mutants=(
        variant("e_θ × e_φ = N (F3)", _right_handed, equations(cross(e_theta, e_phi), normal)),
        variant("e_θ = ∂N/∂θ, without sin φ", _along, equations(_theta, [Derivative(n, theta) for n in _n])),
        variant("orthonormal without θ's circle", _unit, given=on_circles[1:]),
    ),
)

seed_orientation = Theorem(
    "seed_orientation",
    "The seed's orientation of the frame",
    r"$e_\theta \times e_\varphi = N$.",
    claims=_right_handed.but(name="left_handed", shows=equations(cross(e_theta, e_phi), normal)),
    refuted_at=at_angle("3/5", "4/5"),
    steps={r"at one point $e_\theta \times e_\varphi = -N$": "arithmetic"},
    mutants=(
        variant("e_φ × e_θ = N", _right_handed),
        variant("e_θ × e_φ = −N", _right_handed, equations(cross(e_theta, e_phi), -normal)),
    ),
)

_both = (*e_theta[:2], *e_phi)  # the third is 0 in either
_seed = Claim(
    "seed_frame",
    (equation(seed_frame[seed_sin_phi], sin_phi), equations(seed_frame.expand(_both), _both)),
    (on_circles[1], sin_phi > 0),
    frame,
)
_angles = Claim(
    "angles",
    (
        positive(rho, t_a),
        equation(radius * sin_phi, t_a * rho),
        equation(radius * cos_phi, eye * (1 - t_a)),
        equation(radius * sin_phi * cos_theta, t_a * x),
        equation(radius * sin_phi * sin_theta, t_a * y),
        *on_circles,
        sin_phi > 0,
    ),
    ray_meets_a,
    met(angles_on_a),
)

stable = Theorem(
    "stable_frame",
    "The frame without cancellation",
    {
        r"""Off the pole the point hit is $R(\sin\varphi\cos\theta, \sin\varphi\sin\theta, \cos\varphi)$ with
        $\cos\theta = x/\rho$, $\sin\theta = y/\rho$, $\sin\varphi = t\rho/R > 0$, $\cos\varphi = e(1-t)/R$; and where
        $\sin\varphi > 0$ the seed's frame, from $N$ alone, is the same.""": (
            _angles,
            _seed,
            coq("stable_frame__true_angles 1e88d78668a3aac2"),
        )
    },
    hypotheses=("$e > R > 0$", r"$\rho$ is not below $10^{-150} e$", "the ray hits A"),
    steps={
        r"$R\sin\varphi = t\rho$, $R\cos\varphi = e(1-t)$": "both from the conjugate form of $t$",
        r"$\cos^2+\sin^2 = 1$ for both angles": ("the point is on the sphere", "hit_of_a"),
        r"$\sqrt{1-N_z^2} = \sin\varphi$": (r"$|N| = 1$ and $\sin\varphi > 0$", "tangent_frame"),
    },
    mutants=(
        variant("R cos φ = e t", _angles, equation(radius * cos_phi, eye * t_a)),
        variant("sin φ = ρ/R", _angles, equation(radius * sin_phi, rho)),
        variant("x and y swapped", _angles, equation(radius * sin_phi * cos_theta, t_a * y)),
        variant("√(1 − N_z²) = sin φ, whatever its sign", _seed, given=on_circles, squares=sin_phi),
    ),
    side_conditions=(
        SideCondition(r"$\sin\varphi > 0$", "seed_frame", fails=at_angle("3/5", "-4/5"), undefined=at_angle(1, 0)),
        SideCondition(
            r"$\rho \ge 10^{-150}e$",
            "angles",
            holds={x: 2 * POLE, y: 0, eye: 2, radius: 1},
            fails={x: POLE, y: 0, eye: 2, radius: 1},
        ),
    ),
)
