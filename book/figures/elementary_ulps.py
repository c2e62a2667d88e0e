"""Our sine, cosine and arctangent: the certified error of each piece of the range, and errors beneath it."""

from functools import cache

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import bound_style, dots, label_line_end, palette, plot
from verify.accuracy.certified_ulps import CERTIFIED, errors_in_ulps, pieces_of, worst

NAMES = {"sinpi": r"$\sin\,\pi r$", "cospi": r"$\cos\,\pi r$", "atan2pi": r"atan2$(t, 1)/\pi$"}
SEED, EACH, LEAST = 8, 3, 0.01  # below LEAST the pieces only repeat themselves


_pieces = cache(pieces_of)


@cache
def _samples(name):
    """Return {"ends" of the pieces, "certified" ulps of each, arguments "at" which was measured, "error" in ulps}."""
    rng, pieces = np.random.default_rng(SEED), _pieces(name)
    pieces = [piece for piece in pieces if piece.high > LEAST]
    certified, second = [float(piece.ulps) for piece in pieces], [np.ones(EACH)] if name == "atan2pi" else []
    points = [rng.uniform(float(piece.low), float(piece.high), EACH) for piece in pieces]
    errors = [errors_in_ulps(name, at, *second) for at in points]
    for at, off, most in zip(points, errors, certified, strict=True):
        if off.max() > most:
            raise ValueError(f"{name}{at} is off by {off} ulps, certified is {most}")
    ends = [float(piece.low) for piece in pieces] + [float(pieces[-1].high)]
    return {"ends": ends, "certified": certified, "at": np.ravel(points), "error": np.ravel(errors)}


@figure
def elementary_ulps() -> Drawing:
    """The certified error of sinpi, cospi and atan2pi over the reduced range, in ulps, and measured errors below it."""
    fig, axes = plot("page", 3.2, ncols=3, sharey=True)
    data = {name: _samples(name) for name in NAMES}
    numbers = {name: {"bound": float(bound), "certified": float(worst(_pieces(name)))}
               for name, bound in CERTIFIED.items()}  # fmt: skip
    for ax, (name, label) in zip(axes, NAMES.items(), strict=True):
        errors = data[name]["error"]
        dots(ax, data[name]["at"], errors, "difference", 1.6)
        ax.stairs(data[name]["certified"], data[name]["ends"], baseline=None, **bound_style())
        ax.set(title=label, xlabel="t" if name == "atan2pi" else "r", xlim=(0, None))
        numbers[name] |= {"largest": errors.max(), "samples": len(errors)}
    axes[0].set(ylim=(0, 3), ylabel="error, ulps")
    label_line_end(axes[0], 0.165, 1.35, "certified", "bound", "above")
    axes[0].plot(0.145, 2.2, color=palette()["difference"], marker="o", markersize=3)
    label_line_end(axes[0], 0.145, 2.2, "measured", "difference")
    return Drawing(fig, numbers, data)
