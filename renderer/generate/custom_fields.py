"""Custom height fields: their kernels, printed in memory at run time as kernels.py is.

Drawing imports SymPy and the proofs only for such a field.
"""

import re
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from sympy import Expr, Rational, Symbol, diff

from proofs.engine.half_turns import cospi as cospi, sinpi as sinpi
from proofs.engine.program import put
from proofs.formulas import height_fields
from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.symbols import k_u as k_u, k_v as k_v, u as u, v as v
from proofs.printers.python import print_function
from proofs.printers.text import check_operations
from renderer.checks import check_kind, check_number, not_allowed
from renderer.generate import programs
from renderer.generate.custom_printer import OwnPrinter, exact_waves, made
from renderer.generate.kernels import field_entry
from renderer.generate.reader import NAMES, OF_FIELDS, as_spelled, expression_text, parse_expression

_HIGHEST, _STEEPEST = 1e103, 1e143  # β times a height, or a slope: over a step of 1e-40, squared, it is a float64


@dataclass(frozen=True, init=False)
class HeightField(height_fields.HeightField):
    """A height field, by its formula as it comes to mind: an expression of SymPy, or a text.

    name: identifier. expression: h in u, v, k_u, k_v, by any symbols of these names. seam: whether h may differ at
    u = 0 and u = 1 where k_u is even and k_v whole. parameters: numbers by their names in the formula, by which a
    picture has slopes too. Raises ValueError where the name or the formula is not allowed.

    >>> from renderer import HeightField
    >>> HeightField("dunes", "0.1*sin(8*pi*u)^2").expression
    sinpi(8*u)**2/10
    >>> HeightField("dunes", "a*sin(8*pi*u)", a=0.3).expression
    3*sinpi(8*u)/10
    """

    expression: Any
    form: Any = field(default=None, init=False, repr=False)
    parameters: tuple[tuple[str, float], ...] = field(default=(), init=False, repr=False)

    def __init__(self, /, name: str, expression: Any, seam: bool = False, **parameters: float):
        put(self, name=name, expression=expression, seam=seam, form=expression)
        names = NAMES | {each: _symbol(each) for each in parameters}
        put(self, parameters=tuple((each, check_number(each, number)) for each, number in parameters.items()))
        if isinstance(expression, str):
            put(self, form=parse_expression(expression, names=names))
            check_operations("field", self.name, [self.form] * 2)  # slopes take as many or more, and long
        elif isinstance(expression, Expr):
            put(self, form=as_spelled(expression, names))
        else:
            wall = "heights in an array have no formula, and what that costs is told on the page Two frontiers, priced"
            raise self._refused(f"an expression of SymPy, or its text; {wall}")
        has = sorted(each.name for each in self.form.free_symbols - set(NAMES.values()))
        for each in parameters:
            if each not in has:
                raise not_allowed("parameter", each, f"one that the formula has: {', '.join(has) or 'none'}")
        put(self, expression=self.of_numbers(self.form))
        try:
            super().__post_init__()
        except RecursionError:
            raise not_allowed("field", self.name, "a formula that is nested less deep") from None

    def of_numbers(self, form: Expr) -> Expr:
        """Return a formula with the numbers of the parameters in it."""
        return form.xreplace({_symbol(name): Rational(repr(number)) for name, number in self.parameters})

    def with_parameter(self, name: str, number: float) -> "HeightField":
        """Return the field with another number of a parameter."""
        return HeightField(self.name, self.form, self.seam, **dict(self.parameters) | {name: number})

    def by(self, name: str) -> height_fields.HeightField:
        """Return the slope of the height by a parameter, as a field. Raises ValueError where a crease would move."""
        symbol = _symbol(name)
        if any(choice.has(symbol) for choice in self.form.atoms(*height_fields._CHOICES)):
            raise not_allowed("derivatives", name, f"a parameter outside abs, max and the other choices of '{self}'")
        return height_fields.HeightField(f"{self.name}_by_{name}", self.of_numbers(diff(self.form, symbol)), True)


