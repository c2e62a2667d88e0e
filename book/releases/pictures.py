"""The pixels of a release's pictures, kept as one lossless WebP each; of a plot the digest of its numbers is kept."""

import hashlib
from pathlib import Path

import numpy as np
from PIL import Image

CANVAS = "picture_0"  # all of a figure's pictures side by side; no data and no single picture has this name


def arrays_of(path: Path) -> dict[str, np.ndarray]:
    """Return the arrays of a file of data: {CANVAS: (height, width, 4) uint8} of pictures, or else all."""
    if path.suffix in (".png", ".webp"):
        with Image.open(path) as image:
            return {CANVAS: np.asarray(image.convert("RGBA"))}
    if path.suffix == ".csv":
        return {"table": np.frombuffer(path.read_bytes(), np.uint8)}
    with np.load(path) as file:
        arrays = dict(file)
    pictures = [array for name, array in arrays.items() if name.startswith("picture_")]
    return {CANVAS: side_by_side(pictures)} if pictures else arrays


def side_by_side(pictures: list[np.ndarray]) -> np.ndarray:
    """Return pictures on one transparent canvas, from the left: (tallest, sum of the widths, 4) uint8."""
    images = [Image.fromarray(picture) for picture in pictures]
    canvas = Image.new("RGBA", (sum(image.width for image in images), max(image.height for image in images)))
    left = 0
    for image in images:
        canvas.paste(image, (left, 0))
        left += image.width
    return np.asarray(canvas)


def archived(folder: Path, id: str) -> Path:
    """Return the file in which a release's folder keeps a picture."""
    return folder / f"{id}.webp"


def archive(data: Path, target: Path) -> None:
    """Write the pixels of a figure's data to a file; a plot has none."""
    if CANVAS in (arrays := arrays_of(data)):
        Image.fromarray(arrays[CANVAS]).save(target, lossless=True, quality=100, method=6, exact=True)


def digest(arrays: dict[str, np.ndarray]) -> str:
    """Return the SHA-256 of arrays: their names, kinds, shapes and values."""
    hashed = hashlib.sha256()
    for name, array in arrays.items():
        hashed.update(f"{name} {array.dtype.str} {array.shape}\n".encode())
        hashed.update(array.tobytes())
    return hashed.hexdigest()
