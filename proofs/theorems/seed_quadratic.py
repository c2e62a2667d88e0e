"""What the seed's quadratic for sphere B draws: B, everywhere (F1)."""

from sympy import Rational, sqrt

from proofs.engine.claim import Claim, at_least, equation, greater
from proofs.engine.theorem import SideCondition, Step, Theorem, variant
from proofs.formulas.camera import hit_of_b, ray_direction, toward_b
from proofs.formulas.symbols import ball_center, ball_radius, dot, eye, radius, real, x, y
from proofs.theorems.hits import along

t, b, d = real("t b d")
_default = {
    eye: 4,
    ball_radius: Rational(8, 25),
    **dict(zip(ball_center, (Rational(1, 2), Rational(1, 2), Rational(13, 10)), strict=True)),
}
_b = hit_of_b.expand(toward_b).xreplace(_default)
_seed_c = (sum(c**2 for c in ball_center) - ball_radius**2).xreplace(_default)
_true_c = (dot((0, 0, eye), (0, 0, eye)) - 2 * eye * ball_center[2]).xreplace(_default) + _seed_c
_length = dot(ray_direction, ray_direction).xreplace(_default)
_covers = Claim(
    "covers",
    (greater(_b, Rational(35, 4)), greater(_b**2, Rational(1225, 16)), greater(_b**2 - _length * _seed_c, 0)),
    (x >= -2, x <= 2, y >= -2, y <= 2),
)
_root = _seed_c / (b + sqrt(d))
_before = Claim(
    "before",
    (greater(b + sqrt(d), Rational(35, 4)), greater(_root, 0), greater(Rational(1, 4), _root)),
    (b > Rational(35, 4), d > 0),
    ranges=((b, (9, 12)), (d, (0, 100))),
)
_behind = Claim(
    "behind",
    (at_least(radius, eye * (1 - t)), at_least(eye * t, eye - radius)),
    (radius > 0, equation(dot(along(t), along(t)), radius**2)),
    squares=(x * t, y * t),
)

hidden = Theorem(
    id="seed_covers_the_view",
    title="With the seed's quadratic B is everywhere",
    statement="In the default scene, with $c = |C|^2-R_2^2 = 2.0876$ in place of $|E-C|^2-R_2^2$, every ray with "
    r"$|x|, |y| \le 2$ has $b^2-|D|^2c > 0$ and a root $c/(b+\sqrt d)$ in $(0, \frac14)$; A's points have $t \ge 1-R/e "
    r"= \frac34$. So B covers the view and A is never drawn.",
    hypotheses=(r"the view has $|x| \le 5/\sqrt{15}$, $|y| \le 23/4\sqrt{15}$, both less than 2",),
    claims=(_covers, _before, _behind),
    steps=(
        Step(r"$b = 10.8+(x+y)/2 > 35/4$", "the vertex, as for the true quadratic", ("hit_of_b",)),
        Step(r"$b^2 > 76 > 24 \cdot 2.0876 \ge |D|^2c$", r"$|D|^2 = x^2+y^2+16 \le 24$"),
        Step(r"$c/(b+\sqrt d) < c/b < 1/4$", "$d > 0$"),
        Step(r"$e(1-t) \le R$ on A", "no point of A is higher than $R$"),
    ),
    mutants=(
        variant("with the true c too", _covers, greater(_b**2 - _length * _true_c, 0)),
        variant("the root is beyond 1/4", _before, greater(_root, Rational(1, 4))),
        variant("A's points have t ≥ 1", _behind, at_least(t, 1), squares=()),
    ),
    side_conditions=(
        SideCondition(
            r"$|x|, |y| \le 2$", "covers", holds=[((x, -2), (y, Rational(-19, 10)))], fails=[((x, -3), (y, -3))]
        ),
    ),
)
