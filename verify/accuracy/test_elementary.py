"""Our own elementary functions: the bounds that are charged are those that Coq proves; the ends of their ranges.

`verify/test_bounds.py` samples each bound that Coq proves, with the enclosing machine's rules.
"""

import json

import numpy as np
from numpy.testing import assert_array_equal

from proofs.formulas.certified import POWER_RATE, PROVED, ROUNDINGS
from renderer import kernels
from verify.coq import formal


def test_what_a_step_says_is_what_coq_accepted():
    statements = json.loads(formal.RECORD.read_text("utf-8"))["theorems"]["elementary_functions"]["statements"]
    rate = f" + {POWER_RATE.numerator} / {POWER_RATE.denominator} * Rabs (p * ln x)"
    for name, most in PROVED.items():
        written = f"{most.numerator} / {most.denominator}{rate if name == 'power' else ''}"
        assert written in statements[f"elementary_functions__{name}"], name


def test_the_enclosing_machine_charges_enough():
    """The charge is Coq's count, or, twice charged, of a monotone function, at most 8 roundings less."""
    most = PROVED | {name: PROVED["power"] + POWER_RATE * size for name, size in (("power", 50), ("small_power", 709))}
    most |= {"sinpi": PROVED["of_product_relative"], "cospi": PROVED["of_product_relative"]}
    for name, charge in ROUNDINGS.items():
        assert most[name] - charge <= (min(charge, 8) if name in ("exp", "power", "small_power") else 0), name


@np.errstate(all="ignore")
def test_what_they_are_at_the_ends_of_their_range_and_outside():
    numbers = np.array([np.nan, np.inf, -np.inf, 709.1, -708.1, -0.0])
    assert_array_equal(kernels.exp(numbers), [np.nan, np.inf, 0, np.inf, 0, 1])
    assert_array_equal(kernels.log(numbers[[0, 1, 4, 5]]), [np.nan, np.inf, np.nan, -np.inf])
    for exponent in (5e-4, 0.1, 0.5, 1.0, 7.3, 1e6):
        assert_array_equal(kernels.power(np.array([0, 1, np.nan]), exponent), [0, 1, np.nan])
