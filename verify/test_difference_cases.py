"""The cases of the central difference hold where their hypotheses do, which are no narrower than they have to be."""

from itertools import product

import pytest
from sympy import Rational

from proofs.formulas.difference_cases import at_pole, inside, nothing_clamps, nothing_wraps, pole_clamps
from proofs.formulas.finite_difference import central
from proofs.formulas.height_fields import ANY_FIELD
from proofs.formulas.symbols import epsilon, h_u, h_v, u, v

EIGHTHS = [Rational(n, 8) for n in range(9)]
POINTS = [{u: a, v: b, epsilon: c} for a, b, c in product(EIGHTHS[:8], EIGHTHS, EIGHTHS[1:5])]  # on every edge


def places(case, given, slope):
    """Return (the points where the hypotheses hold, those where the case has the central difference's slope)."""
    whole, decided = central(ANY_FIELD).expand(slope), case(ANY_FIELD).expand(slope)
    held = [number for number, at in enumerate(POINTS) if all(relation.subs(at) for relation in given)]
    return held, [number for number, at in enumerate(POINTS) if whole.subs(at) == decided.subs(at)]


def test_nothing_is_decided_elsewhere_than_where_it_is_given():
    """Near the pole, the clamped case is the difference."""
    for given, slope in ((nothing_wraps, h_u), (nothing_clamps, h_v)):
        held, same = places(inside, given, slope)
        assert 0 < len(held) < len(POINTS) and held == same
    held, same = places(at_pole, pole_clamps, h_v)
    assert held and {*held} <= {*same}


@pytest.mark.parametrize("edited", [(1, u - epsilon > 0), (2, u + epsilon > 1)])
def test_an_edited_hypothesis_is_found(edited):
    number, relation = edited
    held, same = places(inside, (*nothing_wraps[:number], relation, *nothing_wraps[number + 1 :]), h_u)
    assert held != same
