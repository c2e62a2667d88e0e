"""Pictures made of the renderer's own pixels, never resampled: strips, panels, difference maps."""

from collections.abc import Sequence

import matplotlib
import numpy as np
from matplotlib.colors import Normalize
from matplotlib.figure import Figure

from book.palette import CSS_PIXELS_PER_INCH, palette

__all__ = ["difference_map", "panels", "strip", "to_bytes", "with_colour_bar"]

GAP = 12  # CSS pixels between two pictures
TITLE = 24  # ... above them, for their titles
BAR = 14  # the colour bar's breadth
BAR_LABELS = 68  # the room for its numbers and its label


def to_bytes(rgb: np.ndarray) -> np.ndarray:
    """Linear light in [0, 1] as sRGB bytes (IEC 61966-2-1)."""
    linear = np.clip(np.asarray(rgb, dtype=np.float64), 0.0, 1.0)
    encoded = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    return np.rint(encoded * 255).astype(np.uint8)


def enlarge(image: np.ndarray, scale: int) -> np.ndarray:
    """Each pixel as scale × scale pixels."""
    if scale < 1 or scale != int(scale):
        raise ValueError(f"scale={scale!r}: pixels are enlarged by a whole number, 1 or more")
    return np.repeat(np.repeat(image, scale, axis=0), scale, axis=1)


def strip(images: Sequence[np.ndarray], titles: Sequence[str] | None = None, scale: int = 1) -> np.ndarray:
    """Pictures beside each other at their own pixels: uint8 (h, w, 4), with gaps that let the page through.

    The order is always numeric, symbolic, difference. `titles` are drawn as pixels above the pictures;
    `panels` sets them as type, and is to be preferred where there are titles.
    """
    pictures = [_with_alpha(enlarge(image, scale)) for image in images]
    height = max(picture.shape[0] for picture in pictures)
    top = TITLE if titles else 0
    width = sum(picture.shape[1] for picture in pictures) + GAP * (len(pictures) - 1)
    sheet = np.zeros((top + height, width, 4), np.uint8)
    left = 0
    for index, picture in enumerate(pictures):
        sheet[top : top + picture.shape[0], left : left + picture.shape[1]] = picture
        if titles:
            _write(sheet, left, titles[index])
        left += picture.shape[1] + GAP
    return sheet


def difference_map(delta: np.ndarray, low: float = -16, high: float = 0) -> np.ndarray:
    """|delta| on a log scale from 10^low to 10^high as uint8 (h, w, 3); zero and NaN are black.

    Of several channels the largest counts.
    """
    size = np.abs(np.asarray(delta, dtype=np.float64))
    if size.ndim == 3:
        size = size.max(axis=2)
    drawn = size > 0  # False for NaN too
    exponent = np.log10(size, out=np.full(size.shape, float(low)), where=drawn)
    share = np.clip((exponent - low) / (high - low), 0.0, 1.0)
    colours = matplotlib.colormaps["inferno"](share, bytes=True)[..., :3]
    return np.where(drawn[..., None], colours, np.uint8(0))


def with_colour_bar(image: np.ndarray, low: float = -16, high: float = 0, label: str = "", scale: int = 1) -> Figure:
    """A difference map (or a strip that ends in one) with a bar in powers of ten at its right."""
    return panels([image], None, scale=scale, bar=(low, high), bar_label=label)


def panels(
    images: Sequence[np.ndarray], titles: Sequence[str] | None = None, scale: int = 1,
    bar: tuple[float, float] | None = None, bar_label: str = "",
) -> Figure:  # fmt: skip
    """Pictures beside each other with their titles as type, pixel for pixel, and a log colour bar if asked.

    Sizes are CSS pixels, one (or scale × scale) for each pixel of a picture, so nothing is resampled.
    """
    sizes = [(image.shape[1] * scale, image.shape[0] * scale) for image in images]
    top = TITLE if titles else 8 if bar else 0
    foot = 8 if bar else 0
    width = sum(w for w, _ in sizes) + GAP * (len(images) - 1) + (GAP + BAR + BAR_LABELS if bar else 0)
    height = top + max(h for _, h in sizes) + foot
    fig = Figure(figsize=(width / CSS_PIXELS_PER_INCH, height / CSS_PIXELS_PER_INCH), layout="none")
    fig.pixel_exact = True  # the page may not scale it
    left = 0
    for index, (image, (w, h)) in enumerate(zip(images, sizes, strict=True)):
        ax = fig.add_axes([left / width, (height - top - h) / height, w / width, h / height])
        ax.imshow(image, interpolation="none", aspect="auto")
        ax.set_axis_off()
        if titles:
            fig.text(left / width, 1 - 15 / height, titles[index], va="baseline", color=palette()["ink"])
        left += w + GAP
    if bar:
        tallest = max(h for _, h in sizes)
        box = [left / width, (height - top - tallest) / height, BAR / width, tallest / height]
        _colour_bar(fig, box, bar, bar_label)
    return fig


def _colour_bar(fig: Figure, box: list[float], limits: tuple[float, float], label: str) -> None:
    low, high = limits
    ax = fig.add_axes(box)
    mappable = matplotlib.cm.ScalarMappable(Normalize(low, high), matplotlib.colormaps["inferno"])
    bar = fig.colorbar(mappable, cax=ax)
    every = max(1, round((high - low) / 8))
    ticks = np.arange(low, high + 1e-9, every)
    bar.set_ticks(ticks, labels=[rf"$10^{{{tick:.0f}}}$" for tick in ticks])
    bar.outline.set_visible(False)
    ax.tick_params(length=0)
    if label:
        bar.set_label(label)


def _with_alpha(image: np.ndarray) -> np.ndarray:
    if image.dtype != np.uint8 or image.ndim != 3 or image.shape[2] not in (3, 4):
        raise ValueError(f"a picture is uint8 (h, w, 3 or 4), not {image.dtype} {image.shape}")
    if image.shape[2] == 4:
        return image
    return np.dstack([image, np.full(image.shape[:2], 255, np.uint8)])


def _write(sheet: np.ndarray, left: int, text: str) -> None:
    """Draw a title into the strip, in a grey that can be read on the light page and on the dark one."""
    from PIL import Image, ImageDraw, ImageFont

    fonts = matplotlib.get_data_path() + "/fonts/ttf/"
    page = Image.fromarray(sheet)
    font = ImageFont.truetype(fonts + "STIXGeneral.ttf", 15)
    ImageDraw.Draw(page).text((left, 2), text, font=font, fill=(122, 119, 112, 255))
    sheet[...] = np.asarray(page)
