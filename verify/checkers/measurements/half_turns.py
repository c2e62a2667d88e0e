"""The certificates of our elementary functions. See verify/accuracy/certified_ulps.py."""

from fractions import Fraction

from proofs.formulas import elementary as e
from proofs.formulas import exponential as x
from verify.accuracy.certified_ulps import CERTIFIED, PIECES, angle_pieces, sine_pieces
from verify.accuracy.exponential_ulps import exponential_pieces, logarithm_pieces
from verify.accuracy.pieces import off_by, worst
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


@measures("elementary_functions", false={"within 0.99 ulp": {"bound": Fraction(99, 100)}, "1/2 is off": {"off": 1}})
def exp(bound: Fraction = CERTIFIED["exp"], off: int = 0) -> Measurement:
    """The exponential."""
    program = off_by(x.exponential_of_sum, x.exponential_tail, x.exponential_series[0], off)
    return _certified("exp", exponential_pieces(program), bound)


@measures("elementary_functions", false={"within 0.51 ulp": {"bound": Fraction(51, 100)}, "2/3 is off": {"off": 8}})
def log(bound: Fraction = CERTIFIED["log"], off: int = 0) -> Measurement:
    """The natural logarithm."""
    program = off_by(x.natural_logarithm, x.log_tail, x.logarithm_series[0], off)
    return _certified("log", logarithm_pieces(program), bound)


@measures("elementary_functions", false={"no worse than exp": {"bound": CERTIFIED["exp"]}})
def power(bound: Fraction = CERTIFIED["power"]) -> Measurement:
    """A power from exp(−50) to 1."""
    return _certified("power", PIECES["power"](), bound)


@measures("elementary_functions", false={"no worse than a larger power": {"bound": CERTIFIED["power"]}})
def small_power(bound: Fraction = CERTIFIED["small_power"]) -> Measurement:
    """A power down to exp(−708)."""
    return _certified("small_power", PIECES["small_power"](), bound)
