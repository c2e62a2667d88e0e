"""Draw the figures that changed, say why, and remove what no figure claims."""

import sys
import time
from collections.abc import Iterable, Sequence

from tqdm import tqdm

from book.build import report, stamps
from book.drawing import keys, save, trace
from book.drawing.discover import all_figures
from book.drawing.registry import Registered, UnknownFigure


def draw(ids: Sequence[str] = (), force: bool = False) -> int:
    """Draw the named figures (all, if none is named) where something changed; the number drawn."""
    figures = all_figures()
    unknown = sorted(set(ids) - figures.keys())
    if unknown:
        raise UnknownFigure(f"no figure is called {', '.join(unknown)}; there are: {', '.join(figures) or 'none'}")
    _remove_unclaimed(figures)
    waiting = _waiting([figures[id] for id in ids or figures], force)
    bar = tqdm(waiting, unit="figure", leave=False, disable=not (waiting and sys.stderr.isatty()))
    for entry, now, reason in bar:
        bar.set_description(entry.id)
        start = time.perf_counter()
        _draw_one(entry, now)
        tqdm.write(f"  drew {entry.id} ({reason}), {time.perf_counter() - start:.1f} s")
    print(f"  {len(waiting)} drawn, {len(ids or figures) - len(waiting)} up to date")
    return len(waiting)


def _waiting(entries: Iterable[Registered], force: bool) -> list[tuple[Registered, dict[str, str], str]]:
    """The figures to draw, each with the hashes of its sources and the reason."""
    found = []
    for entry in entries:
        now = keys.sources(entry)
        reason = "asked for" if force else keys.why_redraw(entry, now)
        if reason:
            found.append((entry, now, reason))
    return found


def _draw_one(entry: Registered, now: dict[str, str]) -> None:
    """Draw a figure and keep its key; an error if it read a file of the repository that its key lacks."""
    stamps.remove(f"figures/{entry.id}")
    source = keys.source_file(entry).relative_to(stamps.ROOT).as_posix()
    with trace.files_read() as seen:
        files = save.save(entry, keys.GENERATED, source, stamps.key(now))
    keys.require(entry, seen, now)
    stamps.write(f"figures/{entry.id}", {"files": files, "sources": now})


def _remove_unclaimed(figures) -> None:
    """A figure that is no longer registered must not live on in a page."""
    if keys.GENERATED.is_dir():
        for path in keys.GENERATED.iterdir():
            if path.is_file() and path != report.REPORT and path.name.split(".")[0] not in figures:
                print(f"  removed {path.name}: no figure of that id is registered")
                path.unlink()
