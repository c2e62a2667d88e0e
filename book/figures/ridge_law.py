"""The √ε law of ridges: by quadrature over the chart, and on the raster, which misses it; and the order at the pole."""

from functools import cache

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import bound_style, decades, label_line_end, palette, plot, slope_triangle
from book.figures.chapter_scene import symbolic
from verify.accuracy import orders
from verify.accuracy.orders import fitted_slope, on_the_raster, predicted, quadrature

STEPS = np.logspace(-2, -8, 25)
FITTED = STEPS < 2e-3


@cache
def _curves():
    frame = symbolic()
    law = {name: np.array([quadrature(name, float(step)) for step in STEPS]) for name in ("h_u", "h_v")}
    return law, np.array([on_the_raster("h_u", float(step), frame) for step in STEPS])


@figure("ridge_law")
def ridge_law() -> Drawing:
    """RMS error of the central difference of ridges against ε: over the chart, the theorem's law, and on the raster."""
    law, raster = _curves()
    fig, ax = plot(height=3.9)
    colour, orange = palette()["difference"], palette()["numeric"]
    for name, marker in (("h_u", "o"), ("h_v", "s")):
        ax.plot(STEPS, predicted(name, STEPS)[0], **bound_style())
        ax.plot(STEPS, law[name], color=colour, linewidth=0, marker=marker, markersize=3.6)
        label_line_end(ax, STEPS[12], law[name][12] * (2 if name == "h_u" else 0.5), f"chart, ${name}$",
                       colour, side="above" if name == "h_u" else "below")  # fmt: skip
    ax.plot(STEPS, raster, color=orange, linewidth=1.3)
    label_line_end(ax, STEPS[-1], raster[-1], "raster, $h_u$", orange, side="above")
    decades(ax, 2, 2, ylim=(1e-9, 1e2), xlabel="step ε", ylabel="RMS error of the slope")
    slope_triangle(ax, 3e-8, 2e-4, 0.5, "½")
    numbers, data = {}, {"step": STEPS, "raster_h_u": raster}
    for name, values in law.items():
        right, room = predicted(name, STEPS)
        if (np.abs(values - right) > room + 1e-9).any():
            raise ValueError(f"the RMS of {name} is further from the theorem's than the theorem allows")
        data |= {f"chart_{name}": values, f"law_{name}": right, f"law_{name}_room": room}
        numbers[f"{name}_slope"] = fitted_slope(STEPS[FITTED], values[FITTED])
        numbers[f"{name}_constant"] = float((values / right)[FITTED].max())
    return Drawing(fig, numbers=numbers, data=data)


@cache
def _clamped():
    return {field: orders.clamped_errors(field) for field in orders.FIELDS}


@figure("clamped_order")
def clamped_order_figure() -> Drawing:
    """The error of the difference clamped at the pole, v = ε/2: the chapter's fields, and one that is not odd."""
    fig, ax = plot(height=3.4)
    blue, orange = palette()["symbolic"], palette()["numeric"]
    names = {"sine": "sine, ridges", "rings": "rings", "cosine": "cos $πk_vv$"}
    markers = {"sine": "o", "ridges": "x", "rings": "s", "cosine": "D"}
    for field, values in _clamped().items():
        colour = orange if field == "cosine" else blue
        ax.plot(orders.STEPS, values, color=colour, marker=markers[field], markersize=4, linewidth=0.9)
        if field in names:
            label_line_end(ax, orders.STEPS[-1], values[-1], names[field], colour)
    decades(ax, xlabel="step ε", ylabel="error of $h_v$")
    slope_triangle(ax, 3e-5, 3e-8, 2, "2")
    slope_triangle(ax, 3e-5, 8e-4, 1, "1")
    fitted = {f: fitted_slope(orders.STEPS, values) for f, values in _clamped().items()}
    return Drawing(fig, numbers=fitted, data={"step": orders.STEPS, **_clamped()})
