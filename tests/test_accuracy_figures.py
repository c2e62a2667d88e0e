"""The figures of accuracy: a point above its bound stops the build."""

import pytest

from book.figures import elementary_ulps, reference_pixels, u_curve_apart
from verify.accuracy.certified_ulps import pieces_of
from verify.accuracy.difference_bounds import Bounds, bounds


def test_a_u_curve_with_an_escape_is_not_drawn(monkeypatch):
    smaller = lambda case, found: Bounds(*(limit / 4 for limit in bounds(case, found)))  # noqa: E731
    monkeypatch.setattr(u_curve_apart, "bounds", smaller)
    u_curve_apart.below.cache_clear()
    with pytest.raises(u_curve_apart.EscapedBound, match="steep"):
        u_curve_apart.below(u_curve_apart.STEEP)
    u_curve_apart.below.cache_clear()


def test_an_argument_above_its_certificate_is_not_drawn(monkeypatch):
    halved = [piece._replace(ulps=piece.ulps / 2) for piece in pieces_of("cospi")]
    monkeypatch.setattr(elementary_ulps, "_pieces", lambda name: halved)
    elementary_ulps._samples.cache_clear()
    with pytest.raises(ValueError, match="certified is"):
        elementary_ulps._samples("cospi")
    elementary_ulps._samples.cache_clear()


def test_a_pixel_above_its_bound_is_not_drawn(monkeypatch):
    monkeypatch.setattr(reference_pixels, "EACH", 1)
    monkeypatch.setattr(reference_pixels, "problems", lambda pixels: pixels[:1])
    reference_pixels._pixels.cache_clear()
    with pytest.raises(ValueError, match="off by more than their bound"):
        reference_pixels.reference_pixels()
    reference_pixels._pixels.cache_clear()
