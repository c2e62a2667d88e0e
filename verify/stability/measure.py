"""One program, three evaluations over arrays of inputs: float64, balls of 50 digits, float64 with running bounds."""

from functools import lru_cache
from typing import ClassVar

import flint
import numpy as np
from sympy import Rational

from renderer.generate.compiled import compiled_program
from renderer.generate.printers import MpmathPrinter, NumPyPrinter
from renderer.generate.source import print_function
from verify.stability import running

BITS = 300  # 50 digits, and 40 to lose
WIDEST, NOTHING = 2.0**-110, 1e-60  # a ball wider than both, against its size and at all, is no reference


class _LibmPrinter(NumPyPrinter):
    """Whole arrays, and the ordinary functions as libm has them: what the seed's formulas call."""

    _functions: ClassVar = {"sin": "np.sin", "cos": "np.cos", "acos": "np.arccos", "atan2": "np.arctan2"}

    def _print_Function(self, expr):
        return self._call(self._functions[type(expr).__name__], expr.args)


class _BallPrinter(MpmathPrinter):
    power = "power"


class _RunningPrinter(MpmathPrinter):
    """The same operations in the same order as the kernels', on `Running` numbers."""

    names: ClassVar = {**NumPyPrinter.names, "Abs": "abs", "Max": "maximum", "Min": "minimum", "sign": "sign"}
    pi, power = "rounded_pi", "power"

    def select(self, condition, value, otherwise):
        return f"select({condition}, {value}, {otherwise})"

    def literal(self, rational):
        number = float(rational)
        exact = Rational(number) == rational
        return f"running({number!r})" if exact else f"(running({float(rational.p)!r}) / {float(rational.q)!r})"


def _ball_names():
    arb = flint.arb

    def atan2pi(y, x):
        return arb(0) if x == 0 and y == 0 else arb.atan2(y, x) / arb.pi()

    return {
        "abs": abs,
        "floor": lambda a: arb(a).floor(),
        "nint": lambda a: (a + arb("0.5")).floor(),
        "sqrt": lambda a: arb(a).sqrt(),
        "power": lambda a, p: arb(a) ** p if a > 0 else arb(0),
        "inf": arb("inf"),
        "mpf": arb,
        "sign": lambda a: arb((a > 0) - (a < 0)),
        "max": lambda a, b: arb(a).max(arb(b)),
        "min": lambda a, b: arb(a).min(arb(b)),
        "sinpi": lambda a: arb(a).sin_pi(),
        "cospi": lambda a: arb(a).cos_pi(),
        "sinpi_of_product": lambda a, b: arb(a * b).sin_pi(),
        "cospi_of_product": lambda a, b: arb(a * b).cos_pi(),
        "atan2pi": atan2pi,
    }


@lru_cache(maxsize=64)
def _function(program, kind):
    """Return the program as a Python function of its inputs in order."""
    if kind == "float64":
        return compiled_program(program, "numpy")
    if kind == "libm":
        scope, printer = {"np": np}, _LibmPrinter()
    elif kind == "running":
        scope, printer = (
            {**vars(running), "rounded_pi": running.Running(np.pi, 2 * running.U), "inf": np.inf},
            _RunningPrinter(),
        )
    else:
        scope, printer = _ball_names() | {"pi": flint.arb.pi()}, _BallPrinter()
    exec(print_function(program.name, program, printer, ""), scope)
    return scope[program.name]


def _arguments(program, inputs):
    """Return the program's inputs, in order, as arrays of one shape."""
    given = {s.name: np.asarray(inputs[s.name], np.float64) for s in program.inputs}
    shape = np.broadcast_shapes(*(a.shape for a in given.values()))
    return [np.broadcast_to(a, shape) for a in given.values()]


def in_float64(program, inputs, kind="float64"):
    """Return {output: array}: the program in float64, by our elementary functions or ("libm") by libm's."""
    arguments = _arguments(program, inputs)
    with np.errstate(all="ignore"):
        results = _function(program, kind)(*arguments)
    results = results if isinstance(results, tuple) else (results,)
    named = zip(program.outputs, results, strict=True)
    return {s.name: np.broadcast_to(np.asarray(r, np.float64), arguments[0].shape) for s, r in named}


def with_bounds(program, inputs):
    """Return {output: Running}: the same numbers as `in_float64`, and their running error bounds."""
    arguments = _arguments(program, inputs)
    with np.errstate(all="ignore"):
        results = _function(program, "running")(*map(running.Running, arguments))
    results = results if isinstance(results, tuple) else (results,)
    shape = arguments[0].shape
    return {s.name: running.running(r).spread(shape) for s, r in zip(program.outputs, results, strict=True)}


def in_balls(program, inputs):
    """Return {output: array of balls} for the exact values of the inputs.

    A ball that is too wide to judge float64 (an undecided comparison, a division by zero) is None.
    """
    arguments = _arguments(program, inputs)
    function, before = None, flint.ctx.prec
    flint.ctx.prec = BITS
    try:
        function = _function(program, "balls")
        points = zip(*(a.ravel().tolist() for a in arguments), strict=True)
        rows = [_narrow(function(*map(flint.arb, point)), len(program.outputs)) for point in points]
    finally:
        flint.ctx.prec = before
    table = np.array(rows, dtype=object).reshape(*arguments[0].shape, len(program.outputs))
    return {s.name: table[..., i] for i, s in enumerate(program.outputs)}


def _narrow(results, count):
    results = results if count > 1 or isinstance(results, tuple) else (results,)
    balls = [flint.arb(r) for r in results]
    return [
        b if b.is_finite() and float(b.rad()) <= max(NOTHING, WIDEST * abs(float(b.mid()))) else None for b in balls
    ]


def distance(values, balls):
    """Return |value − ball| as float64; NaN where there is no reference, infinite where the value is not finite."""
    before = flint.ctx.prec
    flint.ctx.prec = BITS
    try:
        off = [_off(v, b) for v, b in zip(np.ravel(values).tolist(), np.ravel(balls), strict=True)]
    finally:
        flint.ctx.prec = before
    return np.array(off).reshape(np.shape(values))


def _off(value, ball):
    if ball is None:
        return np.nan
    return float(abs(flint.arb(value) - ball)) if np.isfinite(value) else np.inf


def vector_distance(values, balls, names):
    """Return |value − ball| of the vector with the given components, √ of the sum of squares."""
    parts = np.array([distance(values[n], balls[n]) for n in names])
    largest = parts.max(axis=0)
    with np.errstate(all="ignore"):
        scaled = np.sqrt(((parts / largest) ** 2).sum(axis=0)) * largest
    return np.where((largest > 0) & (largest < np.inf), scaled, largest)


def vector_bound(bounds, names):
    """Return the bound on the same distance."""
    return np.sqrt(sum(bounds[n].bound ** 2 for n in names))
