"""Pictures as files: PNG, and every buffer of a frame as NPZ."""

from pathlib import Path

import numpy as np

from renderer.picture.frame import Frame
from renderer.whole_files import whole_file

PICTURE_SUFFIXES = (".png", ".npz")


def write_png(path: str | Path, image: np.ndarray) -> None:
    """Write a uint8 picture, (height, width, 3 or 4), pixel for pixel."""
    from PIL import Image

    with whole_file(path) as name:
        Image.fromarray(image).save(name)


def write_bounds(path: str | Path, frame: Frame) -> None:
    """Write what is certain of a frame that was drawn with bounds: `bounds` and `open`."""
    with whole_file(path) as name:
        np.savez_compressed(name, bounds=frame.bounds, open=frame.open)


def write_npz(path: str | Path, frame: Frame) -> None:
    """Write every buffer of a frame: rgb, chambers, and A's surface data (NaN off A)."""
    with whole_file(path) as name:
        np.savez_compressed(name, rgb=frame.rgb, chambers=frame.chambers, **frame.surface_data)  # type: ignore[arg-type]
