"""The ε-sweep: the difference of the three fields' pictures on A against the step."""

from functools import cache

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import DASHED, DOTTED, SOLID, curve, decades, plot, slope_triangle
from book.figures.chapter_scene import FIELD_NAMES, SIZE, numeric, symbolic
from renderer import Scene, central, render
from renderer.intervals import Interval
from renderer.picture.differences import distance_on_a
from renderer.picture.facts import flat_difference, flips_everywhere, pixels_near_the_pole
from renderer.picture.sweep import DECADES, records, sweep
from verify.accuracy.orders import enclosed_slope

STEPS = np.logspace(-1, -15, 57)
SHOWN = 49  # of them, down to 1e-13, in the picture of the RMS alone


@cache
def _curves(field):
    """Return {"largest", "rms": the difference on A at every step}, Intervals."""
    reference = symbolic(field)
    frames = (render(Scene(field=field), SIZE, SIZE, central(float(eps)), stage=reference.stage) for eps in STEPS)
    pairs = zip(*(distance_on_a(frame, reference) for frame in frames), strict=True)
    return dict(zip(("largest", "rms"), pairs, strict=True))


def _values(intervals):
    return np.array([each.value for each in intervals])


@figure
def eps_sweep() -> Drawing:
    """RMS difference on A against ε for the three fields, 256 × 256."""
    steps, shown = STEPS[:SHOWN], {field: _values(_curves(field)["rms"])[:SHOWN] for field in FIELD_NAMES}
    fig, ax = plot(height=4.2)
    for field, text, side, at, dash in (
        ("sine", "sine and rings", "right", 1e-5, DASHED), ("ridges", "ridges", "above", 1e-4, SOLID),
        ("rings", "", "", None, DOTTED),
    ):  # fmt: skip
        curve(ax, steps, shown[field], "difference", text, side, at, label=field, linestyle=dash, linewidth=1.6)
    decades(ax, 2, 2, ylim=(1e-13, 1), xlabel="step ε", ylabel="RMS difference on A")
    slope_triangle(ax, 3e-3, 1e-7, 2)
    slope_triangle(ax, 2e-5, 1e-4, 0.5)
    # Between which numbers the least over all steps lies, and the step where it was computed.
    differences = _curves("sine")["largest"]
    least = Interval(*(min(getattr(each, end) for each in differences) for end in ("value", "lower", "upper")))
    floor = dict(zip(("from", "to"), least.outward(), strict=True)) | {"eps": STEPS[_values(differences).argmin()]}
    return Drawing(fig, {"sine_best_eps": steps[shown["sine"].argmin()], "sine_largest": floor})


def _interval(row, name):
    return Interval(row[name], row[f"{name}_lower"], row[f"{name}_upper"])


def slope_lost(eps: float) -> float:
    """Return the median relative error of h_u of sine over A where the difference has this step."""
    computed, right = (frame.surface_data["h_u"] for frame in (numeric("sine", eps=eps), symbolic("sine")))
    on_a = symbolic("sine").stage.on_a & (right != 0)
    return np.median(np.abs(computed[on_a] / right[on_a] - 1))


@figure
def eps_table() -> Drawing:
    """The ε-table of the default scene, 256 × 256, and the facts beside it; numbers only."""
    scene, rows = Scene(), records(sweep(Scene(), SIZE, SIZE))
    numbers = {}
    for row in rows:
        eps = f"1e{round(np.log10(row['eps']))}"
        numbers |= {f"{name}_{eps}": row[name] for name in ("flips", "straddling")}
        numbers |= {f"{name}_{eps}": _interval(row, name) for name in ("largest", "rms")}
    frames, flips = flips_everywhere(scene, SIZE, SIZE)
    near, least = pixels_near_the_pole(scene, SIZE, SIZE)
    numbers |= {
        "rms_slope": enclosed_slope(DECADES[1:5], [_interval(row, "rms") for row in rows[1:5]]),
        "frames": frames,
        "flips": flips,
        "slope_lost_1e-16": slope_lost(1e-16),
        "flat": flat_difference(scene, SIZE, SIZE),
        "pixels_near_pole": near,
        "least_sine": least,
        "least_sine_1024": np.nanmin(np.sin(np.pi * symbolic(size=1024).surface_data["v"])),
        "pixels": SIZE * SIZE,
        "pixels_a": symbolic().stage.on_a.sum(),
        "black_times_100": distance_on_a(numeric(eps=1e-8), symbolic())[0].times(100),
    }
    return Drawing(numbers=numbers)
