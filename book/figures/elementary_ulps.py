"""Our elementary functions: the certified error of each piece of the range, and measured errors beneath it."""

from functools import cache

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import bound_style, label_line_end, palette, plot
from verify.accuracy.certified_ulps import CERTIFIED, PIECES, at, errors_in_ulps
from verify.accuracy.pieces import worst

LEAST = 0.01  # below it the pieces of an angle only repeat themselves
PANELS = {
    "sinpi": (r"$\sin\,\pi r$", "r", LEAST, 1),
    "cospi": (r"$\cos\,\pi r$", "r", LEAST, 1),
    "atan2pi": (r"atan2$(t, 1)/\pi$", "t", LEAST, 1),
    "exp": (r"$e^r$", "r", -1, 1),
    "log": (r"$\ln\,m$", "m", 1 + LEAST, 1.4143),
    "power": (r"$b^p$", r"$-p\,\ln\,b$", 0, 50),
}
"""{name: (title, what is along the axis, from where on, up to where)}"""
SEED, EACH = 8, 3


@cache
def _samples(name):
    """Return (ends of the pieces, certified ulps, arguments, their errors in ulps)."""
    rng, (*_, first, last) = np.random.default_rng(SEED), PANELS[name]
    pieces = [piece for piece in PIECES[name]() if first < piece.high <= last]
    arguments, errors = [], []
    for piece in pieces:
        points = rng.uniform(float(piece.low), float(piece.high), EACH)
        other = rng.exponential(size=EACH) if name == "power" else np.ones(EACH)
        found = errors_in_ulps(name, *at(name, points, other))
        if found.max() > float(piece.ulps):
            raise ValueError(f"{name}{points} is off by {found} ulps, certified is {float(piece.ulps)}")
        arguments += points.tolist()
        errors += found.tolist()
    ends = [float(piece.low) for piece in pieces] + [float(pieces[-1].high)]
    return ends, [float(piece.ulps) for piece in pieces], arguments, errors


@figure("elementary_ulps")
def elementary_ulps() -> Drawing:
    """The certified error of our elementary functions over the reduced range, in ulps, and measured errors below it."""
    fig, axes = plot("page", 5.6, nrows=2, ncols=3, sharey=True)
    colour, numbers, data = palette()["difference"], {}, {}
    for ax, (name, (label, along, first, _)) in zip(axes.flat, PANELS.items(), strict=True):
        ends, certified, arguments, errors = _samples(name)
        ax.plot(arguments, errors, color=colour, linewidth=0, marker="o", markersize=1.6)
        ax.stairs(certified, ends, baseline=None, **bound_style())
        ax.set(title=label, xlabel=along, xlim=(0 if first == LEAST else ends[0], None))
        data |= {f"{name}_ends": ends, f"{name}_certified": certified, f"{name}_at": arguments, f"{name}_error": errors}
        numbers |= {f"{name}_largest": max(errors), f"{name}_samples": len(errors)}
    for ax in axes[:, 0]:
        ax.set(ylim=(0, 3), ylabel="error, ulps")
    label_line_end(axes[0, 0], 0.165, 1.35, "certified", palette()["bound"], side="above")
    axes[0, 0].plot(0.145, 2.2, color=colour, marker="o", markersize=3)
    label_line_end(axes[0, 0], 0.145, 2.2, "measured", colour)
    for name, bound in CERTIFIED.items():
        numbers |= {f"{name}_bound": float(bound), f"{name}_certified": float(worst(PIECES[name]()))}
    return Drawing(fig, numbers=numbers, data=data)
