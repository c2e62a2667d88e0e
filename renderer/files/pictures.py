"""Pictures as files: PNG, and every buffer of a frame as NPZ."""

import struct
import zlib
from pathlib import Path
from typing import Any

import numpy as np

from renderer.picture.frame import Frame
from renderer.whole_files import whole_file

PICTURE_SUFFIXES = (".png", ".npz")
SIGNATURE, ABOVE, COLOUR_TYPES = b"\x89PNG\r\n\x1a\n", 2, {3: 2, 4: 6}  # as the PNG specification numbers them


def png_of(image: np.ndarray) -> bytes:
    """Return a uint8 picture, (height, width, 3 or 4), as the bytes of a PNG, pixel for pixel.

    Each row is what it has more than the row above: a picture's rows are much alike.
    """
    height, width, channels = image.shape
    rows = np.empty((height, 1 + width * channels), np.uint8)
    rows[:, 0], rows[:, 1:] = ABOVE, image.reshape(height, -1)
    rows[1:, 1:] -= image.reshape(height, -1)[:-1]
    form = struct.pack(">IIBBBBB", width, height, 8, COLOUR_TYPES[channels], 0, 0, 0)
    chunks = {b"IHDR": form, b"IDAT": zlib.compress(rows.tobytes()), b"IEND": b""}
    return SIGNATURE + b"".join(
        struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        for kind, data in chunks.items()
    )


def write_png(path: str | Path, image: np.ndarray) -> None:
    """Write a uint8 picture, (height, width, 3 or 4), pixel for pixel."""
    with whole_file(path) as name:
        Path(name).write_bytes(png_of(image))


def write_bounds(path: str | Path, frame: Frame) -> None:
    """Write what is certain of a frame that was drawn with bounds: `bounds` and `open`."""
    _write_arrays(path, {"bounds": frame.bounds, "open": frame.open})


def write_npz(path: str | Path, frame: Frame) -> None:
    """Write every buffer of a frame: rgb, chambers, and A's surface data (NaN off A)."""
    _write_arrays(path, {"rgb": frame.rgb, "chambers": frame.chambers, **frame.surface_data})


def _write_arrays(path: str | Path, arrays: dict[str, Any]) -> None:
    with whole_file(path) as name, open(name, "wb") as file:  # to a name that ends in .NPZ NumPy would add another
        np.savez_compressed(file, **arrays)
