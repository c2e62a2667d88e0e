"""The displaced surface that a bump is not: its silhouette, and its normals."""

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import DASHED, DOTTED, SOLID, curve, decades, plot, slope_triangle
from verify.accuracy.frontiers import fiction
from verify.accuracy.orders import fitted_slope

BETAS, SMALLEST = np.logspace(-3, -1.5, 13), slice(9)  # ... of which orders are fitted to


def _order(values):
    return fitted_slope(BETAS[SMALLEST], values[SMALLEST])


@figure
def frontier_silhouette() -> Drawing:
    """Displacement of the silhouette against β, and the remainder after the first two orders."""
    fig, ax = plot(height=3.9)
    remainders = fiction.silhouette_remainders(BETAS)
    for left, (text, role, dash) in zip(remainders, (
        ("displaced − smooth", "ink", SOLID),
        ("less the first order", "difference", DASHED),
        ("less the second, too", "difference", DOTTED),
    ), strict=True):  # fmt: skip
        curve(ax, BETAS, left, role, text, linestyle=dash)
    decades(ax, 1, 2, xlabel="amplitude β", ylabel="radius of the silhouette, in $R$")
    numbers = {"beta": BETAS[-1], "moved": remainders[0][-1]}
    for order, (left, below) in enumerate(zip(remainders, (6, 6, 20), strict=True)):
        slope_triangle(ax, 3e-3, np.interp(3e-3, BETAS, left) / below, order + 1, decades=0.4)
        numbers[f"order_{order}"] = _order(left)
    return Drawing(fig, numbers)
