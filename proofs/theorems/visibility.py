"""The points of sphere A that are seen: the silhouette's radius, and cos φ > R/e."""

from proofs.formulas.camera import discriminant_a, ray_direction, root_a, tangent_squared
from proofs.theorems.hits import along, eye_outside_a, hit_of_a, off_the_axis, ray_meets_a, t_a
from proofs.theorems.language import *

t = real("t")
_square = rho**2 + eye**2
_inside = Claim(
    "inside",
    (
        positive(tangent_squared, rho_silhouette + rho),
        tangent_squared * (rho_silhouette - rho) >= 0,
        discriminant_a >= 0,
    ),
    (eye_outside_a, rho <= rho_silhouette),
    hit_of_a,
)
_only_inside = Claim("only_inside", (rho_silhouette > 0, rho <= rho_silhouette), ray_meets_a, hit_of_a)
_quadratic = Claim(
    "quadratic", equation(discriminant_a, eye**4 - _square * (eye**2 - radius**2)), eye_outside_a, hit_of_a
)
_in_front = Claim("in_front", (t_a > 0, greater(1, t_a)), ray_meets_a, hit_of_a)
_touching = along(1 - radius**2 / eye**2)
_tangent = Claim(
    "tangent",
    (
        zero(discriminant_a),
        equation(rho**2, rho_silhouette**2),
        equation(squared(_touching), radius**2),
        zero(dot(_touching, ray_direction)),
        equation(eye * _touching[2], radius**2),
    ),
    (eye_outside_a, equation((x**2 + y**2) * (eye**2 - radius**2), eye**2 * radius**2)),
    hit_of_a,
)
_on_a = (ray_meets_a, equation(squared(along(t)), radius**2))
_cos_phi = along(t)[2] / radius
_from_center = _square * t - eye**2
_place = (
    equation(t * _from_center, radius * (radius - eye * _cos_phi)),
    equation(_from_center**2, discriminant_a),
    equation(2 * eye**2 * t, _square * t**2 + eye**2 - radius**2),
    positive(eye**2 * t, t),
)
_visible = Claim(
    "visible",
    (_place, at_least(0, _from_center), -_from_center >= root_a, root_a >= -_from_center, t >= t_a, t_a >= t),
    (_on_a, eye * _cos_phi >= radius),
    hit_of_a,
    squares=(rho * t, eye * t),
)
_hidden = Claim("hidden", (_place, _from_center > 0, t > t_a), (_on_a, eye * _cos_phi < radius), hit_of_a)


def _rim(at):
    """Return the inputs of a ray that touches A at t = 16/25, with a value of t."""
    return off_the_axis("15/16") | {t: at}


silhouette = Theorem(
    "silhouette_of_a",
    "The silhouette of sphere A",
    r"""Let $e > R$. A ray meets A exactly if $\rho \le \rho_s = eR/\sqrt{e^2-R^2}$, and then $0 < t < 1$: in
    front of the floor. At $\rho = \rho_s$ it touches A, $P\cdot D = 0$, at height $P_z = R^2/e$, that is
    $\cos\varphi = R/e$.""",
    hypotheses=("$e > R > 0$", r"$\rho$ is not below $10^{-150} e$"),
    claims=(_quadratic, _inside, _only_inside, _in_front, _tangent),
    steps={
        r"$d = e^4-(\rho^2+e^2)(e^2-R^2) = (e^2-R^2)(\rho_s^2-\rho^2)$": "expansion",
        r"its sign is that of $\rho_s-\rho$": "the other factors are positive",
        r"$t = (e^2-R^2)/(e^2+\sqrt d) < 1$": (r"$e^2-R^2 < e^2 \le e^2+\sqrt d$", "hit_of_a"),
        r"$d = 0$: the double root is $t = e^2/(\rho^2+e^2) = 1-R^2/e^2$": "substitution",
    },
    mutants=(
        variant("ρ_s = R e/√(e² + R²)", _only_inside, eye**2 * radius**2 >= rho**2 * (eye**2 + radius**2)),
        variant("t < 1/2", _in_front, greater(HALF, t_a)),
        variant("cos φ = 0 on the silhouette", _tangent, zero(_touching[2])),
    ),
    side_conditions=(
        SideCondition(r"$\rho \le \rho_s$", "inside", holds=off_the_axis("15/16"), fails=off_the_axis(1)),
        SideCondition("$e > R$", "in_front", undefined={x: 0, y: 0, eye: 1, radius: 1}),
    ),
)

visible = Theorem(
    "visible_iff",
    "Which points of sphere A are seen",
    r"""The point $P(t)$ of A at polar angle $\varphi$ is the ray's near hit, $t = t_A$, where $\cos\varphi \ge
    R/e$ (on the rim $\cos\varphi = R/e$ the two hits are one), and lies behind it, $t > t_A$, where $\cos\varphi
    < R/e$.""",
    hypotheses=("$e > R > 0$", r"$\rho$ is not below $10^{-150} e$", "$|P(t)| = R$", "no other body stands before A"),
    claims=(_visible, _hidden),
    steps={
        r"$t\,((\rho^2+e^2)t-e^2) = R^2-eR\cos\varphi$": r"$R\cos\varphi = e(1-t)$ and $|P(t)| = R$",
        "$t > 0$, and a ray that hits A has $d \\ge 0$": (r"$2e^2t = (\rho^2+e^2)t^2+e^2-R^2$", "silhouette_of_a"),
        r"$(\rho^2+e^2)t-e^2 = \mp\sqrt d$": (r"its square is $d$, its sign that of $R-e\cos\varphi$", "hit_of_a"),
    },
    mutants=(
        variant("visible where cos φ ≥ 0", _visible, given=(_on_a, _cos_phi >= 0)),
        variant("hidden on the rim", _hidden, given=(_on_a, equation(eye * _cos_phi, radius)), at=_rim("16/25")),
        variant("the hidden point is nearer", _hidden, t < t_a),
    ),
    side_conditions=SideCondition(r"$\cos\varphi \ge R/e$", "visible", holds=_rim("16/25"), fails=_rim(1)),
)
