"""Kernels of fields and models of one's own, whose constants have bounds: each is a float64, and how far off it is."""

import builtins
import math
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
from mpmath import iv
from mpmath.libmp import to_float
from sympy import Expr, Float, Rational, S
from sympy.printing.precedence import precedence

from proofs.engine.program import Program
from proofs.formulas.height_fields import HeightField
from proofs.formulas.ranges import DIGITS, enclosure
from proofs.formulas.registry import check_name
from proofs.formulas.shading import LightModel
from proofs.formulas.symbols import bumped, k_u, k_v, light, mu, point, specular_base, view
from renderer import kernels
from renderer.checks import not_allowed
from renderer.generate.kernels import print_function, refuse_unknown_calls
from renderer.generate.printer import KernelPrinter
from renderer.operations import maximum

CALLED = vars(kernels)
"""What kernels of one's own may call."""
SEEN_BY_A_LIGHT = (*point, *light, *bumped, *view)
_SEEN = np.random.default_rng(9).normal(size=(4, 3, 99))  # points, lights, normals, views at which lines are compared
_SEEN[2:] /= np.sqrt((_SEEN[2:] ** 2).sum(axis=1, keepdims=True))
_SEEN = _SEEN.reshape(12, 99)


class OwnPrinter(KernelPrinter):
    """Prints a part without a symbol as the float64 nearest to it, which has a bound: of floats nobody takes one."""

    def _print(self, expr: Any, **settings: Any) -> str:
        fixed = isinstance(expr, Expr) and not expr.free_symbols and not expr.is_Rational
        return self._nearest(expr) if fixed else super()._print(expr, **settings)

    @staticmethod
    def _nearest(constant):
        """Of an interval around a constant both ends are nearest to one float64, or the error says how far apart."""
        constant = constant.xreplace({number: Rational(number) for number in constant.atoms(Float)})
        usual, iv.dps = iv.dps, 4 * DIGITS
        try:
            low, high = (to_float(end, rnd="n") for end in enclosure(constant, {S.Exp1: iv.e})._mpi_)
        finally:
            iv.dps = usual
        return f"Constant({low!r}{f', {2 * (high - low) + math.ulp(low)!r}' if low < high else ''})"

    def _apart(self, expr, sign, otherwise):
        fixed, rest = expr.as_independent(*expr.free_symbols, as_Add=expr.is_Add)
        if fixed.is_Rational:
            return otherwise(expr)
        return f"{self._nearest(fixed)} {sign} {self.parenthesize(rest, precedence(expr))}"

    def _print_Mul(self, expr):
        return self._apart(expr, "*", super()._print_Mul)

    def _print_Add(self, expr):
        return self._apart(expr, "+", super()._print_Add)


def made(source: str) -> dict[str, Any]:
    """Return what a text of kernels defines, beside the kernels that are there."""
    scope = dict(CALLED)
    exec(source, scope)
    refuse_unknown_calls(scope)
    return scope


def exact_waves(field: HeightField) -> Callable[[float, float], list[float]]:
    """Return the function (k_u, k_v) → the wave numbers, NaN where they are no float64: rounded, they are another's."""

    @cache
    def waves(*at):
        exact = [rate.subs(dict(zip((k_u, k_v), map(Rational, at), strict=True))) for rate in field.wave_numbers]
        return [float(rate) if rate.is_Rational and Rational(float(rate)) == rate else math.nan for rate in exact]

    return waves


def light_kernels(model: LightModel) -> tuple[Callable, Callable | None]:
    """Return the kernels of a model's programs. Raises ValueError where the second is not of the first's square."""
    plain = _light_kernel(model.name, model.program)
    if model.squared is None:
        return plain, None
    squared = _light_kernel(model.name, model.squared)
    with np.errstate(all="ignore"):
        (one_mu, base), (other_mu, square) = plain(*_SEEN), squared(*_SEEN)
        same = [np.allclose(*pair, 1e-9, 1e-9, equal_nan=True) for pair in ((one_mu, other_mu), (base * base, square))]
    if not all(same):
        raise not_allowed("squared", model.name, "lines of the program's mu, and of the square of its specular_base")
    return plain, squared


def _light_kernel(name, program):
    """Return the kernel of one of a model's programs: it takes all that a light is seen by."""
    if not {*program.inputs} <= {*SEEN_BY_A_LIGHT} or program.outputs != (mu, specular_base):
        allowed = f"a program of some of {', '.join(map(str, SEEN_BY_A_LIGHT))}, with the outputs mu and specular_base"
        raise not_allowed("model", name, allowed)
    for symbol, _ in program.definitions:
        check_name(symbol.name)
        if symbol.name in {*CALLED, *dir(builtins)}:
            raise not_allowed(f"a line of {name}", symbol.name, "a name that no kernel has")
    lines = {}
    for symbol, expression in program.definitions:  # one that is a constant is no number of a machine
        lines[symbol] = expression.xreplace({s: fixed for s, fixed in lines.items() if not fixed.free_symbols})
    whole = Program("own_model", SEEN_BY_A_LIGHT, lines, program.outputs)
    kernel = made(print_function(whole.name, whole, OwnPrinter()))[whole.name]

    def with_base(*seen):
        cosine, base = kernel(*seen)
        least = max if isinstance(base, float) else maximum
        return cosine, least(0.0, base)  # whose power is 0 where it is negative, whether whole or not

    return with_base
