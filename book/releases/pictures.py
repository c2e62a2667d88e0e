"""What a release keeps of a picture to be compared with: its pixels as one PNG, or the numbers that it plots."""

import hashlib
import io
from pathlib import Path

import numpy as np
from PIL import Image

from book.drawing.data import read_data

CANVAS = "picture_0"  # all of a figure's pictures side by side; no data and no single picture has this name


def arrays_of(path: Path) -> dict[str, np.ndarray]:
    """What is compared of a file of data, or of a kept one: {CANVAS: (height, width, 4) uint8}, or all its arrays."""
    if path.suffix == ".png":
        with Image.open(path) as image:
            return {CANVAS: np.asarray(image.convert("RGBA"))}
    arrays = read_data(path.name, path.read_bytes())
    pictures = [array for name, array in arrays.items() if name.startswith("picture_")]
    return {CANVAS: side_by_side(pictures)} if pictures else arrays


def side_by_side(pictures: list[np.ndarray]) -> np.ndarray:
    """Pictures on one transparent canvas, from the left: (tallest, sum of the widths, 4) uint8."""
    height, width = max(p.shape[0] for p in pictures), sum(p.shape[1] for p in pictures)
    canvas, left = np.zeros((height, width, 4), np.uint8), 0
    for picture in pictures:
        tall, wide, channels = picture.shape
        canvas[:tall, left : left + wide, :channels] = picture
        if channels == 3:
            canvas[:tall, left : left + wide, 3] = 255
        left += wide
    return canvas


def kept_file(data: Path) -> tuple[str, str]:
    """The name under which a release keeps a figure's data, and the digest of the arrays in it."""
    arrays = arrays_of(data)
    return f"{data.stem}.png" if CANVAS in arrays else data.name, digest(arrays)


def keep(data: Path, folder: Path) -> None:
    """Write a figure's data into a release's folder."""
    arrays = arrays_of(data)
    if CANVAS in arrays:
        buffer = io.BytesIO()
        Image.fromarray(arrays[CANVAS]).save(buffer, format="PNG", optimize=True)
        (folder / f"{data.stem}.png").write_bytes(buffer.getvalue())
    else:
        (folder / data.name).write_bytes(data.read_bytes())


def digest(arrays: dict[str, np.ndarray]) -> str:
    """The SHA-256 of arrays: their names, kinds, shapes and values."""
    found = hashlib.sha256()
    for name, array in arrays.items():
        found.update(f"{name} {array.dtype.str} {array.shape}\n".encode())
        found.update(np.ascontiguousarray(array).tobytes())
    return found.hexdigest()
