"""The still pictures of the small interactives: what paper shows, and a page on which no script runs."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import ArrayLike

from book.drawing.palette import CSS_PIXELS_PER_INCH
from book.drawing.registry import Drawing, figure
from book.drawing.style import palette
from book.figures.chapter_scene import SCENE
from book.idea_kernels import bump_at
from renderer import Scene, exact, render
from renderer.frame import Frame
from renderer.generate.creases import crease_point
from renderer.views import image_view, to_bytes

PARALLEL, POINT = 0.125, 0.453  # v of the circle, u of the point on it
LIGHT = SCENE.lights[0]


def pixel_axes(fig: Figure, left: float, top: float, wide: float, high: float, **limits: Any) -> Axes:
    """Return axes that fill a box given in CSS pixels from the figure's upper left corner, without a frame."""
    width, height = (size * CSS_PIXELS_PER_INCH for size in fig.get_size_inches())
    ax = fig.add_axes([left / width, (height - top - high) / height, wide / width, high / height])
    ax.set_axis_off()
    ax.set(**limits)
    return ax


def canvas(wide: float, high: float) -> Figure:
    """Return a figure of so many CSS pixels, which the page shows at that size."""
    fig = Figure(figsize=(wide / CSS_PIXELS_PER_INCH, high / CSS_PIXELS_PER_INCH), layout="none")
    fig.pixel_exact = True
    return fig


def along_circle(u: ArrayLike, beta: float = SCENE.beta) -> tuple[np.ndarray, ...]:
    """Return h, h_u, h_v, the tilt in degrees and μ at points of the circle."""
    return bump_at(np.asarray(u, float), PARALLEL, SCENE.ku, SCENE.kv, beta, SCENE.radius, *LIGHT.position)


def on_circle(u: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the image points of points of the circle."""
    with np.errstate(divide="ignore", invalid="ignore"):  # a selection computes both of its sides
        return crease_point(1.0, 0.0, u, PARALLEL, SCENE.eye, SCENE.radius)


def on_picture(frame: Frame, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return image points as columns and rows of a frame, not rounded."""
    columns, rows = frame.raster.image_points(SCENE)
    return (x - columns[0]) / (columns[1] - columns[0]), (rows[0] - y) / (columns[1] - columns[0])


@figure("slope_is_texture")
def slope_is_texture() -> Drawing:
    """The height along a circle of the sphere, the normals that its slope tilts, the light that they catch."""
    fig, c = canvas(928, 308), palette()
    u, few = np.linspace(0, 1, 513), (np.arange(32) + 0.5) / 32
    (h, *_), (at_h, slope, _, tilt, lit), (*_, unlit) = along_circle(u), along_circle(POINT), along_circle(POINT, 0.0)
    top = pixel_axes(fig, 0, 26, 590, 84, xlim=(-0.01, 1.01), ylim=(-0.1, 1.12))
    top.plot(u, h, color=c["ink"], linewidth=1.2)
    run = 0.035
    top.plot([POINT - run, POINT + run], [at_h - run * slope, at_h + run * slope], color=c["symbolic"], linewidth=2)
    top.plot(POINT, at_h, "o", color=c["symbolic"], markersize=7)
    middle = pixel_axes(fig, 0, 130, 590, 70, xlim=(-0.01, 1.01), ylim=(-12, 58))
    middle.plot([0, 1], [0, 0], color=c["ink"], linewidth=1.2)
    _, slopes, _, tilts, _ = along_circle(few)
    arrows = {"scale": 1, "scale_units": "y", "angles": "uv", "units": "dots"}
    for at, leaning, turns, size, look in (
        (few, slopes, tilts, 24, {"color": c["muted"], "width": 1}),
        (POINT, slope, tilt, 42, {"color": c["symbolic"], "width": 3}),
    ):
        turn = np.radians(np.sign(leaning) * turns)
        middle.quiver(at, np.zeros_like(at), size * np.sin(turn), size * np.cos(turn), **arrows, **look)
    between = (u[1:] + u[:-1]) / 2
    strips = {beta: along_circle(between, beta)[4] for beta in (0.0, SCENE.beta)}
    for at, high, mu in ((220, 20, strips[0.0]), (264, 32, strips[SCENE.beta])):
        shown = to_bytes(np.repeat(mu[None, :, None], 3, axis=2))
        pixel_axes(fig, 6, at, 578, high).imshow(shown, aspect="auto", interpolation="nearest")
    frame = render(Scene(ball=False, lights=(LIGHT,)), 360, 360, exact(), crop=(30, 4, 300, 300))
    right = pixel_axes(fig, 628, 8, 300, 300)
    right.imshow(image_view(frame), interpolation="none", aspect="auto")
    x, y = on_picture(frame, *on_circle(np.append(u, POINT)))
    right.plot(x[:-1], y[:-1], color="white", linewidth=1, linestyle=(0, (3, 4)))
    right.plot(x[-1], y[-1], "o", color=c["symbolic"], markeredgecolor="white", markersize=8)
    for y_at, words in (
        (18, "the height $h$ along the circle, and its slope at the point"),
        (136, "the surface stays flat; its normals lean"),
        (214, "the light without the bump"),
        (258, "and with it"),
    ):
        fig.text(6 / 928, 1 - y_at / 308, words, color=c["muted"], va="baseline")
    fig.pictures = (image_view(frame),)
    numbers = {
        "u": POINT,
        "slope": slope,
        "tilt": tilt,
        "light": lit,
        "unlit": unlit,
        "steepest": np.pi * SCENE.ku,
        "worst": along_circle(1e-9)[3],
        "beta": SCENE.beta,
    }
    return Drawing(
        fig,
        numbers=numbers,
        data={"u": u, "height": h, "between": between, "light": strips[SCENE.beta], "circle_x": x, "circle_y": y},
    )
