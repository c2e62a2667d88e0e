"""The boxes leave no pixel out: chambers with them are those of the test of every pixel."""

import os

import numpy as np

from renderer import Light, Scene, bounds, chambers
from renderer.chambers import Stage
from renderer.raster import Raster

SCENES = 10_000 if os.environ.get("HYPOTHESIS_PROFILE") == "long" else 400


def run(work, count):
    for number in range(count):
        work(number)


def whole_raster(x, y, g, positions):
    box = np.array((0, len(x), 0, len(y)), np.int64)
    return box, np.broadcast_to(box, (len(positions), 3, 4)).copy()


def random_scene(random):
    """Return a scene of scales far apart: B may contain, cut, touch or miss everything, lights may be low or below."""
    while True:
        radius = 10.0 ** random.uniform(-2, 2)
        center = tuple(random.normal(size=3) * radius * 10.0 ** random.uniform(-1, 1, 3))
        positions = random.normal(size=(random.integers(0, 4), 3)) * radius * 10.0 ** random.uniform(-0.5, 2, 3)
        try:
            return Scene(
                radius=radius,
                eye=radius * 10.0 ** random.uniform(0.01, 2),
                ball_radius=radius * 10.0 ** random.uniform(-2, 1),
                ball_center=center,
                lights=tuple(Light(tuple(p)) for p in positions),
            )
        except ValueError:
            continue  # B around the eye, or a light inside a body


def test_chambers_are_those_of_the_whole_raster(monkeypatch):
    random = np.random.default_rng(20)
    found_b = 0
    for _ in range(SCENES):
        scene, raster = random_scene(random), Raster(*(int(n) for n in random.integers(1, 90, 2)))
        with_boxes = Stage(scene, raster, run).chambers
        with monkeypatch.context() as patch:
            patch.setattr(chambers, "scene_boxes", whole_raster)
            everywhere = Stage(scene, raster, run).chambers
        assert np.array_equal(with_boxes, everywhere), scene
        found_b += bool((everywhere & 3 == 2).any())
    assert found_b > SCENES // 20


def test_a_box_too_small_is_noticed(monkeypatch):
    scene, raster = Scene(), Raster(64, 64)
    monkeypatch.setattr(bounds, "GUARD", -6)
    clipped = Stage(scene, raster, run).chambers
    monkeypatch.undo()
    assert not np.array_equal(clipped, Stage(scene, raster, run).chambers)
