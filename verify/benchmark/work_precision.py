"""Measure time against error of every way to take the gradient, and of frames; write it with a label:

    python -m verify.benchmark.work_precision            (some minutes, on a machine that does nothing else)

One core. Errors are the largest over the checked points (pixels) against 50 digits; times are medians of interleaved
rounds. Libraries that are not installed (JAX, SciPy, numdifftools) are left out with a word. Writes
verify/results/work_precision.json and work_precision.csv: commit them.
"""

import argparse
import os
from collections.abc import Mapping, Sequence
from functools import lru_cache, partial
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np
from tqdm import tqdm

from proofs.formulas.chart import chart_inverse
from proofs.formulas.height_fields import gradient
from renderer import Scene, central, central4, exact, forward, render, stage_of
from renderer.picture.frame import Frame
from renderer.whole_files import write_csv
from verify.benchmark.label import label, write
from verify.benchmark.methods.table import FIELD, FULL, METHODS, STEPS, WAVES, Method, sample
from verify.benchmark.plan import Case, given, timings
from verify.evaluate.arrays import distance, in_balls
from verify.evaluate.balls import ball_of
from verify.reference import reference_pixel

RESULTS = Path(__file__).parents[1] / "results"
CHECKED, ROUNDS, SEED = 4096, 15, 3
SIDE, PIXELS = 256, 600
FRAMES = {"forward": forward, "central": central, "central, 4th order": central4}
CHANNELS = ("red", "green", "blue")

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


def largest_error(found: Sequence[np.ndarray], count: int) -> float:
    """Return the largest |error| of h_u and h_v over the sample's points, as a float."""
    truth = truth_at(count)
    if found[0].dtype == object:  # mpmath's own numbers, whose error may be far below float64's
        found = [np.frompyfunc(ball_of, 1, 1)(f) for f in found]
    return max(float(distance(f, truth[n]).max()) for f, n in zip(found, ("h_u", "h_v"), strict=True))


def gradient_rows(rounds: int) -> list[Row]:
    """Return the rows of the gradient's diagram: method, its parameter, ns a gradient, largest error."""
    cases, rows = {}, []
    for method in tqdm([m for m in METHODS if m.available], desc="errors", unit="method"):
        checked = min(CHECKED, method.points)
        inputs = points_for(method, checked)
        for value in method.values:
            function = method.make(value)
            rows.append({"method": method.name, "parameter": method.parameter, "value": value, "ours": method.ours,
                         "error": largest_error(function(*inputs), checked), "points": checked})  # fmt: skip
            key = method.name if method.timed_once else f"{method.name}, {value}"
            if key not in cases:
                kind = getattr(function, "kind", np.float64)
                many = [np.ascontiguousarray(a, kind) for a in points_for(method, method.points)]
                cases[key] = Case(key, given(partial(function, *many)), visits=rounds)
            rows[-1] |= {"key": key, "ns": 1e9 / method.points}
    seconds = timings(cases.values(), "gradients")
    return [row | {"ns": row["ns"] * median(seconds[row.pop("key")])} for row in rows]


def gradient_numbers(rows: Sequence[Row]) -> dict[str, float]:
    """Return the numbers that pages cite, of each method: its time, its least error and where; counts, and a ratio."""
    numbers = {"points": FULL, "checked": CHECKED, "fewer": min(r["points"] for r in rows if r["parameter"] == "order")}
    numbers |= {"beaten_by": len(peers_that_beat(rows)), "unbeaten": len(unbeaten_by_ours(rows))}
    numbers |= {"methods": len({r["method"] for r in rows}), "others": sum(not r["ours"] for r in rows)}
    for best in best_rows(rows):
        key = "".join(c if c.isalnum() else "_" for c in best["method"].lower())
        numbers |= {f"{key}_ns": best["ns"], f"{key}_error": best["error"]}
        if best["value"] is not None:
            numbers[f"{key}_at"] = best["value"]
    return numbers | {"central_to_exact": numbers["central_ns"] / numbers["exact__reduced_argument_ns"]}


def best_rows(rows: Sequence[Row]) -> list[Row]:
    """Return each method's row of the least error, in order."""
    names = dict.fromkeys(row["method"] for row in rows)
    return [min((r for r in rows if r["method"] == name), key=lambda row: row["error"]) for name in names]


