"""The figures of accuracy: a point above its bound stops the build."""

import pytest

from book.figures import u_curve
from verify.accuracy.differences import bounds


def test_a_figure_with_an_escape_is_not_drawn(monkeypatch):
    monkeypatch.setattr(u_curve, "bounds", lambda case: {part: limit / 4 for part, limit in bounds(case).items()})
    with pytest.raises(ValueError, match="steep"):
        u_curve.below.__wrapped__(u_curve.STEEP)
