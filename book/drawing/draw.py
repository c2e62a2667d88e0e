"""Draw the figures that changed, two at a time, say why, and remove what no figure claims."""

import importlib
import pkgutil
import sys
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from itertools import repeat
from multiprocessing import get_context
from pathlib import Path

from tqdm import tqdm

from book.assembly import report, stamps
from book.drawing import keys, save
from book.drawing.registry import FIGURES, Registered

PROCESSES = 2
# Those that take longest begin first, so that no process waits long for the other at the end.
LONGEST = ("eps_sweep", "stability", "u_curve_apart", "certified_bounds", "accuracy_maps", "attribution")


def all_figures() -> dict[str, Registered]:
    """Every figure by its id, in alphabetical order: every module of book/figures is imported."""
    for module in pkgutil.iter_modules([str(stamps.ROOT / "book" / "figures")]):
        importlib.import_module(f"book.figures.{module.name}")
    return dict(sorted(FIGURES.items()))


@dataclass(frozen=True)
class Waiting:
    """A figure to be drawn: the hashes of its sources, and the reason."""

    entry: Registered
    sources: dict[str, str]
    reason: str


def draw(ids: Sequence[str] = (), force: bool = False) -> int:
    """Draw the named figures (all, if none is named) where something changed; the number drawn.

    What a figure raises reaches the caller, with the figure's name in a note.
    """
    figures = all_figures()
    unknown = sorted(set(ids) - figures.keys())
    if unknown:
        raise stamps.Refused(f"no figure is called {', '.join(unknown)}; there are: {', '.join(figures) or 'none'}")
    _remove_unclaimed(figures)
    waiting = []
    for entry in (figures[id] for id in ids or figures):
        now = keys.figure_hashes(entry)
        if reason := "asked for" if force else keys.why_redraw(entry, now):
            waiting.append(Waiting(entry, now, reason))
            stamps.remove(f"figures/{entry.id}")
    bar = tqdm(total=len(waiting), unit="figure", leave=False, disable=not (waiting and sys.stderr.isatty()))
    for family in _drawn(_families(waiting)):
        for one, files, seconds in family:
            stamps.write(f"figures/{one.entry.id}", {"files": files, "sources": one.sources})
            bar.update()
            tqdm.write(f"  drew {one.entry.id} ({one.reason}), {seconds:.1f} s")
    bar.close()
    print(f"  {len(waiting)} drawn, {len(ids or figures) - len(waiting)} up to date")
    return len(waiting)


def _families(waiting: list[Waiting]) -> list[list[Waiting]]:
    """The figures by the module that draws them, whose figures share what they compute; the longest first."""
    families: dict[str, list[Waiting]] = {}
    for one in waiting:
        families.setdefault(keys.source_file(one.entry).stem, []).append(one)
    first = [name for name in LONGEST if name in families]
    return [families[name] for name in (*first, *sorted(families.keys() - {*first}))]


def _drawn(families: list[list[Waiting]]) -> Iterator[list[tuple[Waiting, list[str], float]]]:
    """Draw each family, in one of some processes where there are several; yield it when it is done."""
    if PROCESSES == 1 or len(families) < 2:
        yield from map(_draw_family, families, repeat(keys.GENERATED))
        return
    # Started afresh: a fork would take over locks and threads of the renderer in whatever state they are.
    with ProcessPoolExecutor(PROCESSES, get_context("spawn")) as pool:
        yield from pool.map(_draw_family, families, repeat(keys.GENERATED))


def _draw_family(family: list[Waiting], folder: Path) -> list[tuple[Waiting, list[str], float]]:
    """Draw some figures in this process: each with its files' names and its seconds.

    An error if one read a file of the repository that its key lacks.
    """
    drawn = []
    for one in family:
        start, entry = time.perf_counter(), one.entry
        source = keys.source_file(entry).relative_to(stamps.ROOT).as_posix()
        try:
            with keys.files_read() as seen:
                files = save.save(entry, folder, source, stamps.key(one.sources))
            keys.require(entry, seen, one.sources)
        except Exception as error:
            error.add_note(f"while the figure {entry.id!r} was drawn")
            raise
        drawn.append((one, files, time.perf_counter() - start))
    return drawn


def _remove_unclaimed(figures) -> None:
    """A figure that is no longer registered must not live on in a page."""
    if keys.GENERATED.is_dir():
        for path in keys.GENERATED.iterdir():
            if path.is_file() and path != report.REPORT and path.name.split(".")[0] not in figures:
                print(f"  removed {path.name}: no figure of that id is registered")
                path.unlink()
