"""Functions of angles in half-turns: sinpi(x) = sin πx, cospi(x) = cos πx, atan2pi(y, x) = atan2(y, x)/π; and rint.

They are the trigonometric functions, named so that a kernel can reduce the argument exactly: sin πx has its zeros
at the integers, which float64 holds, while sin of a rounded πx has none.
"""

from sympy import Function, Integer, atan2, cos, pi, sin


class sinpi(Function):
    """sin πx. Domain: real x. `rewrite(sin)` gives the ordinary form."""

    nargs = 1
    is_real = True

    @classmethod
    def eval(cls, argument):
        if argument.is_Rational:
            return sin(pi * argument)
        return None

    def fdiff(self, argindex=1):
        return pi * cospi(self.args[0])

    def _eval_rewrite_as_sin(self, argument, **kwargs):
        return sin(pi * argument)

    def _eval_evalf(self, precision):
        return sin(pi * self.args[0])._eval_evalf(precision)

    def _latex(self, printer, exp=None):
        power = f"^{{{exp}}}" if exp else ""
        return rf"\sin{power} {printer._print(pi * self.args[0])}"


class cospi(Function):
    """cos πx. Domain: real x. `rewrite(cos)` gives the ordinary form."""

    nargs = 1
    is_real = True

    @classmethod
    def eval(cls, argument):
        if argument.is_Rational:
            return cos(pi * argument)
        return None

    def fdiff(self, argindex=1):
        return -pi * sinpi(self.args[0])

    def _eval_rewrite_as_cos(self, argument, **kwargs):
        return cos(pi * argument)

    def _eval_evalf(self, precision):
        return cos(pi * self.args[0])._eval_evalf(precision)

    def _latex(self, printer, exp=None):
        power = f"^{{{exp}}}" if exp else ""
        return rf"\cos{power} {printer._print(pi * self.args[0])}"


class atan2pi(Function):
    """atan2(y, x)/π in (−1, 1], and 0 at the origin. `rewrite(atan2)` gives the ordinary form off the origin."""

    nargs = 2
    is_real = True

    def _eval_rewrite_as_atan2(self, y, x, **kwargs):
        return atan2(y, x) / pi

    def _eval_evalf(self, precision):
        return (atan2(*self.args) / pi)._eval_evalf(precision)


class rint(Function):
    """The nearest integer; a tie goes to the even one, as IEEE 754 rounds."""

    nargs = 1
    is_integer = True

    @classmethod
    def eval(cls, argument):
        if argument.is_Rational:
            return Integer(round(argument))
        return None


def ordinary(expression):
    """Return the expression with sinpi, cospi and atan2pi written as sin, cos and atan2."""
    return (
        expression.replace(sinpi, lambda a: sin(pi * a))
        .replace(cospi, lambda a: cos(pi * a))
        .replace(atan2pi, lambda y, x: atan2(y, x) / pi)
    )
