"""Files of a figure's drawing: ID.svg and ID.dark.svg, or ID.png; ID.csv or ID.npz; and always ID.json.

A plot is drawn a second time for phones: ID.phone.svg and ID.phone.dark.svg.

The numbers behind a picture lie beside it: of curves ID.csv, a row for each point; with pictures or arrays ID.npz,
where the pixels of `panels` and of renders are picture_1, picture_2 … A curve is kept under its label, or as curve 1,
curve 2 …; what is drawn with fewer points than a curve has is a mark, unless it has a label.
"""

import csv
import io
import json
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from book.assembly.stamps import write_whole
from book.drawing.palette import CSS_PIXELS_PER_INCH, for_dark
from book.drawing.registry import Drawing, Registered, certified, flat, plain_numbers
from book.drawing.style import narrow, styled
from renderer.files.pictures import png_of

MOST_BYTES = 512 * 1024  # of a file of numbers; where floats would take more, the picture's 8 bits are its data
FEWEST_POINTS = 5  # of a line that counts as a curve: marks and slope triangles have fewer


def draw_files(entry: Registered) -> tuple[dict[str, bytes], dict]:
    """Draw a figure: its files by suffix, and what its JSON says about them."""
    files, size, phone, kind = {}, None, None, "numbers"
    with styled():
        drawing = entry.drawn()
        picture = drawing.picture
        if isinstance(picture, Figure):
            size, kind, files = _size(picture), "svg", _svg(picture)
        elif getattr(picture, "dtype", None) == np.uint8 and picture.ndim == 3:
            files, size, kind = {".png": png_of(picture)}, [picture.shape[1], picture.shape[0]], "png"
        elif picture is not None:
            raise TypeError(
                f"figure {entry.id!r}: a picture is a Matplotlib figure, a uint8 array (h, w, channels) or None"
            )
        data, exact = data_file(entry.id, drawing), kind == "png" or getattr(picture, "pixel_exact", False)
        if kind == "svg" and not exact:
            narrow(picture)
            phone, files = _size(picture), files | _svg(picture, ".phone")
    numbers = plain_numbers(entry.id, drawing.numbers)
    about = " ".join((entry.draw.__doc__ or "").split("\n\n")[0].split())
    description = {"id": entry.id, "about": about, "kind": kind, "size": size, "phone": phone, "exact": exact}
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


def _size(fig: Figure) -> list[int]:
    return [round(inches) for inches in fig.get_size_inches() * CSS_PIXELS_PER_INCH]


def _svg(fig: Figure, name: str = "") -> dict[str, bytes]:
    """Return a drawing for the light page and for the dark one, by suffix."""
    text = io.StringIO()
    # No date, no creator: the same drawing must give the same bytes.
    fig.savefig(text, format="svg", transparent=True, metadata={"Date": None, "Creator": None})
    svg = text.getvalue()
    return {f"{name}.svg": svg.encode(), f"{name}.dark.svg": for_dark(svg).encode()}


def data_file(id: str, drawing: Drawing) -> dict[str, bytes]:
    """Return the file's content by its suffix, the same bytes each time; nothing where there is no picture and no data.

    Raises ValueError naming the figure where two curves have one name, an array is of another kind, missing, too large.
    """
    arrays, picture = {name: _checked(id, name, values) for name, values in flat(drawing.data)}, drawing.picture
    pictures = [picture] if isinstance(picture, np.ndarray) else getattr(picture, "pictures", ())
    curves = _curves(id, getattr(picture, "axes", ()))
    if arrays or pictures:
        arrays |= {f"picture_{number}": image for number, image in enumerate(pictures, 1)} | curves
        suffix, content = ".npz", _npz(arrays)
    elif curves:
        suffix, content = ".csv", _csv(curves)
    elif picture is not None:
        raise ValueError(f"figure {id!r}: its Drawing needs data=: the arrays that the picture shows")
    else:
        return {}
    if (drawing.data or curves) and len(content) > MOST_BYTES:
        raise ValueError(f"figure {id!r}: its data take {len(content)} bytes; at most {MOST_BYTES} are allowed")
    return {suffix: content}


def _checked(id: str, name: str, values) -> np.ndarray:
    array = np.asarray(values)
    if array.dtype.kind not in "biufU" or array.ndim == 0:
        raise ValueError(f"figure {id!r}: data {name!r} is {array.dtype} of shape {array.shape}; give an array of "
                         "numbers, truth values or strings")  # fmt: skip
    return array


def _curves(id: str, axes: Sequence[Axes]) -> dict[str, np.ndarray]:
    """Return the points (2, n) of every curve, by its label, behind that of its axes where there are several."""
    curves: dict[str, np.ndarray] = {}
    for number, ax in enumerate(axes, 1):
        front = f"{ax.get_title('left') or number}: " if len(axes) > 1 else ""
        for place, line in enumerate(ax.lines, 1):
            label, points = line.get_label(), np.array(line.get_data(), dtype=float)
            is_mark = label.startswith("_")
            name = front + (f"curve {place}" if is_mark else " ".join(label.split()))
            if points.shape[1] < FEWEST_POINTS and (is_mark or name in curves):
                continue
            if name in curves:
                raise ValueError(f"figure {id!r}: two curves are called {name!r}")
            curves[name] = points
    return curves


def _csv(curves: Mapping[str, np.ndarray]) -> bytes:
    text = io.StringIO()
    rows = ((name, *point) for name, points in curves.items() for point in points.T.tolist())  # floats read back
    csv.writer(text, lineterminator="\n").writerows([("curve", "x", "y"), *rows])
    return text.getvalue().encode()


def _npz(arrays: Mapping[str, np.ndarray]) -> bytes:
    buffer = io.BytesIO()
    np.savez_compressed(buffer, **arrays)  # its members bear the date 1980-01-01: the same arrays give the same bytes
    return buffer.getvalue()
