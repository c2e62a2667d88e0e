"""The numbers behind a picture, as a file beside it: ID.csv for columns of one length, ID.npz for anything else.

What a drawing hands over as `data` is kept under its names; the pixels of `panels` and of renders are added to it as
picture_1, picture_2 … A curve that is drawn and not handed over is an error, so that the file is what one sees.
"""

import csv
import io
from collections.abc import Iterable, Mapping

import numpy as np
from matplotlib.axes import Axes

from book.drawing.registry import Drawing, flat

SUFFIXES = (".csv", ".npz")
MOST_BYTES = 512 * 1024  # of a file of numbers; where floats would take more, the picture's 8 bits are its data
FEWEST_POINTS = 5  # of a line that counts as a curve: less has the marks of a label, a leader or a slope triangle


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
