"""The ε-sweep: the RMS and the largest difference of the three fields' pictures on A against the step."""

from functools import cache

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import decades, label_curve, label_line_end, palette, plot, slope_triangle
from book.figures.chapter_scene import FIELD_NAMES, SIZE, symbolic
from proofs.formulas.height_fields import HEIGHT_FIELDS
from renderer import Scene, central, render
from renderer.picture.facts import flat_difference, flips_everywhere, pixels_near_the_pole
from renderer.picture.sweep import DECADES, difference_on_a, rms, sweep

DASHES = {"sine": (0, (5, 2)), "ridges": (0, ()), "rings": (0, (1.5, 1.5))}
STEPS = np.logspace(-1, -15, 57)
SHOWN = 49  # of them, down to 1e-13, in the picture of the RMS alone


@cache
def _curves(field):
    """Return the largest and the RMS difference on A at every step."""
    reference = symbolic(field)
    frames = (render(Scene(field=field), SIZE, SIZE, central(float(eps)), stage=reference.stage) for eps in STEPS)
    deltas = [difference_on_a(frame, reference) for frame in frames]
    return np.array([np.abs(d).max() for d in deltas]), np.array([rms(d) for d in deltas])


@figure("eps_sweep")
def eps_sweep() -> Drawing:
    """RMS difference on A against ε for the three fields, 256 × 256."""
    steps, curves = STEPS[:SHOWN], {field: _curves(field)[1][:SHOWN] for field in FIELD_NAMES}
    fig, ax = plot(height=4.2)
    colour = palette()["difference"]
    for field, at in {"sine": 3e-4, "ridges": 1e-4, "rings": 1e-2}.items():
        ax.plot(steps, curves[field], color=colour, linestyle=DASHES[field], linewidth=1.6)
        label_curve(
            ax, steps, curves[field], at, field, colour, side="above" if HEIGHT_FIELDS[field].creases else "left"
        )
    decades(ax, 2, 2, ylim=(1e-13, 1), xlabel="step ε", ylabel="RMS difference on A")
    slope_triangle(ax, 2e-4, 1e-8, 2, "2")
    slope_triangle(ax, 3e-5, 6e-4, 0.5, "½")
    smallest = {f"{field}_least": curve.min() for field, curve in curves.items()}
    at = {f"{field}_best_eps": steps[curve.argmin()] for field, curve in curves.items()}
    return Drawing(fig, numbers=smallest | at, data={"step": steps, **curves})


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
        decades(ax, 4, 4, ylim=(1e-14, 10), title=field, xlabel="step ε")
        numbers |= {f"{field}_largest_least": largest.min(), f"{field}_rms_least": mean.min()}
        numbers |= {f"{field}_largest_eps": STEPS[largest.argmin()], f"{field}_rms_eps": STEPS[mean.argmin()]}
        if not HEIGHT_FIELDS[field].creases:
            slope_triangle(ax, 3e-4, 1e-8, 2, "2")
    axes[0].set_ylabel("error on A")
    largest, mean = _curves(FIELD_NAMES[0])
    label_line_end(axes[0], STEPS[40], largest[40] * 3, "largest", colour, side="above")
    label_line_end(axes[0], STEPS[40], mean[40] / 3, "RMS", colour, side="below")
    return Drawing(fig, numbers=numbers, data=data)


@figure("eps_table")
def eps_table() -> Drawing:
    """The ε-table of the default scene, 256 × 256, and the facts beside it; numbers only."""
    scene, numbers, rows = Scene(), {}, sweep(Scene(), SIZE, SIZE)
    for row in rows:
        name = f"1e{round(np.log10(row.eps))}"
        numbers |= {f"{what}_{name}": getattr(row, what) for what in ("largest", "rms", "flips", "straddling")}
    fitted = [numbers[f"rms_1e-{n}"] for n in range(2, 6)]
    numbers["rms_slope"] = np.polyfit(np.log(DECADES[1:5]), np.log(fitted), 1)[0]
    frames, flips = flips_everywhere(scene, SIZE, SIZE)
    near, least = pixels_near_the_pole(scene, SIZE, SIZE)
    fine = symbolic("ridges", 1024).surface_data["v"]
    numbers |= {
        "frames": frames,
        "flips": flips,
        "flat": flat_difference(scene, SIZE, SIZE),
        "pixels_near_pole": near,
        "least_sine": least,
        "least_sine_1024": float(np.nanmin(np.sin(np.pi * fine))),
        "pixels": SIZE * SIZE,
        "pixels_a": int(symbolic().stage.on_a.sum()),
    }
    tiny = render(scene, SIZE, SIZE, central(1e-8), stage=symbolic().stage)
    numbers["black_times_100"] = 100 * float(np.abs(difference_on_a(tiny, symbolic())).max())
    table = {name: [getattr(row, name) for row in rows] for name in ("eps", "largest", "rms", "flips", "straddling")}
    return Drawing(numbers=numbers, data=table)
