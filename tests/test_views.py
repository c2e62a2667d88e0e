"""Views: sRGB's known values, and what each picture shows."""

import matplotlib
import numpy as np
import pytest

from renderer import Scene, central, render
from renderer.files import srgb
from renderer.picture import views

FRAME = render(Scene(), 48, 40)
OFF_A = FRAME.chambers & 3 != 1


@pytest.mark.parametrize(
    ("linear", "byte"),
    [(0.0, 0), (1.0, 255), (-1.0, 0), (2.0, 255), (0.5, 188), (0.2, 124), (0.0031308, 10), (0.001, 3), (0.18, 118)],
)
def test_srgb(linear, byte):
    assert views.to_bytes([linear]) == byte


@pytest.mark.parametrize("shape", [(3000, 333, 3), (10**6,)])
def test_srgb_is_the_formula_everywhere(shape):
    """Next to where bytes begin, and where the table's cells do, as well as anywhere else."""
    begins = srgb.tables()[0]
    ends = np.concatenate([begins, (np.arange(srgb.CELLS) + 0.5) / srgb.CELLS])
    numbers = np.random.default_rng(1).random(shape)
    near = np.concatenate([ends, np.nextafter(ends, 0), np.nextafter(ends, 1)])
    numbers.reshape(-1)[: near.size] = near
    formula = np.where(numbers <= 0.0031308, 12.92 * numbers, 1.055 * numbers ** (1 / 2.4) - 0.055)
    np.testing.assert_array_equal(views.to_bytes(numbers, threads=2), np.rint(255 * formula))


@pytest.mark.parametrize(
    "picture",
    [
        views.image_view(FRAME),
        views.slope_view(FRAME),
        views.kink_view(FRAME),
        views.difference_linear(FRAME.rgb),
        views.difference_logarithmic(FRAME.rgb),
    ],
)
def test_every_picture_is_bytes_at_the_rasters_own_pixels(picture):
    assert (picture.shape, picture.dtype) == ((40, 48, 3), "uint8")
    assert picture.any()


def test_slope_is_black_off_a_and_white_at_its_largest():
    picture = views.slope_view(FRAME)
    assert (picture[OFF_A] == 0).all()
    assert (picture[FRAME.slope == FRAME.slope.max()] == 255).all()


def test_slope_on_a_scale_that_is_given():
    np.testing.assert_array_equal(views.slope_view(FRAME, 2 * FRAME.slope.max()).max(), 128)
    assert (views.slope_view(FRAME, 1e-9)[FRAME.slope > 1e-9] == 255).all()


def test_slope_of_a_flat_field_is_black():
    assert not views.slope_view(render(Scene(ku=0.0), 16, 16)).any()


def test_kinks_are_white_over_a_dimmed_picture():
    picture = views.kink_view(FRAME)
    assert FRAME.kink.any()
    assert (picture[FRAME.kink] == 255).all()
    np.testing.assert_array_equal(picture[~FRAME.kink], views.to_bytes(FRAME.rgb)[~FRAME.kink] // 3)


def test_the_linear_difference():
    delta = np.array([0.0, 1e-3, -1e-3, 5e-3, 1e-2, -0.5])
    assert views.difference_linear(delta, 100.0).tolist() == [0, 26, 26, 128, 255, 255]


@pytest.mark.parametrize("value", [-1.0, np.nan, np.inf])
def test_a_bad_scale(value):
    with pytest.raises(ValueError, match=r"gain = .* is not allowed"):
        views.difference_linear(np.zeros(3), value)
    with pytest.raises(ValueError, match=r"highest = .* is not allowed"):
        views.slope_view(FRAME, value)


def test_the_logarithmic_difference_is_black_at_zero_and_nowhere_else():
    delta = np.array([[0.0, -0.0, np.nan, 5e-324, 1e-30, 1e-16, 1e-8, 1.0, 10.0]])
    picture = views.difference_logarithmic(delta)
    inferno = matplotlib.colormaps["inferno"]
    low, middle, high = (np.array(inferno(share, bytes=True)[:3]) for share in (0.0, 0.5, 1.0))
    assert low.any()
    np.testing.assert_array_equal(picture[0], [*[0 * low] * 3, *[low] * 3, middle, high, high])


def test_of_the_channels_the_largest_counts():
    delta = np.array([[[0.0, -1e-4, 1e-9], [1e-4, 0.0, 0.0]]])
    np.testing.assert_array_equal(*views.difference_logarithmic(delta)[0])


def test_a_colour_bar_leaves_the_picture_alone():
    picture = views.difference_logarithmic(render(Scene(), 48, 40, central(1e-2)).rgb - FRAME.rgb)
    sheet = views.with_colour_bar(picture)
    np.testing.assert_array_equal(sheet[:40, :48], picture)
    assert sheet.dtype == "uint8"
    bar = sheet[8:-8, 48:].reshape(-1, 3)
    assert len(np.unique(bar, axis=0)) > 100  # inferno's colours
