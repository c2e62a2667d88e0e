"""Whether figures are up to date, and if not, why: each is kept by the hashes of all that it can depend on."""

import inspect
from pathlib import Path

from book.assembly import stamps
from book.drawing.registry import Registered
from verify.sources import difference

GENERATED = stamps.ROOT / "book" / "_generated"
SAVING = Path(__file__).with_name("save.py")  # how a drawing becomes files is a source of every figure


def source_file(entry: Registered) -> Path:
    return Path(inspect.getsourcefile(entry.draw)).resolve()


def figure_hashes(entry: Registered) -> dict[str, str]:
    """The hashes of everything that a figure's pixels and numbers can depend on."""
    code = stamps.reachable(source_file(entry)) | stamps.reachable(SAVING)
    return stamps.hashes([*code, *map(stamps.ROOT.joinpath, entry.reads), stamps.LOCK_FILE])


def why_redraw(entry: Registered, now: dict[str, str]) -> str | None:
    """The reason to draw the figure again, in a few words; None when it is up to date."""
    stamp = stamps.read(f"figures/{entry.id}")
    if stamp is None:
        return "new"
    missing = [name for name in stamp["files"] if not (GENERATED / name).is_file()]
    return f"{missing[0]} is missing" if missing else difference(stamp["sources"], now)
