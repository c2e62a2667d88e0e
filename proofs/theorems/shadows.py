"""The shadow of a sphere on the floor: a conic, its type by the light's height, and its degree along a row."""

from proofs.formulas.camera import distance, point_on_floor
from proofs.formulas.shadow import body_radius, center, segment_squared, shadow, shadow_discriminant, toward_center
from proofs.theorems.hits import distance_squared
from proofs.theorems.language import *
from proofs.theorems.silhouettes import conic_types, theorem as silhouette_of_b

_on_floor = chain("on_floor", point_on_floor, shadow)
_w = _wx, _wy, _wz = light - center
_lx, _ly, _lz = light
_c = squared(_w) - body_radius**2
_apart = distance_squared(light, center) > body_radius**2
_xx, _xy, _yy = _wx**2 - _c, _wx * _wy, _wy**2 - _c
_to_light = Vector((x, y, 0)) - light  # P − L
_across = dot(_to_light, _w)
foot_x, foot_y = real("foot_x foot_y")
_at_foot = _on_floor.expand(shadow_discriminant).xreplace({x: foot_x, y: foot_y})
_determinant = _xx * _yy - _xy**2
_conic = Claim(
    "conic",
    (
        equation(shadow_discriminant, _across**2 - _c * squared(_to_light)),
        equation(
            shadow_discriminant - _xx * x**2 - 2 * _xy * x * y - _yy * y**2,
            x * Derivative(_at_foot, foot_x) + y * Derivative(_at_foot, foot_y) + _at_foot,
        ),
        equation(_determinant, _c * (_wz**2 - body_radius**2)),
    ),
    zero(foot_x, foot_y),
    _on_floor,
)
_types = conic_types(_c, _determinant, _wz, body_radius, _apart)
_along_row = cross(light, center) - cross(_w, (0, y, 0))
_row = Claim(
    "row",
    (
        equation(
            shadow_discriminant,
            (body_radius**2 - _wy**2 - _wz**2) * x**2
            - 2 * (body_radius**2 * _lx + dot(_along_row, cross((1, 0, 0), _w))) * x
            + body_radius**2 * (_lx**2 + (_ly - y) ** 2 + _lz**2)
            - squared(_along_row),
        ),
        equation(segment_squared, x**2 - 2 * _lx * x + _lx**2 + (_ly - y) ** 2 + _lz**2),
        equation(Derivative(_on_floor.expand(toward_center), x), 2 * x - _lx - center[0]),
    ),
    lines=_on_floor,
)
_origin = dict.fromkeys(center, 0)
_of_a = Claim(
    "of_a",
    equation(
        _on_floor.expand(shadow_discriminant).xreplace(_origin),
        (x * _lx + y * _ly) ** 2 - squared(light) * (x**2 + y**2) + body_radius**2 * squared(_to_light),
    ),
)
_away = Claim("away", equation(segment_squared - toward_center, -_across), lines=_on_floor)
_rename = {
    x: x - _lx,
    y: y - _ly,
    eye: _lz,
    distance: _lz - center[2],
    ball_radius: body_radius,
    ball_center[0]: center[0] - _lx,
    ball_center[1]: center[1] - _ly,
}


def _from_the_light(name):
    """Return a claim about B's silhouette with the light as its eye."""
    claim = silhouette_of_b.claim(name)
    shows, given, squares = (
        [part.xreplace(_rename) for part in parts] for parts in (claim.shows, claim.given, claim.squares)
    )
    return claim.but(shows=shows, given=given, squares=squares)


_behind_a = Claim(
    "behind_a", equation(_on_floor.expand(toward_center).xreplace(_origin), x**2 + y**2 - x * _lx - y * _ly)
)
_leading = Claim(
    "leading", equation(Derivative(_on_floor.expand(shadow_discriminant), x, 2), 2 * (body_radius**2 - _wy**2 - _wz**2))
)

