"""The frontiers: a height field of texels, a map of stored normals, the outline of the displaced surface."""

from itertools import product

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import DOTTED, SOLID, curve, decades, label_curve, plot, slope_triangle
from renderer import Scene, central, exact
from renderer.intervals import rms
from verify.accuracy.frontiers import fiction, normal_map, wall
from verify.accuracy.orders import fitted_slope

FIELDS = ("sine", "ridges")
AT, BEST_EPS = 513, 1e-6
CURVES = {  # name: (role, dashes, width, its label, whose side, at how many texels)
    "bytes": ("muted", DOTTED, 1.3, "in 8 bits", "above", 900),
    "symbolic": ("symbolic", SOLID, 2.4, "", "right", None),
    "numeric": ("numeric", (0, (5, 3)), 1.4, "", "right", None),
    "between": ("difference", SOLID, 1.6, "one from the other", "below", 130),
}


@figure
def frontier_wall() -> Drawing:
    """The error of h_u of an interpolated table of texels: two fields, two interpolations; numbers only."""
    numbers, at = {"slope": np.pi * wall.KU, "points": wall.POINTS}, wall.TEXELS.index(AT)
    for field, kind in product(FIELDS, ("bilinear", "cubic")):
        largest, rms = wall.errors(field, kind)
        results = {"order": wall.order(largest), "rms_order": wall.order(rms), AT: largest[at]}
        numbers |= {f"{field}_{kind}_{name}": number for name, number in results.items()}
    # The central difference's error is ε²/6 of the third derivative.
    numbers["as_step"] = np.sqrt(6 * numbers[f"sine_bilinear_{AT}"] / numbers["slope"] ** 3)
    return Drawing(numbers=numbers)


def _same_bytes(scene):
    """Return the share of a map's bytes that exact gradients and differences of the best step agree on."""
    maps = (normal_map.in_bytes(normal_map.baked(scene, AT, method)) for method in (exact(), central(BEST_EPS)))
    return np.mean(np.equal(*maps))


@figure("normal_map")
def map_of_normals() -> Drawing:
    """Distance of a fetched normal from N' against the texels: baked exactly, by differences, one from the other."""
    texels = np.array(normal_map.TEXELS)
    fig, axes = plot(height=4.4, ncols=2, sharey=True)
    numbers, at = {"eps": normal_map.EPS, "at": AT}, normal_map.TEXELS.index(AT)
    for ax, field in zip(axes, FIELDS, strict=True):
        errors, without = normal_map.errors(field), np.full(len(texels), normal_map.without_a_map(field))
        for name, (role, dashes, width, text, side, there) in CURVES.items():
            text = text if field == "sine" else ""
            curve(ax, texels, errors[name], role, text, side, there, label=name, linestyle=dashes, linewidth=width)
        curve(ax, texels, without, "numeric", label="without a map", linestyle=(0, (1, 2)))
        decades(ax, 1, 1, xlim=(25, 2500), ylim=(1e-5, 1), title=field, xlabel="texels across")
        numbers[field] = {name: errors[name][at] for name in ("symbolic", "between", "largest")}
        numbers[field]["order"] = wall.order(errors["symbolic"], normal_map.TEXELS)
    by_beta = normal_map.derivative_errors("sine", AT)
    numbers |= {"by_beta_rms": rms(by_beta), "by_beta_largest": by_beta.max()}
    numbers["same_at_the_best_step"] = _same_bytes(Scene(field="sine"))
    axes[0].set_ylabel("RMS distance of unit normals")
    words = "baked exactly,\nor by differences"
    label_curve(axes[0], texels, 1.7 * normal_map.errors("sine")["symbolic"], 65, words, "symbolic")
    slope_triangle(axes[0], 150, 1.2e-3, -2, decades=0.4)
    slope_triangle(axes[1], 100, 6e-3, -0.5, decades=0.5)
    return Drawing(fig, numbers)


BETAS, SMALLEST = np.logspace(-3, -1.5, 13), slice(9)  # ... of which orders are fitted to


@figure
def frontier_silhouette() -> Drawing:
    """Displacement of the silhouette against β, and the remainders after the first two orders; numbers only."""
    lefts = fiction.silhouette_remainders(BETAS)
    orders = {f"order_{n}": fitted_slope(BETAS[SMALLEST], left[SMALLEST]) for n, left in enumerate(lefts)}
    return Drawing(numbers={"beta": BETAS[-1], "moved": lefts[0][-1]} | orders)
