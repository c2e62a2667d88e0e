"""Pictures of a frame as bytes: sRGB image, slope, kinks, and the difference of two frames."""

from typing import TYPE_CHECKING

import numpy as np

from renderer.checks import check_kind, check_number, extra
from renderer.files.srgb import to_bytes
from renderer.picture.frame import Frame

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LOW, HIGH = -16, 0  # decades of a logarithmic view
DIVERGING = "RdBu_r"


def _bytes(share):
    """Return numbers as bytes: 0 and less as 0, 1 and more as 255."""
    return np.rint(np.clip(share, 0.0, 1.0) * 255).astype(np.uint8)


def image_view(frame: Frame) -> np.ndarray:
    """Return the picture itself: (height, width, 3) uint8, sRGB. Raises ValueError unless it is of a Frame."""
    return to_bytes(check_kind("frame", frame, Frame).rgb)


def slope_view(frame: Frame, highest: float | None = None) -> np.ndarray:
    """Return |∇h| on sphere A in grey, from 0 to `highest` (default: the largest in the frame); black off A."""
    slope = check_kind("frame", frame, Frame).slope
    highest = slope.max() if highest is None else check_number("highest", highest, 0.0)
    return np.repeat(_bytes(slope / highest if highest > 0 else 0.0 * slope)[..., None], 3, axis=2)


def kink_view(frame: Frame) -> np.ndarray:
    """Return the kink flags in white over the dimmed picture: (height, width, 3) uint8."""
    return np.where(check_kind("frame", frame, Frame).kink[..., None], np.uint8(255), to_bytes(frame.rgb) // 3)


def difference_linear(delta: np.ndarray | float, gain: float = 100.0) -> np.ndarray:
    """Return |delta| × gain, clipped to [0, 1], channel by channel: uint8, not sRGB-encoded."""
    return _bytes(np.abs(delta) * check_number("gain", gain, 0.0, 1e300))


def difference_logarithmic(delta: np.ndarray, low: float = LOW, high: float = HIGH) -> np.ndarray:
    """Return |delta| on a scale from 10^low to 10^high in the colours of inferno: (height, width, 3) uint8.

    Of several channels the largest counts; zero and NaN are black.
    """
    with extra("plot"):
        import matplotlib  # only this view needs it, and it is slow to import

    size = np.abs(np.asarray(delta, dtype=np.float64))
    if size.ndim == 3:
        size = size.max(axis=2)
    drawn = size > 0
    exponent = np.log10(size, out=np.full(size.shape, float(low)), where=drawn)
    share = np.clip((exponent - low) / (high - low), 0.0, 1.0)
    colours = matplotlib.colormaps["inferno"](share, bytes=True)[..., :3]
    return np.where(drawn[..., None], colours, np.uint8(0))


def add_colour_bar(
    figure: "Figure",
    box: tuple[float, float, float, float],
    limits: tuple[float, float],
    label: str,
    colours: str = "inferno",
) -> None:
    """Draw a colour bar between two limits into a Matplotlib figure; inferno's in powers of ten, 10^limits[0] ... ."""
    with extra("plot"):
        from matplotlib.cm import ScalarMappable
        from matplotlib.colors import Normalize

    low, high = limits
    bar = figure.colorbar(ScalarMappable(Normalize(low, high), colours), cax=figure.add_axes(box))
    if colours == "inferno":
        ticks = np.arange(low, high + 1e-9, max(1, round((high - low) / 8)))
        bar.set_ticks(list(ticks), labels=[rf"$10^{{{tick:.0f}}}$" for tick in ticks])
    bar.outline.set_visible(False)
    bar.ax.tick_params(length=0)
    if label:
        bar.set_label(label)


def derivative_view(slope: np.ndarray, name: str = "") -> np.ndarray:
    """Return a slope by a number, (height, width, 3): uint8, blue below 0, white, red above; named, with its scale.

    Of a pixel's channels that of the largest slope counts. The scale is symmetric, and ends at the largest of all.
    """
    with extra("plot"):
        import matplotlib

    largest = np.take_along_axis(slope, np.abs(slope).argmax(axis=2)[..., None], axis=2)[..., 0]
    end = float(np.abs(largest).max()) or 1.0
    image = matplotlib.colormaps[DIVERGING](0.5 + 0.5 * (largest / end), bytes=True)[..., :3]
    return with_colour_bar(image, (-end, end), f"slope by {name}", DIVERGING) if name else image


def with_colour_bar(
    image: np.ndarray,
    limits: tuple[float, float] = (LOW, HIGH),
    label: str = "largest |ΔI| of a channel",
    colours: str = "inferno",
) -> np.ndarray:
    """Return a picture, by default a logarithmic difference, with its colour bar at the right: uint8, pixels kept."""
    with extra("plot"):
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure

    height, width = image.shape[:2]
    tall, total = max(height, 160), width + 96
    figure = Figure(figsize=(total / 100, tall / 100), dpi=100, facecolor="white")
    box = (width + 12) / total, 8 / tall, 12 / total, 1 - 16 / tall
    add_colour_bar(figure, box, limits, label, colours)
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    sheet = np.asarray(canvas.buffer_rgba())[..., :3].copy()
    sheet[:height, :width] = image
    return sheet
