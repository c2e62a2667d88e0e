"""The rays' hits with both spheres: the near roots of their quadratics, and the seed's quadratic for B (F1)."""

from proofs.formulas import camera
from proofs.formulas.camera import (
    POLE,
    discriminant_a,
    discriminant_b,
    normal_of_b,
    radius_length,
    radius_vector,
    ray_direction,
    ray_length_squared,
    rho_raw,
    root_a,
    tangent_squared,
    toward_b,
)
from proofs.theorems.language import *

t, t_a, t_b, hits_a, hits_b = real("t t_a t_b hits_a hits_b")
_APART = {camera.t_a: (hits_a, t_a), camera.t_b: (hits_b, t_b)}
_NUMBERS = {hit: t for hit, (_, t) in _APART.items()}


def off_the_axis(x_at: Expr) -> dict:
    """Return the inputs of a ray through (x, 0), e = 5/4 and R = 3/4: the silhouette is at x = 15/16."""
    return {x: x_at, y: 0, eye: "5/4", radius: "3/4"}


def _apart(symbol, line):
    if symbol in _APART:
        line, condition = line.args[0]
        yield _APART[symbol][0], where(condition, 1, 0)
    yield symbol.xreplace(_NUMBERS), line.xreplace(_NUMBERS)


@evaluated
def met(program: Program) -> Program:
    """Return a program's lines with each hit, which is infinite where there is none, in two.

    hits_a is 1 where there is one, else 0; t_a is where: the value that the line has there, a real number.
    """
    return chain(program.name, dict(pair for line in program.definitions for pair in _apart(*line)))


hit_of_a, hit_of_b = met(camera.hit_of_a), met(camera.hit_of_b)


def along(t: Expr) -> tuple[Expr, Expr, Expr]:
    """Return the point P(t) = (t x, t y, e (1 − t)) of the ray through the image point (x, y)."""
    return (t * x, t * y, eye * (1 - t))


def distance_squared(point: Sequence[Expr], center: Sequence[Expr]) -> Expr:
    """Return |P − C|²."""
    return sum((p - c) ** 2 for p, c in zip(point, center, strict=True))


_origin = (0, 0, 0)
eye_outside_a = (lengths_of_a, rho_raw >= POLE * eye)
ray_meets_a = (eye_outside_a, discriminant_a >= 0)
_solves_a = Claim(
    "solves",
    (equation(hits_a, 1), equation(distance_squared(along(t_a), _origin), radius**2), t_a > 0),
    ray_meets_a,
    hit_of_a,
)
_near_a = Claim(
    "near",
    (
        rho**2 + eye**2 > 0,
        equation((rho**2 + eye**2) * t_a, eye**2 - root_a),
        (rho**2 + eye**2) * t - eye**2 + root_a >= 0,
        t >= t_a,
    ),
    (ray_meets_a, equation(distance_squared(along(t), _origin), radius**2)),
    hit_of_a,
)
_misses_a = Claim(
    "misses",
    (distance_squared(along(t), _origin) > radius**2, zero(hits_a)),
    (eye_outside_a, discriminant_a < 0),
    hit_of_a,
    squares=(rho**2 + eye**2) * t - eye**2,
)

