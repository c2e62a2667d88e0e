"""Every method takes the same gradient, each difference at its order; what is not installed is left out."""

import numpy as np
import pytest

from verify.benchmark.methods import table
from verify.benchmark.work_precision import largest_error, points_for

POINTS = 200
METHODS = {method.name: method for method in table.METHODS if method.available}
ORDERS = {"forward": 1, "central": 2, "central, 4th order": 4, "central, 6th order": 6, "Richardson, 8th order": 8}
LEAST = {"exact, algebraic, float32": 1e-4, "forward": 1e-5, "central": 1e-7, "central, 4th order": 1e-9}


def error(name, value):
    """Return a method's largest error at the sample's points."""
    return largest_error(METHODS[name].make(value)(*points_for(METHODS[name], POINTS)), POINTS)


@pytest.mark.parametrize("name", METHODS)
def test_every_method_finds_the_gradient(name):
    values = METHODS[name].values
    best = min(error(name, value) for value in values[:: 1 if len(values) < 10 else 3])
    assert best < LEAST.get(name, 2e-11)


@pytest.mark.parametrize("name", ORDERS)
def test_differences_have_their_order(name):
    """Between two steps at which truncation leads, the error falls by their ratio to the order."""
    high = {1: 1e-4, 2: 1e-3, 4: 1e-2, 6: 2e-2, 8: 3e-2}[ORDERS[name]]
    fitted = np.log(error(name, high) / error(name, high / 1.5)) / np.log(1.5)
    assert fitted == pytest.approx(ORDERS[name], abs=0.15)
