"""A program of `proofs/` as a NumPy function that a reader can follow: vectors whole, sines of half-turns.

    def bumped_normal(cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta):
        ...
        m = beta*g + normal

A vector is an array whose first axis is x, y, z; `dot` is its scalar product. A height that is any is an argument.
"""

import re
from collections.abc import Iterable
from textwrap import wrap

from sympy import Add, Expr, Function, Symbol, atan2, pi
from sympy.core.function import AppliedUndef
from sympy.printing.str import StrPrinter

from proofs.engine.half_turns import atan2pi
from proofs.engine.program import Program, chain
from proofs.formulas import algebraic_form, bump, displacement, image_derivative, shading
from proofs.formulas.chart import chart, chart_inverse
from proofs.formulas.finite_difference import central
from proofs.formulas.height_fields import ANY_FIELD, HEIGHT_FIELDS, gradient_from_factors, height
from proofs.formulas.tangent_frame import seed_frame, tangent_frame

WIDTH = 78  # characters of a line that a column of the page shows
AXES = ("_x", "_y", "_z")
DOT = Function("dot")
NAMES = {"Abs": "abs", "Max": "maximum", "Min": "minimum", "atan2": "arctan2"}


class ReadablePrinter(StrPrinter):
    """Prints for NumPy's names: `sin`, `sqrt`, `where`, `maximum`."""

    def _print_Symbol(self, expr):
        stem, axis = expr.name[:-2], expr.name[-2:]
        return f"{stem}[{AXES.index(axis)}]" if axis in AXES else expr.name

    def _print_Add(self, expr, order=None):
        terms = [self._print(term) for term in self._as_ordered_terms(expr)]
        terms.sort(key=lambda term: term.startswith("-"))  # a sum begins with what is added
        return terms[0] + "".join(f" - {t[1:]}" if t.startswith("-") else f" + {t}" for t in terms[1:])

    def _print_Function(self, expr):
        name = type(expr).__name__
        return f"{NAMES.get(name, name)}({', '.join(self._print(a) for a in expr.args)})"

    _print_Abs = _print_Max = _print_Min = _print_Function

    def _print_Piecewise(self, expr):
        (text,) = (self._print(value) for value, condition in expr.args if condition == True)  # noqa: E712
        for value, condition in reversed(expr.args[:-1]):
            text = f"where({self._print(condition)}, {self._print(value)}, {text})"
        return text

    def _print_And(self, expr):
        return " & ".join(f"({self._print(part)})" for part in sorted(expr.args, key=str))


def _along(expression: Expr, axis: str) -> Expr:
    """Return an expression with the components along x replaced by those along another axis."""
    return expression.xreplace(
        {s: Symbol(s.name[:-2] + axis, real=True) for s in expression.free_symbols if s.name.endswith("_x")}
    )


def _with_dots(expression: Expr) -> Expr:
    """Return an expression in which a_x b_x + a_y b_y + a_z b_z is dot(a, b)."""

    def named(*terms):
        for term in terms:
            rest = {_along(term, axis) for axis in AXES[1:]}
            if len(rest) == 2 and rest < set(terms) and term.is_commutative:
                factors = sorted((s.name[:-2] for s in term.free_symbols), key=str)
                left, right = (factors * 2)[:2]
                coefficient, _ = term.as_coeff_Mul()
                product = DOT(*(Symbol(n, real=True) for n in (left, right)))
                return Add(coefficient * product, *(t for t in terms if t != term and t not in rest))
        return Add(*terms)

    return expression.replace(Add, named)


def _lines(program: Program) -> list[str]:
    """Return the definitions of a program, a line each; the three of a vector are one."""
    needed = program.reaches(*program.outputs)
    printer, lines = ReadablePrinter({"order": "lex"}), []
    waiting = [line for line in program.definitions if line[0] in needed]
    while waiting:
        symbol, expression = waiting.pop(0)
        name, vector = symbol.name, symbol.name.endswith("_x")
        parts = [expression, *(waiting.pop(0)[1] for _ in AXES[1:])] if vector else [expression]
        parts = [_with_dots(part.replace(atan2pi, lambda y, x: atan2(y, x) / pi)) for part in parts]
        if not vector:
            text = printer.doprint(parts[0])
        elif all(_along(parts[0], axis) == part for axis, part in zip(AXES, parts, strict=True)):
            text = printer.doprint(_along(parts[0], ""))  # the vector itself
        else:
            zero = f"0*{printer.doprint(max(parts[0].free_symbols, key=str))}"  # of the other components' shape
            text = f"np.array([{', '.join(printer.doprint(part) if part else zero for part in parts)}])"
        lines.append(f"{name[:-2] if vector else name} = {text}")
    return lines


