"""Whether figures are up to date, and if not, why: each is kept by the hashes of all that it can depend on.

Python's audit hook sees what a figure reads while it is drawn: a check on that key.
"""

import inspect
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from importlib.util import source_from_cache
from pathlib import Path

from book.assembly import check, stamps
from book.drawing.registry import Registered
from verify.sources import difference

GENERATED = stamps.ROOT / "book" / "_generated"
SAVING = Path(__file__).with_name("save.py")  # how a drawing becomes files is a source of every figure
_watching: set[Path] | None = None


def all_sources() -> dict[str, str]:
    """The hashes of all code and data in the repository that a figure could reach, found without importing one."""
    return stamps.hashes(check.checked_files())


def nothing_changed() -> bool:
    """True when everything is as it was when the figures were last seen to be up to date."""
    return stamps.read("figures") == {"sources": all_sources(), "drawn": _drawn()}


def remember(before: dict[str, str]) -> None:
    """Note that the figures agree with these sources, hashed before any figure was drawn."""
    stamps.write("figures", {"sources": before, "drawn": _drawn()})


def _drawn() -> dict[str, str]:
    return stamps.hashes(GENERATED.iterdir() if GENERATED.is_dir() else ())


def source_file(entry: Registered) -> Path:
    return Path(inspect.getsourcefile(inspect.unwrap(entry.draw))).resolve()


def figure_hashes(entry: Registered) -> dict[str, str]:
    """The hashes of everything that a figure's pixels and numbers can depend on."""
    data = [stamps.ROOT / name for name in entry.data]
    for path in data:
        if not path.is_file():
            raise FileNotFoundError(f"figure {entry.id!r}: its data {path.relative_to(stamps.ROOT)} is missing")
    code = stamps.reachable(source_file(entry)) | stamps.reachable(SAVING)
    return stamps.hashes([*code, *data, stamps.LOCK_FILE])


def why_redraw(entry: Registered, now: dict[str, str]) -> str | None:
    """The reason to draw the figure again, in a few words; None when it is up to date."""
    stamp = stamps.read(f"figures/{entry.id}")
    if stamp is None:
        return "new"
    missing = [name for name in stamp["files"] if not (GENERATED / name).is_file()]
    if missing:
        return f"{missing[0]} is missing"
    return difference(stamp["sources"], now)


def require(entry: Registered, read: Iterable[Path], now: dict[str, str]) -> None:
    """Raise ValueError if a figure read a file of the repository whose hash is not among its sources."""
    unknown = sorted({path.relative_to(stamps.ROOT).as_posix() for path in read} - now.keys())
    if unknown:
        raise ValueError(f"figure {entry.id!r} read {unknown[0]}, which is not in its key: name it in data=[…]")


@contextmanager
def files_read() -> Iterator[set[Path]]:
    """Yield a set that fills with the repository's files that are opened within the block, modules included.

    Modules that are imported already are not opened again, and other processes are not seen.
    """
    global _watching
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


sys.addaudithook(_see)  # it can never be removed


def source_of(path: Path) -> Path | None:
    """The repository's file behind a path (its source for compiled code); None for what is not in the repository."""
    if path.suffix == ".pyc" and path.parent.name == "__pycache__":
        path = Path(source_from_cache(str(path)))
    path = path.absolute()
    parts = path.relative_to(stamps.ROOT).parts if path.is_relative_to(stamps.ROOT) else ()
    ours = parts and parts[0] in stamps.PACKAGES and not stamps.PRODUCTS.intersection(parts)
    return path if ours and path.is_file() and not path.name.startswith(".") else None
