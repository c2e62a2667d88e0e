"""Views: sRGB is its formula; and what pictures show that `tests/test_simulator_numbers.py` does not compare."""

import matplotlib
import numpy as np

from renderer.files import srgb
from renderer.machines import numpy_rows
from renderer.picture import views


def test_srgb_is_the_formula_everywhere(monkeypatch):
    """Next to where bytes begin, and where the table's cells do, as well as anywhere else; what is outside is cut."""
    begins = srgb.tables()[0][:-1]
    ends = np.concatenate([begins, (np.arange(srgb.CELLS) + 0.5) / srgb.CELLS])
    near = np.concatenate([ends, np.nextafter(ends, 0), np.nextafter(ends, 1), [-1.0, 0.0, 1.0, 2.0]])
    numbers = np.random.default_rng(1).random((3000, 333, 3))
    numbers.reshape(-1)[: near.size] = near
    inside = np.clip(numbers, 0, 1)
    formula = np.where(inside <= 0.0031308, 12.92 * inside, 1.055 * inside ** (1 / 2.4) - 0.055)
    for written in (views.to_bytes(numbers, threads=2), views.to_bytes(numbers[::-1].copy(order="F"))[::-1]):
        np.testing.assert_array_equal(written, np.rint(255 * formula))
    monkeypatch.setattr(srgb, "machine", lambda: numpy_rows)
    np.testing.assert_array_equal(views.to_bytes(numbers), np.rint(255 * formula))


def test_the_logarithmic_difference_is_black_at_zero_and_nowhere_else():
    """Of a pixel's channels the largest counts."""
    delta = np.array([[0.0, -0.0, np.nan, 5e-324, 1e-30, 1e-16, 1e-8, 1.0, 10.0]])
    low, middle, high = (matplotlib.colormaps["inferno"](n, bytes=True)[:3] for n in (0.0, 0.5, 1.0))
    expected = [[*[(0, 0, 0)] * 3, *[low] * 3, middle, high, high]]
    np.testing.assert_array_equal(views.difference_logarithmic(np.stack([-delta, 0 * delta], axis=2)), expected)
