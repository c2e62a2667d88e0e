"""The rules of the enclosing machine as Coq definitions: the machine runs, on numbers that write down what is done.

Whatever it carries out on float64 numbers it carries out on these, and its text is what each result was made by.
"""

import math
from typing import Any

from proofs.engine.program import Program
from renderer.generate.kernels import function_of
from renderer.machines.enclosing import Enclosed


def literal(number: float) -> str:
    """Return a float64 as a term of Coq's real numbers, to the last bit; infinity by its real part, which is none."""
    if math.isinf(number):
        return "real p_infty"
    mantissa, exponent = math.frexp(abs(number))
    sign = "-" if number < 0 else ""
    if mantissa == 0.5 and abs(exponent) > 64:
        power = f"2 ^ {abs(exponent - 1)}"
        return f"{sign}{power}" if exponent > 0 else f"{sign}1 / {power}"
    above, below = number.as_integer_ratio()
    return str(above) if below == 1 else f"{above} / {below}"


def _text(number):
    text = number.text if isinstance(number, Term) else literal(number)
    return f"({text})" if " " in text else text


class Decision:
    """What a selection asks: Coq's decision of it, or of its negation."""

    def __init__(self, text: str, negated: bool = False):
        self.text, self.negated = text, negated

    def __invert__(self):
        return Decision(self.text, not self.negated)

    def _joined(self, both_of, other):
        if self.negated or other.negated:
            raise ValueError(f"no form for a negation within {self.text} or {other.text}")
        return Decision(f"{both_of} ({self.text}) ({other.text})")

    def __or__(self, other):
        return self._joined("either", other)

    def __and__(self, other):
        return ~(~self | ~other) if self.negated else self._joined("both", other)


class Operations:
    """What `renderer.operations` is on Terms."""

    @staticmethod
    def where(mask: Decision, value: Any, otherwise: Any) -> "Term":
        """Return a selection."""
        sides = (otherwise, value) if mask.negated else (value, otherwise)
        return Term(f"if {mask.text} then {_text(sides[0])} else {_text(sides[1])}")

    @staticmethod
    def sqrt(number: "Term") -> "Term":
        """Return a root, rounded."""
        return Term(f"rounded (sqrt {_text(number)})")

    @staticmethod
    def floor(number: "Term") -> "Term":
        """Return the next whole number below, which is not rounded."""
        return Term(f"whole_below {_text(number)}")

    @staticmethod
    def rint(number: "Term") -> "Term":
        """Return the nearest whole number, which is not rounded."""
        return Term(f"rint {_text(number)}")


class Term:
    """A float64 number, as the text of what it was made by: each operation is rounded."""

    machine = Operations
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, text: str):
        self.text = text

    def _operation(sign):
        return lambda self, other: Term(f"rounded ({_text(self)} {sign} {_text(other)})")

    def _reflected(sign):
        return lambda self, other: Term(f"rounded ({_text(other)} {sign} {_text(self)})")

    __add__, __sub__, __mul__, __truediv__ = map(_operation, "+-*/")  # type: ignore[arg-type]
    __radd__, __rsub__, __rmul__, __rtruediv__ = map(_reflected, "+-*/")  # type: ignore[arg-type]

    def __abs__(self):
        return Term(f"Rabs {_text(self)}")

    def __neg__(self):
        return Term(f"- {_text(self)}")

    def __lt__(self, other):
        return Decision(f"Rlt_dec {_text(self)} {_text(other)}")

    def __le__(self, other):
        return Decision(f"Rle_dec {_text(self)} {_text(other)}")

    def __gt__(self, other):
        return Decision(f"Rlt_dec {_text(other)} {_text(self)}")

    def __eq__(self, other):
        return Decision(f"Req_EM_T {_text(self)} {_text(other)}")


def rule(program: Program) -> list[str]:
    """Return Coq's lines of what the machine makes of a program of one line: its value, and the count of its error."""
    names = [symbol.name for symbol in program.inputs]
    ((output, _),) = program.definitions
    found = function_of(program)(*(Enclosed.counted(Term(name), Term(f"{name}_error")) for name in names))
    inputs = " ".join(f"{name} {name}_error" for name in names)
    return [
        f"Variables {inputs} : R.",
        f"Definition {output.name} := {found.value.text}.",
        f"Definition {output.name}_error := {found.error.text}.",
    ]
