"""Derivatives of a height field's expression: creases, factors, and the bounds of a difference's error.

A field that no kernel could draw is refused in words.
"""

import re
from dataclasses import replace

import numpy as np
import pytest
from mpmath import iv, mpf
from numpy.testing import assert_allclose, assert_array_equal
from sympy import Abs, Max, Min, Piecewise, Rational, atan, floor, log, sign, simplify, sqrt

from proofs.engine.functions import FUNCTIONS
from proofs.engine.half_turns import atan2pi, cospi, ordinary, sinpi
from proofs.engine.program import Program
from proofs.engine.registry import by_name
from proofs.engine.vectors import real
from proofs.formulas.creases import straddling
from proofs.formulas.finite_difference import METHODS
from proofs.formulas.height_fields import HEIGHT_FIELDS, AnyField, HeightField, gradient
from proofs.formulas.ranges import enclosure
from proofs.formulas.shading import LIGHT_MODELS
from proofs.formulas.step_bounds import TERMS
from proofs.formulas.symbols import h, k_u, k_v, u, v
from proofs.printers.coq_float64 import carried_out
from renderer import kernels, operations
from renderer.generate.__main__ import write_all
from renderer.generate.kernels import function_of, kernels_source
from renderer.generate.reader import expression_text, parse_expression
from verify.accuracy.creases import crease_point, crease_rates
from verify.accuracy.step_terms import RULES, bounds_of, factors_of, slope_terms
from verify.checkers.digits import Code
from verify.evaluate.balls import Balls

_inside = Rational(1, 16) - (u - Rational(1, 2)) ** 2 - (v - Rational(1, 2)) ** 2
_cosines = cospi(k_u * u) * cospi(k_v * v)
MORE = {
    "cosines": _cosines,
    "folded": Abs(_cosines),
    "slanted": Abs(sinpi(k_u * u + k_v * v)),
    "waves": sinpi(k_u * u) + sinpi(2 * k_u * u),
    "bump": Max(0, _inside) ** 2,
    "selected": Piecewise((_inside**2, _inside > 0), (0, True)),
    "tent": Abs(v - Rational(1, 2)),
    "golf": Max(0, sinpi(k_u * u) * sinpi(k_v * v) - Rational(1, 2)),
    "bricks": Abs(sinpi(k_u * u + floor(k_v * v) / 2)) * Abs(sinpi(k_v * v)),
    "nested": Abs(2 * Abs(_cosines) - 1),
    "hills": Max(0, sinpi(k_u * u), sinpi(k_v * v)),
}
FIELDS = HEIGHT_FIELDS | {name: HeightField(name, expression) for name, expression in MORE.items()}
COVERED = [field for field in FIELDS.values() if slope_terms(field)]
every_field = pytest.mark.parametrize("field", COVERED, ids=lambda field: field.name)
every_method = pytest.mark.parametrize("method", METHODS)
CHART = (u, v, k_u, k_v)


@pytest.mark.parametrize("function", FUNCTIONS, ids=lambda function: function.kernel)
def test_a_function_is_one_by_all_its_names(function):
    """In a kernel, at 50 digits, over balls, in Coq's float64 it is the same; for fields over intervals and as text."""
    two = function.made in (Max, Min, atan2pi)
    expression, at = function.made(*(u, v)[: 1 + two]), {"u": 0.375, "v": 0.8125}
    program = Program("call", (u, v), {h: expression})
    kernel = float(function_of(program)(*map(np.float64, at.values())))
    assert kernel == pytest.approx(
        float(Code((expression,))(dict(zip((u, v), map(mpf, at.values()), strict=True)))[0]), rel=1e-15
    )
    assert kernel == pytest.approx(float(Balls(program)(at, 200)["h"].mid()), rel=1e-15)
    assert (function.coq_float64 or function.coq) in " ".join(carried_out(program, vars(operations)))
    assert kernel == pytest.approx(float(expression.subs({u: Rational(3, 8), v: Rational(13, 16)})), rel=1e-15)
    if function.enclosed:
        values = enclosure(expression, {symbol: iv.mpf(at[symbol.name]) for symbol in (u, v)})
        assert kernel in values + iv.mpf([-1e-15, 1e-15]) and (function.made is sign or float(values.delta) < 1e-12)
        assert parse_expression(expression_text(expression)) == expression


