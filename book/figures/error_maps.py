"""Maps of errors: the seed's form beside ours, as Herbie draws them, and which term of a difference's is largest."""

import numpy as np
from PIL import ImageColor

from book.drawing.palette import OF_TERMS
from book.drawing.registry import Drawing, figure
from book.drawing.style import GAP, TITLE, colour_of, decades, panels, pixel_axes, pixel_text, plot
from book.figures.chapter_scene import enlarged
from proofs.formulas.step_bounds import TERMS
from renderer import Scene, render
from renderer.picture.views import difference_logarithmic
from verify.stability import attribution, maps

LOW, HIGH = 0, 8
OFF = 0x80  # the grey of what is not on A
TITLES = {"seed": "the seed's form", "ours": "ours"}
SIDE, REACH, ZOOM = 128, 1e-3, 2


def _picture(units):
    """Return a map as a picture: one unit and less is black, what is off A grey."""
    picture = difference_logarithmic(np.where(units > 1, units, 0.0), LOW, HIGH)
    return enlarged(np.where(np.isnan(units)[..., None], np.uint8(OFF), picture), ZOOM)


def _drawing(errors, **numbers) -> Drawing:
    """Both maps beside each other, their medians and largest errors; the data are NaN where there is no error."""
    pictures = [_picture(errors[name]) for name in TITLES]
    fig = panels(pictures, list(TITLES.values()), (LOW, HIGH), "error, in units of the rounding")
    summaries = {name: dict(zip(("median", "most"), maps.summary(errors[name]), strict=True)) for name in TITLES}
    return Drawing(fig, summaries | numbers, {name: errors[name] for name in TITLES})


@figure
def accuracy_chart() -> Drawing:
    """The error of h_u over the chart, relative to h_u itself, in units of 2^-53: the seed's form and ours."""
    return _drawing(maps.over_the_chart(side=SIDE), side=SIDE)


@figure
def accuracy_image() -> Drawing:
    """The error of g over sphere A, in units of 2^-53 π k: the seed's form and ours."""
    return _drawing(maps.over_the_image(size=SIDE, reach=1.0))


@figure
def accuracy_pole() -> Drawing:
    """The same about the pole, enlarged a thousand times."""
    return _drawing(maps.over_the_image(size=SIDE, reach=REACH), reach=REACH)


COLOURS = dict(zip(TERMS, OF_TERMS, strict=True))
STEPS = (3e-2, 1e-6, 1e-8)
SMALL, TIMES = 88, 3
SWEEP = np.logspace(-0.5, -13, 26)
KEYS = [name.replace(" ", "_").replace("-", "_") for name in TERMS]


def _coloured(kinds):
    """Return the kinds as colours, black off A and where there is no error."""
    table = np.array([*map(ImageColor.getrgb, OF_TERMS)], np.uint8)
    return enlarged(np.where(kinds[..., None] >= 0, table[kinds.clip(0)], np.uint8(0)), TIMES)


@figure("attribution")
def attribution_pictures() -> Drawing:
    """The largest of the error's terms at each pixel of sphere A, at three steps, with a legend."""
    frame, numbers, data = render(Scene(), SMALL, SMALL), {}, {"kinds": list(COLOURS)}
    for eps in STEPS:
        data[f"kinds_{eps:.0e}"] = kinds = attribution.over_the_image(frame, eps)
        on_a = kinds[kinds > -2]
        numbers["pixels"] = len(on_a)
        shares = zip(KEYS, attribution.shares(on_a).values(), strict=True)
        numbers |= {f"{key}_{eps:.0e}": share for key, share in shares}
    pictures = [_coloured(data[f"kinds_{eps:.0e}"]) for eps in STEPS]
    fig = panels(pictures, [f"ε = {eps:g}" for eps in STEPS], foot=TITLE + GAP)
    _legend(fig)
    return Drawing(fig, numbers, data)


def _legend(fig):
    """Write the colours' names under the pictures, in the strip that is left free there."""
    top, wide = TITLE + TIMES * SMALL, len(STEPS) * (TIMES * SMALL + GAP) - GAP
    for index, name in enumerate(COLOURS):
        left = index * wide / len(COLOURS)
        mark = pixel_axes(fig, left, top + 16, 14, 14)
        mark.set_axis_on()
        mark.set(xticks=[], yticks=[])
        mark.imshow(_coloured(np.array([[index]])), aspect="auto")  # a facecolour would be saved transparent
        for spine in mark.spines.values():
            spine.set(visible=True, color=colour_of("rule"))
        pixel_text(fig, left + 22, top + 23, name, va="center")


@figure
def attribution_shares() -> Drawing:
    """Over random pixels of A, the share of each dominant term against the step."""
    shares = attribution.shares_by_step(render(Scene(), SMALL, SMALL), SWEEP)
    fig, ax = plot(height=3.6)
    parts = ax.stackplot(SWEEP, *shares.values(), colors=COLOURS.values(), linewidth=0.6, edgecolor=colour_of("paper"))
    decades(ax, 2, None, xlim=(SWEEP[0], SWEEP[-1]), ylim=(0, 1), xlabel="step ε", ylabel="share of A's pixels")
    ax.set_yticks([0, 0.5, 1], ["0", "½", "1"])
    for part, hatch in zip(parts, ("", "", "////", "....", ""), strict=True):
        part.set_hatch(hatch)
    for name, (x, y) in zip(TERMS, ((3e-4, 0.5), (1e-9, 0.4), (3e-10, 0.93), (6e-2, 0.82)), strict=False):
        ax.text(x, y, name, ha="center", va="center", color="#1d1c1b", backgroundcolor=COLOURS[name])
    most = {f"{key}_most": values.max() for key, values in zip(KEYS, shares.values(), strict=True)}
    return Drawing(fig, most | {"points": attribution.POINTS, "steps": len(SWEEP)}, {"step": SWEEP, **shares})
