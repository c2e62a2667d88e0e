"""The certificate of the kernels' sine and cosine. See verify/accuracy/sine.py."""

from fractions import Fraction
from functools import partial

from proofs.formulas.certified import SINE
from verify.accuracy import sine
from verify.checkers.measurements import Enclosure, measures


@measures("sine_of_half_turns", {"within 12/5": {"bound": Fraction(12, 5)}, "π²/2 is off by 1 ulp": {"off": 1}})
def enclosed(bound: Fraction = SINE, off: int = 0) -> Enclosure:
    """Enclose sine and cosine at every reduced argument."""
    return Enclosure(
        pieces=partial(sine.pieces, off),
        over={"ku": ((0.0, sine.END),)},
        at=sine.errors,
        bound=bound,
        quantity="sine and cosine: the error over every piece of the reduced range, in units of 2^-53",
    )
