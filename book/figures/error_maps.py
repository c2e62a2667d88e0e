"""The largest term of a difference's error at every pixel of sphere A."""

import numpy as np
from PIL import ImageColor

from book.drawing.palette import OF_TERMS
from book.drawing.registry import Drawing, figure
from book.drawing.style import GAP, TITLE, colour_of, panels, pixel_axes, pixel_text
from book.figures.chapter_scene import enlarged
from proofs.formulas.step_bounds import TERMS
from renderer import Scene, render
from verify.stability import attribution

COLOURS = dict(zip(TERMS, OF_TERMS, strict=True))
STEPS = (3e-2, 1e-6, 1e-8)
SMALL, TIMES = 88, 3
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
