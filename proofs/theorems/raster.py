"""The distance of a raster's pixels from the pole: the seed's fallback at the pole touches none of 256² (F10)."""

from proofs.formulas.camera import image_extent, image_point, parallel_radius
from proofs.theorems.language import *

m, n = real("m n")
FALLBACK = Rational(1, 10**4)  # the seed's: below this sin φ it takes another basis

_default = {eye: 4, radius: 1, width: 256, height: 256, column: m, row: n}
_pixel = chain("pixel", image_extent, image_point).expand((x, y))
_nearest = Rational(34, 15) / 256**2  # ρ² of the pixels beside the axis
_whole = ((m - 127) * (m - 128) >= 0, (n - 108) * (n - 109) >= 0)
_radius_squared = sum(c.xreplace(_default) ** 2 for c in _pixel)
_on_the_raster = [
    Claim(
        f"raster_{name}",
        ((2 * m - 255) ** 2 >= 1, (1083 - 10 * n) ** 2 >= 9, _radius_squared >= _nearest),
        (_whole[0], given),
    )
    for name, given in (("above", n <= 108), ("below", n >= 109))
]
_linear = Claim(
    "linear",
    (1 - cos_phi >= 0, eye - radius * cos_phi > 0, rho >= 0, eye * radius * sin_phi >= (eye - radius) * rho),
    (equation(cos_phi**2 + sin_phi**2, 1), sin_phi >= 0, lengths_of_a),
    parallel_radius,
    squares=1 - cos_phi,
)
_on_a = (4 * sin_phi >= 3 * rho, rho >= 0)
_far = Claim("far", (sin_phi > Rational(44, 10000), sin_phi > FALLBACK), (_on_a, rho**2 >= _nearest))
_needed = (FALLBACK * Rational(4, 3)) ** 2
_only_near = Claim("only_near", _needed > rho**2, (_on_a, sin_phi < FALLBACK))
_no_pixel = [c.but(name=c.name + "_far", shows=_radius_squared > _needed) for c in _on_the_raster]
_half_squared = number(image_extent.expand(half).xreplace(_default) ** 2)  # 5/3: its root is no rational number
_in_halves = sum(without(half, image_point[c]).xreplace(_default) ** 2 for c in (x, y))
_beside = Claim("beside", _needed > _half_squared * _in_halves, (_whole, (n - 107) * (n - 110) <= 0))

theorem = Theorem(
    "pixels_off_the_pole",
    "No pixel comes near the pole",
    {
        r"""In the default view every pixel of $256^2$ has $\rho \ge \sqrt{34/15}/256$; a visible point of A has
        $\sin\varphi \ge \rho\,(e-R)/(eR)$; so $\sin\varphi > 0.0044$ on A: the seed's fallback below $10^{-4}$ is
        never taken.""": (_on_the_raster, _linear, _far, coq("pixels_off_the_pole__raster 071ffbc9c44967e6"))
    },
    hypotheses=("$e = 4$, $R = 1$, $256^2$ pixels", "column $m$ and row $n$ are whole numbers"),
    steps={
        r"$x = (2m-255)\sqrt{15}/768$, $y = (1083-10n)\sqrt{15}/3840$": "the pixel's centre",
        r"$|2m-255| \ge 1$, $|1083-10n| \ge 3$": (
            r"whole numbers: $m \le 127$ or $m \ge 128$, $n \le 108$ or $n \ge 109$"
        ),
        r"$\rho = eR\sin\varphi/(e-R\cos\varphi)$ and $\cos\varphi \le 1$": ("a parallel is a circle", "kink_loci"),
        r"$\tfrac34\sqrt{34/15}/256 > 0.0044$": "squared",
    },
    mutants=(
        variant("ρ ≥ 2/256", _on_the_raster[0], _radius_squared >= Rational(4, 256**2), at={m: 127, n: 108}),
        variant("sin φ ≥ ρ/R", _linear, radius * sin_phi >= rho),
        variant(
            "sin φ > 0.0045", _far, sin_phi > Rational(45, 10000), at={sin_phi: "4412/1000000", rho: "5882/1000000"}
        ),
    ),
    side_conditions=SideCondition(
        "column and row are whole numbers",
        "raster_above",
        holds={m: 127, n: 108},
        fails=({m: "255/2", n: 108}, {m: 127, n: "217/2"}),
    ),
)

seed_theorem = Theorem(
    "seed_pole_rows",
    "The seed's rows at the pole",
    r"""In the two rows of $256^2$ beside the axis the fallback is taken: $\sin\varphi < 10^{-4}$, which needs
    $\rho < \tfrac43 10^{-4}$.""",
    hypotheses="$e = 4$, $R = 1$",
    claims=_beside,
    refuted_at={m: 127, n: 108},
    steps={r"at the pixel nearest the axis $\rho = \sqrt{34/15}/256 > 0.0058$": "arithmetic; $m = 127$, $n = 108$"},
    mutants=(
        variant("ρ ≥ √(34/15)/256 at every pixel, n ≤ 108", _on_the_raster[0]),
        variant("no pixel is that near the axis, n ≥ 109", _no_pixel[1]),
        variant("sin φ < 10⁻⁴ needs ρ < 4/3·10⁻⁴", _only_near),
    ),
)
