"""Draw the figures that changed, two at a time, say why, and remove what no figure claims."""

import sys
import time
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import dataclass
from itertools import repeat
from multiprocessing import get_context
from pathlib import Path

from tqdm import tqdm

from book.build import report, stamps
from book.drawing import keys, save, trace
from book.drawing.discover import all_figures
from book.drawing.registry import Registered, UnknownFigure

PROCESSES = 2
# Those that take longest begin first, so that no process waits long for the other at the end.
LONGEST = (
    "u_curve_apart", "reference_pixels", "accuracy_maps", "eps_sweep", "elementary_ulps", "attribution", "frontiers",
    "stability", "scene_figures", "pole",
)  # fmt: skip


def draw(ids: Sequence[str] = (), force: bool = False) -> int:
    """Draw the named figures (all, if none is named) where something changed; the number drawn.

    What a figure raises reaches the caller, with the figure's name in a note.
    """
    figures = all_figures()
    unknown = sorted(set(ids) - figures.keys())
    if unknown:
        raise UnknownFigure(f"no figure is called {', '.join(unknown)}; there are: {', '.join(figures) or 'none'}")
    _remove_unclaimed(figures)
    waiting = _waiting([figures[id] for id in ids or figures], force)
    bar = tqdm(total=len(waiting), unit="figure", leave=False, disable=not (waiting and sys.stderr.isatty()))
    for one, seconds in _drawn(waiting):
        bar.update()
        tqdm.write(f"  drew {one.entry.id} ({one.reason}), {seconds:.1f} s")
    bar.close()
    print(f"  {len(waiting)} drawn, {len(ids or figures) - len(waiting)} up to date")
    return len(waiting)


@dataclass(frozen=True)
class Waiting:
    """A figure to be drawn: the hashes of its sources, and the reason."""

    entry: Registered
    sources: dict[str, str]
    reason: str


def _waiting(entries: Iterable[Registered], force: bool) -> list[Waiting]:
    """The figures to draw."""
    found = []
    for entry in entries:
        now = keys.sources(entry)
        reason = "asked for" if force else keys.why_redraw(entry, now)
        if reason:
            found.append(Waiting(entry, now, reason))
    return found


def _drawn(waiting: list[Waiting]) -> Iterator[tuple[Waiting, float]]:
    """Draw, and yield each figure with its seconds when it is done."""
    families = _families(waiting)
    for one in waiting:
        stamps.remove(f"figures/{one.entry.id}")
    if PROCESSES == 1 or len(families) < 2:
        done = map(_draw_family, families, repeat(keys.GENERATED))
        yield from (one for family in done for one in _kept(family))
        return
    # Started afresh: a fork would take over locks and threads of the renderer in whatever state they are.
    with ProcessPoolExecutor(PROCESSES, get_context("spawn")) as pool:
        done = [pool.submit(_draw_family, family, keys.GENERATED) for family in families]
        try:
            yield from (one for family in as_completed(done) for one in _kept(family.result()))
        finally:
            pool.shutdown(cancel_futures=True)


def _kept(family: list[tuple[Waiting, list[str], float]]) -> Iterator[tuple[Waiting, float]]:
    """Keep the keys of figures that are drawn."""
    for one, files, seconds in family:
        stamps.write(f"figures/{one.entry.id}", {"files": files, "sources": one.sources})
        yield one, seconds


def _families(waiting: list[Waiting]) -> list[list[Waiting]]:
    """The figures by the module that draws them, whose figures share what they compute; the longest first."""
    families: dict[str, list[Waiting]] = {}
    for one in waiting:
        families.setdefault(keys.source_file(one.entry).stem, []).append(one)
    order = {name: place for place, name in enumerate(LONGEST)}
    return [families[name] for name in sorted(families, key=lambda name: (order.get(name, len(order)), name))]


def _draw_family(family: list[Waiting], folder: Path) -> list[tuple[Waiting, list[str], float]]:
    """Draw some figures in this process: each with its files' names and its seconds.

    An error if one read a file of the repository that its key lacks.
    """
    found = []
    for one in family:
        start, entry = time.perf_counter(), one.entry
        source = keys.source_file(entry).relative_to(stamps.ROOT).as_posix()
        try:
            with trace.files_read() as seen:
                files = save.save(entry, folder, source, stamps.key(one.sources))
            keys.require(entry, seen, one.sources)
        except Exception as error:
            error.add_note(f"while the figure {entry.id!r} was drawn")
            raise
        found.append((one, files, time.perf_counter() - start))
    return found


def _remove_unclaimed(figures) -> None:
    """A figure that is no longer registered must not live on in a page."""
    if keys.GENERATED.is_dir():
        for path in keys.GENERATED.iterdir():
            if path.is_file() and path != report.REPORT and path.name.split(".")[0] not in figures:
                print(f"  removed {path.name}: no figure of that id is registered")
                path.unlink()
