"""Which height field and which model of light: one of kernels.py by its name, or one's own, made at run time.

One's own is a HeightField or a LightModel. `renderer.generate.own`, which makes its kernels, is imported for it alone,
since SymPy and the proofs come with it.
"""

from collections.abc import Callable, Iterable
from typing import Any

from renderer.checks import check_choice
from renderer.kernels import FIELDS, LIGHT_MODELS


def _makers():
    from renderer.generate import own

    return own


def check_own(name: str, value: Any, choices: Iterable[str]) -> Any:
    """Return one of `choices`, or one's own field or model, whose kernels are made. Raises ValueError on the rest."""
    if isinstance(value, str):
        return str(check_choice(name, value, choices))
    own = _makers()
    kind = own.HeightField if name == "field" else own.LightModel
    return own.registered(value) if isinstance(value, kind) else check_choice(name, value, choices)


def check_size(field: Any, ku: float, kv: float, beta: float) -> None:
    """Raise ValueError where a field of one's own is not finite at the wave numbers, or so high that β would not be."""
    if not isinstance(field, str):
        _makers().check_size(field, ku, kv, beta)


def field_kernels(field: Any) -> dict[str, Any]:
    """Return the kernels of a scene's field, as in `kernels.FIELDS`."""
    return FIELDS[field] if isinstance(field, str) else _makers().field_kernels(field)


def model_kernels(model: Any) -> tuple[Callable, Callable | None]:
    """Return the kernels of a scene's model of light, as in `kernels.LIGHT_MODELS`."""
    return LIGHT_MODELS[model] if isinstance(model, str) else _makers().model_kernels(model)


def own_record(own: Any) -> Any:
    """Return what JSON can say of a field or model: its name, or a dict. Raises ValueError where that has no text."""
    return own if isinstance(own, str) else _makers().as_record(own)


def own_from_record(name: str, record: Any) -> Any:
    """Return what a record says, if it is a dict: the inverse of `own_record`. Raises ValueError."""
    return _makers().from_record(name, record) if isinstance(record, dict) else record
