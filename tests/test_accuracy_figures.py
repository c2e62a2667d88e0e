"""The figures of accuracy: a point above its bound stops the build."""

import pytest

from book.figures import certified_bounds, u_curve
from verify.accuracy.differences import bounds

CASES = (
    (u_curve, {"bounds": lambda case: {part: limit / 4 for part, limit in bounds(case).items()}},
     u_curve.below.__wrapped__, (u_curve.STEEP,), "steep"),
    (certified_bounds, {"EACH": 1, "problems": lambda pixels: pixels[:1]}, certified_bounds.reference_pixels, (),
     "off by more than their bound"),
)  # fmt: skip


@pytest.mark.parametrize("module, changes, drawn, arguments, message", CASES)
def test_a_figure_with_an_escape_is_not_drawn(module, changes, drawn, arguments, message, monkeypatch):
    for name, value in changes.items():
        monkeypatch.setattr(module, name, value)
    with pytest.raises(ValueError, match=message):
        drawn(*arguments)
