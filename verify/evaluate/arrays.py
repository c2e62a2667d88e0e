"""One program, three evaluations over arrays of inputs: float64, balls of 50 digits, float64 with bounds."""

from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache, reduce
from typing import Any

import flint
import numpy as np

from proofs.engine.program import Program
from renderer import kernels, operations
from renderer.generate.kernels import function_of
from renderer.machines.enclosing import UNIT, Enclosed, enclosed
from verify.evaluate.balls import Balls

Inputs = Mapping[str, Any]  # numbers or arrays
Taken = Callable[[float], flint.arb]  # from an input to its ball
BITS, SHAKES = 300, 64  # 50 digits, and 40 to lose
WIDEST, NOTHING = 2.0**-110, 1e-60  # a ball wider than both, against its size and at all, is no reference
LIBM = {"sin": np.sin, "cos": np.cos, "acos": np.arccos, "atan2": np.arctan2}
"""The ordinary functions, which the seed's formulas call."""


@lru_cache(maxsize=64)
def _function(program):
    return function_of(program, names=vars(kernels) | LIBM | {"sign": operations.sign.kernel})  # no pixel is left open


@lru_cache(maxsize=64)
def _balls(program):
    return Balls(program.keep(*program.outputs))


def _arguments(program, inputs):
    """Return the program's inputs, in order, as arrays of one shape."""
    return np.broadcast_arrays(*(np.asarray(inputs[s.name], np.float64) for s in program.inputs))


def _computed(program, inputs, number):
    """Return {output: Enclosed arrays}; number: the function from an input's array to an Enclosed."""
    arguments = _arguments(program, inputs)
    with np.errstate(all="ignore"):
        results = _function(program)(*map(number, arguments))
    results = map(enclosed, results if isinstance(results, tuple) else (results,))
    shaped = [Enclosed(*(np.full(arguments[0].shape, part) for part in (r.value, r.bound))) for r in results]
    return {s.name: result for s, result in zip(program.outputs, shaped, strict=True)}


def in_float64(program: Program, inputs: Inputs) -> dict[str, np.ndarray]:
    """Return {output: array}: the program in float64, sinpi and its kin by our functions, sin and its kin by libm's."""
    return {name: result.value for name, result in _computed(program, inputs, np.asarray).items()}


def with_bounds(program: Program, inputs: Inputs) -> dict[str, Enclosed]:
    """Return {output: Enclosed arrays}: the numbers of `in_float64`, and bounds on how far they are from exact ones."""
    return _computed(program, inputs, Enclosed)


def in_balls(program: Program, inputs: Inputs, taken: Taken = flint.arb) -> dict[str, np.ndarray]:
    """Return {output: array of balls}; taken: the function from an input to its ball, by default of its exact value.

    A ball that is too wide to judge float64 (an undecided comparison, a division by zero) is None.
    """
    arguments, balls = _arguments(program, inputs), _balls(program)
    names, outputs = [s.name for s in program.inputs], [s.name for s in program.outputs]
    table = np.empty((arguments[0].size, len(outputs)), object)
    with flint.ctx.workprec(BITS):
        for row, point in zip(table, zip(*(a.ravel().tolist() for a in arguments), strict=True), strict=True):
            lines = balls(dict(zip(names, map(taken, point), strict=True)), BITS)
            row[:] = [lines[name] if _narrow(lines[name]) else None for name in outputs]
    return {name: column.reshape(arguments[0].shape) for name, column in zip(outputs, table.T, strict=True)}


def response(size: Any, change: Callable[[Taken], Any]) -> Any:
    """Return how far a result is expected to be off: by 2⁻⁵³ of its size, or by what rounded inputs do to it.

    change: given what inputs are taken for, how far the result moves, a number or an array; of 64 shakes of all inputs
    by up to 1e-16 of themselves it is the largest.
    """
    random, most = np.random.default_rng(3), UNIT * size

    def shaken(number):
        return flint.arb(number) * (1 + flint.arb(random.uniform(-1e-16, 1e-16)))

    for _ in range(SHAKES):
        most = np.fmax(most, change(shaken))
    return most


def _narrow(ball):
    return ball.is_finite() and float(ball.rad()) <= max(NOTHING, WIDEST * abs(float(ball.mid())))


def signed_distance(values: np.ndarray, balls: np.ndarray) -> np.ndarray:
    """Return values − balls as float64; NaN where a ball is None, infinite where a value is not finite."""
    with flint.ctx.workprec(BITS):
        return np.asarray(np.frompyfunc(_minus, 2, 1)(values, balls), np.float64)


def _minus(value, ball):
    if value is None or ball is None:
        return np.nan
    return float(flint.arb(value) - ball) if isinstance(value, flint.arb) or np.isfinite(value) else np.inf


def distance(values: np.ndarray, balls: np.ndarray) -> np.ndarray:
    """Return |value − ball| as float64; NaN where there is no reference, infinite where the value is not finite."""
    return np.abs(signed_distance(values, balls))


def length(parts: Sequence[np.ndarray]) -> np.ndarray:
    """Return the length of a vector of components."""
    return reduce(np.hypot, parts)
