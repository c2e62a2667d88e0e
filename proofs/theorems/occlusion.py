"""The shadow test: which signs say that a sphere stands between two points, and when none can."""

from proofs.formulas.camera import discriminant_b, ray_direction, toward_b
from proofs.formulas.shadow import body_radius, offset, segment_squared, shadow, shadow_discriminant, toward_center
from proofs.formulas.shadow_cone import along, at_light, curvature, from_body, half_slope, shadow_clearance
from proofs.theorems.hits import distance_squared, hit_of_b
from proofs.theorems.language import *

s = real("s")
_a, _b, _c, _d = real("a b c d")
_root = sqrt(_d)
_positive_at_p = (_a >= 0, _c > 0, equation(_d, _b**2 - _a * _c))
_first = (_b - _root) / _a
_if = Claim(
    "if",
    (
        _a > 0,
        equation((_b - _root) * (_b + _root), _a * _c),
        positive(_b + _root, _b - _root),
        equation((_a - _b - _root) * (_a - _b + _root), _a * (_a - 2 * _b + _c)),
        positive(_a - _b + _root, 1 / _a, _first),
        greater(1, _first),
        zero(_a * _first**2 - 2 * _b * _first + _c),
    ),
    (_positive_at_p, _d >= 0, _b > 0, _b < _a),
)
_only_if = Claim(
    "only_if",
    (positive(_b, _a - _b), equation((_a * s - _b) ** 2, _d), _d >= 0),
    (_positive_at_p, _a - 2 * _b + _c > 0, s > 0, s < 1, zero(_a * s**2 - 2 * _b * s + _c)),
    squares=_a * s - _b,
)


def _lagrange(apex):
    """Return B's discriminant, by Lagrange's identity, where rays start at the apex."""
    return toward_b**2 - squared(ray_direction) * (distance_squared(apex, ball_center) - ball_radius**2)


_of_b = Claim("of_b", equation(discriminant_b, _lagrange((0, 0, eye))), lines=hit_of_b)
_of_shadow = Claim(
    "of_shadow",
    equation(shadow_discriminant, toward_center**2 - segment_squared * (squared(offset) - body_radius**2)),
    lines=shadow,
)

lagrange = Theorem(
    "lagrange_identity",
    "Both discriminants without cancellation",
    r"""$|a|^2r^2 - |a\times w|^2 = (a\cdot w)^2 - |a|^2(|w|^2-r^2)$: for sphere B with $a = (x, y, -e)$, $w = C -
    E$, $r = R_2$; for a shadow with $a = L - P$, $w = C - P$.""",
    claims=(_of_b, _of_shadow),
    steps={r"$|a\times w|^2 = |a|^2|w|^2 - (a\cdot w)^2$": "Lagrange's identity, by expansion"},
    mutants=(
        variant("w = C", _of_b, equation(discriminant_b, _lagrange((0, 0, 0)))),
        variant(
            "+ |a × w|²",
            _of_shadow,
            equation(shadow_discriminant, toward_center**2 - segment_squared * (squared(offset) + body_radius**2)),
        ),
    ),
)

theorem = Theorem(
    "occlusion_by_signs",
    "The shadow test by signs",
    {
        r"""Let $P$ and $L$ be outside the sphere about $C$ of radius $r$. Then $|P+s(L-P)-C| = r$ for some $s$ in
        $(0, 1)$ exactly if $d = |a|^2r^2-|a\times w|^2 \ge 0$ and $0 < a\cdot w < |a|^2$, where $a = L-P$, $w
        = C-P$.""": (
            _if,
            _only_if,
            coq("occlusion_by_signs__iff 6a1d0e5c94ee3d97", "occlusion_by_signs__numerators e6c759cf3432594d"),
        )
    },
    hypotheses="$|C-P| > r$ and $|C-L| > r$",
    steps={
        r"$|P+sa-C|^2-r^2 = |a|^2s^2 - 2(a\cdot w)s + |w|^2-r^2$": (
            "expansion; positive at $s = 0$ and $s = 1$",
            "lagrange_identity",
        ),
        r"if: $s = (a\cdot w-\sqrt d)/|a|^2$ is a root in $(0, 1)$": r"$d < (a\cdot w)^2$ and $d < (|a|^2-a\cdot w)^2$",
        r"only if: a root has $(|a|^2s - a\cdot w)^2 = d \ge 0$": "the square completed",
        "and the vertex lies between the ends": "a convex parabola, positive at both ends, with a root between them",
    },
    mutants=(
        variant("without the vertex before L", _if, given=_if.given[:-1]),
        variant("without the vertex after P", _if, given=(_if.given[:-2], _a > 0, _b < _a)),
        variant("d > 0 for every root", _only_if, _d > 0, at={_a: 4, _b: 2, _c: 1, s: "1/2"}),
    ),
    side_conditions=(
        SideCondition("$|C-P| > r$", "if", fails={_a: 4, _b: 2, _c: 0, _d: 4}),
        SideCondition(
            "$|C-L| > r$",
            "only_if",
            holds={_a: 4, _b: 3, _c: 2, _d: 1, s: "1/2"},
            fails={_a: 4, _b: 4, _c: 3, _d: 4, s: "1/2"},
        ),
    ),
)


