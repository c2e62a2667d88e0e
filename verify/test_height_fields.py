"""What is derived of a height field's expression is so: creases, factors, and what bounds a central difference's error.

What no kernel could draw is refused in words.
"""

from dataclasses import replace

import numpy as np
import pytest
from mpmath import iv
from numpy.testing import assert_array_equal
from sympy import Abs, Max, Piecewise, Rational, atan, log

from proofs.engine.program import Program
from proofs.formulas.half_turns import cospi, sinpi
from proofs.formulas.height_fields import HEIGHT_FIELDS, AnyField, HeightField, gradient
from proofs.formulas.ranges import enclosure
from proofs.formulas.registry import by_name
from proofs.formulas.shading import LIGHT_MODELS
from proofs.formulas.symbols import k_u, k_v, real, u, v
from renderer import kernels
from renderer.generate.__main__ import write_all
from renderer.generate.kernels import function_of, kernels_source
from renderer.generate.step_terms import SLOPE_TERMS, factors_of, slope_terms

_inside = Rational(1, 16) - (u - Rational(1, 2)) ** 2 - (v - Rational(1, 2)) ** 2
_cosines = cospi(k_u * u) * cospi(k_v * v)
MORE = {
    "cosines": _cosines,
    "folded": Abs(_cosines),
    "slanted": Abs(sinpi(k_u * u + k_v * v)),
    "waves": sinpi(k_u * u) + sinpi(2 * k_u * u),
    "bump": Max(0, _inside) ** 2,
    "selected": Piecewise((_inside**2, _inside > 0), (0, True)),
}
FIELDS = HEIGHT_FIELDS | {name: HeightField(name, expression) for name, expression in MORE.items()}
CHART = (u, v, k_u, k_v)


def test_the_last_of_three_values_is_for_all_else():
    found = enclosure(Piecewise((2, u > 2), (u, u > 1), (3, True)), {u: iv.mpf([0, 1])})
    assert (float(found.a), float(found.b)) == (0, 3)


def crossed(factors, at):
    """Return between which neighbours of some points of the chart a factor sinpi(w) is zero."""
    turns = [function_of(Program("turns", CHART, {real("turns"): factor.args[0]}))(*at) for factor in factors]
    return sum((np.diff(np.floor(w)) != 0 for w in turns), np.zeros(len(at[0]) - 1, bool))


@pytest.mark.parametrize("field", FIELDS.values(), ids=FIELDS)
def test_slopes_jump_at_the_creases_and_nowhere_else(field):
    along = np.linspace(0, 1, 20001)
    at = 0.03 + 0.9 * along, 0.11 + 0.61 * along, 8.0, 4.0
    slopes = np.broadcast_arrays(*function_of(gradient(field))(*at), along)[:2]
    jumps = np.abs(np.diff(slopes)).max(axis=0) > 0.5
    assert_array_equal(jumps, crossed(field.creases, at))
    assert (jumps != crossed((*field.creases[1:], sinpi(k_u * u + Rational(1, 3))), at)).any()


REFUSED = {
    "my-field": (v, "name = 'my-field' is not allowed: an identifier"),
    "lambda": (v, "no keyword of Python"),
    "arctangent": (atan(u * v), r"expression = atan\(u\*v\) is not allowed: no kernel has atan as in"),
    "selected": (Piecewise((1, atan(v) > 1), (v, True)), "no kernel has atan"),
    "rates": (sinpi(v) / (k_u + 3), "on the chart .* is not shown to be finite"),
    "negative": (log(v - 1), "logarithm of a negative"),
    "seam": (u * v, "it is 0 at u = 0 and 0.143 at u = 1, .* without seam=True"),
    "tent": (Abs(v - Rational(1, 2)), "creases have to be .* may be where .* = 0"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_a_field_that_no_kernel_draws_is_refused(name):
    expression, words = REFUSED[name]
    with pytest.raises(ValueError, match=words):
        HeightField(name, expression)


def test_a_seam_may_be_asked_for_and_a_name_is_given_once():
    assert HeightField("seam", u * v, seam=True).creases == ()
    first, *_ = LIGHT_MODELS.values()
    with pytest.raises(ValueError, match=f"name = '{first.name}' is not allowed: a name that no other entry has"):
        by_name([first, replace(first)])


def test_nothing_is_written_unless_all_can_be_printed(tmp_path, monkeypatch):
    monkeypatch.setitem(HEIGHT_FIELDS, "odd_one", AnyField("odd_one", atan(v)))
    with pytest.raises(ValueError, match="height_odd_one is not allowed: it calls atan, which no kernel has"):
        write_all({tmp_path / "first": str, tmp_path / "kernels.py": kernels_source})
    assert not [*tmp_path.iterdir()]


# What bounds a central difference's error, on the pages and in the simulator


def test_only_what_the_theorems_cover_has_a_bound():
    """A slanted wave, a square, another amplitude or frequency, a sine of a cosine's angle: none."""
    assert SLOPE_TERMS.keys() == HEIGHT_FIELDS.keys() and slope_terms(FIELDS["slanted"]) is None
    sine, field = sinpi(k_u * u), HEIGHT_FIELDS["sine"]
    for expression in (sine**2, sinpi(3 * k_u * u / 2) * sine, sine * cospi(k_u * u), 2 * sine, sine + sinpi(k_v * v)):
        assert factors_of(replace(field, expression=expression)) is None
    assert factors_of(replace(field, expression=sine * cospi(k_v * v))) == (sine, cospi(k_v * v))


def test_a_difference_straddles_circles_and_not_the_pole():
    """At v < ε the difference is clamped at the pole, where |sin πk_v v| ends; at v = 1/k_v it crosses the crease."""
    straddling = kernels.FIELDS["ridges"]["straddling"]
    flags = straddling(0.05, np.array([1e-9, 1e-4, 0.009, 0.2499, 0.2501, 0.26]), 8.0, 4.0, 1e-3)
    assert_array_equal(flags, [0, 0, 0, 1, 1, 0])
    assert straddling(np.float64(0.05), np.float64(0.03), 8.0, 16.0, 0.05) == 1  # the first circle, past the pole
