"""The rays' hits with both spheres: they solve the quadratic, and they are its near roots."""

from collections.abc import Sequence

from sympy import Expr, Rational

from proofs.engine.claim import Claim, equation, greater
from proofs.engine.theorem import Mutant, SideCondition, Step, Theorem, variant
from proofs.formulas import symbols
from proofs.formulas.camera import (
    POLE,
    discriminant_a,
    discriminant_b,
    hit_of_a,
    hit_of_b,
    ray_direction,
    rho_raw,
    root_a,
    root_b,
    t_a,
    t_b,
    tangent_squared,
    toward_b,
)
from proofs.formulas.symbols import ball_center, ball_on, ball_radius, dot, eye, lengths_of_a, radius, real, rho, x, y

t = real("t")


def along(t: Expr) -> tuple[Expr, Expr, Expr]:
    """Return the point P(t) = (t x, t y, e (1 − t)) of the ray through the image point (x, y)."""
    return (t * x, t * y, eye * (1 - t))


def distance_squared(point: Sequence[Expr], center: Sequence[Expr]) -> Expr:
    """Return |P − C|²."""
    return sum((p - c) ** 2 for p, c in zip(point, center, strict=True))


_origin = (0, 0, 0)
eye_outside_a = (*lengths_of_a, eye > radius, rho_raw >= POLE * eye)
ray_meets_a = (*eye_outside_a, discriminant_a >= 0)
_solves_a = Claim(
    "solves", (equation(distance_squared(along(t_a), _origin), radius**2), t_a > 0), ray_meets_a, hit_of_a
)
_near_a = Claim(
    "near",
    (
        greater(rho**2 + eye**2, 0),
        equation((rho**2 + eye**2) * t_a, eye**2 - root_a),
        (rho**2 + eye**2) * t - eye**2 + root_a >= 0,
        t >= t_a,
    ),
    (*ray_meets_a, equation(distance_squared(along(t), _origin), radius**2)),
    hit_of_a,
)
_misses_a = Claim(
    "misses",
    (distance_squared(along(t), _origin) > radius**2,),
    (*eye_outside_a, discriminant_a < 0),
    hit_of_a,
    squares=((rho**2 + eye**2) * t - eye**2,),
)

theorem_a = Theorem(
    id="hit_of_a",
    title="The near hit with sphere A",
    statement=r"If $e > R$ and $d = (e^2-R^2)(\rho_s^2-\rho^2) \ge 0$, then $t = (e^2-R^2)/(e^2+\sqrt d)$ is the least "
    r"root of $|P(t)|^2 = R^2$, and $t > 0$; if $d < 0$ there is none.",
    hypotheses=(r"$e > R > 0$", r"$\rho$ is not below $10^{-150} e$"),
    claims=(_solves_a, _near_a, _misses_a),
    steps=(
        Step(r"$|P(t)|^2 - R^2 = (\rho^2+e^2)t^2 - 2e^2 t + e^2 - R^2$", "expansion"),
        Step(r"$(\rho^2+e^2)\,t = e^2 - \sqrt d$", "the conjugate"),
        Step("any other root is not less", r"$((\rho^2+e^2)t - e^2)^2 = d$ leaves $\pm\sqrt d$"),
        Step(r"$d < 0$: no hit", "a square plus something positive"),
    ),
    mutants=(
        variant(
            "d without e² − R²", _solves_a, equation(distance_squared(along(t_a / tangent_squared), _origin), radius**2)
        ),
        variant("the far root", _near_a, t <= t_a),
        variant("t < 1", _solves_a, t_a < Rational(1, 2)),
    ),
    side_conditions=(
        SideCondition(
            r"$\rho \le \rho_s$",
            "solves",
            holds=[((x, Rational(3, 4)), (y, 0), (eye, Rational(5, 4)), (radius, Rational(3, 4)))],
            undefined=[((x, Rational(15, 16)), (y, 0), (eye, Rational(5, 4)), (radius, Rational(3, 5)))],
        ),
        SideCondition(
            "$e > R$",
            "solves",
            undefined=[
                ((x, 0), (y, Rational(1, 2)), (eye, 1), (radius, 1)),
                ((x, 0), (y, Rational(1, 2)), (eye, Rational(1, 2)), (radius, 1)),
            ],
        ),
    ),
)

_eye = (0, 0, eye)
_half = Rational(1, 2)


