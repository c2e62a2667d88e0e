"""Our own elementary functions: what they are at the ends of their range and outside, and what measures them."""

import numpy as np
import pytest
from numpy.testing import assert_array_equal
from sympy import Rational

from proofs.formulas import exponential
from renderer import kernels
from verify.checkers.measurements import elementary


def test_a_constant_of_few_binary_places_has_no_rest():
    assert exponential._in_two(Rational(3, 2)) == (Rational(3, 2), 0)


@pytest.mark.parametrize("name", elementary.KERNELS)
def test_an_error_is_measured(name, monkeypatch):
    """One of eight roundings, or of the bound where that is larger; a missed zero is infinite."""
    kernel = elementary.KERNELS[name]
    assert elementary.shares(name).max() <= 1
    monkeypatch.setitem(elementary.KERNELS, name, lambda *at: kernel(*at) * (1 + 2.0**-50))
    assert elementary.shares(name).max() > 1


def test_a_missed_zero_is_infinite(monkeypatch):
    monkeypatch.setitem(elementary.KERNELS, "log", lambda x: kernels.log(x) + 1e-300)
    assert elementary.shares("log").max() == np.inf


@np.errstate(all="ignore")
def test_what_they_are_at_the_ends_of_their_range_and_outside():
    numbers = np.array([np.nan, np.inf, -np.inf, 709.1, -708.1, -0.0])
    assert_array_equal(kernels.exp(numbers), [np.nan, np.inf, 0, np.inf, 0, 1])
    assert_array_equal(kernels.log(numbers[[0, 1, 4, 5]]), [np.nan, np.inf, np.nan, -np.inf])
    for exponent in (5e-4, 0.1, 0.5, 1.0, 7.3, 1e6):
        assert_array_equal(kernels.power(np.array([0, 1, np.nan]), exponent), [0, 1, np.nan])
