"""The renderer's pixels against the 50-digit reference, which `verify/test_balls.py` encloses."""

import random

import numpy as np
import pytest

from proofs.formulas.half_turns import cospi, ordinary, sinpi
from proofs.formulas.symbols import u
from renderer import Light, Scene, central, exact, render
from verify.reference import Undecided, reference_pixel

SIZE = 48
SCENES = {
    "default": Scene(),
    "phong": Scene(model="phong", field="sine", shininess=5.5, beta=-1.5),
    "rings": Scene(field="rings", kv=2.5, lights=(Light((3.0, -4.0, 6.0), (0.4, 1.0, 0.2)),), floor=False),
    "odd": Scene(field="sine", ku=7.3, kv=-3.1, ball=False, eye=2.5),
}
COLORS = ("rgb_red", "rgb_green", "rgb_blue")


def sampled_pixels(name):
    rng = random.Random(name)
    return [(rng.randrange(SIZE), rng.randrange(SIZE)) for _ in range(24)]


@pytest.mark.parametrize("name", SCENES)
@pytest.mark.parametrize(("gradient", "method", "eps"), [(exact(), "exact", None), (central(1e-3), "central", 1e-3)])
def test_the_renderer_agrees(name, gradient, method, eps):
    """Chambers exactly; colours to rounding, which a difference amplifies by 1/ε."""
    frame = render(SCENES[name], SIZE, SIZE, gradient=gradient)
    tolerance = 1e-11 if eps is None else 1e-9
    for column, row in sampled_pixels(name):
        truth = reference_pixel(SCENES[name], SIZE, SIZE, column, row, method, eps)
        shadows = sum(int(truth[f"occluded_{i}"]) << 2 + i for i in range(len(SCENES[name].lights)))
        assert frame.chambers[row, column] == int(truth["surface"]) | shadows | int(truth["dark_square"]) << 7
        np.testing.assert_allclose(frame.rgb[row, column], [float(truth[c]) for c in COLORS], rtol=0, atol=tolerance)


@pytest.mark.parametrize("digits", [30, 50, 100])
def test_a_pixel_on_the_silhouette_is_undecided(digits):
    """ρ = ρ_s = 3.75: the discriminant is 0, and at no number of digits is its sign anything but noise."""
    scene = Scene(eye=5.0, radius=3.0, ball=False, field="sine")
    with pytest.raises(Undecided, match=f"column = 10, row = 0: surface, rgb_red.* undecided at {digits} digits"):
        reference_pixel(scene, 21, 20, 10, 0, digits=digits)
    assert reference_pixel(scene, 21, 20, 10, 1, digits=digits)["surface"] == 1


def test_a_pixel_on_a_crease_is_undecided():
    with pytest.raises(Undecided, match="column = 10, row = 9: rgb_red, rgb_green, rgb_blue undecided"):
        reference_pixel(Scene(field="ridges"), 21, 20, 10, 9)


@pytest.mark.parametrize("function", [sinpi, cospi])
def test_a_function_of_half_turns_has_the_derivative_of_what_it_is(function):
    at = function(3 * u)
    assert ordinary(at.diff(u)) == ordinary(at).diff(u)
