"""Height fields and models of light that are made at run time: their kernels, printed in memory as kernels.py is.

They alone let SymPy and the proofs be imported where something is drawn.
"""

from collections.abc import Callable
from functools import cache
from typing import Any

from proofs.engine.program import Program
from proofs.formulas.half_turns import cospi as cospi, sinpi as sinpi
from proofs.formulas.height_fields import HEIGHT_FIELDS, HeightField as HeightField
from proofs.formulas.registry import check_name
from proofs.formulas.shading import LIGHT_MODELS, LightModel as LightModel
from proofs.formulas.symbols import k_u as k_u, k_v as k_v, mu, real, specular_base, u as u, v as v
from renderer.checks import check_kind, not_allowed
from renderer.generate import programs
from renderer.generate.expression import check_operations, expression_text, parse_expression
from renderer.generate.kernels import field_entry, print_function
from renderer.generate.own_kernels import SEEN_BY_A_LIGHT, OwnPrinter, exact_waves, light_kernels, made

_KNOWN: dict[type, dict[str, Any]] = {HeightField: dict(HEIGHT_FIELDS), LightModel: dict(LIGHT_MODELS)}
_OF_THE_CHAPTER = (*HEIGHT_FIELDS.values(), *LIGHT_MODELS.values())
_MOST_LINES = 200
_HIGHEST, _STEEPEST = 1e103, 1e143  # β times a height, or a slope: over a step of 1e-40, squared, it is a float64


def _formulas(own):
    """Return what is drawn by: a field's expression, or the lines of a model's programs."""
    if isinstance(own, HeightField):
        return own.expression
    check_kind("program", own.program, Program)
    return [program and check_kind("squared", program, Program).definitions for program in (own.program, own.squared)]


def _known(own):
    """Return what of this process's fields, or of its models, has which name."""
    return _KNOWN[HeightField if isinstance(own, HeightField) else LightModel]


def _named(own):
    """Return the first of this process that has a name. Raises ValueError where that has other formulas."""
    first = _known(own).get(own.name, own)
    if _formulas(first) != _formulas(own):
        raise not_allowed("name", own.name, "a name that no other formula has in this process")
    return first


def registered(own: HeightField | LightModel) -> str | HeightField | LightModel:
    """Return what has the name and the formulas of what is given: the first of this process, or a chapter's name.

    It has the name once its kernels are made. Raises ValueError where other formulas have it, or there are none.
    """
    first = _named(own)
    if first in _OF_THE_CHAPTER:
        return own.name
    (field_kernels if isinstance(own, HeightField) else model_kernels)(first)
    return _known(own).setdefault(own.name, first)


@cache
def field_kernels(field: HeightField) -> dict[str, Any]:
    """Return the entry of a field of one's own, as in `kernels.FIELDS`. Raises ValueError on what is not allowed."""
    _named(field)
    printed = [print_function(p.name, p, OwnPrinter()) for p in programs.field_programs(field).values()]
    entry = made("\n".join([*printed, "ENTRIES = {", field_entry(field), "}"]))["ENTRIES"][field.name]
    return entry | ({"wave_numbers": exact_waves(field)} if field.wave_numbers else {})


_largest = cache(HeightField.largest)


def check_size(field: HeightField, ku: float, kv: float, beta: float) -> None:
    """Raise ValueError where a field is not finite at wave numbers, or higher or steeper than float64 allows."""
    try:
        height, *slopes = _largest(field, ku, kv)
    except ValueError as error:
        raise not_allowed("(ku, kv)", (ku, kv), f"wave numbers of '{field}' at which it is finite: {error}") from None
    most = max(1.0, abs(beta))  # by itself a picture's data has it too
    if not (most * height <= _HIGHEST and most * max(slopes) <= _STEEPEST):
        allowed = f"times the height of '{field}' at most {_HIGHEST:g}, times its slopes at most {_STEEPEST:g}"
        raise not_allowed("beta", beta, allowed)


@cache
def model_kernels(model: LightModel) -> tuple[Callable, Callable | None]:
    """Return the entry of a model of one's own, as in `kernels.LIGHT_MODELS`. Raises ValueError as the above."""
    _named(model)
    return light_kernels(model)


def as_record(own: HeightField | LightModel) -> dict[str, Any]:
    """Return what JSON can say of a field or a model. Raises ValueError where it has no text."""
    if isinstance(own, HeightField):
        return {"name": own.name, "expression": _text_of(own)} | ({"seam": True} if own.seam else {})
    programs_of = {"program": own.program, "squared": own.squared}
    return {"name": own.name} | {role: _lines_of(p) for role, p in programs_of.items() if p}


@cache
def _text_of(field):
    """Return the text of a field's expression. Raises ValueError where none is read as it."""
    check_operations("field", field.name, [field.expression, *field.gradient()])
    return expression_text(field.expression)


def _lines_of(program):
    check_operations("program", program.name, [expression for _, expression in program.definitions])
    names = {symbol.name: symbol for symbol in SEEN_BY_A_LIGHT}
    lines = []
    for symbol, expression in program.definitions:
        lines.append(f"{symbol.name} = {expression_text(expression, names)}")
        names[symbol.name] = symbol
    return lines


def from_record(what: str, record: dict[str, Any]) -> HeightField | LightModel:
    """Return the field or the model of a record. Raises ValueError.

    A field: {"name": …, "expression": its text, "seam": whether it has one}. A model: {"name": …, "program":
    ["line = …", …], "squared": the same or nothing}.
    """
    if what == "field":
        name, expression, seam = _parts(what, record, {"name": str, "expression": str, "seam": bool}, seam=False)
        parsed = parse_expression(expression)
        check_operations("field", name, [parsed] * 2)  # slopes take as many or more, and long to be taken
        field = HeightField(name, parsed, seam)
        _text_of(field)
        return field
    name, program, squared = _parts(what, record, {"name": str, "program": list, "squared": list}, squared=[])
    return LightModel(name, _program_of(name, program), _program_of(name, squared) if squared else None)


def _program_of(name, lines):
    if len(lines) > _MOST_LINES:
        raise not_allowed("program", len(lines), f"at most {_MOST_LINES} lines")
    names = {symbol.name: symbol for symbol in SEEN_BY_A_LIGHT}
    definitions = []
    for line in lines:
        target, equals, text = check_kind("program", line, str, "lines of text").partition("=")
        if not equals:
            raise not_allowed("program", line[:60], "lines such as mu = bumped_z")
        check_name(target.strip())
        expression = parse_expression(text, names)
        names[target.strip()] = real(target.strip())
        definitions.append((names[target.strip()], expression))
    check_operations("program", name, [expression for _, expression in definitions])
    try:
        return Program(name, SEEN_BY_A_LIGHT, definitions, (mu, specular_base))
    except ValueError as error:
        raise not_allowed("program", name, f"{error}") from None


def _parts(what, record, kinds, **defaults):
    """Return the parts of a record, in the order of their kinds."""
    for key in record:
        if key not in kinds:
            raise not_allowed(what, key, f"the parts {', '.join(kinds)}")
    for key in kinds.keys() - record.keys() - defaults.keys():
        raise not_allowed(what, record, f"one with its {key}")
    return [check_kind(f"{what}.{key}", (defaults | record)[key], kind) for key, kind in kinds.items()]
