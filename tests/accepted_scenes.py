"""Many accepted scenes, drawn and looked at for NaN, infinity and warnings; many rejected ones, for anything but a
ValueError:

    python -m tests.accepted_scenes --scenes 100000 --seed 5

Scenes come from tests/strategies.py, the domain's edges included, on small rasters, by every gradient method; each one
drawn is looked at in every field and both models. Writes verify/results/accepted_scenes.json, {"label": {machine,
date, commit}, "numbers": {...}}: commit it.
"""

import argparse
import itertools
import math
import warnings
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from pathlib import Path

import numpy as np
from hypothesis import HealthCheck, Phase, given, seed, settings
from tqdm import tqdm

from renderer import pixel, render
from renderer.kernels import FIELDS
from renderer.scene import MODELS
from tests.strategies import methods, rasters, rejected_fields, scenes
from verify.benchmark.label import label, write

RESULT = Path(__file__).resolve().parent.parent / "verify" / "results" / "accepted_scenes.json"
VARIANTS = tuple(itertools.product(FIELDS, MODELS))
CHUNK = 120  # scenes that are drawn at a time


def check(scene, size, method):
    """Draw a scene and raise AssertionError, or a warning as an error, if anything of it is not a number in range."""
    with warnings.catch_warnings(), np.errstate(all="raise"):
        warnings.simplefilter("error")
        frame = render(scene, *size, method, threads=1)
        assert frame.rgb.min() >= 0 and frame.rgb.max() <= 1  # false for NaN
        assert np.isfinite(frame.slope).all()
        on_a = frame.stage.on_a
        for name, plane in frame.surface_data.items():
            assert (np.isfinite(plane) == on_a).all(), name
        u, v = (frame.surface_data[name][on_a] for name in "uv")
        assert ((u >= 0) & (u < 1) & (v >= 0) & (v < 0.5)).all()
        check_behind_the_clip(scene, size, method, np.argwhere(frame.chambers & 3))


def check_behind_the_clip(scene, size, method, seen):
    """Check the record of a pixel in the middle of those that show a surface: the clip would turn NaN into 0."""
    if len(seen) == 0:
        return
    row, column = seen[len(seen) // 2].tolist()
    record = pixel(scene, *size, column, row, method)
    assert all(map(math.isfinite, (*record.point, *record.rgb))), record
    assert abs(math.hypot(*record.normal) - 1) <= (1e-6 if record.surface == "B" else 1e-14), record
    for light in record.lights:
        assert abs(light.mu) <= 1 + 1e-6, record
        assert all(0 <= number < math.inf for number in (light.specular, *light.adds)), record


def check_rejected(scene, name, value):
    """Assert that a scene with a bad value is refused with a ValueError that names the field."""
    try:
        replace(scene, **{name: value})
    except ValueError as error:
        assert name in str(error) or name in ("radius", "ball_radius", "ball_center"), error
    else:
        raise AssertionError(f"{name} = {value!r} was accepted")


def _chunk(arguments):
    """Check `count` scenes drawn with a seed, each in every variant; return (drawn, pixels of one variant)."""
    start, count = arguments
    done = [0, 0]

    @seed(start)
    @settings(
        max_examples=count,
        database=None,
        deadline=None,
        phases=[Phase.generate],
        suppress_health_check=list(HealthCheck),
    )
    @given(scenes(), rasters(12), methods, rejected_fields)
    def run(scene, size, method, rejected):
        for field, model in VARIANTS:
            check(replace(scene, field=field, model=model), size, method)
        check_rejected(scene, *rejected)
        done[0] += 1
        done[1] += size[0] * size[1]

    run()
    return done


def campaign(count, first_seed, workers):
    """Check at least `count` scenes on several processes; return what was done. Raises on the first failure."""
    drawn = -(-count // len(VARIANTS))
    chunks = [(first_seed * 10**6 + n, CHUNK) for n in range(-(-drawn // CHUNK))]
    with ProcessPoolExecutor(workers) as pool:
        done = list(tqdm(pool.map(_chunk, chunks), total=len(chunks), unit="chunk"))
    drawn, pixels = (sum(column) for column in zip(*done, strict=True))
    variants = len(VARIANTS)
    found = {"not_finite": 0, "crashes": 0}  # else an exception would have ended the run
    return {"scenes": drawn * variants, "pixels": pixels * variants, "rejected": drawn, **found, "seed": first_seed}


def main():
    """Parse the command line, run, write."""
    formatter = argparse.RawDescriptionHelpFormatter
    parser = argparse.ArgumentParser("python -m tests.accepted_scenes", description=__doc__, formatter_class=formatter)
    parser.add_argument("--scenes", type=int, default=100_000, help="how many at least (default: %(default)s)")
    parser.add_argument("--seed", type=int, default=5, help="of the draw (default: %(default)s)")
    parser.add_argument("--workers", type=int, default=2, help="processes (default: %(default)s)")
    parser.add_argument("--out", type=Path, default=RESULT, help="the JSON file")
    options = parser.parse_args()
    numbers = campaign(options.scenes, options.seed, options.workers)
    write(options.out, {"label": label("numpy", "llvmlite", "hypothesis"), "numbers": numbers})
    print(", ".join(f"{key.replace('_', ' ')}: {value:,}" for key, value in numbers.items()))


if __name__ == "__main__":
    main()
