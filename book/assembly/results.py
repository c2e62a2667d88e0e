"""The numbers that pages cite, from figures' and committed benchmarks' JSON: how they are asked for and written."""

import re
from pathlib import Path

from book.assembly.stamps import table_in
from renderer.intervals import Interval
from verify.evidence import records

BENCHMARK_PREFIX = "bench:"
SYNTAX = re.compile(r"(?P<id>(?:bench:)?\w+)\.(?P<key>[^\s|]+)(?:\s*[|\s]\s*(?P<format>\S+))?")
E_NOTATION = re.compile(r"(?P<mantissa>[+-]?\d+(?:\.\d+)?)e(?P<exponent>[+-]\d+)")


class UnknownResult(ValueError):
    """A page asks for a figure, a benchmark or a number that is not there."""


def result_file(book: Path, id: str) -> Path:
    """Return the JSON file behind an id; ids with the prefix `bench:` are committed benchmarks."""
    name = id.removeprefix(BENCHMARK_PREFIX)
    if id.startswith(BENCHMARK_PREFIX):
        record = records.RECORDS.get(name)
        folder, kind = book.parent / (record.folder if record else records.BENCHMARKS), "benchmark"
    else:
        folder, kind = book / "_generated", "figure"
    path = folder / f"{name}.json"
    if "/" in name or not path.is_file():
        names = ", ".join(sorted(other.stem for other in folder.glob("*.json"))) or "none"
        raise UnknownResult(f"unknown {kind} {name!r}; there are: {names}")
    return path


def load_result(book: Path, id: str) -> dict:
    return table_in(result_file(book, id))


def records_of(book: Path, id: str) -> list[str]:
    """Return the names of the records that an id's numbers come from: none for a figure that the build computes."""
    read = {result_file(book, id).relative_to(book.parent).as_posix(), *load_result(book, id).get("reads", ())}
    return [name for name, record in records.RECORDS.items() if record.path in read]


def remark(book: Path, id: str) -> str | None:
    """Return the remark beside the numbers of an id where the code has changed since they were measured; or None."""
    return "; ".join(filter(None, map(records.remark, records_of(book, id)))) or None


def look_up(book: Path, id: str, key: str) -> int | float | str | Interval:
    """Return one number, an Interval where its ends are kept; an unknown key's error lists the known ones."""
    numbers = load_result(book, id).get("numbers", {})
    if key not in numbers:
        raise UnknownResult(f"{id!r} has no number {key!r}; it has: {', '.join(sorted(numbers)) or 'none'}")
    if f"{key}_lower" in numbers:
        return Interval(numbers[key], numbers[f"{key}_lower"], numbers[f"{key}_upper"])
    return numbers[key]


def parse(text: str) -> tuple[str, str, str | None]:
    """Return the id, the key and the format (None if there is none) that a role's text asks for."""
    match = SYNTAX.fullmatch(text.strip())
    if match is None:
        raise UnknownResult(f"{text!r} is not of the form id.key or id.key|format")
    return match["id"], match["key"], match["format"]


def formatted(value: int | float | str | Interval, spec: str | None = None) -> str:
    """Return the value as text, by default with four significant digits for a float, all certain ones for an Interval.

    Raises ValueError where the format asks for digits of an Interval that are not certain.
    """
    if spec is None:
        spec = ".4g" if isinstance(value, float) else ""
    return format(value, spec)


def measured(book: Path, name: str) -> str:
    """Return the sentence that says where, when and at which commit a benchmark was measured."""
    id = f"{BENCHMARK_PREFIX}{name}"
    label, since = load_result(book, id)["label"], "; the code has changed since" if remark(book, id) else ""
    return f"Measured on {label['machine']}, {label['date']}, at commit {label['commit']}{since}."
