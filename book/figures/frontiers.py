"""Two frontiers, priced: a height field of texels, and the displaced surface that a bump is not."""

from functools import cache

import matplotlib
import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import (
    DASHED,
    DOTTED,
    SOLID,
    curve,
    decades,
    label_line_end,
    palette,
    panels,
    plot,
    slope_triangle,
)
from book.figures.chapter_scene import FINE, MARKED, SCENE, marked_by_light, symbolic
from verify.accuracy.frontiers import fiction, wall
from verify.accuracy.orders import fitted_slope

_errors, _silhouette, _leaks = cache(wall.errors), cache(fiction.silhouette_remainders), cache(fiction.leaks)


@figure
def frontier_wall() -> Drawing:
    """The error of h_u of an interpolated table against the number of texels: two fields, two interpolations."""
    texels = np.array(wall.TEXELS)
    fig, axes = plot(height=4.2, ncols=2, sharey=True)
    numbers, data = {"slope": np.pi * wall.KU, "points": wall.POINTS}, {"texels": texels}
    for ax, field in zip(axes, ("sine", "ridges"), strict=True):
        numbers[field], data[field] = {}, {}
        for kind, dash in (("bilinear", SOLID), ("cubic", DASHED)):
            largest, rms = _errors(field, kind)
            curve(ax, texels, largest, "difference", linestyle=dash, marker="o", markersize=4)
            curve(ax, texels, rms, "muted", linestyle=dash, linewidth=1.2)
            data[field][kind] = {"largest": largest, "rms": rms}
            orders = {"order": wall.order(largest), "rms_order": wall.order(rms)}
            numbers[field][kind] = orders | dict(zip(wall.TEXELS, largest, strict=True))
            if ax is axes[0]:
                label_line_end(ax, texels[0], largest[0], kind, "difference", "above")
        decades(ax, 1, 2, xlim=(20, 1000), title=field, xlabel="texels across")
    axes[0].set_ylabel("error of $h_u$")
    third = numbers["slope"] ** 3  # the central difference's error is ε²/6 of it
    numbers["as_step"] = np.sqrt(6 * numbers["sine"]["bilinear"][513] / third)
    ridges, rms = _errors("ridges", "bilinear")
    label_line_end(axes[1], texels[2], ridges[2], "largest", "difference", "above")
    label_line_end(axes[1], texels[2], rms[2] / 1.5, "RMS", "muted", "below")
    slope_triangle(axes[0], 120, 1.5e-1, -1, decades=0.5)
    slope_triangle(axes[0], 60, 3e-4, -3, decades=0.4)
    slope_triangle(axes[1], 120, 1.5e-1, -0.5, decades=0.5)
    return Drawing(fig, numbers, data)


MOST = 180  # degrees, the colours' upper end


@cache
def _angles(side):
    """Return {step: its map of angles}, the steps by short names."""
    maps = fiction.angle_maps(symbolic("ridges", side))
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
        fig.text(bar.x0 + 0.38 * bar.width, height, f"{angle}°", va=place, color=palette()["ink"])
    angles = {key: {"median": np.nanmedian(a), "largest": np.nanmax(a)} for key, a in _angles(256).items()}
    return Drawing(fig, {"beta": SCENE.beta, "most": MOST} | angles, _angles(side))


@figure
def frontier_silhouette() -> Drawing:
    """How far displacement moves the silhouette against β, and what the first two orders leave over."""
    betas = np.logspace(-3, -1.5, 13)
    moved, first, second = _silhouette(tuple(betas))
    fig, ax = plot(height=3.9)
    curve(ax, betas, moved, "ink", "displaced − smooth", linestyle=SOLID)
    curve(ax, betas, first, "difference", "less the first order", linestyle=DASHED)
    curve(ax, betas, second, "difference", "less the second, too", linestyle=DOTTED)
    decades(ax, 1, 2, xlabel="amplitude β", ylabel="radius of the silhouette, in $R$")
    numbers = {"beta": betas[-1], "moved": moved[-1], "left": second[-1]}
    for order, (line, below) in enumerate(((moved, 6), (first, 6), (second, 20))):
        slope_triangle(ax, 3e-3, np.interp(3e-3, betas, line) / below, order + 1, decades=0.4)
        numbers[f"order_{order}"] = fitted_slope(betas[:9], line[:9])
    data = {"beta": betas, "moved": moved, "less_first_order": first, "less_second_order": second}
    return Drawing(fig, numbers, data)


def _leak_maps(size):
    """Return {light: {what: map of bool}}: where it leaks, and where it is missed."""
    names = zip(("first", "second"), _leaks(SCENE, size), strict=True)
    return {name: {"leaks": leak, "missed": miss} for name, (leak, miss) in names}


@figure
def frontier_leaks() -> Drawing:
    """Where a light reaches what faces away from it, and where it misses what faces it, for each light."""
    yellow, blue = (0xF0, 0xE4, 0x42), (0x56, 0xB4, 0xE9)
    fig = marked_by_light([((miss, blue), (leak, yellow)) for leak, miss in _leaks(SCENE, MARKED * FINE)])
    counts = {name: {what: np.sum(flags) for what, flags in maps.items()} for name, maps in _leak_maps(256).items()}
    numbers = {"pixels_a": symbolic("ridges", 256).stage.on_a.sum()} | counts
    return Drawing(fig, numbers, _leak_maps(MARKED), (symbolic("ridges", MARKED * FINE),))


@figure
def blinn_angles() -> Drawing:
    """The median angle between the chapter's N', as it is and with its sign turned, and Blinn's, in degrees."""
    surface = {name: plane[symbolic().stage.on_a] for name, plane in symbolic().surface_data.items()}
    chapter, turned, _, blinn, _ = fiction.normals(SCENE, surface).values()
    apart = {"chapter": fiction.degrees(chapter, blinn), "turned": fiction.degrees(turned, blinn)}
    return Drawing(numbers={name: np.median(angles) for name, angles in apart.items()})
