"""The gradient of the height field: both exact forms, creases, the pole, the steps that float64 cannot take."""

import re
from dataclasses import replace
from itertools import product
from unicodedata import numeric

import numpy as np
import pytest
from hypothesis import given, strategies as st

from book.figures.binades import NAMES, STEPS
from renderer import Scene, central, central4, exact, forward, gradient_at, height_at, pixel, render
from renderer.kernels import FIELDS
from renderer.scene.methods import GradientMethod, difference
from renderer.scene.scene import BUMPS
from tests.refusals import rejection
from tests.strategies import steps, wave_numbers
from tests.test_machines import numpy_draws
from verify.accuracy.binades import dies

SINE, RIDGES, RINGS = (Scene(field=field) for field in ("sine", "ridges", "rings"))
SIZE = (21, 20)  # a raster on which the pole is the centre of a pixel, in column 10 and row 8
chart_points = st.tuples(st.floats(0, 1, exclude_max=True), st.floats(0, 1))


def test_the_gradient_on_a_crease_in_u_is_exactly_zero():
    """In v it is zero too."""
    others, wheres = np.array([0.1, 0.25, 0.47, 0.9]), np.arange(8)[:, None] / 8
    for point in ((wheres, others), (others, wheres[::2])):
        assert not np.any(gradient_at(RIDGES, *point, exact()))


def test_every_float_beside_every_crease_is_off_it():
    """Though the product k u rounds to m at many floats, the kernel finds no crease there."""
    for wave_number in np.arange(1, 65.0):
        creases = np.arange(1, wave_number) / wave_number
        for towards in (0.0, 1.0):
            u = np.nextafter(creases, towards)
            assert (gradient_at(replace(RIDGES, ku=wave_number), u, 0.31, exact())[0] != 0).all()


def test_the_kink_band_is_where_a_factor_is_below_three_hundredths():
    u, v = 0.125 + np.arcsin([0.0299, 0.0301, -0.0299, -0.0301]) / (8 * np.pi), 0.47
    assert FIELDS["ridges"]["kink"](np.sin(np.pi * v), u, v, RIDGES.ku, RIDGES.kv).tolist() == [1, 0, 1, 0]


@pytest.mark.parametrize("method", [exact(), exact("general"), central(1e-3), forward(1e-3), central4(1e-3)])
@numpy_draws()
@pytest.mark.filterwarnings("error")
def test_the_pole(method):
    for scene, beta, bump in product((SINE, RIDGES, RINGS), (0.0, 0.35, 1e80), BUMPS):
        scene = replace(scene, beta=beta, bump=bump)
        record = pixel(scene, *SIZE, 10, 8, method)
        assert (record.surface, record.v, record.kink) == ("A", 0.0, True)
        assert record.point == record.normal == tuple(render(scene, *SIZE, method).normal[8, 10]) == (0.0, 0.0, 1.0)


@given(chart_points, steps, wave_numbers)
def test_rings_have_no_slope_in_u_by_any_method(point, eps, kv):
    for method in (exact(), forward(eps), central(eps), central4(eps)):
        assert gradient_at(replace(RINGS, kv=kv), *point, method)[0] == 0


def test_ridges_keep_their_side_of_a_crease_where_a_product_of_factors_underflows():
    u, v = np.array([[0.31], [1e-200]]), np.array([5e-324, 1e-310, 1e-200])
    across = np.abs(gradient_at(SINE, u, v, exact()))
    assert (across[1] > 0).all()
    np.testing.assert_array_equal(np.abs(gradient_at(RIDGES, u, v, exact())), across)


@pytest.mark.parametrize("step", STEPS)
def test_every_slope_dies_where_the_theorem_says_and_elsewhere_by_equal_heights(step):
    """Find the renderer's slope 0 where the theorem says that it dies; a figure's label has the first such number."""
    for power, sign in re.findall(r"= 0\$: (\S+) ([<≤])", " ".join(NAMES[step])):
        first = 1 / int(power[-4:-2]) if "{" in power else numeric(power)
        assert dies([first, np.nextafter(first, 1)], step).tolist() == [sign == "≤", True]
    at = render(SINE, 256, 256, central(step)).data_on_a
    for axis in "uv":
        counted, lost = at[f"h_{axis}"] == 0, dies(at[axis], step)
        assert not (lost & ~counted).any()
        more = dies(at[axis], step, within=1.0, at_power=0.5)
        assert (more & ~counted).any() or not more.any()  # a whole spacing would be too much
        rest = counted & ~lost
        u, v = at["u"][rest], at["v"][rest]
        ends = [(u + s, v) if axis == "u" else (u, v + s) for s in (step, -step)]
        np.testing.assert_array_equal(*(height_at(SINE, *end) for end in ends))


def test_the_exact_gradient_has_no_step():
    error = rejection(GradientMethod, "exact", 1e-3)
    assert error == "eps = 0.001 is not allowed: none beside the exact gradient, which takes no step"
    assert rejection(exact, "fast") == "form = 'fast' is not allowed: one of 'auto', 'general', 'algebraic'"


@pytest.mark.filterwarnings("error")
def test_a_step_that_float64_loses_is_told_but_for_a_sweep():
    for method in (central, forward, central4):
        method(2.0**-53)
        difference(method.__name__, 1e-17)
        with pytest.warns(UserWarning, match="below 2"):
            method(1e-17)


def test_a_representable_step_is_a_multiple_of_the_coarsest_spacing():
    for eps in (0.1, 1e-3, 3e-16):
        step = central(eps, representable=True).eps
        assert abs(step - eps) <= 2.0**-53 and (step * 2.0**52).is_integer()
    assert rejection(central, 1e-16, True) == "eps = 1e-16 is not allowed: a finite number from 2.22045e-16 to 0.5"
    assert rejection(central, 1e-3, 1) == "representable = 1 is not allowed: a bool"
