"""Turn a figure's drawing into files: ID.svg and ID.dark.svg, or ID.png; ID.csv or ID.npz; and always ID.json.

The numbers behind a picture lie beside it: ID.csv for columns of one length, ID.npz for anything else. What a drawing
hands over as `data` is kept under its names; the pixels of `panels` and of renders are added to it as picture_1,
picture_2 … A curve that is drawn and not handed over is an error, so that the file is what one sees.
"""

import csv
import io
import json
from collections.abc import Iterable, Mapping
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from book.assembly.stamps import write_whole
from book.drawing.palette import CSS_PIXELS_PER_INCH, for_dark
from book.drawing.registry import Drawing, Registered, certified, flat, plain_numbers
from book.drawing.style import styled
from renderer.files.pictures import png_of

SUFFIXES = (".csv", ".npz")
MOST_BYTES = 512 * 1024  # of a file of numbers; where floats would take more, the picture's 8 bits are its data
FEWEST_POINTS = 5  # of a line that counts as a curve: less has the marks of a label, a leader or a slope triangle


def draw_files(entry: Registered) -> tuple[dict[str, bytes], dict]:
    """Draw a figure: its files by suffix, and what its JSON says about them."""
    files, size, kind = {}, None, "numbers"
    with styled():
        drawing = entry.drawn()
        picture = drawing.picture
        if isinstance(picture, Figure):
            size, kind = [round(inches) for inches in picture.get_size_inches() * CSS_PIXELS_PER_INCH], "svg"
            svg = _svg(picture)
            files = {".svg": svg.encode(), ".dark.svg": for_dark(svg).encode()}
        elif getattr(picture, "dtype", None) == np.uint8 and picture.ndim == 3:
            files, size, kind = {".png": png_of(picture)}, [picture.shape[1], picture.shape[0]], "png"
        elif picture is not None:
            raise TypeError(
                f"figure {entry.id!r}: a picture is a Matplotlib figure, a uint8 array (h, w, channels) or None"
            )
    data, numbers = data_file(entry.id, drawing), plain_numbers(entry.id, drawing.numbers)
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


def _svg(fig: Figure) -> str:
    text = io.StringIO()
    # No date, no creator: the same drawing must give the same bytes.
    fig.savefig(text, format="svg", transparent=True, metadata={"Date": None, "Creator": None})
    return text.getvalue()


def data_file(id: str, drawing: Drawing) -> dict[str, bytes]:
    """The file's content by its suffix, the same bytes each time; nothing where there is no picture and no data.

    Raises ValueError naming the figure where an array is of another kind, missing, or too large.
    """
    arrays, picture = {name: _checked(id, name, values) for name, values in flat(drawing.data)}, drawing.picture
    _require_curves(id, getattr(picture, "axes", ()), arrays)
    pictures = [picture] if isinstance(picture, np.ndarray) else getattr(picture, "pictures", ())
    arrays |= {f"picture_{number}": image for number, image in enumerate(pictures, 1)}
    if not arrays:
        if picture is not None:
            raise ValueError(f"figure {id!r}: its Drawing needs data=: the arrays that the picture shows")
        return {}
    shapes = {array.shape for array in arrays.values()}
    is_table = len(shapes) == 1 and len(min(shapes)) == 1
    suffix, content = (".csv", _csv(arrays)) if is_table else (".npz", _npz(arrays))
    if drawing.data and len(content) > MOST_BYTES:
        raise ValueError(f"figure {id!r}: its data take {len(content)} bytes; at most {MOST_BYTES} are allowed")
    return {suffix: content}


def read_data(name: str, content: bytes) -> dict[str, np.ndarray]:
    """The arrays of such a file, by name, from its name and content; columns of words as strings."""
    if name.endswith(".npz"):
        with np.load(io.BytesIO(content)) as arrays:
            return dict(arrays)
    rows = list(csv.reader(io.StringIO(content.decode())))
    return {column[0]: _column(column[1:]) for column in zip(*rows, strict=True)}


def _checked(id: str, name: str, values) -> np.ndarray:
    array = np.asarray(values)
    if array.dtype.kind not in "biufU" or array.ndim == 0:
        raise ValueError(f"figure {id!r}: data {name!r} is {array.dtype} of shape {array.shape}; give an array of "
                         "numbers, truth values or strings")  # fmt: skip
    return array


def _require_curves(id: str, axes: Iterable[Axes], arrays: Mapping[str, np.ndarray]) -> None:
    """Raise ValueError where a curve's heights (the places along a level row of points) are not among the data."""
    known = np.concatenate([[], *(array.ravel() for array in arrays.values() if array.dtype.kind != "U")])
    for line in (line for ax in axes for line in ax.lines):
        places, heights = (np.asarray(values, dtype=float) for values in line.get_data())
        seen = places if len(np.unique(heights)) == 1 else heights
        missing = seen[np.isfinite(seen) & ~np.isin(seen, known)]
        if len(seen) >= FEWEST_POINTS and missing.size:
            raise ValueError(f"figure {id!r} draws a curve that is not in its data: {missing[0]} is missing")


def _csv(arrays: Mapping[str, np.ndarray]) -> bytes:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(arrays)
    writer.writerows(zip(*(array.tolist() for array in arrays.values()), strict=True))  # floats as repr: they read back
    return text.getvalue().encode()


def _npz(arrays: Mapping[str, np.ndarray]) -> bytes:
    buffer = io.BytesIO()
    np.savez_compressed(buffer, **arrays)  # its members bear the date 1980-01-01: the same arrays give the same bytes
    return buffer.getvalue()


def _column(values: list[str]) -> np.ndarray:
    try:
        return np.array([float(value) for value in values])
    except ValueError:
        return np.array(values)
