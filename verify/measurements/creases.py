"""Contrast of a crease in the default scene, and the floats that a rounded product puts on one."""

from collections.abc import Sequence
from fractions import Fraction
from functools import partial

from verify.accuracy import canvas, products
from verify.accuracy.canvas import CREASE_STEP, DARK_STEPS, pictures
from verify.checkers.measurements import Enclosure, measures


@measures(
    "crease_products",
    false={"all of them": {"count": 1824}, "one fewer": {"beside": 1823}, "our kernel does so too": {"zeros": 1756}},
)
def rounded_products_hit_the_crease(beside: int = 1824, count: int = 1756, zeros: int = 0) -> Enclosure:
    """Count, among the nearest floats to all m/k, 0 < m < k ≤ 64, those that are not m/k, and whose k·u rounds to m."""
    return Enclosure(
        pieces=partial(products.off, beside, count, zeros),
        over={"the counts, each over every m and k and its u": ((0, 3),)},
        at=products.off_by_floats,
        bound=0,
        quantity="how far from what is claimed: the floats beside a crease, those that a rounded product k·u puts on "
        "it, those that the kernel does",
    )


@measures("crease_contrast", false={"one order, as the seed says": {"orders": 1}})
def contrast(orders: int = 4) -> Enclosure:
    """Enclose the mean error at the kink flag against that elsewhere on A, in orders of magnitude."""
    return Enclosure(
        pieces=partial(canvas.contrast, orders),
        over={"the picture": ((0, 1),)},
        at=canvas.contrast_drawn,
        bound=Fraction(1, 2),
        quantity="how far the contrast of the exact pictures is from four orders of magnitude, 256², ε = 1e-3",
    )


@measures("dark_difference", false={"at 1e-12 it is dark too": {"steps": (1e-8, 1e-12)}})
def dark(steps: Sequence[float] = DARK_STEPS) -> Enclosure:
    """Enclose 100 |ΔI| on A, of all pixels and channels: it stays below half a level of 255."""
    pixels = int(pictures(CREASE_STEP)[1].stage.on_a.sum())
    return Enclosure(
        pieces=partial(canvas.darkness, steps),
        over={r"\varepsilon": ((0, len(steps)),), "I": ((0, pixels),)},
        at=canvas.darkness_alone,
        bound=1,
        quantity="the largest |ΔI| × 100 on A over half a level, all pixels and channels, 256², linear light",
    )