def _names(symbols: Iterable[Symbol]) -> list[str]:
    """Return the names of some symbols, each vector once."""
    return [s.name.removesuffix("_x") for s in symbols if not s.name.endswith(AXES[1:])]


def function(name: str, program: Program) -> str:
    """Return a program as the text of a Python function."""
    lines, outputs = _lines(program), _names(program.outputs)
    at_once = f"return {', '.join(line.split(' = ', 1)[1] for line in lines)}"
    if [line.split(" = ")[0] for line in lines] == outputs and len(at_once) < WIDTH - 4:
        lines = [at_once]  # nothing is named on the way
    else:
        lines.append(f"return {', '.join(outputs)}")
    any_height = {f.name for _, line in program.definitions for f in line.atoms(AppliedUndef)}
    text = [f"def {name}({', '.join([*_names(program.inputs), *any_height])}):", *(f"    {line}" for line in lines)]
    return "\n".join("\n".join(wrap(line, WIDTH, subsequent_indent=" " * 8)) for line in text)


_lit = chain(
    "red_and_its_derivative",
    bump.normal_by_beta,
    shading.blinn,
    shading.highlight,
    shading.light_term.keep(shading.lit[0]),
    image_derivative.mu_derivative,
    image_derivative.base_derivatives["blinn"],
    image_derivative.term_derivative,
    outputs=(shading.lit[0], image_derivative.term_by_beta),
)

FUNCTIONS = {
    **{f"height_fields.py, {name}": (name, height(field)) for name, field in HEIGHT_FIELDS.items()},
    **{f"height_fields.py, slopes of {n}": (f"{n}_slopes", gradient_from_factors(f)) for n, f in HEIGHT_FIELDS.items()},
    "algebraic_form.py, square": ("complex_square", algebraic_form.complex_square),
    "algebraic_form.py, product": ("complex_product", algebraic_form.complex_product),
    "finite_difference.py": ("central", central(ANY_FIELD)),
    "chart.py": ("chart", chart),
    "chart.py, inverse": ("angles", chart_inverse),
    "tangent_frame.py": ("tangent_frame", tangent_frame),
    "tangent_frame.py, the seed's": ("seed_frame", seed_frame),
    "bump.py": ("bumped_normal", bump.bumped_normal),
    "bump.py, derivative": ("normal_by_beta", bump.normal_by_beta),
    "bump.py, tilt": ("tilt", bump.perturbed),
    "image_derivative.py": ("red_by_beta", _lit),
    "displacement.py": ("displaced_normal", displacement.displaced_normal),
}
"""{what stands after `# Printed from proofs/formulas/` in a cell: (the function's name, its program)}"""

PRINTED = re.compile(r"^# Printed from proofs/formulas/(?P<key>.+)\ndef (?:.*\n)(?:[ ].*\n)+", re.MULTILINE)
SHARED = re.compile(
    r"^(# The (?:scene of §2|pipelines of §3).*)\n(?:.*\n)*?def render_(?:symbolic_)?bump\(.*\n(?:(?: .*)?\n)*?(?=^\S)",
    re.MULTILINE,
)


def refreshed(page: str) -> str:
    """Return the page's text with what its cells have from `proofs/` printed anew, and what they share as at first.

    Raises ValueError on a function that is not known.
    """

    def printed(match: re.Match) -> str:
        if match["key"] not in FUNCTIONS:
            raise ValueError(f"{match['key']!r} is not allowed: one of {', '.join(FUNCTIONS)}")
        return match[0].split("\n")[0] + "\n" + function(*FUNCTIONS[match["key"]]) + "\n"

    first: dict[str, str] = {}
    return PRINTED.sub(printed, SHARED.sub(lambda match: first.setdefault(match[1], match[0]), page))
