"""Measure time against error of every way to take the gradient, and of frames; and the time of pictures' slopes:

    python -m verify.benchmark.work_precision            (some minutes, on a machine that does nothing else)

One core. Errors are the largest over the checked points (pixels) against 50 digits; times are medians of interleaved
rounds. JAX is left out with a word where it is not installed. Writes
verify/results/work_precision.json: commit it.
"""

import os
import re
from collections.abc import Sequence
from functools import lru_cache, partial
from itertools import groupby
from typing import Any

import numpy as np
from flint import arb
from tqdm import tqdm

from proofs.formulas.chart import chart_inverse
from proofs.formulas.height_fields import gradient
from renderer import Scene, central, central4, exact, forward, render, stage_of
from renderer.intervals import rms
from renderer.picture.frame import Frame
from verify.benchmark.methods.table import FIELD, FULL, METHODS, STEPS, WAVES, Method, sample
from verify.benchmark.slopes import slope_numbers
from verify.benchmark.timing import Case, numbers_by_calls
from verify.evaluate.arrays import distance, in_balls
from verify.evidence.records import command
from verify.reference import COLORS, reference_pixel

CHECKED, ROUNDS, SEED = 4096, 15, 3
SIDE, PIXELS = 256, 600
FRAMES = {"forward": forward, "central": central, "central, 4th order": central4}

Row = dict[str, Any]


def points_for(method: Method, count: int) -> tuple[np.ndarray, ...]:
    """Return the arrays that a method takes, for `count` points; each angle is rounded once from the exact value."""
    u, v = sample(count)
    balls = in_balls(chart_inverse, {"u": u, "v": v}) if method.angles else {}
    return tuple(angle.astype(float) for angle in balls.values()) or (u, v)


@lru_cache
def truth_at(count: int) -> dict[str, np.ndarray]:
    """Return {h_u, h_v: balls} at the sample's points."""
    u, v = sample(count)
    return in_balls(gradient(FIELD), {"u": u, "v": v, **WAVES})


def largest_error(slopes: Sequence[np.ndarray], count: int) -> float:
    """Return the largest |error| of h_u and h_v over the sample's points, as a float."""
    truth = truth_at(count)
    if slopes[0].dtype == object:  # mpmath's own numbers, whose error may be far below float64's
        slopes = [np.frompyfunc(arb, 1, 1)(f) for f in slopes]
    return max(float(distance(f, truth[n]).max()) for f, n in zip(slopes, ("h_u", "h_v"), strict=True))


def _timed(rows, title):
    """Return [(row, its case)] as rows: where its case's time belongs a row has the unit's name. Each is timed once."""
    cases = {case.name: case for _, case in rows[::-1]}
    numbers = numbers_by_calls(cases.values(), title)
    return [row | {case.unit: numbers[f"{case.name}_{case.unit}"]} for row, case in rows]


def gradient_rows(rounds: int) -> list[Row]:
    """Return the rows of the gradient's diagram: method, its parameter, ns a gradient, largest error."""
    rows = []
    for method in tqdm([m for m in METHODS if m.available], desc="errors", unit="method"):
        checked, many = min(CHECKED, method.points), points_for(method, method.points)
        inputs = points_for(method, checked)
        for value in method.values:
            function = method.make(value)
            row = {"method": method.name, "parameter": method.parameter, "value": value, "ours": method.ours,
                   "error": largest_error(function(*inputs), checked), "points": checked, "ns": None}  # fmt: skip
            name = method.name if method.timed_once else f"{method.name}, {value}"
            rows.append((row, Case(name, partial(function, *many), 1, rounds, "ns", method.points)))
    return _timed(rows, "gradients")


def gradient_numbers(rows: Sequence[Row]) -> dict[str, float]:
    """Return the numbers that pages cite, of each method: its time, its least error and where; counts, and a ratio."""
    numbers = {"points": FULL, "checked": CHECKED}
    numbers |= {"beaten_by": len(peers_that_beat(rows)), "unbeaten": len(unbeaten_by_ours(rows))}
    numbers |= {"methods": len({r["method"] for r in rows}), "others": sum(not r["ours"] for r in rows)}
    for best in best_rows(rows):
        key = key_of(best["method"])
        numbers |= {f"{key}_ns": best["ns"], f"{key}_error": best["error"]}
        if best["value"] is not None:
            numbers[f"{key}_at"] = best["value"]
    return numbers | {"central_to_exact": numbers["central_ns"] / numbers["exact__reduced_argument_ns"]}


