"""The silhouette of sphere B: a conic, its type, and the branch that is not seen; for any apex, as shadows need it."""

from proofs.formulas.camera import discriminant_b, distance, ray_direction, toward_b
from proofs.theorems.hits import eye_outside_b, hit_of_b
from proofs.theorems.language import *

_cx, _cy, _cz = ball_center
_above = eye - _cz  # H: how far the eye is above B's centre
_c = _cx**2 + _cy**2 + _above**2 - ball_radius**2
_xx, _xy, _yy = _cx**2 - _c, _cx * _cy, _cy**2 - _c
_xz, _yz, _zz = eye * _above * _cx, eye * _above * _cy, eye**2 * (_above**2 - _c)
_determinant = _xx * _yy - _xy**2
_conic = Claim(
    "conic",
    (
        equation(discriminant_b, _xx * x**2 + 2 * _xy * x * y + _yy * y**2 + 2 * _xz * x + 2 * _yz * y + _zz),
        equation(_determinant, _c * (_above**2 - ball_radius**2)),
        equation(
            _xx * (_yy * _zz - _yz**2) - _xy * (_xy * _zz - _yz * _xz) + _xz * (_xy * _yz - _yy * _xz),
            eye**2 * _c**2 * ball_radius**2,
        ),
    ),
    lines=hit_of_b,
)


def conic_types(c: Expr, determinant: Expr, height: Expr, radius: Expr, outside: Basic) -> tuple[Claim, ...]:
    """Return the claims that a sphere's outline is an ellipse, a parabola or a hyperbola, by the height above it."""
    cases = (
        ("ellipse", determinant > 0, height**2 > radius**2),
        ("parabola", zero(determinant), equation(height**2, radius**2)),
        ("hyperbola", greater(0, determinant), height**2 < radius**2),
    )
    return tuple(Claim(name, (c > 0, shown), (outside, given)) for name, shown, given in cases)


_types = conic_types(_c, _determinant, _above, ball_radius, eye_outside_b)
_s, _q, _image = _cx**2 + _cy**2, x * _cx + y * _cy, x**2 + y**2
_h = distance  # H = e − C_z
_ch = _s + _h**2 - ball_radius**2
_bh = _q + eye * _h
_apart = (
    *nonnegative((_h - ball_radius) * (_h + ball_radius), _image, (_ch - _s) * _image),
    _s * _image >= _q**2,
    *positive(eye**2, _ch * eye**2),
    _ch * (_image + eye**2) > _q**2,
    _bh**2 - _q**2 > 0,
    equation(_bh**2 - _q**2, eye * _h * (2 * _bh - eye * _h)),
)
_inside = (_ch > 0, _bh**2 >= _ch * (_image + eye**2))
_all_seen = Claim(
    "all_seen",
    (positive(_h, eye * _h), _apart, positive(2 * _bh - eye * _h, _bh)),
    (lengths_of_b, _h >= ball_radius, _inside),
    squares=x * _cy - y * _cx,
)
_none_seen = Claim(
    "none_seen",
    (
        positive(-_h, -eye * _h),
        (-_h - ball_radius) * (-_h + ball_radius) >= 0,
        _apart[1:],
        -2 * _bh + eye * _h > 0,
        greater(0, _bh),
    ),
    (lengths_of_b, -_h >= ball_radius, _inside),
    squares=x * _cy - y * _cx,
)
_branch = Claim(
    "branch",
    (equation(toward_b**2, _c * squared(ray_direction)), positive(squared(ray_direction), toward_b**2)),
    (eye > 0, eye_outside_b, zero(discriminant_b)),
    hit_of_b,
)


def _scene(eye_height, x_at, center=(2, 0, 3)):
    """Return the inputs of the conic's type for an eye above a centre on the axis."""
    return {eye: eye_height, x: x_at, y: 0, ball_center: center, ball_radius: 1}


theorem = Theorem(
    "silhouette_of_b",
    "The silhouette of sphere B is a conic",
    {
        r"""Let $H = e-C_z$ and $c = |E-C|^2-R_2^2 > 0$. The silhouette $b^2 = c\,(x^2+y^2+e^2)$, $b = xC_x+yC_y+eH$,
        is a non-degenerate conic, with the determinants $c\,(H^2-R_2^2)$ and $e^2c^2R_2^2$: an ellipse if $|H| >
        R_2$, a parabola if $|H| = R_2$, a hyperbola if $|H| < R_2$. It is seen where $b > 0$, where the hits have $t
        > 0$: all of it if $H \ge R_2$, none if $H \le -R_2$, and of the hyperbola the branch $b > 0$; the branch $b <
        0$ is spurious.""": (
            _conic,
            _types,
            _branch,
            _all_seen,
            _none_seen,
            coq(
                "silhouette_of_b__real 8669fc783985e2e4",
                "silhouette_of_b__two_branches 94a77f8fbacf49c4",
                "silhouette_of_b__meets 8edc7ff611f9eaab",
            ),
        )
    },
    hypotheses="$c > 0$: the eye is outside B",
    steps={
        r"$d = b^2-c\,(x^2+y^2+e^2)$, written as a quadratic form in $(x, y, 1)$": ("expansion", "lagrange_identity"),
        r"its determinants are $c\,(H^2-R_2^2)$ and $e^2c^2R_2^2 \ne 0$": "expansion; $c > 0$",
        r"on it $b^2 > 0$; $b < 0$ has $t < 0$": (r"$b \le 0$: every root is negative", "hit_of_b"),
        r"$H \ge R_2$: $b^2 > (xC_x+yC_y)^2$": r"$c \ge C_x^2+C_y^2$ and Cauchy's inequality",
        r"so $eH(2b-eH) > 0$ and $b > 0$; $H \le -R_2$ likewise": r"$b^2-(b-eH)^2 = eH(2b-eH)$",
    },
    mutants=(
        variant("the determinant is c (H² + R₂²)", _conic, equation(_determinant, _c * (_above**2 + ball_radius**2))),
        variant("an ellipse even if |H| < R₂", _types[2], _determinant > 0),
        variant("b > 0 on all of the silhouette", _branch, toward_b > 0),
    ),
    side_conditions=(
        SideCondition("$|H| > R_2$", "ellipse", holds=_scene(5, 0), fails=_scene(4, 0)),
        SideCondition(
            "$H \\ge R_2$",
            "all_seen",
            fails=({**_scene(1, -9, (2, 0, 0)), distance: 0}, {**_scene(1, -9, (2, 0, 0)), distance: 1}),
        ),
    ),
)
