"""Turn a figure's drawing into files: ID.svg and ID.dark.svg, or ID.png; ID.csv or ID.npz; and always ID.json."""

import io
import json
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from book.assembly.stamps import write_whole
from book.drawing.data import data_file
from book.drawing.palette import CSS_PIXELS_PER_INCH
from book.drawing.registry import Drawing, Registered, certified, plain_numbers
from book.drawing.style import styled
from renderer.files.pictures import png_of


def draw_files(entry: Registered) -> tuple[dict[str, bytes], dict]:
    """Draw a figure: its files by suffix, and what its JSON says about them."""
    files, size, kind = {}, None, "numbers"
    with styled():
        drawing = entry.drawn()
        picture = drawing.picture
        if isinstance(picture, Figure):
            size = [round(inches) for inches in picture.get_size_inches() * CSS_PIXELS_PER_INCH]
            files, kind = {".svg": _svg(picture)}, "svg"
        elif getattr(picture, "dtype", None) == np.uint8 and picture.ndim == 3:
            files, size, kind = {".png": png_of(picture)}, [picture.shape[1], picture.shape[0]], "png"
        elif picture is not None:
            raise TypeError(
                f"figure {entry.id!r}: a picture is a Matplotlib figure, a uint8 array (h, w, 3 or 4) or None"
            )
        numbers, data = _content(entry.id, drawing)
    if kind == "svg":
        with styled("dark"):
            again = entry.drawn()
            if _content(entry.id, again) != (numbers, data):
                raise ValueError(f"figure {entry.id!r} gives other numbers when it is drawn again")
            files[".dark.svg"] = _svg(again.picture)
    about = " ".join((entry.draw.__doc__ or "").split("\n\n")[0].split())
    exact = kind == "png" or getattr(picture, "pixel_exact", False)
    description = {"id": entry.id, "about": about, "kind": kind, "size": size, "exact": exact}
    beside = next((f"{entry.id}{suffix}" for suffix in data), None)
    return files | data, description | {"certified": certified(drawing.shown), "data": beside, "numbers": numbers}


def save(entry: Registered, folder: Path, source: str, key: str) -> list[str]:
    """Draw a figure and write its files, the JSON last: it never describes a missing picture."""
    files, description = draw_files(entry)
    for old in folder.glob(f"{entry.id}.*"):
        old.unlink()
    description |= {"source": source, "function": entry.draw.__name__, "key": key, "reads": entry.reads}
    files[".json"] = (json.dumps(description, indent=2, ensure_ascii=False, allow_nan=False) + "\n").encode()
    for suffix, content in files.items():
        write_whole(folder / f"{entry.id}{suffix}", content)
    return [f"{entry.id}{suffix}" for suffix in files]


def _content(id: str, drawing: Drawing) -> tuple[dict, dict[str, bytes]]:
    """A drawing's numbers, and its file of data by suffix."""
    return plain_numbers(id, drawing.numbers), data_file(id, drawing)


def _svg(fig: Figure) -> bytes:
    buffer = io.BytesIO()
    # No date, no creator: the same drawing must give the same bytes.
    fig.savefig(buffer, format="svg", transparent=True, metadata={"Date": None, "Creator": None})
    return buffer.getvalue()
