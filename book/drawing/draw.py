"""The drawing of figures that changed, two at a time, with the reason, and the removal of files of none.

Each is kept by the hashes of all that it can depend on.
"""

import importlib
import inspect
import pkgutil
import signal
import time
from collections.abc import Iterable, Sequence
from concurrent.futures import ProcessPoolExecutor
from itertools import repeat
from multiprocessing import active_children, get_context
from pathlib import Path

from book.assembly import report, stamps
from book.drawing import save
from book.drawing.registry import FIGURES, Registered
from proofs.engine.project import PROJECT
from verify.evidence.sources import difference

GENERATED = PROJECT.generated
PROCESSES = 2
Waiting = tuple[Registered, dict[str, str], str]
"""A figure to be drawn, the hashes of its sources, and the reason."""


def all_figures() -> dict[str, Registered]:
    """Return every figure by its id, in alphabetical order; import every module of the project's figures for it."""
    for module in pkgutil.iter_modules([str(PROJECT.folder(PROJECT.figures))]):
        importlib.import_module(f"{PROJECT.figures}.{module.name}")
    return dict(sorted(FIGURES.items()))


def draw(ids: Sequence[str] = (), force: bool = False) -> int:
    """Draw the named figures (all, if none is named) where something changed; the number drawn.

    What a figure raises reaches the caller, with the figure's name in a note.
    """
    figures = all_figures()
    unknown = sorted(set(ids) - figures.keys())
    if unknown:
        raise stamps.Refused(f"no figure is called {', '.join(unknown)}; there are: {', '.join(figures) or 'none'}")
    _remove_unclaimed(figures)
    families: dict[str, list[Waiting]] = {}  # by their modules: a family shares what it computes
    for entry in (figures[id] for id in ids or figures):
        now = figure_hashes(entry)
        if reason := "asked for" if force else why_redraw(entry, now):
            families.setdefault(source_file(entry).stem, []).append((entry, now, reason))
            stamps.write(f"figures/{entry.id}", {})  # begun
    # The slowest families begin first, so that no process waits long for the other at the end.
    waiting = [families[name] for name in sorted(families, key=PROJECT.slowest.__contains__, reverse=True)]
    # Started afresh: a fork would take over locks and threads of the renderer in whatever state they are.
    with ProcessPoolExecutor(PROCESSES, get_context("spawn")) as pool:
        run = pool.map if PROCESSES > 1 and len(waiting) > 1 else map
        interrupt = signal.signal(
            signal.SIGINT, signal.SIG_IGN
        )  # processes begun now inherit this; they are ended below
        results = run(_draw_family, waiting, repeat(GENERATED))
        signal.signal(signal.SIGINT, interrupt)
        try:
            for family, drawn in zip(waiting, results, strict=True):
                for (entry, sources, reason), (files, seconds) in zip(family, drawn, strict=True):
                    stamps.write(f"figures/{entry.id}", {"files": files_of(files), "sources": sources})
                    print(f"  drew {entry.id} ({reason}), {seconds:.1f} s", flush=True)
        except KeyboardInterrupt:
            for child in active_children():
                child.terminate()
            raise
    count = sum(map(len, waiting))
    print(f"  {count} drawn, {len(ids or figures) - count} up to date")
    return count


def _draw_family(family: list[Waiting], folder: Path) -> list[tuple[list[str], float]]:
    """Draw some figures in this process: of each the names of its files, and the seconds."""
    drawn = []
    for entry, sources, _ in family:
        start, source = time.perf_counter(), source_file(entry).relative_to(stamps.ROOT)
        try:
            files = save.save(entry, folder, source.as_posix(), stamps.key(sources))
        except Exception as error:
            error.add_note(f"while the figure {entry.id!r} was drawn")
            raise
        drawn.append((files, time.perf_counter() - start))
    return drawn


def _remove_unclaimed(figures) -> None:
    """Remove the files of figures that are no longer registered, lest a page still shows them."""
    for path in GENERATED.glob("*.*"):
        if path != report.REPORT and path.name.split(".")[0] not in figures:
            print(f"  removed {path.name}: no figure of that id is registered")
            path.unlink()


def source_file(entry: Registered) -> Path:
    return Path(inspect.getsourcefile(entry.draw)).resolve()


def figure_hashes(entry: Registered) -> dict[str, str]:
    """Return the hashes of everything that a figure's pixels and numbers can depend on."""
    code = stamps.reachable(source_file(entry)) | stamps.reachable(Path(save.__file__))
    return stamps.hashes([*code, *map(stamps.ROOT.joinpath, entry.reads), stamps.LOCK_FILE])


def files_of(names: Iterable[str]) -> dict[str, str]:
    """Return the hash of each of a figure's files, by its name; nothing of one that is missing."""
    return stamps.file_hashes(map(GENERATED.joinpath, names), root=GENERATED)


def why_redraw(entry: Registered, now: dict[str, str]) -> str | None:
    """Return the reason to draw the figure again, in a few words; None when it is up to date."""
    stamp = stamps.read(f"figures/{entry.id}")
    if not stamp:
        return "new" if stamp is None else "interrupted"
    return difference(stamp["sources"], now) or difference(stamp["files"], files_of(stamp["files"]))
