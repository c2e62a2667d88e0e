"""Rasters: sizes, crops, and where the pixels' centres lie."""

import math
from itertools import product

import numpy as np
import pytest
from hypothesis import given

from renderer.scene.raster import MAX_SIDE, Raster
from tests.refusals import rejection
from tests.strategies import rasters, scenes


@pytest.mark.parametrize("side", [0, MAX_SIDE + 1, 1.5, 8.0, "8", None, True])
def test_a_side_that_is_rejected(side):
    allowed = "is not allowed: a whole number from 1 to 16777216"
    assert rejection(Raster, side, 8) == f"width = {side!r} {allowed}"
    assert rejection(Raster, 8, side) == f"height = {side!r} {allowed}"


def test_a_crop_has_pixels_and_all_of_them_are_the_rasters():
    width, height = np.int32(4), np.uint8(3)
    for crop in product(range(-1, 6), repeat=4):
        left, top, wide, high = crop
        if 0 <= left < left + wide <= width and 0 <= top < top + high <= height:
            assert Raster(width, height, crop).crop == crop
        else:
            rejection(Raster, width, height, crop)


@pytest.mark.parametrize("crop", [(0, 0, 1), (0, 0, 1.5, 1), (0, 0, math.inf, 1), ("0", "0", "1", "1"), "0011", 7])
def test_a_crop_of_other_things_than_four_whole_numbers_is_rejected(crop):
    allowed = "(left, top, width, height), whole numbers, inside the raster of 8 x 6"
    assert rejection(Raster, 8, 6, crop) == f"crop = {crop!r} is not allowed: {allowed}"


@given(scenes(ball=False, lights=()), rasters())
def test_pixels_are_square_columns_symmetric_and_row_0_at_the_top(scene, size):
    """So that an odd width puts a column on the axis."""
    x, y = Raster(*size).image_points(scene)
    np.testing.assert_array_equal(x, -x[::-1])
    assert (np.diff(y) < 0).all()
    half = 1.25 * scene.eye / math.sqrt((scene.eye / scene.radius) ** 2 - 1)
    np.testing.assert_allclose(np.diff(x), 2 * half / size[1], rtol=1e-6)
    np.testing.assert_allclose(-np.diff(y), 2 * half / size[1], rtol=1e-6)
    assert y.mean() == pytest.approx(-0.15 * half, rel=1e-6)
