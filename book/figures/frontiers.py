"""Two frontiers, priced: a height field of texels, and the displaced surface that a bump is not."""

from functools import cache

import matplotlib
import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import decades, label_line_end, palette, panels, plot, slope_triangle
from book.figures.chapter_scene import FINE, MARKED, SCENE, marked_by_light, symbolic
from verify.accuracy.frontiers import fiction, wall

KINDS = {"bilinear": (0, ()), "cubic": (0, (5, 2))}


_errors, _silhouette, _leaks = cache(wall.errors), cache(fiction.silhouette_remainders), cache(fiction.leaks)


@figure("frontier_wall")
def frontier_wall() -> Drawing:
    """The error of h_u of an interpolated table against the number of texels: two fields, two interpolations."""
    texels = np.array(wall.TEXELS)
    fig, axes = plot(height=4.2, ncols=2, sharey=True)
    colour, numbers = palette()["difference"], {"slope": np.pi * wall.KU, "points": wall.POINTS}
    data = {"texels": texels}
    for ax, field in zip(axes, ("sine", "ridges"), strict=True):
        for kind, dash in KINDS.items():
            largest, rms = _errors(field, kind)
            data |= {f"{field}_{kind}_largest": largest, f"{field}_{kind}_rms": rms}
            ax.plot(texels, largest, color=colour, linestyle=dash, marker="o", markersize=4)
            ax.plot(texels, rms, color=palette()["muted"], linestyle=dash, linewidth=1.2)
            numbers |= {f"{field}_{kind}_order": wall.order(largest), f"{field}_{kind}_rms_order": wall.order(rms)}
            numbers |= {f"{field}_{kind}_{n}": error for n, error in zip(wall.TEXELS, largest, strict=True)}
            if ax is axes[0]:
                label_line_end(ax, texels[0], largest[0], kind, colour, side="above")
        decades(ax, 1, 2, xlim=(20, 1000), title=field, xlabel="texels across")
    axes[0].set_ylabel("error of $h_u$")
    third = numbers["slope"] ** 3  # the central difference's error is ε²/6 of it
    numbers["as_step"] = np.sqrt(6 * numbers["sine_bilinear_513"] / third)
    ridges, rms = _errors("ridges", "bilinear")
    label_line_end(axes[1], texels[2], ridges[2], "largest", colour, side="above")
    label_line_end(axes[1], texels[2], rms[2] / 1.5, "RMS", palette()["muted"], side="below")
    slope_triangle(axes[0], 120, 1.5e-1, -1, "1", decades=0.5)
    slope_triangle(axes[0], 60, 3e-4, -3, "3", decades=0.4)
    slope_triangle(axes[1], 120, 1.5e-1, -0.5, "½", decades=0.5)
    return Drawing(fig, numbers=numbers, data=data)


MOST = 180  # degrees, the colours' upper end


@cache
def _angles(side):
    return fiction.angle_maps(symbolic("ridges", side))


def _colours(angle):
    """Return angles in degrees in the colours of inferno, black where there is none."""
    return matplotlib.colormaps["inferno"](np.clip(np.nan_to_num(angle) / MOST, 0, 1), bytes=True)[..., :3]


def _degree_bar(tall):
    """Return the colours of 0 to MOST degrees from bottom to top, and room for their numbers, (tall, 50, 4)."""
    bar = np.zeros((tall, 50, 4), np.uint8)
    bar[:, :14, :3] = _colours(np.linspace(MOST, 0, tall)[:, None])
    bar[:, :14, 3] = 255
    return bar


@figure("frontier_angles")
def frontier_angles() -> Drawing:
    """The angle between N' and the displaced surface's normal: the chapter's, and three mends, one at a time."""
    side, full = 200, _angles(256)
    pictures = [_colours(angles) for angles in _angles(side).values()]
    fig = panels([*pictures, _degree_bar(side)], [*fiction.STEPS, ""])
    bar = fig.axes[-1].get_position()
    for angle, place in ((0, "bottom"), (90, "center"), (180, "top")):
        height = bar.y0 + bar.height * angle / MOST
        fig.text(bar.x0 + 0.38 * bar.width, height, f"{angle}°", va=place, color=palette()["ink"])
    numbers = {"beta": SCENE.beta, "most": MOST}
    keys = ("chapter", "sign", "scale", "metric")
    for key, angles in zip(keys, full.values(), strict=True):
        numbers |= {f"{key}_median": np.nanmedian(angles), f"{key}_largest": np.nanmax(angles)}
    return Drawing(fig, numbers=numbers, data=dict(zip(keys, _angles(side).values(), strict=True)))


@figure("frontier_silhouette")
def frontier_silhouette() -> Drawing:
    """How far displacement moves the silhouette against β, and what the first two orders leave over."""
    betas = np.logspace(-3, -1.5, 13)
    moved, first, second = _silhouette(tuple(betas))
    fig, ax = plot(height=3.9)
    colour, ink = palette()["difference"], palette()["ink"]
    curves = (("displaced − smooth", moved, (0, ()), ink), ("less the first order", first, (0, (5, 2)), colour),
              ("less the second, too", second, (0, (1.5, 1.5)), colour))  # fmt: skip
    orders = []
    for name, curve, dash, shade in curves:
        ax.plot(betas, curve, color=shade, linestyle=dash)
        label_line_end(ax, betas[-1], curve[-1], name, shade)
        orders.append(np.polyfit(np.log(betas[:9]), np.log(curve[:9]), 1)[0])
    decades(ax, 1, 2, xlabel="amplitude β", ylabel="radius of the silhouette, in $R$")
    for curve, order, below in ((moved, "1", 6), (first, "2", 6), (second, "3", 20)):
        slope_triangle(ax, 3e-3, np.interp(3e-3, betas, curve) / below, int(order), order, decades=0.4)
    numbers = {f"order_{n}": order for n, order in enumerate(orders)}
    numbers |= {"beta": betas[-1], "moved": moved[-1], "left": second[-1]}
    data = {"beta": betas, "moved": moved, "less_first_order": first, "less_second_order": second}
    return Drawing(fig, numbers=numbers, data=data)


@figure("frontier_leaks")
def frontier_leaks() -> Drawing:
    """Where a light reaches what faces away from it, and where it misses what faces it, for each light."""
    colours = ((0xF0, 0xE4, 0x42), (0x56, 0xB4, 0xE9))
    fig = marked_by_light([zip(found[::-1], colours[::-1], strict=True) for found in _leaks(SCENE, MARKED * FINE)])
    numbers, data = {"pixels_a": int(symbolic("ridges", 256).stage.on_a.sum())}, {}
    for size, kept in ((256, numbers), (MARKED, data)):
        for name, (leak, miss) in zip(("first", "second"), _leaks(SCENE, size), strict=True):
            kept |= {f"{name}_leaks": leak, f"{name}_missed": miss}
    return Drawing(fig, numbers={key: int(np.sum(value)) for key, value in numbers.items()}, data=data)


@figure("blinn_angles")
def blinn_angles() -> Drawing:
    """The median angle between the chapter's N', as it is and with its sign turned, and Blinn's, in degrees."""
    surface = {name: plane[symbolic().stage.on_a] for name, plane in symbolic().surface_data.items()}
    found = fiction.normals(SCENE, surface)
    chapter, turned, _, blinn = (found[name] for name in fiction.STEPS)
    apart = {"chapter": fiction.degrees(chapter, blinn), "turned": fiction.degrees(turned, blinn)}
    return Drawing(numbers={name: float(np.median(angles)) for name, angles in apart.items()})
