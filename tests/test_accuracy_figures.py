"""The figures of accuracy: a point above its bound stops the build."""

import pytest

from book.figures import elementary_ulps, u_curve
from verify.accuracy.certified_ulps import PIECES
from verify.accuracy.differences import bounds

HALVED = [piece._replace(ulps=piece.ulps / 2) for piece in PIECES["cospi"]()]
CASES = (
    (u_curve, {"bounds": lambda case: {part: limit / 4 for part, limit in bounds(case).items()}},
     u_curve.below.__wrapped__, (u_curve.STEEP,), "steep"),
    (elementary_ulps, {"PIECES": {"cospi": lambda: HALVED}}, elementary_ulps._samples, ("cospi",), "certified is"),
)  # fmt: skip


@pytest.mark.parametrize("module, changes, drawn, arguments, message", CASES)
def test_a_figure_with_an_escape_is_not_drawn(module, changes, drawn, arguments, message, monkeypatch):
    for name, value in changes.items():
        monkeypatch.setattr(module, name, value)
    with pytest.raises(ValueError, match=message):
        drawn(*arguments)
