"""What the bump does move: the attached shadow."""

from dataclasses import replace
from functools import cache

from book.drawing.registry import Drawing, figure
from book.figures.chapter_scene import SCENE, SIZE, marked_by_light, symbolic
from renderer import render


@cache
def turned(size=SIZE):
    """Return, for each light, the pixels of A that β turns to the light's other side, (height, width) bool."""
    bumped = symbolic("ridges", size)
    flat = render(replace(SCENE, beta=0.0), size, size, stage=bumped.stage)
    sides = [(bumped.light_cosines(n) > 0, flat.light_cosines(n) > 0) for n in range(len(SCENE.lights))]
    return [(one != other) & bumped.stage.on_a for one, other in sides]


@figure("attached_shadow")
def attached_shadow() -> Drawing:
    """The pixels of A that the bump turns away from a light, or towards it, for each light."""
    fig = marked_by_light([[(flags, (0xCC, 0x79, 0xA7))] for flags in turned(300)])
    on_a = int(symbolic().stage.on_a.sum())
    first, second = turned()
    numbers = {
        "beta": SCENE.beta,
        "pixels_a": on_a,
        "first": int(first.sum()),
        "second": int(second.sum()),
        "first_share": first.sum() / on_a,
        "second_share": second.sum() / on_a,
        "either_share": (first | second).sum() / on_a,
    }
    return Drawing(fig, numbers=numbers, data=dict(zip(("first", "second"), turned(300), strict=True)))
