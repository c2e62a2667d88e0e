"""What moved between two records: theorems, numbers, pictures. Nothing here judges; `notes` does."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from book.releases.pictures import CANVAS, arrays_of, data_name
from book.releases.record import is_within
from renderer.picture.differences import rms
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
    """What is in one record alone, in `words`, and `both(id, old, new)` of the rest; named: what is gone must be."""
    changes = [Change(id, "added", words(after[id])) for id in after.keys() - before.keys()]
    changes += [Change(id, "removed", words(before[id]), named) for id in before.keys() - after.keys()]
    for id in before.keys() & after.keys():
        changes += both(id, before[id], after[id])
    return sorted(changes, key=lambda change: (change.kind, change.id))


def standing(theorem: dict) -> tuple[int, int]:
    """How weak a grade is: its place in the order of grades, then the number of cited lemmas that it is given."""
    grade = theorem["grade"]
    return (STANDING.index(grade) if grade in STANDING else len(STANDING)), len(theorem["given"])


def grade_words(theorem: dict) -> str:
    """The grade as it is read: "proved, given DLMF"."""
    return theorem["grade"] + (f", given {', '.join(theorem['given'])}" if theorem["given"] else "")


def theorems(before: dict, after: dict) -> list[Change]:
    """Theorems added, removed, weakened, strengthened, and stated in other words."""
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


def numbers(before: dict, after: dict) -> list[Change]:
    """Numbers added, removed and moved; out of tolerance where they moved further than the older record allows."""
    return _compared(before, after, lambda entry: str(entry["value"]), _number)


def _number(id: str, before: dict, after: dict) -> Iterator[Change]:
    old, new = before["value"], after["value"]
    if old == new and type(old) is type(new):
        return
    allowed = before["tolerance"]  # as it was stated: nobody widens it afterwards
    good, stated = is_within(old, new, allowed), f"{allowed:g} relative" if isinstance(allowed, float) else allowed
    words = f"{old} → {new}, {how_far(old, new)}; tolerance {stated or 'exact'}"
    yield Change(id, "moved" if good else "out of tolerance", words, not good)


def how_far(old: int | float | str, new: int | float | str) -> str:
    """The way from one value to another, in per cent or in words."""
    if isinstance(old, str) or isinstance(new, str):
        return "another value"
    if type(old) is not type(new):
        return "another kind of number"
    return f"{100 * (new - old) / abs(old):+.3g} %" if old else "from zero"


def pictures(before: dict, after: dict, archived: Path, generated: Path) -> list[Change]:
    """Pictures added, removed, changed, and drawn otherwise from the same pixels or numbers.

    `archived` is the folder of the release before, `generated` the one with the figures and data as drawn now.
    """

    def picture(id, old, new):
        if old["content"] != new["content"]:
            yield _changed(id, arrays_of(archived / old["kept"]), arrays_of(generated / data_name(new)))
        elif old["files"] != new["files"]:
            names = sorted({name for name, _ in old["files"].items() ^ new["files"].items()})
            what = "pixels" if new["kept"].endswith(".png") else "numbers"
            yield Change(id, "drawn otherwise", f"the same {what}, other bytes: {', '.join(names)}")

    return _compared(before, after, lambda picture: "", picture)


def _changed(id: str, old: dict[str, np.ndarray], new: dict[str, np.ndarray]) -> Change:
    before, after = (
        ", ".join(f"{name} {'×'.join(map(str, array.shape))} {array.dtype.kind}" for name, array in arrays.items())
        for arrays in (old, new)
    )
    if before != after:
        return Change(id, "changed", f"other arrays: {before} → {after}")
    if CANVAS in old:
        apart = np.abs(old[CANVAS].astype(int) - new[CANVAS]).max(axis=2)
        words = f"largest difference {apart.max()}/255, RMS {rms(apart):.3g}/255, {np.count_nonzero(apart):,} of "
        words += f"{apart.size:,} pixels; the difference, largest white: {id}.png beside these notes"
        return Change(id, "changed", words, difference=(apart * 255 // apart.max()).astype(np.uint8))
    apart = np.concatenate([relative(old[name], new[name]).ravel() for name in old])
    words = f"largest difference {apart.max():.3g} relative, RMS {rms(apart):.3g}, {np.count_nonzero(apart):,} of "
    return Change(id, "changed", f"{words}{apart.size:,} plotted numbers")


def relative(old: np.ndarray, new: np.ndarray) -> np.ndarray:
    """The differences relative to the larger of two values; 1 where words, or one NaN, differ."""
    if old.dtype.kind == "U":
        return (old != new).astype(float)
    old, new = old.astype(float), new.astype(float)
    scale = np.maximum(np.abs(old), np.abs(new))
    with np.errstate(invalid="ignore", divide="ignore"):
        apart = np.where(old == new, 0.0, np.abs(old - new) / scale)
    return np.where(np.isnan(old) & np.isnan(new), 0.0, np.nan_to_num(apart, nan=1.0, posinf=1.0))
