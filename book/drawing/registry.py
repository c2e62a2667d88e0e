"""Registry of figures: each is a registered function that returns a `Drawing`.

    @figure
    def eps_sweep() -> Drawing:
        \"\"\"RMS of the difference on A against the step.\"\"\"
        ...
        return Drawing(fig, numbers={"rms_1e-3": 0.0121})

A picture is a Matplotlib figure (in the colours of `book.drawing.palette`, which the dark page has its own of), or a
uint8 array (height, width, 3 or 4), or None where only the numbers are wanted.
`data` are the arrays that the picture shows, by name; its curves are kept by themselves (`book/drawing/save.py`).
Both may be nested: {"sine": {"rms": 0.1}} is the number sine_rms. A number that is an `Interval` is kept with its ends,
rms_lower and rms_upper, and a page prints what is certain of it. `shown` are the frames with bounds whose colours one
sees: the line of provenance says what is certain of them.
"""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from renderer.intervals import Interval, rounded_up
from renderer.picture.frame import Frame
from verify.evidence.records import RECORDS, read


@dataclass(frozen=True)
class Drawing:
    """A picture, the numbers that its caption and the prose cite, the arrays and the frames that it shows."""

    picture: Any = None
    numbers: Mapping[str, Any] = field(default_factory=dict)
    data: Mapping[str, Any] = field(default_factory=dict)
    shown: Sequence[Frame] = ()


@dataclass(frozen=True)
class Registered:
    """A figure's id, the function that draws it, and the records that this is given."""

    id: str
    draw: Callable[..., Drawing]
    records: Sequence[str] = ()

    @property
    def reads(self) -> list[str]:
        """The files that it is drawn from beside code, by path from the root."""
        return [RECORDS[name].path for name in self.records]

    def drawn(self) -> Drawing:
        return self.draw(*map(read, self.records))


FIGURES: dict[str, Registered] = {}


def figure(id: str | Callable[[], Drawing] | None = None, record: str = "") -> Callable:
    """Register the decorated function under its own name or, as @figure("id"), under an id.

    record: names of records of `verify`, which the function is given; it reads no other file.
    """
    if callable(id):
        return figure()(id)

    def register(draw: Callable[..., Drawing]) -> Callable[..., Drawing]:
        name = id or draw.__name__
        if name in FIGURES:
            other = FIGURES[name].draw
            raise ValueError(f"figure id {name!r} is taken by {other.__module__}.{other.__qualname__}")
        if not draw.__doc__:
            raise ValueError(f"figure {name!r}: its function needs a docstring that says what it draws")
        FIGURES[name] = Registered(name, draw, record.split())
        return draw

    return register


def flat(values: Mapping[str, Any], front: str = "") -> Iterator[tuple[str, Any]]:
    """Yield (name, value) of a mapping, the names of nested ones joined by _, an Interval with its ends."""
    for name, value in values.items():
        if isinstance(value, Mapping):
            yield from flat(value, f"{front}{name}_")
        elif isinstance(value, Interval):
            ends = {f"{name}_lower": value.lower, f"{name}_upper": value.upper}
            yield from flat({name: value.value} | ends, front)
        else:
            yield f"{front}{name}", value


def plain_numbers(id: str, numbers: Mapping[str, Any]) -> dict[str, int | float | str]:
    """Return the numbers as plain Python values; an error names the figure and the key."""
    plain = {key: value.tolist() if hasattr(value, "tolist") else value for key, value in flat(numbers)}
    for key, value in plain.items():
        is_number = isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)
        if not is_number and not isinstance(value, str):
            raise ValueError(f"figure {id!r}: number {key!r} is {value!r}; give a finite number or a str")
    return plain


def certified(shown: Sequence[Frame]) -> dict[str, float | int] | None:
    """Return how far a colour of frames is at most from exact arithmetic, two digits, and the pixels without a bound.

    A pixel that is open, or whose bound is a hundredth of the scale, is one of the latter. None where none is shown.
    """
    if not shown:
        return None
    bounds = np.concatenate([np.maximum(frame.bounds.max(axis=2), frame.open).ravel() for frame in shown])
    limited = bounds[bounds < 0.01]
    within = float(rounded_up(limited.max(), 2))
    return {"within": within, "undecided": bounds.size - limited.size, "pixels": bounds.size}
