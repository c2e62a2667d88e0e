"""Our own elementary functions, against balls: no error is above what Coq proves, or the certified one.

Arguments are random, and adversarial: on and beside the zeros, the quadrants' and the nodes' edges, tiny, large.
"""

import json

import numpy as np
import pytest
from numpy.testing import assert_array_equal
from sympy import Rational

from proofs.engine.program import chain
from proofs.formulas import exponential
from proofs.formulas.certified import POWER_RATE, PROVED, ROUNDINGS, SINE
from proofs.formulas.enclosed import RULES
from proofs.formulas.symbols import real, x, y
from renderer import kernels
from renderer.operations import UNIT
from verify.coq import formal
from verify.evaluate.arrays import distance, in_balls, in_float64


def beside(values, count=3):
    """Return float64 numbers and their neighbours on either side; below a power of two these are half as far away."""
    return np.concatenate([values + half * np.spacing(values) / 2 for half in range(-2 * count, 2 * count + 1)])


RANDOM = np.random.default_rng(5)
SPREAD = RANDOM.uniform(-2, 2, 3000), RANDOM.uniform(-(2**20), 2**20, 1000), 10.0 ** -np.arange(1.0, 100)
NUMBERS = np.concatenate([*SPREAD, beside(np.arange(-32, 33) / 16)])
POSITIVE = np.abs(NUMBERS)[np.abs(NUMBERS) > 1e-90]
WAVES = RANDOM.integers(1, 65, 800).astype(float)
CREASES = beside(np.floor((WAVES + 1) * RANDOM.random(800)) / WAVES)
SIGNS = RANDOM.choice([-1.0, 1.0], NUMBERS.size)
EXPONENTS = 10.0 ** RANDOM.uniform(-3, 6, 5000)
BASES = np.exp(-np.where(RANDOM.random(5000) < 0.5, 50, 707) * RANDOM.random(5000) / EXPONENTS)
PRODUCTS = np.append(np.resize(WAVES, CREASES.size), np.ones(NUMBERS.size)), np.append(CREASES, NUMBERS)
CASES = {
    "sine": (RULES["enclosed_sine"], PRODUCTS, PROVED["of_product_relative"]),
    "cosine": (RULES["enclosed_cosine"], PRODUCTS, PROVED["of_product_relative"]),
    "angle": (RULES["enclosed_angle"], (np.append(NUMBERS, SIGNS), np.append(SIGNS, NUMBERS)), ROUNDINGS["atan2pi"]),
    "exponential": (RULES["enclosed_exponential"], (350 * NUMBERS[np.abs(NUMBERS) <= 2],), PROVED["exp"]),
    "logarithm": (RULES["enclosed_logarithm"], (np.concatenate([POSITIVE, POSITIVE**-3]),), PROVED["log"]),
    "power": (chain("raised", {real("raised"): x**y}), (BASES[BASES > 0], EXPONENTS[BASES > 0]), PROVED["power"]),
}
"""{function: (its program, arguments, how far it can be off, of itself)}"""


def errors(name):
    """Return how far a function is off, in units of 2^-53, and its size."""
    program, arguments, _ = CASES[name]
    inputs = dict(zip((s.name for s in program.inputs), arguments, strict=True))
    (ours,), (exact,) = in_float64(program, inputs).values(), in_balls(program, inputs).values()
    return distance(ours, exact) / UNIT, np.abs(exact.astype(float))


@pytest.mark.parametrize("name", CASES)
def test_no_error_is_larger(name):
    (off, size), most = errors(name), float(CASES[name][2])
    rate = float(POWER_RATE) * np.abs(np.log(size)) if name == "power" else 0.0
    assert (off <= (most + rate) * size).all()
    if name in ("sine", "cosine"):
        assert (off <= float(SINE)).all()


def test_what_a_step_says_is_what_coq_accepted():
    statements = json.loads(formal.RECORD.read_text("utf-8"))["theorems"]["elementary_functions"]["statements"]
    rate = f" + {POWER_RATE.numerator} / {POWER_RATE.denominator} * Rabs (p * ln x)"
    for name, most in PROVED.items():
        written = f"{most.numerator} / {most.denominator}{rate if name == 'power' else ''}"
        assert written in statements[f"elementary_functions__{name}"], name


def test_the_enclosing_machine_charges_enough():
    """Once, or twice what rises or falls: there Coq's count is above the charge by 8 roundings at most."""
    most = PROVED | {name: PROVED["power"] + POWER_RATE * size for name, size in (("power", 50), ("small_power", 709))}
    most |= {"sinpi": PROVED["of_product_relative"], "cospi": PROVED["of_product_relative"]}
    for name, charge in ROUNDINGS.items():
        assert most[name] - charge <= (min(charge, 8) if name in ("exp", "power", "small_power") else 0), name


def test_a_constant_of_few_binary_places_has_no_rest():
    assert exponential._in_two(Rational(3, 2)) == (Rational(3, 2), 0)


@np.errstate(all="ignore")
def test_what_they_are_at_the_ends_of_their_range_and_outside():
    numbers = np.array([np.nan, np.inf, -np.inf, 709.1, -708.1, -0.0])
    assert_array_equal(kernels.exp(numbers), [np.nan, np.inf, 0, np.inf, 0, 1])
    assert_array_equal(kernels.log(numbers[[0, 1, 4, 5]]), [np.nan, np.inf, np.nan, -np.inf])
    for exponent in (5e-4, 0.1, 0.5, 1.0, 7.3, 1e6):
        assert_array_equal(kernels.power(np.array([0, 1, np.nan]), exponent), [0, 1, np.nan])
