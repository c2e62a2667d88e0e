"""A map of stored normals: its error against the texels, and the two pipelines that meet in it."""

from functools import cache

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import DOTTED, SOLID, curve, decades, label_curve, plot, slope_triangle
from renderer import Scene, central, exact
from renderer.picture.differences import rms
from verify.accuracy.frontiers import normal_map
from verify.accuracy.frontiers.wall import order

AT, BEST_EPS = 513, 1e-6
CURVES = {  # name: (role, dashes, width)
    "bytes": ("muted", DOTTED, 1.3),
    "symbolic": ("symbolic", SOLID, 2.4),
    "numeric": ("numeric", (0, (5, 3)), 1.4),
    "between": ("difference", SOLID, 1.6),
}
_errors, _apart = cache(normal_map.errors), cache(normal_map.without_a_map)


def _same_bytes(scene):
    """Return the share of a map's bytes that exact gradients and differences of the best step agree on."""
    maps = (normal_map.in_bytes(normal_map.baked(scene, AT, method)) for method in (exact(), central(BEST_EPS)))
    return np.mean(np.equal(*maps))


@figure("normal_map")
def map_of_normals() -> Drawing:
    """How far a fetched normal is from N' against the texels: baked exactly, by differences, and one from the other."""
    texels = np.array(normal_map.TEXELS)
    fig, axes = plot(height=4.4, ncols=2, sharey=True)
    numbers, data = {"eps": normal_map.EPS, "at": AT, "best_eps": BEST_EPS}, {"texels": texels}
    for ax, field in zip(axes, ("sine", "ridges"), strict=True):
        errors = _errors(field)
        for name, (role, dashes, width) in CURVES.items():
            curve(ax, texels, errors[name], role, linestyle=dashes, linewidth=width)
        without = np.full(len(texels), _apart(field))
        curve(ax, texels, without, "numeric", linestyle=(0, (1, 2)))
        data[field] = {name: errors[name] for name in CURVES} | {"without_a_map": without}
        decades(ax, 1, 1, xlim=(25, 2500), ylim=(1e-5, 1), title=field, xlabel="texels across")
        numbers[field] = {name: values[normal_map.TEXELS.index(AT)] for name, values in errors.items()}
        numbers[field] |= {"order": order(errors["symbolic"], normal_map.TEXELS), "without": _apart(field)}
    sine, by_beta = _errors("sine"), normal_map.derivative_errors("sine", AT)
    numbers |= {"by_beta_rms": rms(by_beta), "by_beta_largest": by_beta.max()}
    numbers["same_at_the_best_step"] = _same_bytes(Scene(field="sine"))
    numbers["largest_of_ridges"] = _errors("ridges")["largest"].min()
    numbers["from_texels"] = AT * np.sqrt(numbers["sine"]["symbolic"] / _apart("sine"))
    axes[0].set_ylabel("RMS distance of unit normals")
    label_curve(axes[0], texels, 1.7 * sine["symbolic"], 65, "baked exactly,\nor by differences", "symbolic")
    label_curve(axes[0], texels, sine["bytes"], 900, "in 8 bits", "muted", "above")
    label_curve(axes[0], texels, sine["between"], 130, "one from the other", "difference", "below")
    slope_triangle(axes[0], 150, 1.2e-3, -2, decades=0.4)
    slope_triangle(axes[1], 100, 6e-3, -0.5, decades=0.5)
    return Drawing(fig, numbers, data)