def test_a_function_of_half_turns_has_the_slopes_of_its_like():
    for function, of in ((sinpi, (u,)), (cospi, (u,)), (atan2pi, (u, v))):
        for symbol in of:
            assert simplify(ordinary(function(*of).diff(symbol)) - ordinary(function(*of)).diff(symbol)) == 0


def test_the_last_of_three_values_is_for_all_else():
    values = enclosure(Piecewise((2, u > 2), (u, u > 1), (3, True)), {u: iv.mpf([0, 1])})
    assert (float(values.a), float(values.b)) == (0, 3)


def crossed(factors, at):
    """Return between which neighbours of some points of the chart a factor changes its sign."""
    signs = [np.sign(function_of(Program("factor", CHART, {h: factor}))(*at)) for factor in factors]
    return sum((np.diff(side) != 0 for side in signs), np.zeros(len(at[0]) - 1, bool))


@pytest.mark.parametrize("field", FIELDS.values(), ids=FIELDS)
def test_slopes_jump_at_the_creases_and_nowhere_else(field):
    along = np.linspace(0, 1, 20001)
    at = 0.03 + 0.9 * along, 0.11 + 0.61 * along, 8.0, 4.0
    slopes = np.broadcast_arrays(*function_of(gradient(field))(*at), along)[:2]
    jumps = np.abs(np.diff(slopes)).max(axis=0) > 0.5
    creases = crossed(field.creases, at)
    may = field.name == "hills"  # where two of its values are equal, the third may be above them
    assert_array_equal(jumps, creases & jumps if may else creases)


@pytest.mark.parametrize("name", ["ridges", "tent", "golf", "bricks", "nested", "hills"])
def test_no_difference_is_off_unless_it_straddles(name):
    """A difference across a jump of the slope is off by some of the jump; two crossings in one step are not noticed."""
    at = *np.random.default_rng(53).uniform(0, 1, (2, 4000)), 8.0, 4.0
    ours, true = function_of(METHODS["central"](FIELDS[name]))(*at, 1e-3), function_of(gradient(FIELDS[name]))(*at)
    off = np.max([abs(one - other) + 0 * at[0] for one, other in zip(ours, true, strict=True)], axis=0)
    flags = function_of(straddling(FIELDS[name]))(*at, 1e-3) == 1
    assert off[~flags].max() < 0.2 < off[flags].max()


