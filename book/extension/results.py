"""Find the numbers that pages cite: drawn figures' JSON, and committed benchmark JSON."""

import json
from pathlib import Path

from verify import records

BENCHMARK_PREFIX = "bench:"


class UnknownResult(ValueError):
    """A page asks for a figure, a benchmark or a number that is not there."""


def result_file(book: Path, id: str) -> Path:
    """The JSON file behind an id; ids with the prefix `bench:` are committed benchmarks."""
    if id.startswith(BENCHMARK_PREFIX):
        folder, what = book.parent / "verify" / "benchmark" / "results", "benchmark"
    else:
        folder, what = book / "_generated", "figure"
    name = id.removeprefix(BENCHMARK_PREFIX)
    path = folder / f"{name}.json"
    if "/" in name or not path.is_file():
        known = ", ".join(sorted(other.stem for other in folder.glob("*.json"))) or "none"
        raise UnknownResult(f"unknown {what} {name!r}; there are: {known}")
    return path


def load_result(book: Path, id: str) -> dict:
    return json.loads(result_file(book, id).read_text(encoding="utf-8"))


def remark(book: Path, id: str) -> str | None:
    """What has to be said beside the numbers of an id where the code has changed since they were measured; or None."""
    read = {result_file(book, id).relative_to(book.parent).as_posix(), *load_result(book, id).get("reads", ())}
    said = [records.remark(name) for name, record in records.RECORDS.items() if record.path in read]
    return "; ".join(filter(None, said)) or None


def look_up(book: Path, id: str, key: str) -> int | float | str | bool:
    """One number; an unknown key's error lists the known ones."""
    numbers = load_result(book, id).get("numbers", {})
    if key not in numbers:
        raise UnknownResult(f"{id!r} has no number {key!r}; it has: {', '.join(sorted(numbers)) or 'none'}")
    return numbers[key]
