"""Printer of expressions for any kind of number, such as mpmath's or balls: its text calls the names of a table."""

from sympy import Rational, S

from proofs.printers.python import KernelPrinter


class NumberPrinter(KernelPrinter):
    """A printer for any kind of number: literals, comparisons and choices are calls, a symbol is looked up by its name.

    A choice computes the side that is taken, and not the other.
    """

    def literal(self, rational: Rational) -> str:
        return f"rational({rational.p}, {rational.q})"

    def _print_Symbol(self, expr):
        return f"value[{expr.name!r}]"

    def _half_turn(self, name, argument):
        return self._call(name, [argument])

    def _print_Relational(self, expr):
        return f"compare({self._print(expr.lhs)}, {expr.rel_op!r}, {self._print(expr.rhs)})"

    def _print_And(self, expr, connective="every"):
        return self._call(connective, sorted(expr.args, key=str))

    def _print_Or(self, expr):
        return self._print_And(expr, "some")

    def _print_Pow(self, expr):
        neither = expr.exp.is_Rational and expr.exp > 0 and expr.exp.q > 1 and expr.exp != S.Half  # product nor root
        return self._call("power", expr.args) if neither else super()._print_Pow(expr)

    def select(self, condition: str, value: str, otherwise: str) -> str:
        return f"where({condition}, lambda: {value}, lambda: {otherwise})"
