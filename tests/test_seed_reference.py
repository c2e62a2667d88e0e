"""Agreement with the seed chapter's own pictures, its sphere B mended."""

from functools import cache
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from proofs.formulas.height_fields import HEIGHT_FIELDS
from renderer import Scene, central, exact, render
from renderer.kernels import FIELDS
from renderer.scene.scene import MODELS

DATA = np.load(Path(__file__).parent / "data" / "seed_64.npz")
METHODS = {"exact": exact(), "general": exact("general"), "central": central(1e-3)}
AGREEMENT = 1e-10


@cache
def drawn(field, model, method):
    return render(Scene(field=field, model=model), 64, 64, METHODS[method])


@pytest.mark.parametrize(("field", "model", "method"), list(product(FIELDS, MODELS, METHODS)))
def test_rgb(field, model, method):
    stored = DATA[f"{field}.{model}.{'central' if method == 'central' else 'exact'}.rgb"]
    assert_allclose(drawn(field, model, method).rgb, stored, rtol=0, atol=AGREEMENT)


@pytest.mark.parametrize("field", FIELDS)
def test_surface_kink_and_slope(field):
    frame, data = drawn(field, "blinn", "exact"), DATA[f"{field}.blinn.exact.kink"]
    assert_array_equal(frame.chambers & 3, DATA[f"{field}.blinn.exact.surface"])
    assert_array_equal(frame.kink, data)
    assert data.any() == bool(HEIGHT_FIELDS[field].creases)
    slope_l1 = np.nan_to_num(np.abs(frame.surface_data["h_u"]) + np.abs(frame.surface_data["h_v"]))
    assert_allclose(slope_l1, DATA[f"{field}.blinn.exact.slope_l1"], rtol=0, atol=AGREEMENT)
