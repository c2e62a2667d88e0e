"""Printer of custom fields' kernels: a constant is the float64 nearest to it, with a bound of how far that is off."""

import math
from collections.abc import Callable
from functools import cache
from typing import Any

from mpmath import iv
from mpmath.libmp import to_float
from sympy import Expr, Rational
from sympy.printing.precedence import precedence

from proofs.formulas.height_fields import HeightField
from proofs.formulas.ranges import DIGITS, enclosure
from proofs.formulas.symbols import k_u, k_v
from proofs.printers.python import KernelPrinter, refuse_unknown_calls
from renderer import kernels

CALLED = vars(kernels)
"""Names that kernels of custom fields may call."""


class OwnPrinter(KernelPrinter):
    """A printer of a part without a symbol as the float64 nearest to it, with a bound of its error."""

    def _print(self, expr: Any, **settings: Any) -> str:
        fixed = isinstance(expr, Expr) and not expr.free_symbols and not expr.is_Rational
        return self._nearest(expr) if fixed else super()._print(expr, **settings)

    @staticmethod
    def _nearest(constant):
        """Return the text of a constant as the float64 nearest to it, with its error where an enclosure leaves two."""
        usual, iv.dps = iv.dps, 4 * DIGITS
        try:
            low, high = (to_float(end, rnd="n") for end in enclosure(constant, {})._mpi_)
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
    """Return the names that a text of kernels defines, beside the printed kernels."""
    scope = dict(CALLED)
    exec(source, scope)
    refuse_unknown_calls(scope)
    return scope


def exact_waves(field: HeightField) -> Callable[[float, float], list[float]]:
    """Return the function (k_u, k_v) → the wave numbers, NaN where float64 does not hold them exactly."""

    @cache
    def waves(*at):
        exact = [rate.subs(dict(zip((k_u, k_v), map(Rational, at), strict=True))) for rate in field.wave_numbers]
        return [float(rate) if rate.is_Rational and Rational(float(rate)) == rate else math.nan for rate in exact]

    return waves
