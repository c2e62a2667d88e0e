"""The error of the picture against the step: its largest value and its RMS on sphere A, for the three fields."""

from functools import cache

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import decades, label_line_end, palette, plot, readable, slope_triangle
from book.figures.chapter_scene import FIELD_NAMES, SIZE, symbolic
from renderer import Scene, central, render
from renderer.sweep import difference_on_a, rms

STEPS = np.logspace(-1, -15, 57)


@cache
def _curves(field):
    reference = symbolic(field)
    frames = (render(Scene(field=field), SIZE, SIZE, central(float(eps)), stage=reference.stage) for eps in STEPS)
    deltas = [difference_on_a(frame, reference) for frame in frames]
    return np.array([np.abs(d).max() for d in deltas]), np.array([rms(d) for d in deltas])


@figure("image_error")
def image_error() -> Drawing:
    """The largest and the RMS difference of the pictures on A against ε, 256 × 256, for sine, ridges and rings."""
    fig, axes = plot("page", 3.4, ncols=3, sharey=True)
    colour, numbers, data = palette()["difference"], {}, {"step": STEPS}
    for ax, field in zip(axes, FIELD_NAMES, strict=True):
        largest, mean = _curves(field)
        data |= {f"{field}_largest": largest, f"{field}_rms": mean}
        ax.plot(STEPS, largest, color=colour, linewidth=1.5)
        ax.plot(STEPS, mean, color=colour, linewidth=1.2, linestyle=(0, (2, 1.5)))
        decades(ax, "both", every=4)
        ax.set_ylim(1e-14, 10)
        ax.set_title(field)
        ax.set_xlabel("step ε")
        numbers |= {f"{field}_largest_least": largest.min(), f"{field}_rms_least": mean.min()}
        numbers |= {f"{field}_largest_eps": STEPS[largest.argmin()], f"{field}_rms_eps": STEPS[mean.argmin()]}
        if field != "ridges":
            slope_triangle(ax, 3e-4, 1e-8, 2, "2")
    axes[0].set_ylabel("error on A")
    largest, mean = _curves(FIELD_NAMES[0])
    label_line_end(axes[0], STEPS[40], largest[40] * 3, "largest", readable(colour), side="above")
    label_line_end(axes[0], STEPS[40], mean[40] / 3, "RMS", readable(colour), side="below")
    return Drawing(fig, numbers=numbers, data=data)
