"""Many accepted scenes, drawn and looked at for NaN, infinity and warnings; many rejected ones, for anything but a
ValueError:

    python -m tests.accepted_scenes --count 100000 --seed 5

Scenes come from tests/strategies.py, the domain's edges included, on small rasters, by every gradient method; each one
drawn is looked at in every field and both models. Writes verify/results/accepted_scenes.json: commit it.
"""

import itertools
import math
import warnings
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace

import numpy as np
from hypothesis import HealthCheck, Phase, given, seed as seeded, settings
from tqdm import tqdm

from renderer import pixel, render
from renderer.kernels import FIELDS
from renderer.scene.scene import MODELS
from tests.strategies import methods, rasters, rejected_fields, scenes
from verify.records import command

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


def chunk(start, count=CHUNK):
    """Check `count` scenes drawn with a seed, each in every variant; return (drawn, pixels of one variant)."""
    done = [0, 0]

    @seeded(start)
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


def measure(count, seed, workers):
    """Check at least `count` scenes on some processes; return what was done. The first failure ends the run."""
    variants = len(VARIANTS)
    seeds = [seed * 10**6 + number for number in range(-(-count // (variants * CHUNK)))]
    with ProcessPoolExecutor(workers) as pool:
        done = list(tqdm(pool.map(chunk, seeds), total=len(seeds), desc="accepted scenes", unit="chunk"))
    drawn, pixels = (sum(column) for column in zip(*done, strict=True))
    found = {"not_finite": 0, "crashes": 0}  # else an exception would have ended the run
    return {
        "numbers": {"scenes": drawn * variants, "pixels": pixels * variants, "rejected": drawn, **found, "seed": seed}
    }


if __name__ == "__main__":
    command("accepted_scenes", __doc__, measure, count=100_000, seed=5, workers=2)
