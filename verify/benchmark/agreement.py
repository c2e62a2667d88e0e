"""What the run also counts: whether the fast renderer draws what the strict one draws."""

import numpy as np
from tqdm import tqdm

from renderer import Scene, exact, render, stage_of
from verify.strict import random_scene, strict_chambers, strict_rgb

SEED = 9
SIDE = 256


def chambers_differing(scenes):
    """Return how many pixels of that many random scenes have another chamber than the strict reference gives them."""
    rng, differing = np.random.default_rng(SEED), 0
    for _ in tqdm(range(scenes), desc="chambers", unit="scene"):
        scene, width, height = random_scene(rng)
        differing += np.count_nonzero(stage_of(scene, width, height).chambers != strict_chambers(scene, width, height))
    return int(differing)


def image_error():
    """Return the largest difference of a channel of the default scene, both exact forms, from the strict reference."""
    scene = Scene()
    strict = strict_rgb(scene, SIDE, SIDE)
    return max(float(np.abs(render(scene, SIDE, SIDE, m).rgb - strict).max()) for m in (exact(), exact("general")))
