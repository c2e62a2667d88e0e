"""What true displacement moves: the outline, the cast shadows' edges, and which surface is in front."""

from functools import cache

import numpy as np

from book.drawing.palette import readable
from book.drawing.registry import Drawing, figure
from book.drawing.style import decades, label_line_end, palette, plot, slope_triangle
from verify.accuracy.frontiers import boundaries

SHOWN, SIDE = 0.1, 256
BETAS = np.logspace(-3, -1.5, 13)
ORDERS = np.geomspace(0.01, 0.1, 5)
SCENE = boundaries.SCENE
LIGHTS = {name: np.array(light.position) for name, light in zip(("first", "second"), SCENE.lights, strict=True)}


@cache
def _shadow(name):
    return boundaries.shadow_remainders(BETAS, LIGHTS[name])


@cache
def _edges():
    """Return {curve: (x, y)} on the floor, which is the image plane: the outline and each shadow's edge, twice."""
    around, curves = np.linspace(-np.pi, np.pi, 721), {}
    for kind, beta in (("smooth", 0.0), ("displaced", SHOWN)):
        found = {"outline": (boundaries.outline(SCENE, around, beta), around)}
        for name, light in LIGHTS.items():
            azimuths = boundaries.away_from(light, 181)
            found[f"shadow_{name}"] = boundaries.edge(SCENE, light, azimuths, beta), azimuths
        curves |= {f"{kind}_{name}": (s * np.cos(a), s * np.sin(a)) for name, (s, a) in found.items()}
    return curves


@cache
def _changed():
    """Return the pixels whose first surface is another than without β: of all for each of ORDERS, and of B at most."""
    plain = boundaries.first_surface(SCENE, 0.0, SIDE)
    pictures = [boundaries.first_surface(SCENE, beta, SIDE) for beta in (*ORDERS, 0.35)]
    counts = [np.count_nonzero(picture != plain) for picture in pictures]
    return np.array(counts[:-1]), max(np.count_nonzero((p == 2) != (plain == 2)) for p in pictures)


def _draw_map(ax):
    """Draw the outline and the shadows' edges, smooth in grey and displaced in colour."""
    colours, data = palette(), {}
    ink = {"outline": colours["ink"], "shadow_first": colours["difference"], "shadow_second": colours["reference"]}
    for name, (x, y) in _edges().items():
        kind, what = name.split("_", 1)
        grey = kind == "smooth"
        ax.plot(x, y, color=colours["muted"] if grey else ink[what], linewidth=1 if grey else 1.7,
                linestyle=(0, (4, 3)) if grey else (0, ()))  # fmt: skip
        data |= {f"{name}_x": x, f"{name}_y": y}
    title = f"β = {SHOWN}; dashed, without"
    ax.set(aspect="equal", xlim=(-1.6, 1.7), ylim=(-1.55, 1.3), xticks=[], yticks=[], title=title)
    labels = {"outline": (0.0, 0.2, "outline"), "shadow_first": (-0.95, -1.5, "shadow, first light"),
              "shadow_second": (1.2, -1.2, "second light")}  # fmt: skip
    for name, (x, y, text) in labels.items():
        ax.annotate(text, (x, y), color=readable(ink[name]), ha="center")
    return data


@figure("frontier_boundaries")
def frontier_boundaries() -> Drawing:
    """The outline and the cast shadows of the displaced surface beside the smooth one's, and their shift against β."""
    fig, (left, right) = plot("page", height=4.2, ncols=2, width_ratios=(1, 1.15))
    data, colours, numbers = _draw_map(left), palette(), {"shown": SHOWN, "beta": BETAS[-1], "side": SIDE}
    for name, role in (("first", "difference"), ("second", "reference")):
        moved, rest = _shadow(name)
        right.plot(BETAS, moved, color=colours[role])
        right.plot(BETAS, rest, color=colours[role], linestyle=(0, (5, 2)))
        data |= {f"{name}_moved": moved, f"{name}_left": rest}
        for what, curve in (("order", moved), ("left_order", rest)):
            numbers[f"{name}_{what}"] = np.polyfit(np.log(BETAS[:9]), np.log(curve[:9]), 1)[0]
        numbers[f"{name}_moved"] = moved[-1]
    label_line_end(right, BETAS[-1], _shadow("first")[0][-1], "displaced\n− smooth", colours["ink"])
    label_line_end(right, BETAS[-1], _shadow("first")[1][-1], "less the\nfirst order", colours["ink"])
    slope_triangle(right, 3e-3, 8e-4, 1, "1", decades=0.4)
    slope_triangle(right, 6e-3, 5e-5, 2, "2", decades=0.4)
    decades(right, 1, 1, xlabel="amplitude β", ylabel="shift of the shadow's edge, in $R$")
    changed, of_b = _changed()
    numbers |= {"changed": int(changed[-1]), "changed_of_b": int(of_b), "largest_beta": 0.35}
    numbers["order_of_order"] = np.polyfit(np.log(ORDERS), np.log(changed), 1)[0]
    return Drawing(fig, numbers=numbers, data=data | {"beta": BETAS, "orders_beta": ORDERS, "orders_changed": changed})
