"""Pictures as files: PNG, TIFF, NPZ, and NPY, which may be larger than memory.

A PNG's rows are deflated by bands, side by side, each from nothing: the bytes do not depend on the threads.
"""

import shutil
import struct
from collections.abc import Iterable
from io import BytesIO
from pathlib import Path
from threading import Lock
from typing import Any
from zipfile import ZipFile, ZipInfo

import numpy as np

from renderer.checks import check_choice, extra, not_allowed
from renderer.files.srgb import FEW, to_bytes
from renderer.machines import machine, numpy_rows
from renderer.operations import where
from renderer.threads import run_bands
from renderer.whole_files import whole_file, write_whole

try:
    from zlib_ng import zlib_ng as zlib
except ImportError:  # no wheel for this processor: the same pixels, more slowly
    import zlib  # type: ignore[no-redef]

TIFF, LINEAR = (".tif", ".tiff"), ("float32", "float64")
PICTURE_SUFFIXES = (".png", *TIFF, ".npz", ".npy")
SIGNATURE, PAETH, COLOUR_TYPES = b"\x89PNG\r\n\x1a\n", 4, {1: 0, 3: 2, 4: 6}  # as the PNG specification numbers them
KEYWORD = b"symbolic-rendering"
BYTES = 64  # filtered together
BAND = 2**19  # bytes that are filtered and deflated, or stored, at a time
RUNS = {"level": 1, "strategy": zlib.Z_RLE}
QUICK, SEARCH, DEEP = ({"level": level} for level in (3, 5, 7))
SAMPLE = 2**15  # bytes of a band that are tried: as far back as repeats are searched for
FAIR = 0.87  # a slower way has to be shorter than this share of a quicker one


def _paeth(left, up, corner, here):
    """Return a byte less Paeth's guess: of its pixel's neighbours that which is nearest to left + up - corner."""
    to_left, to_up, to_corner = abs(up - corner), abs(left - corner), abs(left + up - corner - corner)
    guess = where((to_left <= to_up) & (to_left <= to_corner), left, where(to_up <= to_corner, up, corner))
    return where(here < guess, here - guess + 256, here - guess)


