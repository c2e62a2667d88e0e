"""Print one definition of a straight-line program in JavaScript, and a row kernel as a JavaScript function.

The operations and their order are those of the Python kernels; JavaScript contracts nothing, so the bits are the same.
"""

import textwrap
from typing import ClassVar

from sympy import Integer

from proofs.half_turns import atan2pi, cospi, sinpi
from proofs.program import Program
from proofs.symbols import real
from renderer.generate.printers import StraightLinePrinter

ELEMENTARY = (sinpi, cospi, atan2pi)


class JavaScriptPrinter(StraightLinePrinter):
    """Scalars inside a loop over a row. `rint`, `sign`, `maximum` and `minimum` are ours.

    calls: {call of sinpi, cospi or atan2pi: the text that stands for its result}. The text is put in while printing,
    so that terms and factors keep the order in which Python has them.
    """

    sqrt, infinity, pi, power = "Math.sqrt", "Infinity", "Math.PI", "Math.pow"
    names: ClassVar = {**StraightLinePrinter.names, "Abs": "Math.abs", "floor": "Math.floor"}

    def __init__(self, calls=None):
        super().__init__()
        self.calls = calls or {}

    def literal(self, rational):
        return super().literal(rational).replace(".0 /", " /").replace(".0)", ")").removesuffix(".0")

    def select(self, condition, value, otherwise):
        return f"({condition} ? {value} : {otherwise})"

    def _print_Relational(self, expr):
        operator = {"==": "===", "!=": "!=="}.get(expr.rel_op, expr.rel_op)
        return f"({self._print(expr.lhs)} {operator} {self._print(expr.rhs)})"

    def _print_sinpi(self, expr):
        return self.calls.get(expr) or super()._print_sinpi(expr)

    def _print_cospi(self, expr):
        return self.calls.get(expr) or super()._print_cospi(expr)

    def _print_atan2pi(self, expr):
        return self.calls.get(expr) or super()._print_atan2pi(expr)


PRINTER = JavaScriptPrinter()


def print_scalar_function(name, program):
    """Return the text of a function of scalars; several results come as an array."""
    results = ", ".join(s.name for s in program.outputs)
    result = f"return {results};" if len(program.outputs) == 1 else f"return [{results}];"
    lines = _constants((s.name, PRINTER.doprint(e)) for s, e in program.definitions)
    return _function(name, [s.name for s in program.inputs], [*lines, result])


def print_row_kernel(kernel):
    """Return the text of a row kernel.

    V8 boxes the numbers that pass through a call, so no function is called inside a loop: each sine is a pass over
    the row of its own, into a spare row.
    """
    program, rows = kernel.program, set(kernel.rows)
    targets = dict(zip(program.outputs, kernel.into or program.outputs, strict=True))
    parameters = [f"{s.name}_row" if s in rows else s.name for s in program.inputs]
    parameters += [f"{t.name}_row" for t in targets.values() if f"{t.name}_row" not in parameters]
    body = _Body(program, rows)
    stores = [f"{t.name}_row[i] = {s.name};" for s, t in targets.items()]
    lines = [*body.before(), *body.passes(), *body.loop(program.outputs, stores)]
    return _function(f"{program.name}_row", [*parameters, "start", "stop"], lines)


