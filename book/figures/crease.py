"""The difference where no field is smooth: at a crease, and over all of them (the √ε law of ridges)."""

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import DASHED, SHORT, SOLID, colour_of, curve, label_line_end, plot
from book.figures.chapter_scene import SCENE, numeric, symbolic
from renderer import central, exact, gradient_at
from verify.accuracy.canvas import crease_contrast
from verify.accuracy.orders import SLOPES, fitted_slope, predicted, quadrature

CREASE, ROW = 0.125, 0.47


def _slope(offsets, method):
    """Return h_u of ridges at these distances from the crease u = 1/8."""
    return gradient_at(SCENE, CREASE + offsets, ROW, method)[0]


@figure
def crease() -> Drawing:
    """h_u of ridges across the crease u = 1/8: exact, and by central differences of three steps."""
    offsets = np.linspace(-0.03, 0.03, 601)
    exact_slope = _slope(offsets, exact())
    fig, ax = plot(height=3.6)
    for side, text, name in ((offsets < 0, "", "left"), (offsets > 0, "exact", "right")):
        curve(ax, offsets[side], exact_slope[side], "symbolic", text, label=f"exact, {name}", linewidth=2.2)
    curve(ax, 0, 0, "symbolic", marker="o", markersize=5)
    for eps, dash, text, at, side in (
        (0.02, SOLID, "ε = 0.02", 0.014, "right"), (0.01, DASHED, "0.01", 0.01, "above"),
        (0.004, SHORT, "0.004", -0.004, "below"),
    ):  # fmt: skip
        slope, index = _slope(offsets, central(eps)), np.searchsorted(offsets, at)
        curve(ax, offsets, slope, "numeric", label=text, linewidth=1.3, linestyle=dash)
        label_line_end(ax, at, slope[index], text, "numeric", side)
    ax.axhline(0, color=colour_of("grid"), linewidth=0.8, zorder=0)
    ax.set(ylim=(-11, 11), xlabel="distance δ from the crease, in $u$", ylabel="$h_u$")
    on_kink, off_kink = crease_contrast(numeric(eps=1e-3), symbolic())
    numbers = {"jump": exact_slope[offsets > 0][0] - exact_slope[offsets < 0][-1]}
    for name, method in (("exact", exact()), ("central", central(1e-4))):
        at, beside = _slope(np.array([0, 1e-6]), method)
        numbers[name] = {"at": at + 0.0, "beside": beside}  # −0 is 0
    numbers |= {"float_sine": np.sin(np.pi * SCENE.ku * CREASE), "mean_on": on_kink, "mean_off": off_kink}
    return Drawing(fig, numbers | {"orders": np.log10(on_kink / off_kink)})


STEPS = np.logspace(-2, -8, 25)
FITTED = STEPS < 2e-3


@figure
def ridge_law() -> Drawing:
    """The RMS error of the central difference of ridges over the chart, against the theorem's law; numbers only."""
    law = {name: np.array([quadrature(name, float(step)) for step in STEPS]) for name in SLOPES}
    numbers = {}
    for name, values in law.items():
        right, room = predicted(name, STEPS)
        if (np.abs(values - right) > room + 1e-9).any():
            raise ValueError(f"the RMS of {name} is further from the theorem's than the theorem allows")
        numbers[f"{name}_slope"] = fitted_slope(STEPS[FITTED], values[FITTED])
        numbers[f"{name}_constant"] = (values / right)[FITTED].max()
    return Drawing(numbers=numbers)
