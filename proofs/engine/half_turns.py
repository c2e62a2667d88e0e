"""Functions of angles in half-turns: sinpi(x) = sin πx, cospi(x) = cos πx, atan2pi(y, x) = atan2(y, x)/π; and rint.

They are the trigonometric functions, named so that a kernel can reduce the argument exactly: sin πx has its zeros
at the integers, which float64 holds, while sin of a rounded πx has none.
"""

from sympy import Basic, Expr, Function, Integer, Mul, atan2, cos, pi, sin


class _OfHalfTurns(Function):
    """`plain` of π times the argument, and evaluated where that is rational and the value has no sine."""

    is_real = True

    @classmethod
    def eval(cls, argument: Expr) -> Basic | None:
        value = cls.plain(pi * argument) if argument.is_Rational else None
        return None if value is None or value.has(sin, cos) else value

    def _eval_evalf(self, precision):
        return self.plain(pi * self.args[0])._eval_evalf(precision)

    def _latex(self, printer, exp=None):
        power = f"^{{{exp}}}" if exp else ""
        return rf"\{self.plain.__name__}{power}({printer._print(Mul(pi, self.args[0], evaluate=False))})"


class sinpi(_OfHalfTurns):
    """sin πx. Domain: real x."""

    plain = sin

    def fdiff(self, argindex: int = 1) -> Expr:
        return pi * cospi(self.args[0])


class cospi(_OfHalfTurns):
    """cos πx. Domain: real x."""

    plain = cos

    def fdiff(self, argindex: int = 1) -> Expr:
        return -pi * sinpi(self.args[0])


class atan2pi(Function):
    """atan2(y, x)/π in (−1, 1], and 0 at the origin."""

    nargs = 2
    is_real = True

    def fdiff(self, argindex: int = 1) -> Expr:
        y, x = self.args
        return (x if argindex == 1 else -y) / (pi * (x**2 + y**2))

    def _eval_evalf(self, precision):
        return (atan2(*self.args) / pi)._eval_evalf(precision)


class rint(Function):
    """The nearest integer; a tie goes to the even one, as IEEE 754 rounds."""

    nargs = 1
    is_integer = True

    @classmethod
    def eval(cls, argument: Expr) -> Integer | None:
        return Integer(round(argument)) if argument.is_Rational else None


def ordinary(expression: Basic) -> Basic:
    """Return the expression with sinpi, cospi and atan2pi written as sin, cos and atan2."""
    return (
        expression.replace(sinpi, lambda a: sin(pi * a))
        .replace(cospi, lambda a: cos(pi * a))
        .replace(atan2pi, lambda y, x: atan2(y, x) / pi)
    )