def _on_the_axis(eye, z, ball_radius):
    """Return the inputs of a ray along the axis, with B's centre at height z on it."""
    names = {symbols.x: 0, symbols.y: 0, symbols.eye: eye, symbols.ball_radius: ball_radius, ball_on: 1}
    return (*names.items(), *zip(ball_center, (0, 0, z), strict=True))


_outside = distance_squared(_eye, ball_center) > ball_radius**2
_sees_b = (_outside, discriminant_b >= 0, toward_b > 0, ball_on > 0)
_solves_b = Claim(
    "solves", (equation(distance_squared(along(t_b), ball_center), ball_radius**2), t_b > 0), _sees_b, hit_of_b
)
_length = dot(ray_direction, ray_direction)
_near_b = Claim(
    "near",
    (greater(_length, 0), equation(_length * t_b, toward_b - root_b), _length * t - toward_b + root_b >= 0, t >= t_b),
    (eye > 0, *_sees_b[1:], equation(distance_squared(along(t), ball_center), ball_radius**2)),
    hit_of_b,
)
_behind_b = Claim(
    "behind",
    (t < 0,),
    (_outside, toward_b <= 0, equation(distance_squared(along(t), ball_center), ball_radius**2)),
    hit_of_b,
    squares=(x * t, y * t, eye * t),
)
_seed_c = sum(c**2 for c in ball_center) - ball_radius**2
_c = distance_squared(_eye, ball_center) - ball_radius**2
_quadratic = Claim(
    "quadratic",
    (
        equation(distance_squared(along(t), ball_center) - ball_radius**2, _length * t**2 - 2 * toward_b * t + _c),
        equation(discriminant_b, toward_b**2 - _length * _c),
    ),
    (),
    hit_of_b,
)

theorem_b = Theorem(
    id="hit_of_b",
    title="The near hit with sphere B",
    statement=r"With $D = (x, y, -e)$, $b = -D\cdot(E-C)$, $c = |E-C|^2-R_2^2$ and $d = b^2-|D|^2c$: if $c > 0$, "
    r"$d \ge 0$ and $b > 0$, then $t = c/(b+\sqrt d) > 0$ is the least root of $|P(t)-C|^2 = R_2^2$; "
    r"if $b \le 0$, every root is negative.",
    hypotheses=("$c > 0$: the eye is outside B",),
    claims=(_quadratic, _solves_b, _near_b, _behind_b),
    steps=(
        Step(r"$|P(t)-C|^2-R_2^2 = |D|^2t^2-2bt+c$", "expansion"),
        Step(r"$d = |D|^2R_2^2-|D\times(E-C)|^2$", "Lagrange's identity"),
        Step(r"$|D|^2\,t = b-\sqrt d$", "the conjugate"),
        Step(r"$b \le 0$, $t \ge 0$: then $|D|^2t^2-2bt+c > 0$", "a sum of a square and non-negative terms"),
    ),
    mutants=(
        variant("the seed's c", _quadratic, equation(discriminant_b, toward_b**2 - _length * _seed_c)),
        variant("the far root", _near_b, t <= t_b),
        variant("b with its sign turned", _behind_b, given=(_outside, toward_b >= 0, *_behind_b.given[2:])),
    ),
    side_conditions=(
        SideCondition(
            "$c > 0$: the eye is outside B",
            "solves",
            fails=[_on_the_axis(eye=4, z=3, ball_radius=1), _on_the_axis(eye=4, z=3, ball_radius=2)],
        ),
    ),
)

seed_quadratic = Theorem(
    id="seed_quadratic_of_b",
    title="The seed's quadratic for sphere B",
    statement=r"The constant term of sphere B's quadratic is $|C|^2-R_2^2$.",
    claims=(Claim("constant", (equation(_seed_c, _c),)),),
    refuted_at=(
        (eye, 4),
        *zip(ball_center, (_half, _half, Rational(13, 10)), strict=True),
        (ball_radius, Rational(8, 25)),
    ),
    steps=(Step(r"in the default scene $|C|^2-R_2^2 = 2.0876$ and $|E-C|^2-R_2^2 = 7.6876$", "arithmetic"),),
    mutants=(
        Mutant("the constant is |E − C|² − R₂²", _quadratic),
        Mutant(
            "the two agree where e = 2 C_z",
            Claim("agree", (equation(_seed_c, _c),), (equation(eye, 2 * ball_center[2]),)),
        ),
    ),
)