theorem_a = Theorem(
    "hit_of_a",
    "The near hit with sphere A",
    r"""If $e > R$ and $d = (e^2-R^2)(\rho_s^2-\rho^2) \ge 0$, then $t = (e^2-R^2)/(e^2+\sqrt d)$ is the least
    root of $|P(t)|^2 = R^2$, and $t > 0$; if $d < 0$ there is none.""",
    hypotheses=(r"$e > R > 0$", r"$\rho$ is not below $10^{-150} e$"),
    claims=(_solves_a, _near_a, _misses_a),
    steps={
        r"$|P(t)|^2 - R^2 = (\rho^2+e^2)t^2 - 2e^2 t + e^2 - R^2$": "expansion",
        r"$(\rho^2+e^2)\,t = e^2 - \sqrt d$": "the conjugate",
        "any other root is not less": r"$((\rho^2+e^2)t - e^2)^2 = d$ leaves $\pm\sqrt d$",
        r"$d < 0$: no hit": "a square plus something positive",
    },
    mutants=(
        variant(
            "d without e² − R²", _solves_a, equation(distance_squared(along(t_a / tangent_squared), _origin), radius**2)
        ),
        variant("the far root", _near_a, t <= t_a),
        variant("t < 1", _solves_a, t_a < HALF),
    ),
    side_conditions=(
        SideCondition(
            r"$\rho \le \rho_s$",
            "solves",
            holds=off_the_axis("3/4"),
            fails={x: "15/16", y: 0, eye: "5/4", radius: "3/5"},
        ),
        SideCondition(
            "$e > R$",
            "solves",
            undefined=({x: 0, y: "1/2", eye: 1, radius: 1}, {x: 0, y: "1/2", eye: "1/2", radius: 1}),
        ),
    ),
)

_eye = (0, 0, eye)


def _on_the_axis(size):
    """Return the inputs of a ray along the axis, from height 4, with B of a size about a centre at height 3 on it."""
    return {x: 0, y: 0, eye: 4, ball_radius: size, ball_on: 1, ball_center: (0, 0, 3)}


eye_outside_b = distance_squared(_eye, ball_center) > ball_radius**2
_sees_b = (eye_outside_b, discriminant_b >= 0, toward_b > 0, ball_on > 0)
_solves_b = Claim(
    "solves",
    (equation(hits_b, 1), equation(distance_squared(along(t_b), ball_center), ball_radius**2), t_b > 0),
    _sees_b,
    hit_of_b,
)
_length = squared(ray_direction)
_behind_b = Claim(
    "behind",
    (t < 0, zero(hits_b)),
    (eye_outside_b, toward_b <= 0, equation(distance_squared(along(t), ball_center), ball_radius**2)),
    hit_of_b,
    squares=(x * t, y * t, eye * t),
)
_from_the_center = Vector(along(t_b)) - ball_center
_outward_b = Claim(
    "outward",
    (
        ray_length_squared > 0,
        equations(radius_vector, _from_the_center),
        equation(radius_length, ball_radius),
        equations(ball_radius * normal, _from_the_center),
        equations(point, along(t_b)),
    ),
    (_sees_b, ball_radius > 0),
    met(chain("hit_and_normal_of_b", camera.hit_of_b, normal_of_b)),
)
_seed_c = sum(c**2 for c in ball_center) - ball_radius**2
_c = distance_squared(_eye, ball_center) - ball_radius**2
_quadratic = Claim(
    "quadratic",
    (
        equation(distance_squared(along(t), ball_center) - ball_radius**2, _length * t**2 - 2 * toward_b * t + _c),
        equation(discriminant_b, toward_b**2 - _length * _c),
    ),
    lines=hit_of_b,
)

theorem_b = Theorem(
    "hit_of_b",
    "The near hit with sphere B",
    {
        r"""With $D = (x, y, -e)$, $b = -D\cdot(E-C)$, $c = |E-C|^2-R_2^2$ and $d = b^2-|D|^2c$: if $c > 0$, $d \ge 0$
        and $b > 0$, then $t = c/(b+\sqrt d) > 0$ is the least root of $|P(t)-C|^2 = R_2^2$; if $b \le 0$, every root
        is negative. With $K = D\times(E-C)$, $R_2N = (K\times D-\sqrt d\,D)/|D|^2 = P(t)-C$.""": (
            _quadratic,
            _solves_b,
            _behind_b,
            _outward_b,
            coq("hit_of_b__first_hit 95fde9b15390ff07"),
        )
    },
    hypotheses="$c > 0$: the eye is outside B",
    steps={
        r"$|P(t)-C|^2-R_2^2 = |D|^2t^2-2bt+c$": "expansion",
        r"$d = |D|^2R_2^2-|D\times(E-C)|^2$": "Lagrange's identity",
        r"$|D|^2\,t = b-\sqrt d$": "the conjugate",
        r"$K\times D = |D|^2(E-C)+bD$": "a triple product",
        r"$b \le 0$, $t \ge 0$: then $|D|^2t^2-2bt+c > 0$": "a sum of a square and non-negative terms",
    },
    mutants=(
        variant("the seed's c", _quadratic, equation(discriminant_b, toward_b**2 - _length * _seed_c)),
        variant("the inward normal", _outward_b, equations(-ball_radius * normal, _from_the_center)),
        variant("b with its sign turned", _behind_b, given=(eye_outside_b, toward_b >= 0, _behind_b.given[2:])),
    ),
    side_conditions=SideCondition("$c > 0$: the eye is outside B", "solves", fails=(_on_the_axis(1), _on_the_axis(2))),
)
_default = {eye: 4, **dict(zip(ball_center, (HALF, HALF, Rational(13, 10)), strict=True)), ball_radius: Rational(8, 25)}