def image_error(frame: Frame, pixels: Mapping[tuple[int, int], np.ndarray]) -> tuple[float, float]:
    """Return (largest, RMS) |ΔI| of a frame over the given pixels of A, whose 50-digit colours are `pixels`."""
    off = np.array([np.abs(frame.rgb[place] - colour) for place, colour in pixels.items()])
    return float(off.max()), float(np.sqrt(np.mean(off**2)))


def reference_colours(scene: Scene, count: int) -> dict[tuple[int, int], np.ndarray]:
    """Return {(row, column): rgb} of random pixels of A, from 50 digits, rounded to float64."""
    on_a = np.argwhere(stage_of(scene, SIDE, SIDE).on_a)
    chosen = np.random.default_rng(SEED).choice(len(on_a), count, replace=False)
    colours = {}
    for row, column in tqdm(on_a[chosen].tolist(), desc=f"50 digits, {scene.field}", unit="pixel"):
        line = reference_pixel(scene, SIDE, SIDE, column, row)
        colours[row, column] = np.array([float(line[f"rgb_{c}"]) for c in CHANNELS])
    return colours


def frame_rows(rounds: int, count: int) -> list[Row]:
    """Return the rows of the frames' diagram: field, method, its parameter, ms a frame, largest and RMS error."""
    cases, rows = {}, []
    for field in ("sine", "ridges"):
        scene = Scene(field=field)
        stage, pixels = stage_of(scene, SIDE, SIDE), reference_colours(scene, count)
        methods = [(name, eps, make(eps)) for name, make in FRAMES.items() for eps in STEPS]
        methods += [("exact, general", None, exact("general")), ("exact, algebraic", None, exact("algebraic"))]
        for name, eps, method in methods:
            frame = render(scene, SIDE, SIDE, method, threads=1, stage=stage)
            largest, rms = image_error(frame, pixels)
            key = f"{field}, {name}"
            if key not in cases:
                call = partial(render, scene, SIDE, SIDE, method, threads=1, stage=stage)
                cases[key] = Case(key, given(call), visits=rounds)
            rows.append({"field": field, "method": name, "value": eps, "ours": name.startswith("exact"),
                         "largest": largest, "rms": rms})  # fmt: skip
    seconds = timings(cases.values(), "frames")
    return [row | {"ms": 1e3 * median(seconds[f"{row['field']}, {row['method']}"])} for row in rows]


def unbeaten_by_ours(rows: Sequence[Row]) -> list[Row]:
    """Return the rows of other methods that no row of ours beats in both: not slower and not less accurate."""
    ours = [r for r in rows if r["ours"]]
    return [r for r in rows if not r["ours"]
            and not any(o["ns"] <= r["ns"] and o["error"] <= r["error"] for o in ours)]  # fmt: skip


def peers_that_beat(rows: Sequence[Row], cost: str = "ns", error: str = "error") -> list[Row]:
    """Return the rows of other methods that are both faster and more accurate than one of ours in float64."""
    ours = [r for r in rows if r["ours"] and "float32" not in r["method"]]
    return [r for r in rows if not r["ours"] and any(r[cost] < o[cost] and r[error] < o[error] for o in ours)]


def main() -> None:
    """Parse the command line, measure, write."""
    formatter = argparse.RawDescriptionHelpFormatter
    parser = argparse.ArgumentParser(
        "python -m verify.benchmark.work_precision", description=__doc__, formatter_class=formatter
    )
    parser.add_argument("--rounds", type=int, default=ROUNDS, help="timed rounds (default: %(default)s)")
    parser.add_argument("--pixels", type=int, default=PIXELS, help="checked pixels a field (default: %(default)s)")
    parser.add_argument("--out", type=Path, default=RESULTS, help="folder of the results")
    options = parser.parse_args()
    packages = ["numpy", "llvmlite", "mpmath", *(m.module for m in METHODS if m.module and m.available)]
    where: Row = label(*packages)
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    absent = sorted(m.name for m in METHODS if not m.available)
    print(f"left out, not installed: {', '.join(absent)}" if absent else "every library is installed")
    gradients, frames = gradient_rows(options.rounds), frame_rows(options.rounds, options.pixels)
    where |= {"absent": absent, "seed": SEED, "rounds": options.rounds, "side": SIDE}
    write(options.out / "work_precision.json", {"label": where, "gradients": gradients, "frames": frames})
    write_csv(options.out / "work_precision.csv", gradients)
    print(f"others that beat ours in both: {[r['method'] for r in peers_that_beat(gradients)] or 'none'}")


if __name__ == "__main__":
    main()
