"""Scenes, lights and rasters: what they accept, what they reject and how they say so."""

import math
from dataclasses import replace
from itertools import product

import numpy as np

from renderer import HeightField, Light, Scene, exact, render, sinpi, u
from renderer.scene.methods import difference
from renderer.scene.raster import MAX_SIDE, Raster
from tests.refusals import rejection
from tests.strategies import REJECTED
from tests.test_machines import numpy_draws

INSIDE_B = (0.5, 0.5, 1.3)


def test_a_rejection_names_field_and_value():
    for name, value in REJECTED:
        text = rejection(Scene, **{name: value})
        assert text.startswith(name)
        shown = text.partition(" = ")[2].rpartition(" is not allowed: ")[0]
        assert shown in {repr(value), *(repr(item) for item in (value if isinstance(value, tuple) else ()))}


def test_numbers_are_converted():
    scene = Scene(ku=np.int64(3), ball_center=np.array(INSIDE_B))
    assert type(scene.ku) is float and scene.ball_center == INSIDE_B


def test_a_side_that_is_rejected():
    for side in (0, MAX_SIDE + 1, 1.5, True):
        assert rejection(Raster, 8, side) == f"height = {side!r} is not allowed: a whole number from 1 to 16777216"


def test_a_crop_has_pixels_and_all_of_them_are_the_rasters():
    width, height = np.int32(4), np.uint8(3)
    for crop in product(range(-1, 6), repeat=4):
        left, top, wide, high = crop
        if 0 <= left < left + wide <= width and 0 <= top < top + high <= height:
            assert Raster(width, height, crop).crop == crop
        else:
            rejection(Raster, width, height, crop)


def test_a_crop_of_other_things_than_four_whole_numbers_is_rejected():
    allowed = "(left, top, width, height), whole numbers, inside the raster of 8 x 6"
    for crop in ((0, 0, 1), (0, 0, math.inf, 1), (0, 0, 1.0, 1), (0, 0, True, 1), {0, 1, 2, 3}, "0011", 7):
        assert rejection(Raster, 8, 6, crop) == f"crop = {crop!r} is not allowed: {allowed}"


@numpy_draws()
def test_the_surfaces_bump_is_refused_where_float64_ends_and_drawn_up_to_there():
    assert rejection(Scene, bump="hills") == "bump = 'hills' is not allowed: one of 'chart', 'surface'"
    assert rejection(Scene, horizon=1) == "horizon = 1 is not allowed: True or False"
    told = rejection(Scene, bump="surface", beta=-1e81)
    assert told == "beta = -1e+81 is not allowed: at most 1e+80 in size beside bump 'surface'"
    small = {"radius": 1e-60, "eye": 4e-60, "ball": False, "lights": (Light((5e-60, 5e-60, 1e-59)),)}
    steepest = Scene(**small, field="sine", beta=1e20, bump="surface")
    for method in (exact(), difference("forward", 1e-40)):
        frame = render(steepest, 21, 20, method, bounds=True)
        assert np.isfinite(frame.rgb).all() and np.isfinite(frame.light_cosines(0)[frame.stage.on_a]).all()
    told = rejection(replace, Scene(bump="surface"), field=HeightField("own", 10**130 * sinpi(u)))
    assert (
        told == "beta = 0.35 is not allowed: times the height of 'own' at most 1e+83, times its slopes at most 1e+123"
    )
