"""Agreement with the seed chapter's own pictures, its sphere B mended."""

from functools import cache
from itertools import product
from pathlib import Path

import numpy as np
import pytest

from renderer import Scene, central, exact, render
from renderer.kernels import FIELDS
from renderer.scene import MODELS

DATA = np.load(Path(__file__).parent / "data" / "seed_64.npz")
METHODS = {"exact": exact(), "general": exact("general"), "central": central(1e-3)}
AGREEMENT = 1e-10


@cache
def drawn(field, model, method):
    return render(Scene(field=field, model=model), 64, 64, METHODS[method])


@pytest.mark.parametrize(("field", "model", "method"), list(product(FIELDS, MODELS, METHODS)))
def test_rgb(field, model, method):
    stored = DATA[f"{field}.{model}.{'central' if method == 'central' else 'exact'}.rgb"]
    np.testing.assert_allclose(drawn(field, model, method).rgb, stored, rtol=0, atol=AGREEMENT)


@pytest.mark.parametrize("field", FIELDS)
def test_surface(field):
    np.testing.assert_array_equal(drawn(field, "blinn", "exact").chambers & 3, DATA[f"{field}.blinn.exact.surface"])


@pytest.mark.parametrize("field", FIELDS)
def test_kink(field):
    np.testing.assert_array_equal(drawn(field, "blinn", "exact").kink, DATA[f"{field}.blinn.exact.kink"])


def test_the_stored_kinks_are_on_ridges_alone():
    assert [bool(DATA[f"{field}.blinn.exact.kink"].any()) for field in FIELDS] == [f == "ridges" for f in FIELDS]


@pytest.mark.parametrize("field", FIELDS)
def test_slope(field):
    data = drawn(field, "blinn", "exact").surface_data
    slope_l1 = np.nan_to_num(np.abs(data["h_u"]) + np.abs(data["h_v"]))
    np.testing.assert_allclose(slope_l1, DATA[f"{field}.blinn.exact.slope_l1"], rtol=0, atol=AGREEMENT)
