"""Our sine, cosine and arctangent: the certified error of each piece of the range, and errors beneath it."""

from functools import cache

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import bound_style, label_line_end, palette, plot
from proofs.formulas.certified import CERTIFIED
from verify.accuracy.certified_ulps import errors_in_ulps, pieces_of, worst

NAMES = {"sinpi": r"$\sin\,\pi r$", "cospi": r"$\cos\,\pi r$", "atan2pi": r"atan2$(t, 1)/\pi$"}
SEED, EACH, LEAST = 8, 3, 0.01  # below LEAST the pieces only repeat themselves


_pieces = cache(pieces_of)


@cache
def _samples(name):
    """Return (ends of the pieces, certified ulps, arguments, their errors in ulps)."""
    rng, pieces = np.random.default_rng(SEED), _pieces(name)
    pieces = [piece for piece in pieces if piece.high > LEAST]
    arguments, errors = [], []
    for piece in pieces:
        points = rng.uniform(float(piece.low), float(piece.high), EACH)
        found = errors_in_ulps(name, points, np.ones(EACH)) if name == "atan2pi" else errors_in_ulps(name, points)
        if found.max() > float(piece.ulps):
            raise ValueError(f"{name}{points} is off by {found} ulps, certified is {float(piece.ulps)}")
        arguments += points.tolist()
        errors += found.tolist()
    ends = [float(piece.low) for piece in pieces] + [float(pieces[-1].high)]
    return ends, [float(piece.ulps) for piece in pieces], arguments, errors


@figure("elementary_ulps")
def elementary_ulps() -> Drawing:
    """The certified error of sinpi, cospi and atan2pi over the reduced range, in ulps, and measured errors below it."""
    fig, axes = plot("page", 3.2, ncols=3, sharey=True)
    colour, numbers, data = palette()["difference"], {}, {}
    for ax, (name, label) in zip(axes, NAMES.items(), strict=True):
        ends, certified, arguments, errors = _samples(name)
        ax.plot(arguments, errors, color=colour, linewidth=0, marker="o", markersize=1.6)
        ax.stairs(certified, ends, baseline=None, **bound_style())
        ax.set(title=label, xlabel="t" if name == "atan2pi" else "r", xlim=(0, None))
        data |= {f"{name}_ends": ends, f"{name}_certified": certified, f"{name}_at": arguments, f"{name}_error": errors}
        numbers |= {f"{name}_largest": max(errors), f"{name}_samples": len(errors)}
    axes[0].set(ylim=(0, 3), ylabel="error, ulps")
    label_line_end(axes[0], 0.165, 1.35, "certified", palette()["bound"], side="above")
    axes[0].plot(0.145, 2.2, color=colour, marker="o", markersize=3)
    label_line_end(axes[0], 0.145, 2.2, "measured", colour)
    for name, bound in CERTIFIED.items():
        numbers |= {f"{name}_bound": float(bound), f"{name}_certified": float(worst(_pieces(name)))}
    return Drawing(fig, numbers=numbers, data=data)
