"""Certified counterexamples: intervals, with every rounding in them, show hypotheses true and a conclusion false."""

import mpmath
from mpmath import iv
from sympy import Eq

from verify.checkers.digits import Relations, Undefined

BITS = 400


class Enclosure:
    """An interval that holds a real number; a comparison that it does not decide raises Undefined."""

    def __init__(self, value):
        self.value = value.value if isinstance(value, Enclosure) else iv.mpf(value)

    def __abs__(self):
        return Enclosure(abs(self.value))

    def __neg__(self):
        return Enclosure(-self.value)

    def __pow__(self, power):
        if isinstance(power, Enclosure):
            raise Undefined("a power that is not whole")
        return Enclosure(self.value**power)

    def __bool__(self):
        raise Undefined("an enclosure is neither true nor false")


def _operator(name):
    def operate(a, b):
        return Enclosure(getattr(iv.mpf, name)(a.value, Enclosure(b).value))

    return operate


def _comparison(name):
    def compare(a, b):
        decided = getattr(iv.mpf, name)(a.value, Enclosure(b).value)
        if decided is None:
            raise Undefined("not decided")
        return decided

    return compare


for _name in ("add", "sub", "mul", "truediv"):
    setattr(Enclosure, f"__{_name}__", _operator(f"__{_name}__"))
for _name in ("add", "mul"):
    setattr(Enclosure, f"__r{_name}__", _operator(f"__{_name}__"))
Enclosure.__rsub__ = lambda a, b: Enclosure(b) - a
Enclosure.__rtruediv__ = lambda a, b: Enclosure(b) / a
for _name in ("lt", "le", "gt", "ge"):
    setattr(Enclosure, f"__{_name}__", _comparison(f"__{_name}__"))


def _function(of):
    return lambda x: Enclosure(of(Enclosure(x).value))


def _sqrt(x):
    if not x >= 0:
        raise Undefined("the root of a negative number")
    return Enclosure(iv.sqrt(x.value))


def _sign(x):
    return 1 if x > 0 else -1 if x < 0 else 0


SCOPE = {
    "mpf": lambda x: Enclosure(mpmath.mpf(x) if not isinstance(x, tuple) else x),
    "sqrt": lambda x: _sqrt(Enclosure(x)),
    "cos": _function(iv.cos),
    "sin": _function(iv.sin),
    "sign": lambda x: _sign(Enclosure(x)),
    "abs": abs,
    "max": max,
    "min": min,
    "True": True,
    "False": False,
}


def certified(sampler, point):
    """Return whether enclosures show that a claim fails near a 50-digit point {symbol: value} of its sampler.

    The free inputs are taken as they are, exactly; what the sampler solved for is solved again, by formulas, so that
    its enclosure holds a solution. Equations that it did not solve decide nothing: then the answer is no.
    """
    previous, iv.prec = iv.prec, BITS
    try:
        scope = SCOPE | {"pi": Enclosure(iv.pi)}
        solved = dict(sampler.solved)
        values = {s: Enclosure(v) for s, v in point.items() if s not in solved}
        for symbol, coefficients in sampler.solved:
            values[symbol] = _root(coefficients.within(scope)(values), point[symbol])
        open_ = [r for r in sampler.given if not (isinstance(r, Eq) and r in sampler.solved_relations)]
        if any(isinstance(r, Eq) for r in open_):
            return False
        given, shows = (Relations(sampler.inputs, r, sampler.definitions) for r in (open_, sampler.claimed))
        return _decided(given, scope, values, all) and not _decided(shows, scope, values, all)
    except (Undefined, ZeroDivisionError, TypeError, ValueError, NotImplementedError, NameError):
        return False
    finally:
        iv.prec = previous


def _root(coefficients, near):
    """Return an enclosure of a root of a linear or quadratic polynomial, the one near a number."""
    if len(coefficients) == 2:
        return -coefficients[1] / coefficients[0]
    a, b, c = (Enclosure(each) for each in coefficients)
    root = _sqrt(b * b - 4 * a * c)
    return min(((-b + s * root) / (2 * a) for s in (1, -1)), key=lambda r: abs(mpmath.mpf(r.value.mid) - near))


def _decided(relations, scope, values, combine):
    sides = [Enclosure(s) for s in relations.code.within(scope)(values)]
    return combine([_holds(op, a - b) for op, a, b in zip(relations.operators, sides[::2], sides[1::2], strict=True)])


def _holds(operator, gap):
    if operator in ("==", "!="):
        if gap > 0 or gap < 0:
            return operator == "!="
        raise Undefined("an equation is not decided")
    return {">": gap > 0, ">=": gap >= 0, "<": gap < 0, "<=": gap <= 0}[operator]
