"""Differences of two records: theorems, numbers, pictures. Nothing here judges; `notes` does."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from book.releases.pictures import CANVAS, archived, arrays_of
from book.releases.record import is_within
from renderer.intervals import rms
from verify.checkers.grades import STANDING


@dataclass(frozen=True)
class Change:
    """One thing that moved: its id, what happened to it in a word, and the words for the notes.

    difference: of a picture, its pixels (height, width) uint8, where there are some.
    """

    id: str
    kind: str
    words: str
    must_be_named: bool = False
    difference: np.ndarray | None = field(default=None, compare=False)


def _compared(
    before: dict, after: dict, words: Callable[[dict], str], both: Callable[..., Iterator[Change]], named: bool = False
) -> list[Change]:
    """Return the entries of one record alone, in `words`, and `both(id, old, new)` of the rest.

    named: whether release notes have to name what is gone.
    """
    changes = [Change(id, "added", words(after[id])) for id in after.keys() - before.keys()]
    changes += [Change(id, "removed", words(before[id]), named) for id in before.keys() - after.keys()]
    for id in before.keys() & after.keys():
        changes += both(id, before[id], after[id])
    return sorted(changes, key=lambda change: (change.kind, change.id))


def standing(theorem: dict) -> tuple[int, int]:
    """Return a grade's weakness: its place in the order of grades, then the number of cited lemmas that it is given."""
    grade = theorem["grade"]
    return (STANDING.index(grade) if grade in STANDING else len(STANDING)), len(theorem["given"])


def grade_words(theorem: dict) -> str:
    """Return the grade as it is read: "proved, given DLMF"."""
    return theorem["grade"] + (f", given {', '.join(theorem['given'])}" if theorem["given"] else "")


def theorems(before: dict, after: dict) -> list[Change]:
    """Return the theorems added, removed, weakened, strengthened, and stated in other words."""
    return _compared(before, after, grade_words, _theorem, named=True)


def _theorem(id: str, old: dict, new: dict) -> Iterator[Change]:
    words = f"{grade_words(old)} → {grade_words(new)}"
    if standing(new) != standing(old):
        weaker = standing(new) > standing(old)
        yield Change(id, "weakened" if weaker else "strengthened", words, weaker)
    elif new["given"] != old["given"]:
        yield Change(id, "restated", words)
    if new["statement"] != old["statement"]:
        yield Change(id, "restated", f"“{old['statement']}” → “{new['statement']}”")
    if moved := sorted(dict(old.get("says", new.get("says", {})).items() ^ new.get("says", {}).items())):
        yield Change(id, "restated", f"said by other {', '.join(moved)}")


def numbers(before: dict, after: dict) -> list[Change]:
    """Return the numbers added, removed and moved; out of tolerance if further than the older record allows."""
    return _compared(before, after, lambda entry: str(entry["value"]), _number)


def _number(id: str, before: dict, after: dict) -> Iterator[Change]:
    old, new = before["value"], after["value"]
    if old == new and type(old) is type(new):
        return
    allowed = before["tolerance"]  # as it was stated: nobody widens it afterwards
    good, stated = is_within(old, new, allowed), f"{allowed:g} relative" if isinstance(allowed, float) else allowed
    numeric = old and isinstance(old, int | float) and isinstance(new, int | float)
    far = f", {100 * (new - old) / abs(old):+.3g} %" if numeric else ""
    words = f"{old} → {new}{far}; tolerance {stated or 'exact'}"
    yield Change(id, "moved" if good else "out of tolerance", words, not good)


def pictures(before: dict, after: dict, folder: Path, generated: Path) -> list[Change]:
    """Return the pictures added, removed and changed.

    `folder` is that of the release before, `generated` the one with the figures and data as drawn now.
    """

    def picture(id, old, new):
        if old["content"] != new["content"]:
            yield _changed(id, archived(folder, id), generated / new["data"])

    return _compared(before, after, lambda picture: "", picture)


def _changed(id: str, before: Path, after: Path) -> Change:
    if not before.is_file():
        return Change(
            id, "changed", "its pixels or plotted numbers; a build of the older version's tag has those before"
        )
    old, new = arrays_of(before)[CANVAS], arrays_of(after).get(CANVAS, np.empty(0))
    if old.shape != new.shape:
        return Change(id, "changed", f"another size: {old.shape} → {new.shape}")
    apart = np.abs(old.astype(int) - new).max(axis=2)
    words = f"largest difference {apart.max()}/255, RMS {rms(apart):.3g}/255, {np.count_nonzero(apart):,} of "
    words += f"{apart.size:,} pixels; the difference, largest white: {id}.png beside these notes"
    return Change(id, "changed", words, difference=(apart * 255 // apart.max()).astype(np.uint8))
