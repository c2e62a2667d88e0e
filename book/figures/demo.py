"""Two figures that show what the machinery does. To be replaced by the chapter's own."""

import numpy as np

from book.figures.registry import Drawing, figure
from book.style import decades, difference_map, label_line_end, palette, panels, plot, slope_triangle


@figure("demo_curve")
def demo_curve() -> Drawing:
    """The error of a central difference of exp at 0 against its step."""
    steps = np.logspace(-12, 0, 97)
    errors = np.abs((np.exp(steps) - np.exp(-steps)) / (2 * steps) - 1) + 1e-17
    fig, ax = plot(height=3.6)
    colour = palette()["numeric"]
    ax.plot(steps, errors, color=colour)
    decades(ax, "both", every=2)
    label_line_end(ax, steps[-1], errors[-1], "central\ndifference", colour)
    slope_triangle(ax, 1e-3, 2e-8, 2, "2")
    ax.set_xlabel("step")
    ax.set_ylabel("error")
    return Drawing(fig, numbers={"least": errors.min(), "steps": len(steps)})


@figure("hero")
def hero() -> Drawing:
    """A lit sphere, split down the middle: a stand-in for the front page."""
    y, x = np.mgrid[1:-1:360j, -2:2:720j]
    z = np.sqrt(np.clip(0.64 - x * x - y * y, 0, None))
    light = np.clip(0.1 + 0.9 * (0.5 * x + 0.6 * y + 0.6 * z) / 0.8, 0, 1) * (z > 0)
    picture = np.repeat((255 * light[..., None]).astype(np.uint8), 3, axis=2)
    picture[:, 360:, 0] //= 2
    return Drawing(picture, numbers={"width": 720})


@figure("demo_panels")
def demo_panels() -> Drawing:
    """Three pictures and a colour bar."""
    y, x = np.mgrid[-1:1:256j, -1:1:256j]
    noise = np.random.default_rng(0).integers(0, 256, (256, 256, 3), dtype=np.uint8)
    delta = np.where(x * x + y * y < 0.8, 10 ** (-8 + 7 * np.sin(9 * x) * y), 0)
    pictures = [noise, noise[::-1], difference_map(delta)]
    return Drawing(panels(pictures, ["numeric", "symbolic", "difference"], bar=(-16, 0), bar_label="largest channel"))
