"""At a crease: what the difference returns there, and what it costs in the picture."""

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import label_line_end, palette, plot
from book.figures.chapter_scene import SCENE, numeric, symbolic
from renderer import central, exact, gradient_at
from renderer.picture.facts import crease_contrast

CREASE, ROW = 0.125, 0.47


@figure("crease")
def crease() -> Drawing:
    """h_u of ridges across the crease u = 1/8: exact, and by central differences of three steps."""
    offsets = np.linspace(-0.03, 0.03, 601)
    exact_slope = gradient_at(SCENE, CREASE + offsets, ROW, exact())[0]
    fig, ax = plot(height=3.6)
    data = {"offset": offsets, "exact": exact_slope}
    blue, orange = palette()["symbolic"], palette()["numeric"]
    left, right = offsets < 0, offsets > 0
    for side in (left, right):
        ax.plot(offsets[side], exact_slope[side], color=blue, linewidth=2.2)
    ax.plot(0, 0, marker="o", color=blue, markersize=5)
    for eps, dash in ((0.02, (0, ())), (0.01, (0, (5, 2))), (0.004, (0, (2, 1.5)))):
        slope = gradient_at(SCENE, CREASE + offsets, ROW, central(eps))[0]
        data[f"central_{eps:g}"] = slope
        ax.plot(offsets, slope, color=orange, linewidth=1.3, linestyle=dash)
        corner = int(np.searchsorted(offsets, eps))
        text = f"ε = {eps:g}" if eps == 0.02 else f"{eps:g}"
        label_line_end(ax, offsets[corner], slope[corner], text, orange, side="above")
    label_line_end(ax, offsets[-1], exact_slope[-1], "exact", blue)
    ax.axhline(0, color=palette()["grid"], linewidth=0.8, zorder=0)
    ax.set(ylim=(-11, 11), xlabel="distance δ from the crease, in $u$", ylabel="$h_u$")
    on_kink, off_kink = crease_contrast(numeric(eps=1e-3), symbolic())
    at_crease = gradient_at(SCENE, CREASE, ROW, exact())[0]
    beside = gradient_at(SCENE, CREASE + 1e-6, ROW, exact())[0]
    numbers = {
        "jump": float(exact_slope[right][0] - exact_slope[left][-1]),
        "exact_at": float(at_crease) + 0.0,
        "exact_beside": float(beside),
        "central_at": float(gradient_at(SCENE, CREASE, ROW, central(1e-4))[0]) + 0.0,
        "central_beside": float(gradient_at(SCENE, CREASE + 1e-6, ROW, central(1e-4))[0]),
        "float_sine": float(np.sin(np.pi * 8 * 0.125)),
        "mean_on": on_kink,
        "mean_off": off_kink,
        "orders": float(np.log10(on_kink / off_kink)),
    }
    return Drawing(fig, numbers=numbers, data=data)
