"""The ε-sweep: the RMS and the largest difference of the pictures against the step."""

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import decades, label_line_end, palette, plot, readable, slope_triangle
from book.figures.chapter_scene import FIELD_NAMES, SIZE, symbolic
from renderer import Scene, central, render
from renderer.facts import flat_difference, flips_everywhere, pixels_near_the_pole
from renderer.sweep import DECADES, difference_on_a, rms, sweep

DASHES = {"sine": (0, (5, 2)), "ridges": (0, ()), "rings": (0, (1.5, 1.5))}


def _rms_curve(field, steps):
    reference = symbolic(field)
    frames = (render(Scene(field=field), SIZE, SIZE, central(eps), stage=reference.stage) for eps in steps)
    return np.array([rms(difference_on_a(frame, reference)) for frame in frames])


@figure("eps_sweep")
def eps_sweep() -> Drawing:
    """RMS difference on A against ε for the three fields, 256 × 256."""
    steps = np.logspace(-1, -13, 49)
    curves = {field: _rms_curve(field, steps) for field in FIELD_NAMES}
    fig, ax = plot(height=4.2)
    colour = palette()["difference"]
    for field, curve in curves.items():
        ax.plot(steps, curve, color=colour, linestyle=DASHES[field], linewidth=1.6)
    decades(ax, "both", every=2)
    ax.set_ylim(1e-13, 1)
    where = {"ridges": 1e-4, "sine": 3e-4, "rings": 1e-2}
    for field, eps in where.items():
        index = int(np.abs(np.log(steps / eps)).argmin())
        label_line_end(
            ax,
            steps[index],
            curves[field][index],
            field,
            readable(colour),
            side="above" if field == "ridges" else "left",
        )
    slope_triangle(ax, 2e-4, 1e-8, 2, "2")
    slope_triangle(ax, 3e-5, 6e-4, 0.5, "½")
    ax.set_xlabel("step ε")
    ax.set_ylabel("RMS difference on A")
    smallest = {f"{field}_least": curve.min() for field, curve in curves.items()}
    at = {f"{field}_best_eps": steps[curve.argmin()] for field, curve in curves.items()}
    return Drawing(fig, numbers=smallest | at, data={"step": steps, **curves})


@figure("eps_table")
def eps_table() -> Drawing:
    """The ε-table of the default scene, 256 × 256, and the facts beside it; numbers only."""
    scene, numbers, rows = Scene(), {}, sweep(Scene(), SIZE, SIZE)
    for row in rows:
        name = f"1e{round(np.log10(row.eps))}"
        numbers |= {
            f"largest_{name}": row.largest,
            f"rms_{name}": row.rms,
            f"flips_{name}": row.flips,
            f"straddling_{name}": row.straddling,
        }
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
