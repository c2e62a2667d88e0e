"""Height fields of a scene: one of kernels.py by its name, or a custom HeightField, made at run time.

`renderer.generate.custom_fields`, which makes a custom field's kernels, is imported for it alone, since SymPy and the
proofs come with it.
"""

from collections.abc import Iterable
from typing import Any

from renderer.checks import not_allowed
from renderer.kernels import FIELDS


def _makers():
    from renderer.generate import custom_fields

    return custom_fields


def check_field(name: str, value: Any, choices: Iterable[str]) -> Any:
    """Return one of `choices`, or a custom field, whose kernels are made. Raises ValueError on the rest."""
    if isinstance(value, str) and value in choices:
        return str(value)
    makers = _makers()
    if isinstance(value, makers.height_fields.HeightField):
        return makers.made_field(value)
    raise not_allowed(name, value, f"one of {', '.join(map(repr, choices))}, or HeightField(name, formula)")


def check_size(field: Any, ku: float, kv: float, beta: float, steeper: float = 1.0) -> None:
    """Raise ValueError where a custom field is not finite at the wave numbers, or so high that β would not be."""
    if not isinstance(field, str):
        _makers().check_size(field, ku, kv, beta, steeper)


def field_kernels(field: Any) -> dict[str, Any]:
    """Return the kernels of a scene's field, as in `kernels.FIELDS`."""
    return FIELDS[field] if isinstance(field, str) else _makers().field_kernels(field)


def parameters(field: Any) -> dict[str, float]:
    """Return the numbers of a custom field's parameters, by name."""
    return dict(getattr(field, "parameters", ()))


def field_record(field: Any) -> Any:
    """Return a field as JSON can say it: its name, or a dict. Raises ValueError where its formula has no text."""
    return field if isinstance(field, str) else _makers().as_record(field)


def field_from_record(record: Any) -> Any:
    """Return the field of a record, if it is a dict: the inverse of `field_record`. Raises ValueError."""
    return _makers().from_record(record) if isinstance(record, dict) else record
