"""Linear light as sRGB bytes (IEC 61966-2-1), by table: a byte begins where the standard's formula is rounded to it."""

from collections.abc import Callable
from functools import cache

import numpy as np

from renderer.machines import machine, numpy_rows
from renderer.threads import run_bands

CELLS = 2**12  # equal parts of [0, 1]: so small that at most one byte begins inside
AT_ONCE = 2**17  # numbers: with fewer, threads wait for each other's Python
FEW = 2**16  # for which compiling takes longer


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
    """Return (the least float64 of each byte from 1 to 255, and NaN; the byte at which each cell begins, uint8)."""
    begins = np.append(thresholds(_level), np.nan)
    return begins, begins.searchsorted(np.arange(CELLS + 1) / CELLS, "right").astype(np.uint8)


def to_bytes(rgb: np.ndarray, threads: int | None = None) -> np.ndarray:
    """Return linear light, (…, 3) in [0, 1], as sRGB bytes, uint8, clipped. threads: at most as many."""
    rgb = np.asarray(rgb, dtype=np.float64)
    encoded = np.empty(rgb.shape, np.uint8)
    linear, into = (one if one.ndim == 3 else one.reshape(-1, 1, one.shape[-1]) for one in (rgb, encoded))
    write_levels = (numpy_rows if rgb.size < FEW else machine()).write_levels

    def band(rows):
        for channel in range(linear.shape[-1]):
            write_levels(linear[rows, :, channel], *tables(), into[rows, :, channel])

    run_bands(band, len(linear), max(1, AT_ONCE * len(linear) // max(1, linear.size)), threads)
    return encoded
