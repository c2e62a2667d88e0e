"""Run a program without a file: its NumPy printing on arrays, or its mpmath printing at the working precision."""

import mpmath
import numpy as np

from renderer.generate.printers import MpmathPrinter, NumPyPrinter
from renderer.generate.source import elementary_functions, print_function


def _sign(a):
    return (a > 0) - (a < 0)


def _mpmath_names():
    def atan2pi(y, x):
        return mpmath.atan2(y, x) / mpmath.pi if (x or y) else mpmath.mpf(0)

    return {
        "abs": abs,
        "floor": mpmath.floor,
        "nint": mpmath.nint,
        "sqrt": mpmath.sqrt,
        "pow": mpmath.power,
        "pi": mpmath.pi,
        "inf": mpmath.inf,
        "mpf": mpmath.mpf,
        "sign": _sign,
        "max": max,
        "min": min,
        "sinpi": mpmath.sinpi,
        "cospi": mpmath.cospi,
        "atan2pi": atan2pi,
        "sinpi_of_product": lambda a, b: mpmath.sinpi(a * b),
        "cospi_of_product": lambda a, b: mpmath.cospi(a * b),
    }


def _numpy_names():
    names = {"np": np}
    for name, program in elementary_functions():
        exec(print_function(name, program, NumPyPrinter(), ""), names)
    return names


def compiled_program(program, back_end):
    """Return a function of the program's inputs, in order, that returns its outputs.

    back_end: "numpy" (float64 arrays; bit for bit what the Numba kernels compute) or "mpmath" (at the working
    precision; sinpi and its kin are the functions themselves, not our polynomials). ValueError on another.
    """
    printers = {"numpy": (NumPyPrinter, _numpy_names), "mpmath": (MpmathPrinter, _mpmath_names)}
    if back_end not in printers:
        raise ValueError(f"back_end = {back_end!r} is not allowed: one of {', '.join(map(repr, printers))}")
    printer, names = printers[back_end]
    scope = names()
    exec(print_function(program.name, program, printer(), ""), scope)
    return scope[program.name]
