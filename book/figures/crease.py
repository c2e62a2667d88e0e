"""At a crease: what the difference returns there, and what it costs in the picture."""

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import DASHED, SHORT, SOLID, curve, label_line_end, palette, plot
from book.figures.chapter_scene import SCENE, numeric, symbolic
from renderer import central, exact, gradient_at
from renderer.picture.facts import crease_contrast

CREASE, ROW = 0.125, 0.47


@figure
def crease() -> Drawing:
    """h_u of ridges across the crease u = 1/8: exact, and by central differences of three steps."""
    offsets = np.linspace(-0.03, 0.03, 601)
    exact_slope = gradient_at(SCENE, CREASE + offsets, ROW, exact())[0]
    fig, ax = plot(height=3.6)
    data = {"offset": offsets, "exact": exact_slope}
    left, right = offsets < 0, offsets > 0
    curve(ax, offsets[left], exact_slope[left], "symbolic", linewidth=2.2)
    curve(ax, offsets[right], exact_slope[right], "symbolic", "exact", linewidth=2.2)
    ax.plot(0, 0, marker="o", color=palette()["symbolic"], markersize=5)
    for eps, dash, text in ((0.02, SOLID, "ε = 0.02"), (0.01, DASHED, "0.01"), (0.004, SHORT, "0.004")):
        slope = gradient_at(SCENE, CREASE + offsets, ROW, central(eps))[0]
        data[f"central_{eps:g}"] = slope
        curve(ax, offsets, slope, "numeric", linewidth=1.3, linestyle=dash)
        corner = np.searchsorted(offsets, eps)
        label_line_end(ax, offsets[corner], slope[corner], text, "numeric", "above")
    ax.axhline(0, color=palette()["grid"], linewidth=0.8, zorder=0)
    ax.set(ylim=(-11, 11), xlabel="distance δ from the crease, in $u$", ylabel="$h_u$")
    on_kink, off_kink = crease_contrast(numeric(eps=1e-3), symbolic())
    numbers = {"jump": exact_slope[right][0] - exact_slope[left][-1]}
    for name, method in (("exact", exact()), ("central", central(1e-4))):
        at, beside = gradient_at(SCENE, CREASE + np.array([0, 1e-6]), ROW, method)[0]
        numbers[name] = {"at": at + 0.0, "beside": beside}  # −0 is 0
    numbers |= {"float_sine": np.sin(np.pi * SCENE.ku * CREASE), "mean_on": on_kink, "mean_off": off_kink}
    return Drawing(fig, numbers | {"orders": np.log10(on_kink / off_kink)}, data)
