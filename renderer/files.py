"""Files that appear whole or not at all: written beside their place under another name, then renamed."""

import csv
import os
import tempfile
from contextlib import contextmanager
from pathlib import Path

import numpy as np

PICTURE_SUFFIXES = (".png", ".npz")


def checked_target(path, suffixes, name="out"):
    """Return `path` as a Path, or raise ValueError unless it ends in one of `suffixes` and can be written.

    `name` is what the message calls it.
    """
    path = Path(path)
    if path.suffix not in suffixes:
        raise ValueError(f"{name} = {str(path)!r} is not allowed: a file name that ends in {' or '.join(suffixes)}")
    if os.path.isdir(path) or not os.path.isdir(path.parent):  # unlike Path's, False for a name that is too long
        raise ValueError(f"{name} = {str(path)!r} is not allowed: a file in a folder that exists")
    try:
        _remove(_temporary(path))
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise ValueError(f"{name} = {str(path)!r} is not allowed: a file that can be written ({reason})") from None
    return path


def _temporary(path):
    """Make an empty file beside `path` and return its name."""
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.stem}-", suffix=path.suffix)
    os.close(handle)
    return name


def _remove(name):
    Path(name).unlink(missing_ok=True)


@contextmanager
def whole_file(path):
    """Yield a temporary file name beside `path`; rename it to `path` at the end, or remove it on an error."""
    path = Path(path)
    name = _temporary(path)
    try:
        yield name
        mask = os.umask(0)
        os.umask(mask)
        os.chmod(name, 0o666 & ~mask)
        os.replace(name, path)
    except BaseException:
        _remove(name)
        raise


def write_png(path, image):
    """Write a uint8 picture, (height, width, 3 or 4), pixel for pixel."""
    from PIL import Image

    with whole_file(path) as name:
        Image.fromarray(image).save(name, optimize=True)


def write_npz(path, frame):
    """Write every buffer of a frame: rgb, chambers, and A's surface data (NaN off A)."""
    with whole_file(path) as name:
        np.savez_compressed(name, rgb=frame.rgb, chambers=frame.chambers, **frame.surface_data)


def write_csv(path, names, records):
    """Write dicts as a table with its column names."""
    with whole_file(path) as name, open(name, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, names)
        writer.writeheader()
        writer.writerows(records)
