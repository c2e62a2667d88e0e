"""Records as text, JSON or TOML, read with distrust: a text's author may have meant harm."""

import json
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

LARGEST = 2**16  # bytes of a text
OFF = "off"  # the colour of a light that is off: TOML has no None


@contextmanager
def distrusted(name: str, path: object) -> Iterator[None]:
    """Turn whatever Python raises of a hostile text, or no file at all, into a ValueError of one line that names it."""
    try:
        yield
    except (OSError, ValueError, TypeError, LookupError, AttributeError, RecursionError) as error:
        reason = " ".join(str(getattr(error, "strerror", error)).split())[:200]
        raise ValueError(
            f"{name} = {str(path)!r} is not allowed: a file with a whole record of a scene ({reason})"
        ) from None


def _once(pairs):
    """Return a dict of pairs. Raises ValueError where a key is said twice."""
    record = dict(pairs)
    if len(record) < len(pairs):
        raise ValueError("a key is said twice")
    return record


def _no_number(text):
    raise ValueError(f"{text} is no number")


def read_json(text: bytes) -> Any:
    """Return the value of a JSON text. Raises ValueError or RecursionError; NaN, and a key said twice, are refused."""
    return json.loads(text, object_pairs_hook=_once, parse_constant=_no_number)


def _toml(value):
    """Return a value as TOML says it: an inline table for a dict."""
    match value:
        case dict():
            return "{" + ", ".join(f"{name} = {_toml(part)}" for name, part in value.items()) + "}"
        case list() | tuple():
            return "[" + ", ".join(map(_toml, value)) + "]"
    return json.dumps(OFF if value is None else value)


def toml_of(record: dict[str, Any]) -> str:
    """Return a record as TOML, a line for each of its names."""
    return "".join(f"{name} = {_toml(value)}\n" for name, value in record.items())


def read_toml(path: Any) -> dict[str, Any]:
    """Return the record of a scene that a TOML file says."""
    import tomllib  # which a picture does not need

    with open(Path(path), "rb") as file:  # a number would be an open file's
        text = file.read(LARGEST + 1)
    if len(text) > LARGEST:
        raise ValueError(f"more than {LARGEST} bytes")
    record = tomllib.loads(text.decode("utf-8-sig"))  # as some editors begin a file
    lights = record.get("lights")
    for light in lights if isinstance(lights, list) else ():
        if isinstance(light, dict) and light.get("color") == OFF:
            light["color"] = None
    return record
