"""A map of stored normals: its error against the texels, and the two pipelines that meet in it."""

from functools import cache

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import decades, label_curve, palette, plot, slope_triangle
from renderer import Scene, central, exact
from verify.accuracy.frontiers import normal_map
from verify.accuracy.frontiers.wall import order

AT, BEST_EPS = 513, 1e-6
CURVES = {  # name: (role, dashes, width)
    "bytes": ("muted", (0, (1.5, 1.5)), 1.3),
    "symbolic": ("symbolic", (0, ()), 2.4),
    "numeric": ("numeric", (0, (5, 3)), 1.4),
    "between": ("difference", (0, ()), 1.6),
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
        found = _errors(field)
        for name, (role, dashes, width) in CURVES.items():
            ax.plot(texels, found[name], color=palette()[role], linestyle=dashes, linewidth=width)
        data |= {f"{field}_{name}": found[name] for name in CURVES}
        data[f"{field}_without_a_map"] = np.full(len(texels), _apart(field))
        ax.plot(texels, data[f"{field}_without_a_map"], color=palette()["numeric"], linestyle=(0, (1, 2)))
        decades(ax, 1, 1, xlim=(25, 2500), ylim=(1e-5, 1), title=field, xlabel="texels across")
        numbers |= {f"{field}_order": order(found["symbolic"], normal_map.TEXELS), f"{field}_without": _apart(field)}
        numbers |= {f"{field}_{name}": found[name][normal_map.TEXELS.index(AT)] for name in found}
    numbers["same_at_the_best_step"] = _same_bytes(Scene(field="sine"))
    numbers["largest_of_ridges"] = _errors("ridges")["largest"].min()
    numbers["from_texels"] = AT * np.sqrt(numbers["sine_symbolic"] / numbers["sine_without"])
    axes[0].set_ylabel("RMS distance of unit normals")
    sine, colours, both = _errors("sine"), palette(), "baked exactly,\nor by differences"
    label_curve(axes[0], texels, sine["symbolic"], 65, both, colours["symbolic"], times=1.7)
    label_curve(axes[0], texels, sine["bytes"], 900, "in 8 bits", colours["muted"], side="above")
    label_curve(axes[0], texels, sine["between"], 130, "one from the other", colours["difference"], side="below")
    slope_triangle(axes[0], 150, 1.2e-3, -2, "2", decades=0.4)
    slope_triangle(axes[1], 100, 6e-3, -0.5, "½", decades=0.5)
    return Drawing(fig, numbers=numbers, data=data)
