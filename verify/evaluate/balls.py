"""A straight-line program run in ball arithmetic: each line a midpoint and a radius that enclose its exact value.

At a few hundred bits the balls are a reference that says itself how good it is; at 53 bits their radius bounds what
rounding can do to the same lines. A selection that the balls do not decide takes both branches, and is named.
"""

from flint import arb, ctx, fmpq

from verify.evaluate import ExactPrinter, code_of


class _BallPrinter(ExactPrinter):
    """Comparisons of balls may be undecided; a condition stands in parentheses, as a kernel's does."""

    def select(self, condition, value, otherwise):
        return f"select({condition}, lambda: {value}, lambda: {otherwise})"

    def _print_And(self, expr, connective="both"):
        return f"({connective}({', '.join(self._print(part) for part in sorted(expr.args, key=str))}))"

    def _print_Or(self, expr):
        return self._print_And(expr, "either")

    def _print_Relational(self, expr):
        return f"(compare({self._print(expr.lhs)}, {expr.rel_op!r}, {self._print(expr.rhs)}))"


_OPERATORS = {"<": ("__lt__", "__ge__"), "<=": ("__le__", "__gt__"), ">": ("__gt__", "__le__"),
              ">=": ("__ge__", "__lt__"), "==": ("__eq__", "__ne__"), "!=": ("__ne__", "__eq__")}  # fmt: skip


def compare(left, operator, right):
    """Return True, False, or None where the balls leave it open."""
    holds, fails = _OPERATORS[operator]
    if getattr(left, holds)(right):
        return True
    return False if getattr(left, fails)(right) else None


def both(*conditions):
    """Return the conjunction of True, False and None."""
    return False if False in conditions else (None if None in conditions else True)


def either(*conditions):
    """Return the disjunction of True, False and None."""
    return True if True in conditions else (None if None in conditions else False)


def power(base, exponent):
    """Return base^exponent for base ≥ 0, exponent > 0; a ball that reaches below 0 is cut off there."""
    if base > 0:
        return base**exponent
    high = base.upper()
    return arb(0).union(high**exponent) if high > 0 else arb(0)


def root(value):
    """Return √value for a value ≥ 0 by its meaning; a ball that reaches below 0 is cut off there."""
    if value > 0 or value.is_zero():
        return value.sqrt()
    high = value.upper()
    return arb(0).union(high.sqrt()) if high > 0 else value.sqrt()


def _atan2pi(y, x):
    return arb(0) if y.is_zero() and x.is_zero() else arb.atan2(y, x) / arb.pi()


class Balls:
    """A program in balls: called with {name: float}, it returns ({name: ball} of every line, names left undecided)."""

    def __init__(self, program):
        self.program, self.lines, self.undecided = program, code_of(program, _BallPrinter()), set()
        self.names = {
            "rational": lambda p, q: arb(fmpq(p, q)),
            "compare": compare,
            "both": both,
            "either": either,
            "select": self._select,
            "sign": self._sign,
            "sqrt": root,
            "power": power,
            "floor": arb.floor,
            "rint": lambda x: (x + 0.5).floor(),
            "maximum": lambda *a: _fold(arb.max, a),
            "minimum": lambda *a: _fold(arb.min, a),
            "inf": arb.pos_inf(),
            "sinpi": arb.sin_pi,
            "cospi": arb.cos_pi,
            "atan2pi": _atan2pi,
        }

    def __call__(self, values, bits=53):
        self.undecided.clear()
        with ctx.workprec(bits):
            scope = dict(self.names) | {"pi": arb.pi()}
            scope |= {s.name: arb(values[s.name]) for s in self.program.inputs}
            for name, code in self.lines:
                self.line = name
                scope[name] = eval(code, scope)
            return {name: scope[name] for name, _ in self.lines}, frozenset(self.undecided)

    def _select(self, condition, value, otherwise):
        if condition is None:
            self.undecided.add(self.line)
            return value().union(otherwise())
        return value() if condition else otherwise()

    def _sign(self, value):
        if value > 0 or value < 0 or value.is_zero():
            return value.sgn()
        self.undecided.add(self.line)
        return arb(0, 1)


def _fold(operation, values):
    result = values[0]
    for value in values[1:]:
        result = operation(result, value)
    return result
