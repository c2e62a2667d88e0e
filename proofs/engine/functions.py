"""The functions that formulas call: an entry has their names in every language, and encloses them.

One that kernels do not have yet is also a program, `renderer.generate.programs.ELEMENTARY`, with its error in
`proofs/formulas/certified.py`.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

from mpmath import iv
from mpmath.libmp import mpf_floor
from sympy import Abs, Max, Min, exp, floor, log, sign

from proofs.engine.half_turns import atan2pi, cospi, rint, sinpi


def hull(lowest: Callable, highest: Callable) -> Callable:
    """Return the interval from the lowest or highest lower end of some to the lowest or highest upper end."""
    return lambda *parts: iv.mpf([lowest(part.a for part in parts), highest(part.b for part in parts)])


def _whole_below(number):
    return iv.make_mpf(tuple(map(mpf_floor, number._mpi_)))


def _angle(ordinate, abscissa):
    if not abscissa.a > 0:
        raise ValueError("atan2pi(y, x) has a jump unless x is above 0 everywhere, as in atan2pi(y, 1)")
    return iv.atan2(ordinate, abscissa) / iv.pi


class Function(NamedTuple):
    """A function, and its name in each language.

    made: SymPy's class. kernel: its name in kernels, and in every table of numbers. coq: of real numbers, if it has no
    form of its own. coq_float64: of float64 numbers. text, mpmath, arb: in a formula's text, in mpmath and in FLINT,
    where that is not the kernels' name. enclosed: it, of intervals; without it no field may call it.
    """

    made: Any
    kernel: str
    coq: str = ""
    coq_float64: str = ""
    text: str = ""
    mpmath: str = ""
    arb: str = ""
    enclosed: Callable | None = None


FUNCTIONS = (
    Function(sinpi, "sinpi", coq_float64="sine_of_half_turns_float64.sine", arb="sin_pi",
             enclosed=lambda turns: iv.sin(iv.pi * turns)),
    Function(cospi, "cospi", coq_float64="cosine_of_half_turns_float64.cosine", arb="cos_pi",
             enclosed=lambda turns: iv.cos(iv.pi * turns)),
    Function(exp, "exp", "exp", "exponential_of_sum_float64.exponential", enclosed=iv.exp),
    Function(log, "log", "ln", "natural_logarithm_float64.logarithm", enclosed=iv.log),
    Function(Abs, "abs", "Rabs", enclosed=abs),
    Function(sign, "sign", "sign", "sign", arb="sgn", enclosed=lambda _: iv.mpf([-1, 1])),
    Function(Max, "maximum", "Rmax", "Rmax", text="max", enclosed=hull(max, max)),
    Function(Min, "minimum", "Rmin", "Rmin", text="min", enclosed=hull(min, min)),
    Function(floor, "floor", coq_float64="whole_below", enclosed=_whole_below),
    Function(rint, "rint", coq_float64="rint", mpmath="nint"),
    Function(atan2pi, "atan2pi", coq_float64="angle_in_half_turns_float64.angle", enclosed=_angle),
)  # fmt: skip
