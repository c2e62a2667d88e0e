"""When one sphere cannot shade another: the segments from a light to a ball fill a cone, and the body clears it."""

from sympy import Rational

from proofs.engine.claim import Claim, at_least, equation, greater
from proofs.engine.theorem import Clause, SideCondition, Step, Theorem, variant
from proofs.formulas.shadow import body_radius
from proofs.formulas.shadow_cone import along, at_light, curvature, from_body, half_slope, shadow_clearance
from proofs.formulas.symbols import ball_radius, cross, dot, real, vector

axis, aside = vector("axis"), vector("aside")
distance, wander, reach, product, share = real("distance wander reach product share")
_met = axis + aside
_cone = Claim(
    "cone",
    (
        equation(distance**2 * wander**2 - product**2, dot(cross(axis, aside), cross(axis, aside))),
        at_least(distance**2 * wander**2 - product**2, 0),
        at_least(distance * wander, 0),
        at_least(distance * wander + product, 0),
        equation(dot(_met, _met), (distance - wander) ** 2 + 2 * (distance * wander + product)),
        greater(distance - wander, body_radius),
        greater((distance - wander) ** 2, body_radius**2),
        greater(dot(_met, _met), body_radius**2),
    ),
    (
        body_radius > 0,
        wander >= 0,
        reach >= wander,
        distance > body_radius + reach,
        equation(distance**2, dot(axis, axis)),
        equation(wander**2, dot(aside, aside)),
        equation(product, dot(axis, aside)),
    ),
    squares=cross(axis, aside),
)
_to_ball = real("to_ball_x to_ball_y to_ball_z")
_within = Claim(
    "within",
    (at_least((share * ball_radius) ** 2, sum((share * d) ** 2 for d in _to_ball)),),
    (at_least(ball_radius**2, dot(_to_ball, _to_ball)),),
    squares=(share,),
)
_on_axis = from_body + share * along
_value = at_light + share * (2 * half_slope + share * curvature)
_quadratic = Claim(
    "quadratic",
    (equation(dot(_on_axis, _on_axis) - (body_radius + share * ball_radius) ** 2, _value),),
    (),
    shadow_clearance.keep(at_light, half_slope, curvature, name="along_the_axis"),
)
_low, _slope, _bend, _at = real("low slope bend at")
_parabola = _low + share * (2 * _slope + share * _bend)
_least = tuple(
    Claim(name, (at_least(_parabola, bound),), given)
    for name, bound, given in (
        ("turns_before", _low, (share >= 0, _bend > 0, _slope >= 0)),
        ("turns_between", _low + _at * (2 * _slope + _at * _bend), (_bend > 0, equation(_slope + _at * _bend, 0))),
        ("turns_after", _low + 2 * _slope + _bend, (share <= 1, _bend > 0, _slope + _bend <= 0)),
    )
)
_chord = Claim(
    "bends_down",
    (at_least(_parabola, (1 - share) * _low + share * (_low + 2 * _slope + _bend)),),
    (share >= 0, share <= 1, _bend <= 0),
)


def _points(apart):
    """Return a body of radius 1 at the origin, and a point `apart` along x that strays back by 1."""
    vectors = zip((*axis, *aside), (apart, 0, 0, -1, 0, 0), strict=True)
    return (*vectors, (distance, apart), (wander, 1), (reach, 1), (product, -apart), (body_radius, 1))


theorem = Theorem(
    id="shadow_out_of_reach",
    title="A body that clears the cone of light casts no shadow",
    statement=(
        Clause(
            "The segments from a light $L$ to a ball (centre $C$, radius $s$) pass at share $t$ of the way within $ts$ "
            "of $L + t(C-L)$.",
            (_within,),
        ),
        Clause(
            r"If $|L - c + t(C-L)| > r + ts$ for all $t \in [0,1]$, no such segment meets the ball of radius "
            r"$r$ about $c$.",
            (_cone,),
        ),
        Clause(
            r"The squares' difference is a quadratic in $t$, least at an end or where it turns.",
            (_quadratic, *_least, _chord),
        ),
    ),
    hypotheses=("$r, s > 0$",),
    steps=(
        Step(r"$X\cdot w \ge -|X||w|$, so $|X + w| \ge |X| - |w|$", "Lagrange's identity"),
        Step(r"$|X| - |w| > r + ts - |w| \ge r$", r"$|w| \le ts$"),
        Step(
            r"$|X(t)|^2 - (r+ts)^2 = f_0 + 2f_1 t + f_2 t^2$",
            "expansion; its least value on $[0,1]$ by the sign of $f_2$",
        ),
    ),
    mutants=(
        variant(
            "without the ball's reach",
            _cone,
            *_cone.shows[-1:],
            given=(
                body_radius > 0,
                wander >= 0,
                reach >= wander,
                distance > body_radius,
                equation(distance**2, dot(axis, axis)),
                equation(wander**2, dot(aside, aside)),
                equation(product, dot(axis, aside)),
            ),
            at=_points(Rational(3, 2)),
        ),
        variant("the ends are enough", _least[1], at_least(_parabola, _low)),
        variant(
            "a ball of radius s all the way",
            _quadratic,
            equation(dot(_on_axis, _on_axis) - (body_radius + ball_radius) ** 2, _value),
        ),
    ),
    side_conditions=(SideCondition("$|X| > r + ts$", "cone", holds=[_points(Rational(5, 2))], fails=[_points(2)]),),
)