REFUSED = {
    "my-field": (v, "name = 'my-field' is not allowed: an identifier"),
    "lambda": (v, "no keyword of Python"),
    "arctangent": (atan(u * v), r"expression = atan\(u\*v\) is not allowed: no kernel has atan as in"),
    "power": ((2 + v) ** k_u, "no kernel has Pow as in"),
    "selected": (Piecewise((1, atan(v) > 1), (v, True)), "no kernel has atan"),
    "pole": (1 / (3 * v - 1), "on the chart .* is not shown to be finite"),
    "root": (v * sqrt(u - 2), r"on the chart sqrt\(u - 2\) is not shown to be real"),
    "rates": (sinpi(v) / (k_u + 3), "on the chart .* is not shown to be finite"),
    "negative": (log(v - 1), "logarithm of a negative"),
    "seam": (u * v, "it is 0 at u = 0 and 0.143 at u = 1, .* without seam=True"),
    "symbol": (u * real("w"), "it has w, and a field no symbols but u, v, k_u, k_v"),
    "spiral": (atan2pi(v - Rational(1, 2), u), r"atan2pi\(y, x\) has a jump unless"),
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


def test_nothing_is_written_unless_all_can_be_printed(tmp_path, monkeypatch, capsys):
    monkeypatch.setitem(HEIGHT_FIELDS, "odd_one", AnyField("odd_one", atan(v)))
    words = re.escape("height_odd_one is not allowed: it calls atan, which no kernel has")
    with pytest.raises(ValueError, match=words):
        write_all({tmp_path / "first": str, tmp_path / "kernels.py": kernels_source})
    assert not [*tmp_path.iterdir()]
    for told in ("wrote", "unchanged"):
        write_all({tmp_path / "first": str})
        assert capsys.readouterr().out == f"{told} first: 0 lines\n"


# The bounds of a difference's error, on the pages and in the simulator


def test_only_what_the_theorems_cover_has_a_bound():
    """A slanted wave, a square, another amplitude or frequency, and a sine of a cosine's angle have none."""
    assert {"sine", "ridges"} < {field.name for field in COVERED} and slope_terms(FIELDS["slanted"]) is None
    sine, field = sinpi(k_u * u), HEIGHT_FIELDS["sine"]
    for expression in (sine**2, sinpi(3 * k_u * u / 2) * sine, sine * cospi(k_u * u), 2 * sine, sine + sinpi(k_v * v)):
        assert factors_of(replace(field, expression=expression)) is None
    assert factors_of(replace(field, expression=sine * cospi(k_v * v))) == (sine, cospi(k_v * v))


def drawn(count):
    """Return random u, v, k_u, k_v and ε: everywhere, beside zeros, the seam and poles; whole waves and others."""
    rng, two = np.random.default_rng(11), (2, count)
    eps, waves = 10.0 ** rng.uniform(-18, np.log10(0.5), count), rng.integers(-16, 17, two).astype(float)
    waves += rng.choice([0.0, 0.5, 0.3], count)
    places, near = rng.random(two), 10.0 ** rng.uniform(-9, -1, two) * rng.choice([-1, 1], two)
    zeros = np.rint(places * waves) + rng.choice([0.0, 0.5], two) + near
    places = np.where(rng.random(two) < 0.5, places, zeros / np.where(waves == 0, 1, waves))
    return places[0] % 1.0, np.clip(np.abs(places[1]), 0, 1), *waves, eps


def errors_and_terms(field, at, method="central"):
    """Return how far a field's difference is off, in u and in v, and each slope's terms, which have to bound that."""
    ours, true = function_of(METHODS[method](field))(*at), function_of(gradient(field))(*at[:-1])
    zero = np.zeros(np.broadcast(*at).shape)
    errors = [zero + abs(one - other) for one, other in zip(ours, true, strict=True)]
    terms = np.array([[zero + term for term in slope] for slope in slope_terms(field, method)(*at)])
    assert (errors <= terms.sum(axis=1)).all()
    return np.array(errors), terms


@every_method
@every_field
@np.errstate(all="ignore")
def test_no_difference_is_further_off_than_its_bound(field, method):
    at = drawn(20_000)
    errors, terms = errors_and_terms(field, at, method)
    of_slopes = terms.sum(axis=1)
    assert (errors > of_slopes - terms.max(axis=1)).any()  # without its largest term it is no bound
    leading = {TERMS[number] for number in np.unique(terms.argmax(axis=1))}
    never = {"one-sided"} if method == "forward" else set()  # it turns round at a pole
    never |= {"straddling"} if factors_of(field)[0] is None else set()  # rings has no seam
    assert leading == {*TERMS} - never
    bound, leading, *slopes = bounds_of(field, method)(*at)  # what the simulator shows: the larger slope's
    assert_allclose(slopes, of_slopes)
    larger = terms[np.where(slopes[0] > slopes[1], 0, 1), :, np.arange(20_000)]
    assert_array_equal(leading, np.where(larger.any(axis=1), larger.argmax(axis=1) + 1, 0))
    assert_array_equal(bound, np.max(slopes, axis=0))


@every_method
@pytest.mark.parametrize("k", [2.0, 8.0, 64.0])
def test_the_bounds_are_sharp(k, method):
    """Reach the bound, up to the next term of its series, by a small step where the derivative is the largest."""
    u, eps = 0.3 + np.linspace(0, 1 / k, 2001), 1e-2 / k
    (errors, _), _ = errors_and_terms(HEIGHT_FIELDS["sine"], (u, 1 / 8, k, 4.0, eps), method)
    assert 0.999 < errors.max() / RULES[method].smooth(eps, k) < 1


@np.errstate(all="ignore")
def test_the_creases_are_where_the_factors_are_zero():
    """Meridians and a parallel: on the image, and back on the chart, the factor is zero there."""
    for a, b, offset in np.reshape(crease_rates(HEIGHT_FIELDS["ridges"])(8.0, 4.0), (2, 3)):
        x, y = crease_point(a, b, 1.0, np.linspace(0.01, 1, 97), 4.0, 1.0)
        at_u, at_v = kernels.chart(*kernels.angles_on_a(x[~np.isnan(x)], y[~np.isnan(x)], 4.0, 1.0))
        turns = a * at_u + b * at_v + offset
        assert np.abs(turns - np.rint(turns)).max() < 1e-12