class _Body:
    """The statements of a row kernel. What does not vary along the row stands before the loop."""

    def __init__(self, program, rows):
        self.rows, self.varying = rows, _varying(program, rows)
        self.program = program = _with_named_arguments(program, self.varying)
        found = dict.fromkeys(c for _, e in program.definitions for c in sorted(e.atoms(*ELEMENTARY), key=str))
        self.names = {call: f"{type(call).__name__}_{number}" for number, call in enumerate(found)}
        self.printer = JavaScriptPrinter({call: f"{name}[i]" for call, name in self.names.items()})

    def before(self):
        """Return the definitions that do not vary, of those that the outputs need."""
        return self._definitions(self._needed(self.program.outputs), varying=False)

    def passes(self):
        """Return what fills the spare rows: the arguments of all calls in one loop, then each call."""
        defined = {s for s, _ in self.program.definitions}
        arguments = sorted({s for c in self.names for s in c.free_symbols & self.varying & defined}, key=str)
        spare = [*(f"{s.name}_row" for s in arguments), *self.names.values()]
        text = [f"const [{', '.join(spare)}] = spare_rows({len(spare)}, stop);"] if spare else []
        if arguments:
            text += self.loop(arguments, [f"{s.name}_row[i] = {s.name};" for s in arguments])
        return text + [self._call(call, name) for call, name in self.names.items()]

    def _call(self, call, result):
        """Return the statement that takes one function over the row."""
        name, given = _name_and_arguments(call)
        moving = {s.name for s in call.free_symbols & self.varying}
        given = [f"{a}_row" if a in moving else a for a in given]
        return f"{name}_row({', '.join([*given, result])}, start, stop);"

    def loop(self, outputs, stores):
        """Return a loop that computes `outputs`, line by line."""
        needed = self._needed(outputs)
        used = set(outputs).union(*(self._reads(e) for _, e in needed))
        loads = _constants((s.name, f"{s.name}_row[i]") for s in sorted(self.rows & used, key=str))
        lines = [*loads, *self._definitions(needed, varying=True), *stores]
        return ["for (let i = start; i < stop; i++) {", *(f"  {line}" for line in lines), "}"]

    def _definitions(self, lines, varying):
        return _constants((s.name, self.printer.doprint(e)) for s, e in lines if (s in self.varying) is varying)

    def _reads(self, expression):
        """Return the names that an expression reads, beside the results of calls."""
        return expression.xreplace(dict.fromkeys(self.names, Integer(1))).free_symbols

    def _needed(self, outputs):
        """Return the definitions that the outputs depend on, calls left out."""
        found, kept = set(outputs), []
        for symbol, expression in reversed(self.program.definitions):
            if symbol in found:
                found |= self._reads(expression)
                kept.append((symbol, expression))
        return kept[::-1]


def _varying(program, rows):
    """Return the names of a program that vary along the row."""
    varying = set(rows)
    for symbol, expression in program.definitions:
        if expression.free_symbols & varying:
            varying.add(symbol)
    return varying


def _name_and_arguments(call):
    """Return the name of the function that a call is printed as, and its arguments, each as text."""
    name, given = PRINTER.doprint(call).removesuffix(")").split("(", 1)
    return name, given.split(", ")


def _with_named_arguments(program, varying):
    """Return the program with a line for each argument of a call that is neither a row nor a scalar, such as a sum.

    The new names are put into `varying`.
    """
    lines, names = [], {}
    for symbol, expression in program.definitions:
        for call in sorted(expression.atoms(*ELEMENTARY), key=str):
            if {s.name for s in call.free_symbols & varying} <= set(_name_and_arguments(call)[1]):
                continue
            for argument in call.args:
                if argument not in names:
                    names[argument] = real(f"argument_{len(names)}")
                    lines.append((names[argument], argument))
            expression = expression.xreplace({call: call.func(*(names[a] for a in call.args))})
        lines.append((symbol, expression))
    varying |= set(names.values())
    return Program(program.name, program.inputs, tuple(lines), program.outputs)


def _constants(pairs):
    """Return the lines of one declaration of several constants."""
    lines = [f"{name} = {text}" for name, text in pairs]
    if not lines:
        return []
    return [f"{'const' if n == 0 else ' '} {line}{',;'[n == len(lines) - 1]}" for n, line in enumerate(lines)]


def _function(name, parameters, lines):
    """Return the text of a function; `lines` are not yet indented."""
    head = textwrap.wrap(", ".join(parameters), 112)
    signature = [f"function {name}({head[0]}) {{"] if len(head) == 1 else [f"function {name}(", *head, ") {"]
    return "\n".join([*signature, *(f"  {line}" for line in lines), "}", ""])
