"""Pictures made of the renderer's own pixels, never resampled, with their titles as type."""

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure

from book.drawing.palette import CSS_PIXELS_PER_INCH, palette
from renderer.views import add_colour_bar

__all__ = ["panels"]

GAP = 12  # CSS pixels between two pictures
TITLE = 24  # ... above them, for their titles
BAR = 14  # the colour bar's breadth
BAR_LABELS = 68  # the room for its numbers and its label


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
    fig.pictures = tuple(images)  # kept beside the figure, with its data
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
        add_colour_bar(fig, box, bar, bar_label)
    return fig
