"""Printer of float64's operations as Coq definitions: those of kernels, and of the machine that counts roundings.

Both are run on numbers that record each operation as text: the text of a result is the expression that computed it.
"""

import math
from collections.abc import Callable, Mapping
from typing import Any

from proofs.engine.functions import FUNCTIONS
from proofs.engine.program import Program
from proofs.printers.python import KernelPrinter, function_of


def literal(number: float) -> str:
    """Return a float64 as a term of Coq's real numbers, to the last bit; 0 for infinity and NaN, which are no reals."""
    if not math.isfinite(number):
        return "real p_infty"
    mantissa, exponent = math.frexp(abs(number))
    sign = "-" if number < 0 else ""
    if mantissa == 0.5 and abs(exponent) > 64:
        power = f"2 ^ {abs(exponent - 1)}"
        return f"{sign}{power}" if exponent > 0 else f"{sign}1 / {power}"
    above, below = number.as_integer_ratio()
    return str(above) if below == 1 else f"{above} / {below}"


def argument(number: Any) -> str:
    """Return a number or a decision as an argument of a function: in parentheses, where it needs them."""
    text = literal(number) if isinstance(number, float) else number.text
    return f"({text})" if (" " in text and text[0] != "(") or text[0] == "-" else text


def applied(name: str, *arguments: Any) -> str:
    """Return the text of a function of numbers or decisions."""
    return " ".join([name, *map(argument, arguments)])


class Decision:
    """A condition, as the text of Coq's decision of it or of its negation."""

    def __init__(self, text: str, negated: bool = False):
        self.text, self.negated = text, negated

    def __invert__(self):
        return Decision(self.text, not self.negated)

    def _joined(self, both_of, other):
        if self.negated or other.negated:
            raise ValueError(f"no form for a negation within {self.text} or {other.text}")
        return Decision(applied(both_of, self, other))

    def __or__(self, other):
        return self._joined("either", other)

    def __and__(self, other):
        return ~(~self | ~other) if self.negated else self._joined("both", other)


def _operation(sign):
    """Return the methods of an operation of Terms, and of it with the operands in the other order."""

    def operation(self, other):
        return type(self)(f"rounded ({self.operand(self)} {sign} {self.operand(other)})")

    def reflected(self, other):
        return type(self)(f"rounded ({self.operand(other)} {sign} {self.operand(self)})")

    return operation, reflected


def _comparison(decision):
    """Return the methods of a comparison of Terms, and of it with the operands in the other order."""

    def compare(*sides):
        if any(side is math.inf for side in sides):  # which is no real number
            extended = ("p_infty" if side is math.inf else f"(Finite {argument(side)})" for side in sides)
            return Decision(" ".join([f"Rbar_{decision[1:]}", *extended]))
        return Decision(applied(decision, *sides))

    return compare, lambda *sides: compare(*sides[::-1])


class Term:
    """A float64 number, as the text of the operations that made it, each rounded.

    Its machine, which `renderer.operations` asks, is its class.
    """

    machine = property(type)
    operand = staticmethod(argument)  # a number within an operation
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, text: str):
        self.text = text

    @classmethod
    def where(cls, mask: Decision, value: Any, otherwise: Any) -> "Term":
        """Return a selection."""
        sides = [cls.operand(side) for side in (value, otherwise)][:: -1 if mask.negated else 1]
        return cls(f"if {mask.text} then {sides[0]} else {sides[1]}")

    @classmethod
    def two_product(cls, *factors: Any) -> list["Term"]:
        """Return a product and its rounding."""
        return [cls(applied(f"two_product_float64.{part}", *factors)) for part in ("product", "product_error")]

    def sqrt(self) -> "Term":
        """Return a root, rounded."""
        return type(self)(f"rounded ({applied('sqrt', self)})")

    __add__, __radd__ = _operation("+")
    __sub__, __rsub__ = _operation("-")
    __mul__, __rmul__ = _operation("*")
    __truediv__, __rtruediv__ = _operation("/")

    def __abs__(self):
        return type(self)(applied("Rabs", self))

    def __neg__(self):
        return type(self)(f"- {self.operand(self)}")

    __lt__, __gt__ = _comparison("Rlt_dec")
    __le__, __ge__ = _comparison("Rle_dec")
    __eq__, _ = _comparison("Req_EM_T")


def rule(program: Program, names: Mapping[str, Any], counted: Callable) -> list[str]:
    """Return Coq's lines of the machine's result for a program of one line: its value, and the count of its error.

    names: the kernels. counted: (value, count) → a number of the machine.
    """
    inputs = [symbol.name for symbol in program.inputs]
    ((output, _),) = program.definitions
    result = function_of(program, names)(*(counted(Term(name), Term(f"{name}_error")) for name in inputs))
    variables = " ".join(f"{name} {name}_error" for name in inputs)
    return [
        f"Variables {variables} : R.",
        f"Definition {output.name} := {result.value.text}.",
        f"Definition {output.name}_error := {result.error.text}.",
    ]


class Line(Term):
    """A number in a line of a kernel, which is written with fewer parentheses."""

    @staticmethod
    def operand(number: Any) -> str:
        """Return a number within an operation."""
        return number.text if isinstance(number, Term) else argument(number)

    @classmethod
    def where(cls, mask: Decision, value: Any, otherwise: Any) -> "Line":
        """Return a selection."""
        return cls(f"({super().where(mask, value, otherwise).text})")


NAMES = {function.kernel: function.coq_float64 for function in FUNCTIONS if function.coq_float64}
NAMES |= {name: name for name in ("power_of_two", "binary_exponent", "height")} | {"power": "raised_float64.power"}
"""{kernel: Coq's function}; each rounds as its definition says, and no more"""
OF_PRODUCTS = "sinpi", "cospi", "exp"  # and of a product's rounding, which is 0 unless it is given


def _called(name):
    def called(machine, *arguments):
        rounding = (0.0,) * (name in OF_PRODUCTS and len(arguments) == 1)
        return machine(applied(NAMES[name], *arguments, *rounding))

    return classmethod(called)


for name in NAMES:
    setattr(Term, name, _called(name))
Decision.machine = Term  # type: ignore[attr-defined]  # a selection may have two literals

CALLED: dict[str, Any] = {"pi": Line("rounded PI")}
CALLED |= {name: getattr(Line, name) for name in (*NAMES, "two_product", "where")}


def carried_out(program: Program, operations: Mapping[str, Any]) -> list[str]:
    """Return Coq's lines of a kernel's operations, in its order; operations: the functions that kernels call."""
    printer, scope = KernelPrinter(), {**operations, **CALLED} | {s.name: Line(s.name) for s in program.inputs}
    lines = [f"Variables {' '.join(s.name for s in program.inputs)} : R."]
    for symbol, expression in program.definitions:
        made = Line.operand(eval(printer.doprint(expression), scope))
        lines.append(f"Definition {symbol.name} := {made}.")
        scope[symbol.name] = Line(symbol.name)
    return lines
