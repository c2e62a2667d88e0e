"""The ε-table: how far the difference pipeline's picture is from the exact one, step by step."""

from dataclasses import asdict, dataclass, fields

import numpy as np

from renderer import files
from renderer.drawing import render, stage_of
from renderer.methods import GradientMethod, exact

DECADES = (1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6)


@dataclass(frozen=True)
class SweepRow:
    """One ε: the largest and the RMS difference over A's pixels and channels, the pixels whose chamber differs
    (flips), the pixels whose difference straddles a crease."""

    eps: float
    largest: float
    rms: float
    flips: int
    straddling: int


def difference_on_a(frame, reference):
    """Return the differences of two frames of one raster on sphere A: (pixels, 3)."""
    return (frame.rgb - reference.rgb)[reference.stage.on_a]


def rms(values):
    """Return the root of the mean square, 0 of nothing."""
    return float(np.sqrt(np.mean(np.square(values)))) if values.size else 0.0


def compare(frame, reference):
    """Return the SweepRow of a difference's frame against the exact one, `reference`, of the same raster."""
    delta = difference_on_a(frame, reference)
    flips = int(np.count_nonzero(frame.chambers != reference.chambers))
    largest = float(np.abs(delta).max()) if delta.size else 0.0
    return SweepRow(frame.method.eps, largest, rms(delta), flips, int(frame.straddling.sum()))


def sweep(scene, width, height, steps=DECADES, method="central", threads=None, progress=iter):
    """Return a SweepRow for every ε in `steps`: `method` against the exact gradient.

    The exact frame's chambers are computed once; the numeric ones anew for every step, so that flips are counted,
    not assumed. `progress` wraps the iterable of steps.
    """
    reference = render(scene, width, height, exact(), threads=threads)
    rows = []
    for eps in progress(tuple(steps)):
        own = stage_of(scene, width, height, threads=threads)
        frame = render(scene, width, height, GradientMethod(method, eps), threads=threads, stage=own)
        rows.append(compare(frame, reference))
    return rows


def write_csv(path, rows):
    """Write the table with its column names."""
    files.write_csv(path, [f.name for f in fields(SweepRow)], [asdict(row) for row in rows])


def table(rows):
    """Return the table as text."""
    lines = [f"{'eps':>9} {'max |dI| on A':>14} {'RMS on A':>12} {'flips':>6} {'straddling':>11}"]
    lines += [f"{r.eps:9.0e} {r.largest:14.4g} {r.rms:12.4g} {r.flips:6d} {r.straddling:11d}" for r in rows]
    return "\n".join(lines)
