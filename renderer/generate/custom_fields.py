"""Custom height fields: their kernels, printed in memory at run time as kernels.py is.

They alone let SymPy and the proofs be imported where something is drawn.
"""

from dataclasses import dataclass
from functools import cache
from typing import Any

from sympy import Expr

from proofs.engine.half_turns import cospi as cospi, sinpi as sinpi
from proofs.engine.program import put
from proofs.formulas import height_fields
from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.symbols import k_u as k_u, k_v as k_v, u as u, v as v
from proofs.printers.python import print_function
from proofs.printers.text import check_operations
from renderer.checks import check_kind, not_allowed
from renderer.generate import programs
from renderer.generate.custom_printer import OwnPrinter, exact_waves, made
from renderer.generate.kernels import field_entry
from renderer.generate.reader import as_spelled, expression_text, parse_expression

_HIGHEST, _STEEPEST = 1e103, 1e143  # β times a height, or a slope: over a step of 1e-40, squared, it is a float64


@dataclass(frozen=True)
class HeightField(height_fields.HeightField):
    """A height field, by its formula as it comes to mind: an expression of SymPy, or a text.

    name: identifier. expression: h in u, v, k_u, k_v, by any symbols of these names. seam: whether h may differ at
    u = 0 and u = 1 where k_u is even and k_v whole. Raises ValueError where the name or the formula is not allowed.

    >>> from renderer import HeightField
    >>> HeightField("dunes", "0.1*sin(8*pi*u)^2").expression
    sinpi(8*u)**2/10
    """

    expression: Any

    def __post_init__(self):
        if isinstance(self.expression, str):
            put(self, expression=parse_expression(self.expression))
            check_operations("field", self.name, [self.expression] * 2)  # slopes take as many or more, and long
        elif isinstance(self.expression, Expr):
            put(self, expression=as_spelled(self.expression))
        else:
            wall = "heights in an array have no formula, and what that costs is told on the page Two frontiers, priced"
            raise self._refused(f"an expression of SymPy, or its text; {wall}")
        try:
            super().__post_init__()
        except RecursionError:
            raise not_allowed("field", self.name, "a formula that is nested less deep") from None


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
    return {"name": field.name, "expression": _text_of(field)} | ({"seam": True} if field.seam else {})


@cache
def _text_of(field):
    """Return the text of a field's expression. Raises ValueError where none is read as it."""
    check_operations("field", field.name, [field.expression, *field.gradient()])
    return expression_text(field.expression)


def from_record(record: dict[str, Any]) -> HeightField:
    """Return the field of a record: {"name": …, "expression": its text, "seam": whether it has one}.

    Raises ValueError on anything else.
    """
    for key in record:
        if key not in ("name", "expression", "seam"):
            raise not_allowed("field", key, "the parts name, expression, seam")
    for key in ("name", "expression"):
        if key not in record:
            raise not_allowed("field", record, f"one with its {key}")
    name = check_kind("field.name", record["name"], str)
    expression = check_kind("field.expression", record["expression"], str)
    seam = check_kind("field.seam", record.get("seam", False), bool)
    field = HeightField(name, expression, seam)
    _text_of(field)
    return field
