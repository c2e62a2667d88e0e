"""The √ε law of ridges: by quadrature over the chart, and on the raster, which misses it; and the order at the pole."""

from functools import cache

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import curve, decades, dots, label_line_end, plot, slope_triangle
from book.figures.chapter_scene import symbolic
from verify.accuracy import orders
from verify.accuracy.orders import SLOPES, fitted_slope, on_the_raster, predicted, quadrature

STEPS = np.logspace(-2, -8, 25)
FITTED = STEPS < 2e-3


@cache
def _curves():
    frame = symbolic()
    law = {name: np.array([quadrature(name, float(step)) for step in STEPS]) for name in SLOPES}
    return law, np.array([on_the_raster("h_u", float(step), frame) for step in STEPS])


@figure
def ridge_law() -> Drawing:
    """RMS error of the central difference of ridges against ε: over the chart, the theorem's law, and on the raster."""
    law, raster = _curves()
    fig, ax = plot(height=3.9)
    for name, marker, side, times in (("h_u", "o", "above", 2), ("h_v", "s", "below", 0.5)):
        curve(ax, STEPS, predicted(name, STEPS)[0], "bound")
        dots(ax, STEPS, law[name], "difference", 3.6, marker)
        label_line_end(ax, STEPS[12], law[name][12] * times, f"chart, ${name}$", "difference", side)
    curve(ax, STEPS, raster, "numeric", "raster, $h_u$", "above", linewidth=1.3)
    decades(ax, 2, 2, ylim=(1e-9, 1e2), xlabel="step ε", ylabel="RMS error of the slope")
    slope_triangle(ax, 3e-8, 2e-4, 0.5)
    numbers, data = {}, {"step": STEPS, "raster_h_u": raster}
    for name, values in law.items():
        right, room = predicted(name, STEPS)
        if (np.abs(values - right) > room + 1e-9).any():
            raise ValueError(f"the RMS of {name} is further from the theorem's than the theorem allows")
        data |= {f"chart_{name}": values, f"law_{name}": right, f"law_{name}_room": room}
        numbers[f"{name}_slope"] = fitted_slope(STEPS[FITTED], values[FITTED])
        numbers[f"{name}_constant"] = (values / right)[FITTED].max()
    return Drawing(fig, numbers, data)


@cache
def _clamped():
    return {field: orders.clamped_errors(field) for field in orders.FIELDS}


@figure("clamped_order")
def clamped_order_figure() -> Drawing:
    """The error of the difference clamped at the pole, v = ε/2: the chapter's fields, and one that is not odd."""
    fig, ax = plot(height=3.4)
    steps, errors = orders.STEPS, _clamped()
    for field, text, marker, role in (
        ("sine", "sine, ridges", "o", "symbolic"),
        ("ridges", "", "x", "symbolic"),
        ("rings", "rings", "s", "symbolic"),
        ("cosine", "cos $πk_vv$", "D", "numeric"),
    ):
        curve(ax, steps, errors[field], role, text, marker=marker, markersize=4, linewidth=0.9)
    decades(ax, xlabel="step ε", ylabel="error of $h_v$")
    slope_triangle(ax, 3e-5, 3e-8, 2)
    slope_triangle(ax, 3e-5, 8e-4, 1)
    fitted = {field: fitted_slope(steps, values) for field, values in errors.items()}
    return Drawing(fig, fitted, {"step": steps, **errors})
