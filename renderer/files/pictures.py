"""Pictures and tables as files: PNG, every buffer of a frame as NPZ, CSV."""

import csv
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from renderer.picture.frame import Frame
from renderer.whole_files import whole_file

PICTURE_SUFFIXES = (".png", ".npz")


def write_png(path: str | Path, image: np.ndarray) -> None:
    """Write a uint8 picture, (height, width, 3 or 4), pixel for pixel."""
    from PIL import Image

    with whole_file(path) as name:
        Image.fromarray(image).save(name)


def write_npz(path: str | Path, frame: Frame) -> None:
    """Write every buffer of a frame: rgb, chambers, and A's surface data (NaN off A)."""
    with whole_file(path) as name:
        np.savez_compressed(name, rgb=frame.rgb, chambers=frame.chambers, **frame.surface_data)  # type: ignore[arg-type]


def write_csv(path: str | Path, records: Sequence[Mapping[str, Any]]) -> None:
    """Write dicts of the same keys as a table with its column names."""
    with whole_file(path) as name, open(name, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, [name for record in records[:1] for name in record])
        writer.writeheader()
        writer.writerows(records)
