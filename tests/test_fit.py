"""A scene that is fitted to a picture: what is not told apart, and what is refused."""

from dataclasses import replace

import numpy as np
import pytest

from renderer import Scene, fit, render
from tests.refusals import rejection

SINE = Scene(field="sine")


def test_a_fit_says_what_it_cannot_tell_and_what_it_is_not_given():
    frame = render(SINE, 16, 16)
    once, twice = (fit(replace(SINE, beta=0.3), frame, names) for names in (["beta"], ["beta", "beta"]))
    assert once == twice and once.scene.number("beta") == pytest.approx(SINE.beta, rel=1e-12)
    for scene, names in (
        (replace(SINE, kd=0.0, ks=0.0), ["beta"]),
        (SINE, ["ka", *(f"ambient[{n}]" for n in range(3))]),
    ):
        assert set(fit(scene, render(scene, 16, 16), names).errors.values()) == {np.inf}
    for picture in (None, "sky", frame.srgb, frame.rgb[..., 0], frame.rgb * np.nan, frame.rgb * 1e5, frame.rgb + 0j):
        assert rejection(fit, SINE, picture, ["beta"]).startswith("picture = ")
    assert [rejection(fit, SINE, frame, names)[:5] for names in ((), "beta")] == ["names", "names"]