axis, aside = vectors("axis aside")
distance, wander, reach, product, share = real("distance wander reach product share")
_met = axis + aside
_cone = Claim(
    "cone",
    (
        equation(distance**2 * wander**2 - product**2, squared(cross(axis, aside))),
        nonnegative(distance**2 * wander**2 - product**2, distance * wander, distance * wander + product),
        equation(squared(_met), (distance - wander) ** 2 + 2 * (distance * wander + product)),
        distance - wander > body_radius,
        (distance - wander) ** 2 > body_radius**2,
        squared(_met) > body_radius**2,
    ),
    (
        body_radius > 0,
        wander >= 0,
        reach >= wander,
        distance > body_radius + reach,
        equation(distance**2, squared(axis)),
        equation(wander**2, squared(aside)),
        equation(product, dot(axis, aside)),
    ),
    squares=cross(axis, aside),
)
_to_ball = real("to_ball_x to_ball_y to_ball_z")
_within = Claim(
    "within", (share * ball_radius) ** 2 >= sum((share * d) ** 2 for d in _to_ball), ball_radius**2 >= squared(_to_ball)
)
_on_axis = from_body + share * along
_value = at_light + share * (2 * half_slope + share * curvature)
_clearance = Claim(
    "quadratic",
    equation(squared(_on_axis) - (body_radius + share * ball_radius) ** 2, _value),
    (),
    shadow_clearance.keep(at_light, half_slope, curvature, name="along_the_axis"),
)
_low, _slope, _bend, _at = real("low slope bend at")
_parabola = _low + share * (2 * _slope + share * _bend)
_least = [
    Claim(name, _parabola >= bound, given)
    for name, bound, given in (
        ("turns_before", _low, (share >= 0, _bend > 0, _slope >= 0)),
        ("turns_between", _low + _at * (2 * _slope + _at * _bend), (_bend > 0, zero(_slope + _at * _bend))),
        ("turns_after", _low + 2 * _slope + _bend, (share <= 1, _bend > 0, _slope + _bend <= 0)),
    )
]
_chord = Claim(
    "bends_down",
    _parabola >= (1 - share) * _low + share * (_low + 2 * _slope + _bend),
    (share >= 0, share <= 1, _bend <= 0),
)


def _points(apart):
    """Return a body of radius 1 at the origin, and a point `apart` along x that strays back by 1."""
    vectors = {axis: (apart, 0, 0), aside: (-1, 0, 0)}
    return {**vectors, distance: apart, wander: 1, reach: 1, product: -apart, body_radius: 1}


cone = Theorem(
    "shadow_out_of_reach",
    "A body that clears the cone of light casts no shadow",
    {
        """The segments from a light $L$ to a ball (centre $C$, radius $s$) pass at share $t$ of the way within
        $ts$ of $L + t(C-L)$.""": _within,
        r"""If $|L - c + t(C-L)| > r + ts$ for all $t \in [0,1]$, no such segment meets the ball of radius $r$
        about $c$.""": _cone,
        r"The squares' difference is a quadratic in $t$, least at an end or where it turns,": (
            _clearance,
            _least,
            _chord,
        ),
        "and where the program's least is positive, none of the segments meets the ball.": coq(
            "shadow_out_of_reach__program e8588dfcd3f2e7f4"
        ),
    },
    hypotheses=("$r, s > 0$", "in the last sentence $|L - c| > r$"),
    steps={
        r"$X\cdot w \ge -|X||w|$, so $|X + w| \ge |X| - |w|$": "Lagrange's identity",
        r"$|X| - |w| > r + ts - |w| \ge r$": r"$|w| \le ts$",
        r"$|X(t)|^2 - (r+ts)^2 = f_0 + 2f_1 t + f_2 t^2$": "expansion; its least value on $[0,1]$ by the sign of $f_2$",
    },
    mutants=(
        variant(
            "without the ball's reach",
            _cone,
            given=(_cone.given[:3], distance > body_radius, _cone.given[4:]),
            at=_points(3 * HALF),
        ),
        variant("the ends are enough", _least[1], _parabola >= _low),
        variant(
            "a ball of radius s all the way",
            _clearance,
            equation(squared(_on_axis) - (body_radius + ball_radius) ** 2, _value),
        ),
    ),
    side_conditions=SideCondition("$|X| > r + ts$", "cone", holds=_points(5 * HALF), fails=_points(2)),
)
