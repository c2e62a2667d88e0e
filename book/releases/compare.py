"""What moved between two records: theorems, numbers, pictures. Nothing here judges; `notes` does."""

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from book.releases.pictures import CANVAS, arrays_of
from book.releases.tolerances import is_within
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


def _come_and_gone(before: dict, after: dict, words: Callable[[dict], str], named: bool = False) -> list[Change]:
    """What is in one record alone; named: what is gone must be named."""
    added = [Change(id, "added", words(after[id])) for id in after.keys() - before.keys()]
    return added + [Change(id, "removed", words(before[id]), named) for id in before.keys() - after.keys()]


def _in_order(found: list[Change]) -> list[Change]:
    return sorted(found, key=lambda change: (change.kind, change.id))


def standing(theorem: dict) -> tuple[int, int]:
    """How weak a grade is: its place in the order of grades, then the number of cited lemmas that it is given."""
    grade = theorem["grade"]
    return (STANDING.index(grade) if grade in STANDING else len(STANDING)), len(theorem["given"])


def grade_words(theorem: dict) -> str:
    """The grade as it is read: "proved, given DLMF"."""
    return theorem["grade"] + (f", given {', '.join(theorem['given'])}" if theorem["given"] else "")


def theorems(before: dict, after: dict) -> list[Change]:
    """Theorems added, removed, weakened, strengthened, and stated in other words."""
    found = _come_and_gone(before, after, grade_words, named=True)
    for id in before.keys() & after.keys():
        old, new = before[id], after[id]
        words = f"{grade_words(old)} → {grade_words(new)}"
        if standing(new) != standing(old):
            weaker = standing(new) > standing(old)
            found.append(Change(id, "weakened" if weaker else "strengthened", words, weaker))
        elif new["given"] != old["given"]:
            found.append(Change(id, "restated", words))
        if new["statement"] != old["statement"]:
            found.append(Change(id, "restated", f"“{old['statement']}” → “{new['statement']}”"))
    return _in_order(found)


def numbers(before: dict, after: dict) -> list[Change]:
    """Numbers added, removed and moved; out of tolerance where they moved further than both records allow."""
    found = _come_and_gone(before, after, lambda entry: str(entry["value"]))
    for id in before.keys() & after.keys():
        old, new = before[id]["value"], after[id]["value"]
        if old == new and type(old) is type(new):
            continue
        allowed = before[id]["tolerance"]  # as it was stated: nobody widens it afterwards
        good, stated = is_within(old, new, allowed), f"{allowed:g} relative" if isinstance(allowed, float) else allowed
        words = f"{old} → {new}, {how_far(old, new)}; tolerance {stated or 'exact'}"
        found.append(Change(id, "moved" if good else "out of tolerance", words, not good))
    return _in_order(found)


def how_far(old: int | float | str | bool, new: int | float | str | bool) -> str:
    """The way from one value to another, in per cent or in words."""
    if isinstance(old, str | bool) or isinstance(new, str | bool):
        return "another value"
    if type(old) is not type(new):
        return "another kind of number"
    return f"{100 * (new - old) / abs(old):+.3g} %" if old else "from zero"


def pictures(before: dict, after: dict, kept: Path, generated: Path) -> list[Change]:
    """Pictures added, removed, changed, and drawn otherwise from the same pixels or numbers.

    `kept` is the folder of the release before, `generated` the one with the figures and data as drawn now.
    """
    found = _come_and_gone(before, after, lambda picture: "")
    for id in before.keys() & after.keys():
        old, new = before[id], after[id]
        if old["content"] != new["content"]:
            data = next(name for name in new["files"] if name.endswith((".csv", ".npz")))
            found.append(_changed(id, arrays_of(kept / old["kept"]), arrays_of(generated / data)))
        elif old["files"] != new["files"]:
            names = [n for n in sorted(old["files"] | new["files"]) if old["files"].get(n) != new["files"].get(n)]
            what = "pixels" if new["kept"].endswith(".png") else "numbers"
            found.append(Change(id, "drawn otherwise", f"the same {what}, other bytes: {', '.join(names)}"))
    return _in_order(found)


def _changed(id: str, old: dict[str, np.ndarray], new: dict[str, np.ndarray]) -> Change:
    shapes = [{name: (array.shape, array.dtype.kind) for name, array in arrays.items()} for arrays in (old, new)]
    if shapes[0] != shapes[1]:
        sizes = [", ".join(f"{n} {'×'.join(map(str, a.shape))}" for n, a in arrays.items()) for arrays in (old, new)]
        return Change(id, "changed", f"other arrays: {sizes[0]} → {sizes[1]}")
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


def rms(apart: np.ndarray) -> float:
    return math.sqrt(np.mean(np.square(apart, dtype=float)))
