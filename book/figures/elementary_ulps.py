"""Our elementary functions: the certified error of each piece of the range, and measured errors beneath it."""

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import bound_style, curve, dots, label_line_end, plot
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
    numbers, data = {}, {}
    for ax, (name, (title, along, first, _)) in zip(axes.flat, PANELS.items(), strict=True):
        data[name] = found = _samples(name)
        dots(ax, found["at"], found["error"], "difference", 1.6)
        ax.stairs(found["certified"], found["ends"], baseline=None, **bound_style())
        ax.set(title=title, xlabel=along, xlim=(0 if first == LEAST else found["ends"][0], None))
        certified = float(worst(PIECES[name]()))
        numbers[name] = {"certified": certified, "largest": found["error"].max(), "samples": len(found["error"])}
    for ax in axes[:, 0]:
        ax.set(ylim=(0, 3), ylabel="error, ulps")
    label_line_end(axes[0, 0], 0.165, 1.35, "certified", "bound", "above")
    curve(axes[0, 0], 0.145, 2.2, "difference", marker="o", markersize=3)
    label_line_end(axes[0, 0], 0.145, 2.2, "measured", "difference")
    return Drawing(fig, numbers, data)