shadow_of_b = Theorem(
    "shadow_of_b_on_floor",
    "A sphere's shadow on the floor is a conic",
    {
        r"""Let the light $L$, $L_z > 0$, be outside the sphere about $C$ of radius $r$, $w = L-C$, $c = |w|^2-r^2$.
        On the floor the shadow's discriminant is $((P-L)\cdot w)^2-c|P-L|^2$, a quadratic in $(x, y)$ with the
        determinant $c\,(w_z^2-r^2)$: an ellipse if the light is above the sphere's top or below its lowest point, a
        parabola if level with either, a hyperbola between. The part cast away from the light has $a\cdot w' < |a|^2$
        ($a = L-P$, $w' = C-P$): all of it if $L_z \ge C_z+r$, none if $L_z \le C_z-r$, and one branch of the
        hyperbola.""": (
            _conic,
            _types,
            _away,
            _from_the_light("all_seen"),
            _from_the_light("none_seen"),
            coq("shadow_of_b_on_floor__real beb8a43c00b0b27a", "shadow_of_b_on_floor__two_branches de9ac851c2bcb394"),
        )
    },
    hypotheses=("$|L-C| > r$", "$L_z > 0$"),
    steps={
        r"$d = (a\cdot w')^2-|a|^2(|w'|^2-r^2)$, the same seen from $L$": ("expansion", "lagrange_identity"),
        r"its quadratic part has the determinant $c\,(w_z^2-r^2)$": "expansion; $c > 0$",
        r"$|a|^2-a\cdot w' = (P-L)\cdot(C-L)$": ("the vertex comes before the light", "occlusion_by_signs"),
        "its sign, type by type": ("the silhouette of the sphere with the light as the eye", "silhouette_of_b"),
    },
    mutants=(
        variant("the determinant is c (w_z² + r²)", _conic, equation(_determinant, _c * (_wz**2 + body_radius**2))),
        variant("an ellipse from any height", _types[2], _determinant > 0),
        variant("the vertex on the sphere's side", _away, equation(segment_squared - toward_center, _across)),
    ),
    side_conditions=SideCondition(
        "the light is not level with the top", "ellipse", fails={light: (0, 0, 3), center: (2, 0, 2), body_radius: 1}
    ),
)

shadow_of_a = Theorem(
    "shadow_of_a_on_floor",
    "Sphere A's shadow on the floor",
    {
        r"""With $C = 0$: $d = (P\cdot L)^2-|L|^2|P|^2+R^2|P-L|^2$, a conic of the type of a sphere's shadow with $w_z
        = L_z$: an ellipse if $L_z > R$. The shadow is its part with $0 < a\cdot w' < |a|^2$, beyond A: $P\cdot L <
        |P|^2$.""": (
            _of_a,
            _behind_a,
            coq("shadow_of_a_on_floor__ellipse 323cdca58282fba4", "shadow_of_a_on_floor__beyond_a a9744a46ff697466"),
        )
    },
    hypotheses="$|L| > R$, $|P| > R$",
    steps={
        "put $C = 0$": ("substitution", "shadow_of_b_on_floor"),
        r"$a\cdot w' = |P|^2-P\cdot L$": ("the vertex comes after P", "occlusion_by_signs"),
    },
    mutants=(
        variant(
            "− R²|P − L|²",
            _of_a,
            equation(_of_a.shows[0].lhs, 2 * _of_a.shows[0].lhs - _of_a.shows[0].rhs + body_radius**2),
        ),
        variant("the vertex on the light's side", _behind_a, negated(_behind_a)),
    ),
)

row = Theorem(
    "shadow_along_a_row",
    "Along a row of pixels the shadow test is quadratic",
    r"""On the floor, for fixed $y$, the discriminant $|a|^2r^2-|a\times w'|^2$ is a polynomial of degree at most
    2 in $x$, with the leading coefficient $r^2-w_y^2-w_z^2$, $w = L-C$; $|a|^2$ and $a\cdot w'$ are quadratics
    with leading coefficient 1, and $|a|^2-a\cdot w'$ is linear. So a row is cut by the roots of two quadratics
    and one linear polynomial.""",
    claims=(_row, _leading, _away),
    steps={
        r"$(L-P)\times(C-P) = L\times C-(L-C)\times P$": r"$P\times P = 0$: linear in $P$, not quadratic",
        r"$|a|^2-a\cdot w' = (P-L)\cdot(C-L)$": ("the conditions of the shadow test", "occlusion_by_signs"),
    },
    mutants=(
        variant(
            "the leading coefficient is r² − w_z²",
            _leading,
            equation(_leading.shows[0].lhs, 2 * (body_radius**2 - _wz**2)),
        ),
        variant(
            "w_x in place of w_y", _leading, equation(_leading.shows[0].lhs, 2 * (body_radius**2 - _wx**2 - _wz**2))
        ),
    ),
)
