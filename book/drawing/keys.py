"""Whether a figure is up to date, and if not, why."""

import inspect
from collections.abc import Iterable
from pathlib import Path

from book.build import stamps
from book.drawing.registry import Registered

GENERATED = stamps.ROOT / "book" / "_generated"
SAVING = Path(__file__).with_name("save.py")  # how a drawing becomes files is a source of every figure


def source_file(entry: Registered) -> Path:
    """The file in which a figure's function stands."""
    return Path(inspect.getsourcefile(inspect.unwrap(entry.draw))).resolve()


def sources(entry: Registered) -> dict[str, str]:
    """The hashes of everything that a figure's pixels and numbers can depend on."""
    data = [stamps.ROOT / name for name in entry.data]
    for path in data:
        if not path.is_file():
            raise FileNotFoundError(f"figure {entry.id!r}: its data {path.relative_to(stamps.ROOT)} is missing")
    code = stamps.reachable(source_file(entry)) | stamps.reachable(SAVING)
    return stamps.hashes([*code, *data, stamps.LOCK_FILE])


def require(entry: Registered, read: Iterable[Path], now: dict[str, str]) -> None:
    """Raise ValueError if a figure read a file of the repository whose hash is not among its sources."""
    unknown = sorted({path.relative_to(stamps.ROOT).as_posix() for path in read} - now.keys())
    if unknown:
        raise ValueError(f"figure {entry.id!r} read {unknown[0]}, which is not in its key: name it in data=[…]")


def why_redraw(entry: Registered, now: dict[str, str]) -> str | None:
    """The reason to draw the figure again, in a few words; None when it is up to date."""
    stamp = stamps.read(f"figures/{entry.id}")
    if stamp is None:
        return "new"
    missing = [name for name in stamp["files"] if not (GENERATED / name).is_file()]
    if missing:
        return f"{missing[0]} is missing"
    before = stamp["sources"]
    changed = [name for name in sorted(before.keys() | now.keys()) if before.get(name) != now.get(name)]
    if not changed:
        return None
    more = f" and {len(changed) - 1} more" if len(changed) > 1 else ""
    return f"{changed[0]} changed{more}"
