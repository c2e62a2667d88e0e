"""What is derived of a height field's expression is so, and what no kernel could draw is refused in words."""

import re
from dataclasses import replace

import numpy as np
import pytest
from sympy import Abs, Max, Piecewise, Rational, atan, log

from proofs.engine.program import Program
from proofs.formulas.half_turns import cospi, sinpi
from proofs.formulas.height_fields import HEIGHT_FIELDS, AnyField, HeightField, gradient
from proofs.formulas.registry import by_name
from proofs.formulas.shading import LIGHT_MODELS
from proofs.formulas.symbols import h_u, h_v, k_u, k_v, real, u, v
from renderer.generate import kernels
from renderer.generate.__main__ import write_all
from renderer.generate.kernels import function_of
from verify.evaluate.arrays import distance, in_balls

_inside = Rational(1, 16) - (u - Rational(1, 2)) ** 2 - (v - Rational(1, 2)) ** 2
MORE = {
    "cosines": Abs(cospi(k_u * u) * cospi(k_v * v)),
    "slanted": Abs(sinpi(k_u * u + k_v * v)),
    "waves": sinpi(k_u * u) + sinpi(2 * k_u * u),
    "bump": Max(0, _inside) ** 2,
    "selected": Piecewise((_inside**2, _inside > 0), (0, True)),
}
FIELDS = HEIGHT_FIELDS | {name: HeightField(name, expression) for name, expression in MORE.items()}
CHART = (u, v, k_u, k_v)


def crossed(factors, at):
    """Return between which neighbours of some points of the chart a factor sinpi(w) is zero."""
    turns = [function_of(Program("turns", CHART, ((real("turns"), factor.args[0]),)))(*at) for factor in factors]
    return sum((np.diff(np.floor(w)) != 0 for w in turns), np.zeros(len(at[0]) - 1, bool))


@pytest.mark.parametrize("field", FIELDS.values(), ids=FIELDS)
def test_slopes_jump_at_the_creases_and_nowhere_else(field):
    along = np.linspace(0, 1, 20001)
    at = 0.03 + 0.9 * along, 0.11 + 0.61 * along, 8.0, 4.0
    slopes = np.broadcast_arrays(*function_of(gradient(field))(*at), along)[:2]
    jumps = np.abs(np.diff(slopes)).max(axis=0) > 0.5
    np.testing.assert_array_equal(jumps, crossed(field.creases, at))
    assert (jumps != crossed((*field.creases[1:], sinpi(k_u * u + Rational(1, 3))), at)).any()


@pytest.mark.parametrize("field", [field for field in FIELDS.values() if field.wave_numbers], ids=str)
def test_the_wave_numbers_give_the_gradient_its_factors(field):
    at = {"u": [0.13, 0.71], "v": [0.29, 0.83], "k_u": [7.3, -2.0], "k_v": [4.1, 3.0]}
    named, whole = in_balls(gradient(field), at), Program("slopes", CHART, (((h_u, h_v), field.gradient()),))
    assert max(distance(named[name], ball).max() for name, ball in in_balls(whole, at).items()) < 1e-60


REFUSED = {
    "my-field": (v, "name = 'my-field' is not allowed: an identifier"),
    "lambda": (v, "no keyword of Python"),
    "arctangent": (atan(u * v), r"expression = atan\(u\*v\) is not allowed: no kernel has atan as in"),
    "power": ((2 + v) ** k_u, "no kernel has Pow as in"),
    "selected": (Piecewise((1, atan(v) > 1), (v, True)), "no kernel has atan"),
    "pole": (1 / (3 * v - 1), "on the chart .* is not shown to be finite"),
    "negative": (log(v - 1), "logarithm of a negative"),
    "seam": (u * v, "it is 0 at u = 0 and 0.143 at u = 1, .* without seam=True"),
    "tent": (Abs(v - Rational(1, 2)), "creases have to be .* may be where .* = 0"),
    "three": (Max(0, sinpi(k_u * u), sinpi(k_v * v)), "creases have to be"),
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
    words = re.escape("height_odd_one is not allowed: it calls atan, which no kernel has")
    with pytest.raises(ValueError, match=words):
        write_all({tmp_path / "first": str, tmp_path / "kernels.py": kernels.kernels_source})
    assert not [*tmp_path.iterdir()]
