"""What a figure reads while it is drawn, seen by Python's own audit hook: a check on the key that it is kept by."""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import source_from_cache
from pathlib import Path

from book.build import stamps

_watching: set[Path] | None = None
_hooked = False


@contextmanager
def files_read() -> Iterator[set[Path]]:
    """Yield a set that fills with the repository's files that are opened within the block, modules included.

    Modules that are imported already are not opened again, and other processes are not seen.
    """
    global _watching, _hooked
    if not _hooked:
        sys.addaudithook(_see)  # it can never be removed
        _hooked = True
    _watching = seen = set()
    try:
        yield seen
    finally:
        _watching = None


def _see(event: str, arguments: tuple) -> None:
    if event == "open" and _watching is not None and isinstance(arguments[0], str):
        path = source_of(Path(arguments[0]))
        if path is not None:
            _watching.add(path)


def source_of(path: Path) -> Path | None:
    """The repository's file behind a path (its source for compiled code); None for what is not in the repository."""
    if path.suffix == ".pyc" and path.parent.name == "__pycache__":
        path = Path(source_from_cache(str(path)))
    path = path.absolute()
    try:
        parts = path.relative_to(stamps.ROOT).parts
    except ValueError:
        return None
    ours = parts and parts[0] in stamps.PACKAGES and not stamps.PRODUCTS.intersection(parts)
    return path if ours and path.is_file() and not path.name.startswith(".") else None
