"""The tangent frame of sphere A: tangent, orthonormal, and which way round it is."""

from sympy import cos, diff, sin

from ..claim import Claim
from ..program import chain
from ..statement import equation
from ..symbols import cos_phi, cos_theta, cross, dot, normal, phi, sin_phi, sin_theta, theta
from ..tangent_frame import e_phi, e_theta, tangent_frame, unit_normal
from ..theorem import Mutant, Step, Theorem

frame = chain("frame", unit_normal, tangent_frame)
on_circles = (equation(cos_theta**2 + sin_theta**2, 1), equation(cos_phi**2 + sin_phi**2, 1))
angles = {cos_theta: cos(theta), sin_theta: sin(theta), cos_phi: cos(phi), sin_phi: sin(phi)}


def equations(left, right):
    """Return the three equations of two vectors."""
    return tuple(equation(a, b) for a, b in zip(left, right, strict=True))


def _in_angles(names):
    return [frame[name].xreplace(angles) for name in names]


_n, _theta, _phi = (_in_angles(names) for names in (normal, e_theta, e_phi))
_along_phi = Claim("e_phi", equations(_phi, [diff(n, phi) for n in _n]))
_along_theta = Claim("e_theta", equations([sin(phi) * e for e in _theta], [diff(n, theta) for n in _n]))
_unit = Claim(
    "orthonormal",
    (
        *(equation(dot(a, a), 1) for a in (e_theta, e_phi, normal)),
        *(equation(dot(a, b), 0) for a, b in ((e_theta, e_phi), (e_theta, normal), (e_phi, normal))),
    ),
    on_circles,
    frame,
)
_right_handed = Claim("right_handed", equations(cross(e_phi, e_theta), normal), on_circles, frame)

theorem = Theorem(
    id="tangent_frame",
    title="The tangent frame",
    section="s3",
    statement=r"$e_\varphi = \partial N/\partial\varphi$ and $\sin\varphi\, e_\theta = \partial N/\partial\theta$; "
    r"$(e_\varphi, e_\theta, N)$ is orthonormal and $e_\varphi \times e_\theta = N$.",
    hypotheses=(r"$\cos^2 + \sin^2 = 1$ for each of $\theta$ and $\varphi$",),
    claims=(_along_phi, _along_theta, _unit, _right_handed),
    steps=(
        Step(r"$\partial N/\partial\varphi$ is $e_\varphi$ line by line", "differentiation"),
        Step(r"$\partial N/\partial\theta$ is $\sin\varphi\, e_\theta$ line by line", "differentiation"),
        Step("the six scalar products", "each is a combination of the two circle equations"),
        Step(r"$e_\varphi \times e_\theta = N$", "each component is a combination of the two circle equations"),
    ),
    mutants=(
        Mutant("e_θ × e_φ = N (F3)", _right_handed.but(shows=equations(cross(e_theta, e_phi), normal))),
        Mutant("e_θ = ∂N/∂θ, without sin φ", _along_theta.but(shows=equations(_theta, [diff(n, theta) for n in _n]))),
        Mutant("e_φ ⟂ N without θ's circle", _unit.but(shows=(equation(dot(e_phi, normal), 0),), given=on_circles[1:])),
    ),
)
