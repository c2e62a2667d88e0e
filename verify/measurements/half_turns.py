"""The certificates of our elementary functions. See verify/accuracy/certified_ulps.py."""

import math
from collections.abc import Callable
from fractions import Fraction
from functools import partial
from typing import Any

from proofs.formulas import elementary as e, exponential as x
from proofs.formulas.certified import CERTIFIED
from verify.accuracy.certified_ulps import PIECES, SMALL, errors_on_pieces
from verify.accuracy.pieces import SMALLEST, off_by, worst
from verify.checkers.measurement import Enclosure, measures

CONSTANTS = {
    "sinpi": (e.sine_of_half_turns, e.sine_tail, e.sine_series[0]),
    "cospi": (e.sine_of_half_turns, e.cosine_near, e.cosine_series[0]),
    "atan2pi": (e.angle_in_half_turns, e.arctangent_tail, e.arctangent_series[1]),
    "exp": (x.exponential_of_sum, x.exponential_tail, x.exponential_series[0]),
    "log": (x.natural_logarithm, x.log_tail, x.logarithm_series[0]),
}
"""{name: (program, one of its lines, a constant there that a false variant changes)}"""
FALSE: dict[str, dict[str, Any]] = {
    "sinpi": {"within 3/2 ulp": {"bound": Fraction(3, 2)}, "π³/6 is off by 4 ulps": {"off": 4}},
    "cospi": {"within 3/2 ulp": {"bound": Fraction(3, 2)}, "π²/2 is off by 1 ulp": {"off": 1}},
    "sinpi_of_product": {"no worse than without a product": {"bound": CERTIFIED["sinpi"]}},
    "cospi_of_product": {"no worse than without a product": {"bound": CERTIFIED["cospi"]}},
    "atan2pi": {"within 2 ulps": {"bound": Fraction(2)}, "1/3π is off by 4 ulps": {"off": 4}},
    "exp": {"within 0.99 ulp": {"bound": Fraction(99, 100)}, "1/2 is off by 1 ulp": {"off": 1}},
    "log": {"within 0.51 ulp": {"bound": Fraction(51, 100)}, "2/3 is off by 8 ulps": {"off": 8}},
    "power": {"no worse than exp": {"bound": CERTIFIED["exp"]}},
    "small_power": {"no worse than a larger power": {"bound": CERTIFIED["power"]}},
}


FIRST = 2.0 ** (SMALLEST - 1)  # what is smaller scales
OVER = {
    "atan2pi": ((FIRST, 1.0),),
    "exp": ((-math.log(2) / 2, math.log(2) / 2),),
    "log": ((2.0**-5.5, 57 / 64), ((1 + FIRST) / (1 - FIRST), 2.0**5.5)),  # of −q it is −log
    "power": ((0.0, SMALL),),
    "small_power": ((0.0, 708.0),),
}
"""{name: the ranges of the reduced argument}, where none is named all of a quarter turn"""


OF = {"sinpi_of_product": "ku", "cospi_of_product": "ku", "atan2pi": "y, x", "power": "x^p", "small_power": "x^p"}
"""{name: what its argument is made of}, where that is not x"""


def certificate(name: str) -> Callable[..., Enclosure]:
    """Return what encloses a function's error on every piece of its range."""

    def enclosed(bound=CERTIFIED[name], off=0):
        pieces = partial(PIECES[name], program=off_by(*CONSTANTS[name], off)) if off else PIECES[name]
        return Enclosure(
            pieces=pieces,
            over={OF.get(name, "x"): OVER.get(name, ((FIRST, 0.5 - FIRST),))},
            at=partial(errors_on_pieces, name),
            bound=bound,
            what=f"{name}: the error in ulps over every piece of the reduced range",
            numbers={f"{name}_ulps": worst(pieces()), f"{name}_pieces": len(pieces())},
        )

    return enclosed


for name, false in FALSE.items():
    measures("elementary_functions", false=false)(certificate(name))
