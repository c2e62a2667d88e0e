"""Pictures as files: PNG and NPZ, and what may be larger than memory, NPY and TIFF.

A PNG's rows are deflated by bands, side by side, each from nothing: the bytes do not depend on the threads.
"""

import shutil
import struct
import zlib
from collections.abc import Iterable
from pathlib import Path
from typing import Any
from zipfile import ZipFile

import numpy as np

from renderer.checks import extra
from renderer.threads import available_cores, run_bands
from renderer.whole_files import whole_file

PICTURE_SUFFIXES, STREAM_SUFFIXES = (".png", ".npz"), (".npy", ".tif", ".tiff")
SIGNATURE, ABOVE, COLOUR_TYPES = b"\x89PNG\r\n\x1a\n", 2, {1: 0, 3: 2, 4: 6}  # as the PNG specification numbers them
KEYWORD = b"symbolic-rendering"
ADLER = 65521
BAND = 2**18  # bytes
LEVEL = 4  # a third of level 6's time, a tenth more bytes
TILE = 256


def adler32_combined(one: int, other: int, length: int) -> int:
    """Return the Adler-32 of two byte strings in a row, of theirs and the second one's length."""
    low, high = (one & 0xFFFF) - 1, (one >> 16) + (other >> 16)
    return (high + length * low) % ADLER << 16 | (low + (other & 0xFFFF)) % ADLER


def _filtered(image, start, stop):
    """Return rows of a picture as a PNG has them: what each has more than the row above, as rows are much alike."""
    rows = image[start:stop].reshape(stop - start, -1)
    lines = np.empty((len(rows), 1 + rows.shape[1]), np.uint8)
    lines[:, 0] = ABOVE
    lines[0, 1:] = rows[0] - image[start - 1].reshape(-1) if start else rows[0]
    np.subtract(rows[1:], rows[:-1], out=lines[1:, 1:])
    return lines


def _deflated(lines, last):
    """Return rows as a part of a deflate stream that ends on a whole byte. In noise nothing repeats but runs."""
    strategy = zlib.Z_RLE if 2 * np.count_nonzero(lines) > lines.size else zlib.Z_DEFAULT_STRATEGY
    deflate = zlib.compressobj(LEVEL, zlib.DEFLATED, -zlib.MAX_WBITS, strategy=strategy)
    return deflate.compress(lines) + deflate.flush(zlib.Z_FINISH if last else zlib.Z_SYNC_FLUSH)


def _chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png_of(image: np.ndarray, text: str = "", threads: int | None = None) -> bytes:
    """Return a uint8 picture, (height, width, 1, 3 or 4), as the bytes of an sRGB PNG, pixel for pixel.

    text: ASCII that it carries under KEYWORD. threads: default, all cores; the bytes are the same.
    """
    height, width, channels = image.shape
    rows = max(1, BAND // (width * channels))

    def band(number):
        stop = min(height, (number + 1) * rows)
        lines = _filtered(image, number * rows, stop)
        return _deflated(lines, stop == height), zlib.adler32(lines), lines.size

    parts, checksum = [b"\x78\x5e"], 1  # zlib's header: deflate, the largest window, a fast level
    for deflated, of_band, size in run_bands(band, -(-height // rows), threads or available_cores()):
        parts.append(deflated)
        checksum = adler32_combined(checksum, of_band, size)
    parts.append(struct.pack(">I", checksum))
    chunks = [(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, COLOUR_TYPES[channels], 0, 0, 0)), (b"sRGB", b"\0")]
    chunks += [(b"tEXt", KEYWORD + b"\0" + text.encode("ascii"))] if text else []
    chunks += [*((b"IDAT", part) for part in parts), (b"IEND", b"")]
    return SIGNATURE + b"".join(_chunk(*chunk) for chunk in chunks)


def write_png(path: str | Path, image: np.ndarray, text: str = "") -> None:
    """Write what `png_of` returns; the file appears whole or not at all."""
    with whole_file(path) as name:
        Path(name).write_bytes(png_of(image, text))


def write_npz(path: str | Path, arrays: dict[str, Any], **texts: str) -> None:
    """Write arrays by their names, and texts as `NAME.json`; the file appears whole or not at all."""
    with whole_file(path) as name, open(name, "w+b") as file:  # to a name that ends in .NPZ NumPy would add another
        np.savez_compressed(file, **arrays)
        with ZipFile(file, "a") as zipped:
            for member, text in texts.items():
                with zipped.open(f"{member}.json", "w") as told:
                    told.write(text.encode("ascii"))


def write_npy(path: str | Path, shape: tuple[int, int], parts: Iterable[np.ndarray]) -> None:
    """Write linear light, of a shape (rows, columns), in parts one after the other: whole rows, or pieces of one row.

    Plain writes, not a memory map: its pages would count as this process's, and a full disk would be a signal.
    """
    rows, columns = shape
    with whole_file(path) as name:
        size, free = 24 * rows * columns, shutil.disk_usage(name).free
        if size > free:
            raise OSError(f"the picture takes {size / 1e9:.3g} GB, and the disk has {free / 1e9:.3g} GB left")
        with open(name, "wb") as file:
            header = {"descr": "<f8", "fortran_order": False, "shape": (rows, columns, 3)}
            np.lib.format.write_array_header_1_0(file, header)
            for part in parts:
                file.write(np.ascontiguousarray(part, "<f8").data)


def write_tiff(path: str | Path, shape: tuple[int, int], parts: Iterable[np.ndarray]) -> None:
    """Write bytes, of a shape (rows, columns), in parts of whole tiles; one at an edge is filled up with zeros."""
    with extra("tiff"):
        import tifffile

    def tiles():
        for part in parts:
            for top in range(0, part.shape[0], TILE):
                for left in range(0, part.shape[1], TILE):
                    tile = part[top : top + TILE, left : left + TILE]
                    yield np.pad(tile, ((0, TILE - tile.shape[0]), (0, TILE - tile.shape[1]), (0, 0)))

    form: dict[str, Any] = {"shape": (*shape, 3), "dtype": np.uint8, "photometric": "rgb", "metadata": None}
    with whole_file(path) as name:
        tifffile.imwrite(name, tiles(), bigtiff=True, tile=(TILE, TILE), compression="zlib", **form)
