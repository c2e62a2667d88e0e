"""The certificates of our sinpi, cospi and atan2pi. See verify/accuracy/certified_ulps.py."""

from fractions import Fraction

from proofs.formulas import elementary as e
from proofs.formulas.certified import CERTIFIED
from verify.accuracy.certified_ulps import angle_pieces, off_by, sine_pieces, worst
from verify.checkers.measurement import Measurement, measures


def _certified(name, pieces, bound):
    largest = worst(pieces)
    return Measurement(
        samples=len(pieces),
        worst=largest,
        bound=bound,
        what=f"{name}: the error in ulps over every piece of the reduced range",
        numbers={f"{name}_ulps": largest, f"{name}_pieces": len(pieces)},
        certified=True,
    )


@measures(
    "elementary_functions", false={"within 4/3 ulp": {"bound": Fraction(133, 100)}, "π³/6 is off by 4 ulps": {"off": 4}}
)
def sinpi(bound: Fraction = CERTIFIED["sinpi"], off: int = 0) -> Measurement:
    """The sine of an argument that is not rounded."""
    program = off_by(e.sine_of_half_turns, e.sine_tail, e.sine_series[0], off)
    return _certified("sinpi", sine_pieces(program=program), bound)


@measures(
    "elementary_functions", false={"within 3/2 ulp": {"bound": Fraction(3, 2)}, "π²/2 is off by 1 ulp": {"off": 1}}
)
def cospi(bound: Fraction = CERTIFIED["cospi"], off: int = 0) -> Measurement:
    """The cosine of an argument that is not rounded."""
    program = off_by(e.sine_of_half_turns, e.cosine_near, e.cosine_series[0], off)
    return _certified("cospi", sine_pieces(cosine=True, program=program), bound)


@measures("elementary_functions", false={"no worse than without a product": {"bound": CERTIFIED["sinpi"]}})
def sinpi_of_product(bound: Fraction = CERTIFIED["sinpi_of_product"]) -> Measurement:
    """The sine of a product, whose reduced argument is rounded once."""
    return _certified("sinpi_of_product", sine_pieces(of_product=True), bound)


@measures("elementary_functions", false={"no worse than without a product": {"bound": CERTIFIED["cospi"]}})
def cospi_of_product(bound: Fraction = CERTIFIED["cospi_of_product"]) -> Measurement:
    """The cosine of a product, whose reduced argument is rounded once."""
    return _certified("cospi_of_product", sine_pieces(cosine=True, of_product=True), bound)


@measures("elementary_functions", false={"within 2 ulps": {"bound": Fraction(2)}, "1/3π is off by 4 ulps": {"off": 4}})
def atan2pi(bound: Fraction = CERTIFIED["atan2pi"], off: int = 0) -> Measurement:
    """The angle, over the eight octants."""
    program = off_by(e.angle_in_half_turns, e.arctangent_tail, e.arctangent_series[1], off)
    return _certified("atan2pi", angle_pieces(program), bound)
