"""What true displacement moves: the outline, the cast shadows' edges, and which surface is in front."""

from functools import cache

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import DASHED, curve, decades, label, label_line_end, plot, slope_triangle
from verify.accuracy.frontiers import boundaries
from verify.accuracy.orders import fitted_slope

SHOWN, LARGEST, SIDE = 0.1, 0.35, 256  # two β, and the raster's side
BETAS = np.logspace(-3, -1.5, 13)
ORDERS = np.geomspace(0.01, 0.1, 5)
SCENE = boundaries.SCENE
LIGHTS = {name: np.array(light.position) for name, light in zip(("first", "second"), SCENE.lights, strict=True)}


@cache
def _shadow(name):
    return boundaries.shadow_remainders(BETAS, LIGHTS[name])


@cache
def _edges():
    """Return {"smooth" or "displaced": {curve: its x and y}} on the floor, the image plane: outline, shadows' edges."""
    around, curves = np.linspace(-np.pi, np.pi, 721), {}
    for kind, beta in (("smooth", 0.0), ("displaced", SHOWN)):
        polar = {"outline": (boundaries.outline(SCENE, around, beta), around)}
        for name, light in LIGHTS.items():
            azimuths = boundaries.away_from(light, 181)
            polar[f"shadow_{name}"] = boundaries.edge(SCENE, light, azimuths, beta), azimuths
        curves[kind] = {name: {"x": s * np.cos(a), "y": s * np.sin(a)} for name, (s, a) in polar.items()}
    return curves


@cache
def _changed():
    """Return the pixels whose first surface is another than without β: of all for each of ORDERS, and of B at most."""
    plain = boundaries.first_surface(SCENE, 0.0, SIDE)
    pictures = [boundaries.first_surface(SCENE, beta, SIDE) for beta in (*ORDERS, LARGEST)]
    counts = [np.count_nonzero(picture != plain) for picture in pictures]
    return np.array(counts[:-1]), max(np.count_nonzero((p == 2) != (plain == 2)) for p in pictures)


def _draw_map(ax):
    """Draw the outline and the shadows' edges, smooth in grey and displaced in colour, with their names."""
    for edge in _edges()["smooth"].values():
        curve(ax, edge["x"], edge["y"], "muted", linewidth=1, linestyle=(0, (4, 3)))
    for name, role, at, text in (
        ("outline", "ink", (0.0, 0.2), "outline"),
        ("shadow_first", "difference", (-0.95, -1.5), "shadow, first light"),
        ("shadow_second", "reference", (1.2, -1.2), "second light"),
    ):
        edge = _edges()["displaced"][name]
        curve(ax, edge["x"], edge["y"], role)
        label(ax, at, text, role, (0, 0), ha="center")
    title = f"β = {SHOWN}; dashed, without"
    ax.set(aspect="equal", xlim=(-1.6, 1.7), ylim=(-1.55, 1.3), xticks=[], yticks=[], title=title)


@figure
def frontier_boundaries() -> Drawing:
    """The outline and the cast shadows of the displaced surface beside the smooth one's, and their shift against β."""
    fig, (left, right) = plot("page", height=4.2, ncols=2, width_ratios=(1, 1.15))
    _draw_map(left)
    numbers, data = {"shown": SHOWN, "beta": BETAS[-1], "side": SIDE}, dict(_edges())
    for name, role in (("first", "difference"), ("second", "reference")):
        moved, rest = _shadow(name)
        curve(right, BETAS, moved, role)
        curve(right, BETAS, rest, role, linestyle=DASHED)
        data[name] = {"moved": moved, "left": rest}
        orders = {"order": fitted_slope(BETAS[:9], moved[:9]), "left_order": fitted_slope(BETAS[:9], rest[:9])}
        numbers[name] = orders | {"moved": moved[-1]}
    for heights, text in zip(_shadow("first"), ("displaced\n− smooth", "less the\nfirst order"), strict=True):
        label_line_end(right, BETAS[-1], heights[-1], text, "ink")
    slope_triangle(right, 3e-3, 8e-4, 1, decades=0.4)
    slope_triangle(right, 6e-3, 5e-5, 2, decades=0.4)
    decades(right, 1, 1, xlabel="amplitude β", ylabel="shift of the shadow's edge, in $R$")
    changed, of_b = _changed()
    numbers |= {"changed": changed[-1], "changed_of_b": of_b, "largest_beta": LARGEST}
    numbers["order_of_order"] = fitted_slope(ORDERS, changed)
    return Drawing(fig, numbers, data | {"beta": BETAS, "orders": {"beta": ORDERS, "changed": changed}})