def _symbol(name):
    """Return the symbol of a parameter. Raises ValueError on a name that is taken, such as u or pi."""
    if name in {*NAMES, "pi"} or not re.fullmatch("[a-z][a-z_]*", name):
        raise not_allowed("parameter", name, f"a name of small letters, but {', '.join(NAMES)}, pi")
    return Symbol(name, real=True)


def made_field(field: height_fields.HeightField) -> str | height_fields.HeightField:
    """Return a field once its kernels are made, or the name of the chapter's that it is.

    Raises ValueError where the chapter has another formula by its name, or the field is not allowed.
    """
    if field.name not in HEIGHT_FIELDS:
        field_kernels(field)
        return field
    if field.expression != HEIGHT_FIELDS[field.name].expression:
        raise not_allowed("name", field.name, "a name that no other formula has, and this is one of the chapter's")
    return field.name


@cache
def field_kernels(field: HeightField) -> dict[str, Any]:
    """Return the entry of a custom field, as in `kernels.FIELDS`. Raises ValueError where it is not allowed."""
    printed = [print_function(p.name, p, OwnPrinter()) for p in programs.field_programs(field).values()]
    entry = made("\n".join([*printed, "ENTRIES = {", field_entry(field), "}"]))["ENTRIES"][field.name]
    return entry | ({"wave_numbers": exact_waves(field)} if field.wave_numbers else {})


_largest = cache(HeightField.largest)


def check_size(field: HeightField, ku: float, kv: float, beta: float, steeper: float) -> None:
    """Raise ValueError where a field is not finite at wave numbers, or higher or steeper than float64 allows.

    steeper: by how much a bump may make its slopes steeper.
    """
    try:
        height, *slopes = _largest(field, ku, kv)
    except ValueError as error:
        raise not_allowed("(ku, kv)", (ku, kv), f"wave numbers of '{field}' at which it is finite: {error}") from None
    most = max(1.0, abs(beta) * steeper)  # by itself a picture's data has it too
    if not (most * height <= _HIGHEST and most * max(slopes) <= _STEEPEST):
        high, steep = _HIGHEST / steeper, _STEEPEST / steeper
        allowed = f"times the height of '{field}' at most {high:g}, times its slopes at most {steep:g}"
        raise not_allowed("beta", beta, allowed)


def as_record(field: HeightField) -> dict[str, Any]:
    """Return a field as a record for JSON. Raises ValueError where it has no text."""
    numbers = {"parameters": dict(parameters)} if (parameters := getattr(field, "parameters", ())) else {}
    return {"name": field.name, "expression": _text_of(field)} | ({"seam": True} if field.seam else {}) | numbers


@cache
def _text_of(field):
    """Return a text that is read as the field's expression. Raises ValueError where there is none."""
    check_operations("field", field.name, [field.expression, *field.gradient()])
    names = {name: _symbol(name) for name, _ in getattr(field, "parameters", ())}
    return expression_text(getattr(field, "form", field.expression), names=OF_FIELDS | names)


def from_record(record: dict[str, Any]) -> HeightField:
    """Return the field of a record: {"name": …, "expression": its text, "seam": whether it has one, "parameters": {}}.

    Raises ValueError on anything else.
    """
    for key in record:
        if key not in ("name", "expression", "seam", "parameters"):
            raise not_allowed("field", key, "the parts name, expression, seam, parameters")
    for key in ("name", "expression"):
        if key not in record:
            raise not_allowed("field", record, f"one with its {key}")
    name = check_kind("field.name", record["name"], str)
    expression = check_kind("field.expression", record["expression"], str)
    seam = check_kind("field.seam", record.get("seam", False), bool)
    parameters = check_kind("field.parameters", record.get("parameters", {}), dict)
    if not parameters.keys().isdisjoint(record):
        raise not_allowed("field.parameters", parameters, "others than name, expression and seam")
    field = HeightField(name, expression, seam, **parameters)
    _text_of(field)
    return field
