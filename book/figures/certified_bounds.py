"""Certified bounds beside true errors: of small pictures, pixels by what is hard about them, fields of one's own."""

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import curve, decades, dots, label_line_end, panels, plot
from book.figures.chapter_scene import FIELD_NAMES, FINE, SIZE, certified_numbers, enlarged, smooth, symbolic
from renderer import HeightField, Scene, render, u, v
from renderer.generate.reader import parse_expression
from renderer.intervals import rounded_up
from renderer.picture.views import difference_logarithmic
from verify.accuracy.any_field import u_curve
from verify.accuracy.pixels import SCENES, checked_pixels, compared, problems

SIDE, ZOOM = 64, 4  # few enough pixels for 256-bit balls of every one
LOW, HIGH = -18, -8


@figure
def certified_bounds() -> Drawing:
    """The picture, the bound that it carries, and its true error, of every pixel of a small raster."""
    frame = symbolic(size=SIDE)
    places = ((column, row) for row in range(SIDE) for column in range(SIDE))
    off = [[float(each.upper()) for each in compared(frame, *place)[1]] for place in places]
    bounds, errors = frame.bounds, np.reshape(off, (SIDE, SIDE, 3))  # rounded up, from 256-bit balls
    if (errors > bounds).any():
        raise ValueError(f"{(errors > bounds).sum()} colours are further from the truth than their bound")
    fine = symbolic(size=SIZE * FINE)
    maps = [enlarged(difference_logarithmic(each, LOW, HIGH), ZOOM) for each in (bounds, errors)]
    pictures = [smooth(fine), *maps]
    fig = panels(pictures, ("the picture", "its bound", "its error"), (LOW, HIGH), "largest of a channel")
    numbers = {
        "side": SIDE,
        "colours": errors.size,
        "largest_error": float(rounded_up(errors.max(), 2)),
        "median_ratio": np.median(bounds[errors > 0] / errors[errors > 0]),
        "largest_share": (errors[bounds > 0] / bounds[bounds > 0]).max(),
    }
    numbers |= {field: certified_numbers(symbolic(field)) for field in FIELD_NAMES}
    data = {"bound": bounds.max(axis=2), "error": errors.max(axis=2)}
    return Drawing(fig, numbers | {"whole_side": SIZE}, data, (frame, fine))


EACH = 15


@figure
def reference_pixels() -> Drawing:
    """The largest channel error of pixels of each kind against 256-bit balls, and the bounds of their frames."""
    pixels = checked_pixels(SCENES, each=EACH)
    if wrong := problems(pixels):
        raise ValueError(f"{len(wrong)} pixels are off by more than their bound: {wrong[0]}")
    kinds = list(dict.fromkeys(p.kind for p in pixels))[::-1]
    fig, ax = plot(height=3.8)
    decided = [p for p in pixels if not p.undecided]
    for row, kind in enumerate(kinds):
        for what, role, marker, shift in (("error", "difference", "o", 0.12), ("bound", "reference", "|", -0.2)):
            values = [getattr(p, what) for p in decided if p.kind == kind and getattr(p, what) > 0]
            dots(ax, values, np.full(len(values), row + shift), role, 4, marker)
    ax.set_yticks(range(len(kinds)), kinds)
    limits = {"xlim": (1e-20, 1e-8), "ylim": (-0.6, len(kinds) - 0.1)}
    decades(ax, 2, None, **limits, xlabel="error of a channel, and its bound")
    label_line_end(ax, 7e-19, len(kinds) - 0.88, "error", "difference", "left")
    label_line_end(ax, 1e-10, len(kinds) - 1.2, "bound", "reference")
    numbers = {"pixels": len(pixels), "decided": len(decided), "largest": max(p.error for p in decided)}
    numbers["largest_share"] = max(p.error / p.bound for p in decided if p.bound > 0)
    data = {name: [getattr(p, name) for p in pixels] for name in ("kind", "error", "bound")}
    data["undecided"] = [bool(p.undecided) for p in pixels]
    return Drawing(fig, numbers, data)


TEXTS = {
    "crater": "exp(-150*(v - 1/5)**2) - exp(-60*v**2)/2",
    "dunes": "v*(1 + sinpi(k_u*u + 4*sinpi(2*v)))**2/2",
    "hill": "9*v**2*exp(4*(cospi(2*u - 7/4) - 1) - 60*(v - 1/5)**2)",
}
POINT = {"u": 0.81, "v": 0.23}
STEPS = np.logspace(-1, -12, 177)


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
        numbers[name] = {"best_eps": STEPS[best], "bound": float(rounded_up(found.bound[best], 2))}
        data |= {f"{name}_error": found.error, f"{name}_bound": found.bound}
    axes[0].set_ylabel("error of the slope")
    return Drawing(fig, numbers, data)
