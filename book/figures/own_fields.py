"""Three fields that are not the chapter's, each from one line of text: picture, certified bound and U-curve."""

from functools import cache

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import curve, decades, dots, panels, plot
from book.figures.chapter_scene import FINE, SIZE, certified_numbers, smooth
from renderer import HeightField, Scene, render, u, v
from renderer.generate.expression import parse_expression
from renderer.picture.differences import rounded_up
from renderer.picture.views import difference_logarithmic
from verify.accuracy.any_field import u_curve

TEXTS = {
    "crater": "exp(-150*(v - 1/5)**2) - exp(-60*v**2)/2",
    "dunes": "v*(1 + sinpi(k_u*u + 4*sinpi(2*v)))**2/2",
    "hill": "9*v**2*exp(4*(cospi(2*u - 7/4) - 1) - 60*(v - 1/5)**2)",
}
LOW, HIGH = -18, -9
POINT = {"u": 0.81, "v": 0.23}
STEPS = np.logspace(-1, -12, 177)


@cache
def scene_of(name: str) -> Scene:
    """Return the chapter's scene with one of the three fields."""
    return Scene(field=HeightField(name, parse_expression(TEXTS[name])))


@figure
def own_fields() -> Drawing:
    """Crater, dunes and a hill on sphere A, and the certified bound of each picture."""
    columns, numbers, frames, data = [], {}, [], {}
    for name in TEXTS:
        fine, frame = (render(scene_of(name), side, side, bounds=True) for side in (SIZE * FINE, SIZE))
        bounds = difference_logarithmic(frame.bounds, LOW, HIGH)
        columns.append(np.vstack([smooth(fine), bounds]))
        frames.append(frame)
        data[f"{name}_log10_bound"] = np.log10(np.maximum(frame.bounds.max(axis=2), 10.0**LOW)).astype(np.float16)
        numbers[name] = certified_numbers(frame)
    fig = panels(columns, tuple(TEXTS), (LOW, HIGH), "bound of a channel")
    return Drawing(fig, numbers | {"side": SIZE}, data, tuple(frames))


@figure
def own_u_curves() -> Drawing:
    """The error of the central difference of crater, dunes and hill against its step, and the bound on it."""
    fig, axes = plot("page", 3.3, ncols=len(TEXTS), sharey=True)
    numbers, data = dict(POINT), {"step": STEPS}
    for ax, name in zip(axes, TEXTS, strict=True):
        scene = scene_of(name)
        along = v if name == "crater" else u  # which is round
        found = u_curve(scene.field, along, POINT | {"k_u": scene.ku, "k_v": scene.kv}, STEPS)
        if (found.error > found.bound).any():
            raise ValueError(f"an error of {name} is above its bound")
        dots(ax, STEPS, found.error, "numeric", 2.2)
        curve(ax, STEPS, found.bound, "bound")
        decades(ax, 3, 3, xlabel="step ε", title=f"{name}, $h_{along.name}$", ylim=(1e-16, 1e3))
        best = found.bound.argmin()
        numbers[name] = {
            "best_eps": STEPS[best],
            "bound": float(rounded_up(found.bound[best], 2)),
            "least": found.error[found.error > 0].min(),
            "median_share": np.median(found.error / found.bound),
        }
        data |= {f"{name}_error": found.error, f"{name}_bound": found.bound}
    axes[0].set_ylabel("error of the slope")
    return Drawing(fig, numbers, data)