def _filter(image, start, lines):
    """Write rows of a picture as a PNG has them by Paeth's filter. Above the first row, and before it, there are 0."""
    rows, channels, width = len(lines), image.shape[2], image.shape[1] * image.shape[2]
    size = -(-rows * width // BYTES) * BYTES
    padded = np.zeros(channels + width + size, np.uint8)
    image_rows = image[max(0, start - 1) : start + rows]
    image_rows = (image_rows if image.dtype == np.uint8 else to_bytes(image_rows, 1)).reshape(-1)
    end = channels + (rows + 1) * width
    padded[end - image_rows.size : end] = image_rows
    parts = (padded[first : first + size] for first in (width, channels, 0, channels + width))
    rest = (numpy_rows if size < FEW else machine()).over_bytes(_paeth, *parts)
    lines[:, 0], lines[:, 1:] = PAETH, rest[: rows * width].reshape(rows, width)
    of_first = padded[channels:end].reshape(rows + 1, width)[:, :channels]  # which have nothing at the left
    np.subtract(of_first[1:], of_first[:-1], out=lines[:, 1 : 1 + channels])


def _deflate(data, way):
    """Return bytes as a part of a deflate stream that ends on a whole byte."""
    stream = zlib.compressobj(wbits=-zlib.MAX_WBITS, memLevel=9, **way)
    return stream.compress(data) + stream.flush(zlib.Z_SYNC_FLUSH)


def _way(lines):
    """Return zlib's settings for a band, by a sample of it: runs of equal bytes alone, or a search for repeats too.

    After Paeth's filter runs alone are mostly nearly as short, and quicker. The search is deep where a quick one leaves
    less than a quarter of the runs' length.
    """
    sample = lines.reshape(-1)[lines.size // 2 :][:SAMPLE]
    runs, search = (len(_deflate(sample, way)) for way in (RUNS, QUICK))
    if search < runs / 4:
        return DEEP
    return RUNS if runs * FAIR < search else SEARCH


def _chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def _parts(image, text, threads=None):
    """Return the bytes of a PNG, part by part."""
    height, width, channels = image.shape
    rows = -(-height // max(1, round(height * width * channels / BAND)))
    lines = np.empty((height, 1 + width * channels), np.uint8)

    def band(part):
        filtered = lines[part]
        _filter(image, part.start, filtered)
        return _chunk(b"IDAT", _deflate(filtered, _way(filtered)))

    header = struct.pack(">IIBBBBB", width, height, 8, COLOUR_TYPES[channels], 0, 0, 0)
    parts = [SIGNATURE, _chunk(b"IHDR", header), _chunk(b"sRGB", b"\0")]
    parts += [_chunk(b"tEXt", KEYWORD + b"\0" + text.encode("ascii"))] if text else []
    parts.append(_chunk(b"IDAT", b"\x78\x5e"))  # zlib's header: deflate, the largest window, a fast level
    parts += run_bands(band, height, rows, threads)
    parts.append(_chunk(b"IDAT", b"\3\0" + struct.pack(">I", zlib.adler32(lines))))  # a last block, of nothing
    return [*parts, _chunk(b"IEND", b"")]


def png_of(image: np.ndarray, text: str = "", threads: int | None = None) -> bytes:
    """Return a uint8 picture, (height, width, 1, 3 or 4), as the bytes of an sRGB PNG, pixel for pixel.

    One of float64 is linear light. text: ASCII that it carries under KEYWORD. threads: default, all cores; the bytes
    are the same.
    """
    return b"".join(_parts(image, text, threads))


def check_linear(linear: str | None, path: Path) -> None:
    """Raise ValueError unless a picture of linear light in such numbers is a TIFF; None: there is none."""
    if linear is not None:
        check_choice("linear", linear, LINEAR)
        if path.suffix.lower() not in TIFF:
            raise not_allowed("linear", linear, "given with a .tif")


def write_png(path: str | Path, image: np.ndarray, text: str = "") -> None:
    """Write the PNG of `png_of`; the file appears whole or not at all."""
    write_whole(Path(path), *_parts(image, text))


def _npy_header(kind, shape):
    """Return the bytes with which an array's numbers, row by row, are a .npy."""
    header = BytesIO()
    np.lib.format.write_array_header_1_0(header, {"descr": kind, "fortran_order": False, "shape": shape})
    return header.getvalue()


def _in_order(part):
    """Return an array's numbers row by row, copied a channel at a time: NumPy alone goes pixel by pixel."""
    if part.ndim < 3:
        return np.ascontiguousarray(part)
    numbers = np.empty(part.shape, part.dtype)
    for channel in range(part.shape[2]):
        numbers[..., channel] = part[..., channel]
    return numbers


def _store(path, alone, info, header, array):
    """Write an array to its place in a zip by bands: `ZipFile.open` would copy it whole, and its sum takes long."""
    rows = max(1, BAND // (array[:1].nbytes or 1))
    with open(path, "r+b") as file:
        file.seek(info.header_offset + len(info.FileHeader()))
        file.write(header)
        info.CRC = zlib.crc32(header)
        for start in range(0, len(array), rows):
            data = _in_order(array[start : start + rows]).data
            with alone:  # threads that write to one file at once would wait in the system, at work
                file.write(data)
            info.CRC = zlib.crc32(data, info.CRC)
        file.seek(info.header_offset)
        file.write(info.FileHeader())


def write_npz(path: str | Path, arrays: dict[str, Any], **texts: str) -> None:
    """Write arrays by their names, and texts that say anything as `NAME.json`; the file appears whole or not at all.

    They are stored, side by side: packed, they would take a hundred times as long as a picture takes to draw.
    """
    members, alone = [], Lock()
    with whole_file(path) as name, ZipFile(name, "w") as zipped:
        for member, array in arrays.items():
            info, header = ZipInfo(f"{member}.npy"), _npy_header(array.dtype.str, array.shape)
            members.append((info, header, array))
            info.file_size = info.compress_size = len(header) + array.nbytes
            info.CRC, info.header_offset, info.external_attr = 0, zipped.start_dir, 0o600 << 16
            zipped.start_dir += len(info.FileHeader()) + info.file_size
            zipped.filelist.append(info)

        run_bands(lambda part: _store(name, alone, *members[part.start]), len(members), 1, None)
        for member in filter(texts.get, texts):
            zipped.writestr(f"{member}.json", texts[member])


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
            file.write(_npy_header("<f8", (rows, columns, 3)))
            for part in parts:
                file.write(_in_order(part).astype("<f8", copy=False).data)


def write_tiff(path: str | Path, image: np.ndarray) -> None:
    """Write a picture, (height, width, 3), as a TIFF of its numbers. Raises ModuleNotFoundError without `tiff`."""
    with extra("tiff"):
        import tifffile
    with whole_file(path) as name:
        tifffile.imwrite(name, image, photometric="rgb", metadata=None)
