"""Agreement with the seed chapter's own pictures, its sphere B mended."""

from pathlib import Path

import numpy as np
import pytest

from renderer import Scene, central, exact, render

DATA = np.load(Path(__file__).parent / "data" / "seed_64.npz")
METHODS = {"exact": (exact(), exact("general")), "central": (central(1e-3),)}


@pytest.mark.parametrize("name", DATA)
def test_what_the_seed_drew_is_drawn(name):
    """Colours, surfaces, kinks, and |h_u| + |h_v| on A."""
    field, model, method, plane = name.split(".")
    for way in METHODS[method]:
        frame = render(Scene(field=field, model=model), 64, 64, way)
        slope = np.abs([frame.surface_data["h_u"], frame.surface_data["h_v"]]).sum(axis=0)
        planes = {"rgb": frame.rgb, "surface": frame.chambers & 3, "kink": frame.kink, "slope_l1": np.nan_to_num(slope)}
        np.testing.assert_allclose(planes[plane], DATA[name], rtol=0, atol=1e-10)