def best_rows(rows: Sequence[Row], error: str = "error") -> list[Row]:
    """Return each method's row of the least error, in order."""
    return [min(group, key=lambda row: row[error]) for _, group in groupby(rows, lambda row: row["method"])]


def key_of(method: str) -> str:
    """Return how a method is called in the numbers that pages cite."""
    return re.sub(r"\W", "_", method.lower())


def image_error(frame: Frame, places: np.ndarray, colours: np.ndarray) -> tuple[float, float]:
    """Return (largest, RMS) |ΔI| of a frame at pixels (n, 2), (row, column), whose colours are `colours` (n, 3)."""
    off = np.abs(frame.rgb[tuple(places.T)] - colours)
    return float(off.max()), rms(off)


def reference_pixels(scene: Scene, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return random pixels of A (n, 2), (row, column), and their colours (n, 3) from 50 digits, rounded to float64."""
    on_a = np.argwhere(stage_of(scene, SIDE, SIDE).on_a)
    places = on_a[np.random.default_rng(SEED).choice(len(on_a), count, replace=False)]
    pixels = [reference_pixel(scene, SIDE, SIDE, column, row)
             for row, column in tqdm(places.tolist(), desc=f"50 digits, {scene.field}", unit="pixel")]  # fmt: skip
    return places, np.array([[float(pixel[c]) for c in COLORS] for pixel in pixels])


def frame_rows(rounds: int, count: int) -> list[Row]:
    """Return the rows of the frames' diagram: field, method, its parameter, ms a frame, largest and RMS error."""
    rows = []
    methods = [(name, eps, make(eps)) for name, make in FRAMES.items() for eps in STEPS]
    methods += [(f"exact, {form}", None, exact(form)) for form in ("general", "algebraic")]
    for field in ("sine", "ridges"):
        scene = Scene(field=field)
        stage, reference = stage_of(scene, SIDE, SIDE), reference_pixels(scene, count)
        for name, eps, method in methods:
            draw = partial(render, scene, SIDE, SIDE, method, threads=1, stage=stage)
            largest, rms = image_error(draw(), *reference)
            row = {"field": field, "method": name, "value": eps, "ours": name.startswith("exact"),
                   "largest": largest, "rms": rms}  # fmt: skip
            rows.append((row, Case(f"{field}, {name}", draw, visits=rounds)))
    return _timed(rows, "frames")


def unbeaten_by_ours(rows: Sequence[Row]) -> list[Row]:
    """Return the rows of other methods that no row of ours beats in both: not slower and not less accurate."""
    ours = [r for r in rows if r["ours"]]
    return [r for r in rows if not r["ours"]
            and not any(o["ns"] <= r["ns"] and o["error"] <= r["error"] for o in ours)]  # fmt: skip


def peers_that_beat(rows: Sequence[Row], cost: str = "ns", error: str = "error") -> list[Row]:
    """Return the rows of other methods that are both faster and more accurate than one of ours."""
    ours = [r for r in rows if r["ours"]]
    return [r for r in rows if not r["ours"] and any(r[cost] < o[cost] and r[error] < o[error] for o in ours)]


def measure(rounds: int, pixels: int) -> dict[str, Any]:
    """Return the rows of both diagrams, slopes' numbers, and the label's; pixels: how many are checked of a field."""
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    absent = sorted(m.name for m in METHODS if not m.available)
    print(f"left out, not installed: {', '.join(absent) or 'none'}")
    more = {"absent": absent, "seed": SEED, "rounds": rounds, "side": SIDE}
    rows = {"gradients": gradient_rows(rounds), "frames": frame_rows(rounds, pixels)}
    return {"label": more, **rows, "slopes": slope_numbers(rounds)}


main = partial(command, "work_precision", __doc__, measure, rounds=ROUNDS, pixels=PIXELS)

if __name__ == "__main__":
    main()