seed_quadratic = Theorem(
    "seed_quadratic_of_b",
    "The seed's quadratic for sphere B",
    r"The constant term of sphere B's quadratic is $|C|^2-R_2^2$.",
    claims=Claim("constant", equation(_seed_c, _c)),
    refuted_at=_default,
    steps={r"in the default scene $|C|^2-R_2^2 = 2.0876$ and $|E-C|^2-R_2^2 = 7.6876$": "arithmetic"},
    mutants=(
        variant("the constant is |E − C|² − R₂²", _quadratic),
        variant(
            "the two agree where e = 2 C_z", Claim("agree", equation(_seed_c, _c), equation(eye, 2 * ball_center[2]))
        ),
    ),
)

_b = hit_of_b.expand(toward_b).xreplace(_default)
_false_c, _true_c, _squared = (part.xreplace(_default) for part in (_seed_c, _c, _length))
b, d = real("b d")
_covers = Claim(
    "covers",
    (_b > 35 * QUARTER, _b**2 > Rational(1225, 16), _b**2 - _squared * _false_c > 0),
    (x >= -2, x <= 2, y >= -2, y <= 2),
)
_root = _false_c / (b + sqrt(d))
_before = Claim("before", (b + sqrt(d) > 35 * QUARTER, _root > 0, greater(QUARTER, _root)), (b > 35 * QUARTER, d > 0))
_behind = Claim(
    "behind",
    (radius >= eye * (1 - t), eye * t >= eye - radius),
    (radius > 0, equation(squared(along(t)), radius**2)),
    squares=(x * t, y * t),
)

hidden = Theorem(
    "seed_covers_the_view",
    "With the seed's quadratic B is everywhere",
    r"""In the default scene, with $c = |C|^2-R_2^2 = 2.0876$ in place of $|E-C|^2-R_2^2$, every ray with $|x|,
    |y| \le 2$ has $b^2-|D|^2c > 0$ and a root $c/(b+\sqrt d)$ in $(0, \frac14)$; A's points have $t \ge 1-R/e =
    \frac34$. So B covers the view and A is never drawn.""",
    hypotheses=r"the view has $|x| \le 5/\sqrt{15}$, $|y| \le 23/4\sqrt{15}$, both less than 2",
    claims=(_covers, _before, _behind),
    steps={
        r"$b = 10.8+(x+y)/2 > 35/4$": ("the vertex, as for the true quadratic", "hit_of_b"),
        r"$b^2 > 76 > 24 \cdot 2.0876 \ge |D|^2c$": r"$|D|^2 = x^2+y^2+16 \le 24$",
        r"$c/(b+\sqrt d) < c/b < 1/4$": "$d > 0$",
        r"$e(1-t) \le R$ on A": "no point of A is higher than $R$",
    },
    mutants=(
        variant("with the true c too", _covers, _b**2 - _squared * _true_c > 0),
        variant("the root is beyond 1/4", _before, _root > QUARTER),
        variant("A's points have t ≥ 1", _behind, t >= 1, squares=()),
    ),
    side_conditions=SideCondition(r"$|x|, |y| \le 2$", "covers", holds={x: -2, y: "-19/10"}, fails={x: -3, y: -3}),
)
