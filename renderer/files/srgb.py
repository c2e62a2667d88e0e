"""Linear light as sRGB bytes (IEC 61966-2-1), by table: a byte begins where the standard's formula is rounded to it."""

from collections.abc import Callable
from functools import cache

import numpy as np

from renderer.threads import run_bands

CELLS = 2**16  # equal parts of [0, 1], a half at either end: so small that at most one byte begins inside
ROUND = 1.5 * 2**36  # x + ROUND holds the nearest whole number to x · CELLS in its lowest bits
BEGINS = 256  # is added to the byte of a cell in which the next one begins
AT_ONCE = 2**19  # numbers: with fewer, threads wait for each other's Python; with many more, for the memory


def thresholds(level_of: Callable[[np.ndarray], np.ndarray]) -> np.ndarray:
    """Return the least float64 in [0, 1] at each level from 1 to 255, where level_of(numbers) never falls."""
    low, high = np.zeros(255, np.int64), np.full(255, np.float64(1).view(np.int64))
    while (low + 1 < high).any():
        middle = (low + high) // 2
        reached = level_of(middle.view(np.float64)) >= np.arange(1, 256)
        low, high = np.where(reached, low, middle), np.where(reached, middle, high)
    return high.view(np.float64)


def _level(linear):
    """Return the standard's formula, rounded."""
    encoded = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    return np.rint(encoded * 255)


@cache
def tables() -> tuple[np.ndarray, np.ndarray]:
    """Return (the least float64 of each byte from 1 to 255; each cell's byte, uint16, + BEGINS where one begins)."""
    begins = thresholds(_level)
    low, high = (begins.searchsorted((np.arange(CELLS + 1) + end) / CELLS, "right") for end in (-0.5, 0.5))
    return begins, np.where(low == high, low, low + BEGINS).astype(np.uint16)


def _encode(channels, into):
    """Write the bytes of some arrays of numbers, (channels, …), into others."""
    begins, of_cell = tables()
    cell, level = np.empty(channels.shape[1:]), np.empty(channels.shape[1:], np.uint16)
    number, first = cell.view(np.int64), np.float64(ROUND).view(np.int64)
    for linear, encoded in zip(channels, into, strict=True):
        np.subtract(np.add(linear, ROUND, out=cell).view(np.int64), first, out=number)
        if number.view(np.uint64).max() > CELLS:
            np.clip(number, 0, CELLS, out=number)
        of_cell.take(number, out=level, mode="wrap")  # no number is outside, and this is the fastest
        unsure = np.flatnonzero(level >= BEGINS)
        below = level.flat[unsure] - BEGINS  # the byte where the cell begins
        level.flat[unsure] = below + (linear.flat[unsure] >= begins[below])
        encoded[...] = level


def to_bytes(rgb: np.ndarray, threads: int | None = None) -> np.ndarray:
    """Return linear light, (…, 3) in [0, 1], as sRGB bytes, uint8, clipped. threads: at most as many."""
    rgb = np.asarray(rgb, dtype=np.float64)
    encoded = np.empty(rgb.shape, np.uint8)
    linear, into = (one if one.ndim > 1 else one.reshape(-1, 1) for one in (rgb, encoded))
    rows = max(1, AT_ONCE * len(linear) // max(1, linear.size))

    def band(part):
        _encode(np.moveaxis(linear[part], -1, 0), np.moveaxis(into[part], -1, 0))

    run_bands(band, len(linear), rows, threads)
    return encoded
