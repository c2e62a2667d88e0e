"""Files that appear whole or not at all: written beside their place under another name, then renamed."""

import os
import tempfile
from contextlib import contextmanager
from pathlib import Path

import numpy as np

PICTURE_SUFFIXES = (".png", ".npz")


def checked_target(path, suffixes):
    """Return `path` as a Path, or raise ValueError unless it ends in one of `suffixes` and can be written."""
    path = Path(path)
    if path.suffix not in suffixes:
        raise ValueError(f"out = {str(path)!r} is not allowed: a file name that ends in {' or '.join(suffixes)}")
    if path.is_dir() or not path.parent.is_dir():
        raise ValueError(f"out = {str(path)!r} is not allowed: a file in a folder that exists")
    if not os.access(path.parent, os.W_OK):
        raise ValueError(f"out = {str(path)!r} is not allowed: a file in a folder that can be written")
    return path


@contextmanager
def whole_file(path):
    """Yield a temporary file name beside `path`; rename it to `path` at the end, or remove it on an error."""
    path = Path(path)
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.stem}-", suffix=path.suffix)
    os.close(handle)
    try:
        yield name
        mask = os.umask(0)
        os.umask(mask)
        os.chmod(name, 0o666 & ~mask)
        os.replace(name, path)
    except BaseException:
        Path(name).unlink(missing_ok=True)
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
