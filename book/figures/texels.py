"""A height field of texels, and a map of stored normals: their errors against the texels."""

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import DASHED, DOTTED, SOLID, curve, decades, label_curve, label_line_end, plot, slope_triangle
from renderer import Scene, central, exact
from renderer.intervals import rms
from verify.accuracy.frontiers import normal_map, wall

FIELDS = ("sine", "ridges")
AT, BEST_EPS = 513, 1e-6
CURVES = {  # name: (role, dashes, width)
    "bytes": ("muted", DOTTED, 1.3),
    "symbolic": ("symbolic", SOLID, 2.4),
    "numeric": ("numeric", (0, (5, 3)), 1.4),
    "between": ("difference", SOLID, 1.6),
}


@figure
def frontier_wall() -> Drawing:
    """The error of h_u of an interpolated table against the number of texels: two fields, two interpolations."""
    texels, slope = np.array(wall.TEXELS), np.pi * wall.KU
    fig, axes = plot(height=4.2, ncols=2, sharey=True)
    numbers, data = {"slope": slope, "points": wall.POINTS}, {"texels": texels}
    for ax, field in zip(axes, FIELDS, strict=True):
        numbers[field], data[field] = {}, {}
        for kind, dash in (("bilinear", SOLID), ("cubic", DASHED)):
            largest, rms = wall.errors(field, kind)
            curve(ax, texels, largest, "difference", linestyle=dash, marker="o", markersize=4)
            curve(ax, texels, rms, "muted", linestyle=dash, linewidth=1.2)
            data[field][kind] = {"largest": largest, "rms": rms}
            orders = {"order": wall.order(largest), "rms_order": wall.order(rms)}
            numbers[field][kind] = orders | {AT: largest[wall.TEXELS.index(AT)]}
            if field == "sine":
                label_line_end(ax, texels[0], largest[0], kind, "difference", "above")
        decades(ax, 1, 2, xlim=(20, 1000), title=field, xlabel="texels across")
    axes[0].set_ylabel("error of $h_u$")
    # The central difference's error is ε²/6 of the third derivative.
    numbers["as_step"] = np.sqrt(6 * numbers["sine"]["bilinear"][AT] / slope**3)
    ridges, rms = data["ridges"]["bilinear"].values()
    label_line_end(axes[1], texels[2], ridges[2], "largest", "difference", "above")
    label_line_end(axes[1], texels[2], rms[2] / 1.5, "RMS", "muted", "below")
    slope_triangle(axes[0], 120, 1.5e-1, -1, decades=0.5)
    slope_triangle(axes[0], 60, 3e-4, -3, decades=0.4)
    slope_triangle(axes[1], 120, 1.5e-1, -0.5, decades=0.5)
    return Drawing(fig, numbers, data)


def _same_bytes(scene):
    """Return the share of a map's bytes that exact gradients and differences of the best step agree on."""
    maps = (normal_map.in_bytes(normal_map.baked(scene, AT, method)) for method in (exact(), central(BEST_EPS)))
    return np.mean(np.equal(*maps))


@figure("normal_map")
def map_of_normals() -> Drawing:
    """How far a fetched normal is from N' against the texels: baked exactly, by differences, and one from the other."""
    texels = np.array(normal_map.TEXELS)
    fig, axes = plot(height=4.4, ncols=2, sharey=True)
    numbers, data = {"eps": normal_map.EPS, "at": AT}, {"texels": texels}
    for ax, field in zip(axes, FIELDS, strict=True):
        errors, without = normal_map.errors(field), np.full(len(texels), normal_map.without_a_map(field))
        for name, (role, dashes, width) in CURVES.items():
            curve(ax, texels, errors[name], role, linestyle=dashes, linewidth=width)
        curve(ax, texels, without, "numeric", linestyle=(0, (1, 2)))
        data[field] = {name: errors[name] for name in CURVES} | {"without_a_map": without}
        decades(ax, 1, 1, xlim=(25, 2500), ylim=(1e-5, 1), title=field, xlabel="texels across")
        at = normal_map.TEXELS.index(AT)
        numbers[field] = {name: errors[name][at] for name in ("symbolic", "between", "largest")}
        numbers[field]["order"] = wall.order(errors["symbolic"], normal_map.TEXELS)
    sine, by_beta = data["sine"], normal_map.derivative_errors("sine", AT)
    numbers |= {"by_beta_rms": rms(by_beta), "by_beta_largest": by_beta.max()}
    numbers["same_at_the_best_step"] = _same_bytes(Scene(field="sine"))
    axes[0].set_ylabel("RMS distance of unit normals")
    for text, heights, at, role, side in (
        ("baked exactly,\nor by differences", 1.7 * sine["symbolic"], 65, "symbolic", "right"),
        ("in 8 bits", sine["bytes"], 900, "muted", "above"),
        ("one from the other", sine["between"], 130, "difference", "below"),
    ):
        label_curve(axes[0], texels, heights, at, text, role, side)
    slope_triangle(axes[0], 150, 1.2e-3, -2, decades=0.4)
    slope_triangle(axes[1], 100, 6e-3, -0.5, decades=0.5)
    return Drawing(fig, numbers, data)
