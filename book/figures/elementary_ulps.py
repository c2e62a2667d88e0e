"""Our elementary functions: the certified error of each piece of the range, and measured errors beneath it."""

from functools import cache

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import bound_style, dots, label_line_end, palette, plot
from proofs.formulas.certified import CERTIFIED
from verify.accuracy.certified_ulps import PIECES, at, errors_in_ulps
from verify.accuracy.pieces import worst

LEAST = 0.01  # below it the pieces of an angle only repeat themselves
PANELS = {
    "sinpi": (r"$\sin\,\pi r$", "r", LEAST, 0.2501),
    "cospi": (r"$\cos\,\pi r$", "r", LEAST, 0.2501),
    "atan2pi": (r"atan2$(t, 1)/\pi$", "t", LEAST, 1),
    "exp": (r"$e^r$", "r", -1, 1),
    "log": (r"$\ln\,m$", "m", 1 + LEAST, 1.4143),
    "power": (r"$b^p$", r"$-p\,\ln\,b$", 0, 50),
}
"""{name: (title, what is along the axis, from where on, up to where)}"""
SEED, EACH = 8, 3


@cache
def _samples(name):
    """Return {"ends" of the pieces, "certified" ulps of each, arguments "at" which was measured, "error" in ulps}."""
    rng, (*_, first, last) = np.random.default_rng(SEED), PANELS[name]
    pieces = [piece for piece in PIECES[name]() if first < piece.high <= last]
    points, errors = [], []
    for piece in pieces:
        points.append(rng.uniform(float(piece.low), float(piece.high), EACH))
        other = rng.exponential(size=EACH) if name == "power" else np.ones(EACH)
        errors.append(errors_in_ulps(name, *at(name, points[-1], other)))
        if errors[-1].max() > float(piece.ulps):
            raise ValueError(f"{name}{points[-1]} is off by {errors[-1]} ulps, certified is {float(piece.ulps)}")
    certified = [float(piece.ulps) for piece in pieces]
    ends = [float(piece.low) for piece in pieces] + [float(pieces[-1].high)]
    return {"ends": ends, "certified": certified, "at": np.ravel(points), "error": np.ravel(errors)}


@figure
def elementary_ulps() -> Drawing:
    """The certified error of our elementary functions over the reduced range, in ulps, and measured errors below it."""
    fig, axes = plot("page", 5.6, nrows=2, ncols=3, sharey=True)
    data = {name: _samples(name) for name in PANELS}
    numbers = {name: {"bound": float(bound), "certified": float(worst(PIECES[name]()))}
               for name, bound in CERTIFIED.items()}  # fmt: skip
    for ax, (name, (label, along, first, _)) in zip(axes.flat, PANELS.items(), strict=True):
        errors = data[name]["error"]
        dots(ax, data[name]["at"], errors, "difference", 1.6)
        ax.stairs(data[name]["certified"], data[name]["ends"], baseline=None, **bound_style())
        ax.set(title=label, xlabel=along, xlim=(0 if first == LEAST else data[name]["ends"][0], None))
        numbers[name] |= {"largest": errors.max(), "samples": len(errors)}
    for ax in axes[:, 0]:
        ax.set(ylim=(0, 3), ylabel="error, ulps")
    label_line_end(axes[0, 0], 0.165, 1.35, "certified", "bound", "above")
    axes[0, 0].plot(0.145, 2.2, color=palette()["difference"], marker="o", markersize=3)
    label_line_end(axes[0, 0], 0.145, 2.2, "measured", "difference")
    return Drawing(fig, numbers, data)
