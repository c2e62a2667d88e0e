"""The displaced surface that a bump is not: normals, lights that leak, and the silhouette that it would move."""

import matplotlib
import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import DASHED, DOTTED, SOLID, colour_of, curve, decades, panels, plot, slope_triangle
from book.figures.chapter_scene import FINE, MARKED, SCENE, marked_by_light, symbolic
from verify.accuracy.frontiers import fiction
from verify.accuracy.orders import fitted_slope

BETAS, SMALLEST = np.logspace(-3, -1.5, 13), slice(9)  # ... of which orders are fitted to
MOST = 180  # degrees, the colours' upper end
SIDE = 256  # of the raster
LIGHTS = "first", "second"


def _order(values):
    return fitted_slope(BETAS[SMALLEST], values[SMALLEST])


def _angles(side):
    """Return {step: its map of angles}, the steps by short names."""
    maps = fiction.angle_maps(symbolic(size=side))
    return dict(zip(("chapter", "sign", "scale", "metric"), maps.values(), strict=True))


def _colours(angle):
    """Return angles in degrees in the colours of inferno, black where there is none."""
    return matplotlib.colormaps["inferno"](np.clip(np.nan_to_num(angle) / MOST, 0, 1), bytes=True)[..., :3]


def _degree_bar(tall):
    """Return the colours of 0 to MOST degrees from bottom to top, and room for their numbers, (tall, 50, 4)."""
    bar = np.zeros((tall, 50, 4), np.uint8)
    bar[:, :14, :3] = _colours(np.linspace(MOST, 0, tall)[:, None])
    bar[:, :14, 3] = 255
    return bar


@figure
def frontier_angles() -> Drawing:
    """The angle between N' and the displaced surface's normal: the chapter's, and three mends, one at a time."""
    side = 200
    fig = panels([*map(_colours, _angles(side).values()), _degree_bar(side)], [*fiction.STEPS, ""])
    bar = fig.axes[-1].get_position()
    for angle, place in ((0, "bottom"), (90, "center"), (180, "top")):
        height = bar.y0 + bar.height * angle / MOST
        fig.text(bar.x0 + 0.38 * bar.width, height, f"{angle}°", va=place, color=colour_of("ink"))
    angles = {key: {"median": np.nanmedian(a), "largest": np.nanmax(a)} for key, a in _angles(SIDE).items()}
    return Drawing(fig, {"beta": SCENE.beta} | angles, _angles(side))


@figure
def frontier_silhouette() -> Drawing:
    """How far displacement moves the silhouette against β, and what the first two orders leave over."""
    fig, ax = plot(height=3.9)
    remainders, data = fiction.silhouette_remainders(BETAS), {"beta": BETAS}
    for left, (name, text, role, dash) in zip(remainders, (
        ("moved", "displaced − smooth", "ink", SOLID),
        ("less_first_order", "less the first order", "difference", DASHED),
        ("less_second_order", "less the second, too", "difference", DOTTED),
    ), strict=True):  # fmt: skip
        curve(ax, BETAS, left, role, text, linestyle=dash)
        data[name] = left
    decades(ax, 1, 2, xlabel="amplitude β", ylabel="radius of the silhouette, in $R$")
    numbers = {"beta": BETAS[-1], "moved": remainders[0][-1]}
    for order, (left, below) in enumerate(zip(remainders, (6, 6, 20), strict=True)):
        slope_triangle(ax, 3e-3, np.interp(3e-3, BETAS, left) / below, order + 1, decades=0.4)
        numbers[f"order_{order}"] = _order(left)
    return Drawing(fig, numbers, data)


def _leak_maps(size):
    """Return {light: {what: map of bool}}: where it leaks, and where it is missed."""
    return {
        name: dict(zip(("leaks", "missed"), maps, strict=True))
        for name, maps in zip(LIGHTS, fiction.leaks(SCENE, size), strict=True)
    }


@figure
def frontier_leaks() -> Drawing:
    """Where a light reaches what faces away from it, and where it misses what faces it, for each light."""
    yellow, blue = (0xF0, 0xE4, 0x42), (0x56, 0xB4, 0xE9)
    fig = marked_by_light([((miss, blue), (leak, yellow)) for leak, miss in fiction.leaks(SCENE, MARKED * FINE)])
    counts = {name: {what: np.sum(flags) for what, flags in maps.items()} for name, maps in _leak_maps(SIDE).items()}
    numbers = {"pixels_a": symbolic().stage.on_a.sum()} | counts
    return Drawing(fig, numbers, _leak_maps(MARKED), (symbolic(size=MARKED * FINE),))


@figure
def blinn_angles() -> Drawing:
    """The median angle between the chapter's N', as it is and with its sign turned, and Blinn's, in degrees."""
    surface = symbolic().data_on_a
    chapter, turned, _, blinn, _ = fiction.normals(SCENE, surface).values()
    apart = {"chapter": fiction.degrees(chapter, blinn), "turned": fiction.degrees(turned, blinn)}
    return Drawing(numbers={name: np.median(angles) for name, angles in apart.items()})
