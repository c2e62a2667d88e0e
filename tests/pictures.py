"""Pictures in files, and contents of a folder."""

from io import BytesIO

import numpy as np
from PIL import Image

from renderer.picture import views


def pixels(png):
    """Return the bytes of the colours of a PNG, (rows, columns, 3)."""
    return np.asarray(Image.open(BytesIO(png)).convert("RGB"))


def shows(path, frame):
    """Return whether a file shows a frame: its float64 numbers, or its bytes for the eye."""
    if path.suffix.lower() in (".npy", ".npz"):
        pixels, expected = np.load(path), frame.rgb
    else:
        pixels, expected = np.asarray(Image.open(path)), views.image_view(frame)
    pixels = pixels["rgb"] if path.suffix == ".npz" else pixels
    return pixels.dtype == expected.dtype and np.array_equal(pixels, expected)


def contents(folder):
    """Return {name: bytes} of a folder's files."""
    return {path.name: path.read_bytes() for path in folder.iterdir()}
