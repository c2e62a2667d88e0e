"""How far the chapter's normal is from Blinn's; numbers only, for the ledger."""

import numpy as np

from book.drawing.registry import Drawing, figure
from book.figures.chapter_scene import SCENE, symbolic
from verify.accuracy.frontiers.fiction import STEPS, degrees, normals


@figure("blinn_angles")
def blinn_angles() -> Drawing:
    """The median angle between the chapter's N', as it is and with its sign turned, and Blinn's, in degrees."""
    frame = symbolic()
    on_a = frame.stage.on_a
    found = normals(SCENE, {name: plane[on_a] for name, plane in frame.surface_data.items()})
    chapter, turned, _, blinn = (found[name] for name in STEPS)
    medians = {"chapter": np.median(degrees(chapter, blinn)), "turned": np.median(degrees(turned, blinn))}
    return Drawing(numbers={name: float(value) for name, value in medians.items()})
