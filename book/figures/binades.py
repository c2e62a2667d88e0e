"""The bump that dies by binades: steps so small that float64 no longer takes them."""

from itertools import product

import numpy as np
from matplotlib import patheffects

from book.drawing.registry import Drawing, figure
from book.drawing.style import GAP, TITLE, canvas, curve, pixel_picture, pixel_text
from book.figures.chapter_scene import SCENE, SIZE, numeric, place
from renderer import Scene, render
from renderer.picture.views import image_view
from renderer.scene.methods import difference
from verify.accuracy.binades import dies

COLUMNS = ((1e-16, 5e-17), (2e-17, 1e-17), (3e-18, 1e-18))  # one above the other: so they stay on a phone
STEPS = tuple(step for column in COLUMNS for step in column)
RASTER, CROP = 312, (26, 4, 260, 260)  # sphere A and a little around it
RIM = np.arccos(SCENE.radius / SCENE.eye) / np.pi  # v of the last circle that the eye sees
NAMES = {  # by step: the binades of u where none is lost yet, then where h_u, h_v are 0; at which (u, v)
    1e-16: {
        "½ ≤ $u$ < 1": (0.79, 0.31),
        "¼ ≤ $u$ < ½": (0.38, 0.32),
        "⅛ ≤ $u$ < ¼": (0.19, 0.32),
        "$u$ < ⅛": (0.07, 0.27),
    },
    5e-17: {"$h_u = 0$: ½ < $u$": (0.78, 0.27)},
    2e-17: {"$h_u = 0$: ¼ < $u$": (0.38, 0.17), "$h_v = 0$: ¼ < $v$": (0.75, 0.335)},
    1e-17: {"$h_u = 0$: ⅛ < $u$": (0.3, 0.27), "$h_v = 0$: ⅛ < $v$": (0.77, 0.24)},
    3e-18: {"$h_u = 0$: $^1\\!/_{32}$ < $u$": (0.3, 0.27), "$h_v = 0$: $^1\\!/_{32}$ < $v$": (0.77, 0.24)},
    1e-18: {"$h_u = 0$: $^1\\!/_{64}$ < $u$": (0.3, 0.27), "$h_v = 0$: $^1\\!/_{64}$ < $v$": (0.77, 0.24)},
}
HALO = [patheffects.withStroke(linewidth=2, foreground="#000000a0")]


def lost(step: float) -> dict[str, float]:
    """Return the shares of A where h_u, and where both slopes are 0."""
    h_u, h_v = (numeric("sine", SIZE, step).data_on_a[name] == 0 for name in ("h_u", "h_v"))
    return {"u": h_u.mean(), "both": (h_u & h_v).mean()}


def _edges(frame, step):
    """Return the edge of what a step loses, of the largest binades where it loses none, and the seam, in pixels."""
    powers = 0.5 ** np.arange(1, 8)
    lost = powers[dies(powers, step, at_power=0.5)]
    ends, round_a = lost[-1:] if lost.size else powers[:3], np.linspace(0, 1, 65)
    lines = [(np.full(2, u), np.array([0.001, 0.999 * RIM])) for u in (*ends, 0.0)]  # straight: A is seen from above
    lines += [(round_a, np.full(65, v)) for v in ends[ends < RIM]]
    return [place(frame, *line) for line in lines]


@figure
def binades() -> Drawing:
    """Sphere A with sine at six steps from 1e-16 to 1e-18, where binade after binade of u and v loses its slope."""
    side, frames, numbers = CROP[2], [], {}
    fig = canvas(len(COLUMNS) * (side + GAP) - GAP, 2 * (TITLE + side) + GAP)
    for step, (left, top) in zip(STEPS, product(range(3), range(2)), strict=True):
        x, y = left * (side + GAP), top * (TITLE + side + GAP)
        frame = render(Scene(field="sine"), RASTER, RASTER, difference("central", step), crop=CROP, bounds=True)
        digits, power = (name := f"{step:.0e}").split("e-")
        ax = pixel_picture(fig, x, y + TITLE, image_view(frame))
        for number, line in enumerate(_edges(frame, step)):
            curve(ax, *line, "white", label=f"edge {number}", linewidth=0.8, linestyle=(0, (2, 3)))
        for words, at in NAMES[step].items():
            (column,), (row,) = place(frame, *np.array(at)[:, None])
            ax.text(column, row, words, color="white", ha="center", va="center", fontsize=10, path_effects=HALO)
        pixel_text(fig, x, y + 16, rf"$\varepsilon = {digits}\cdot 10^{{-{int(power)}}}$")
        frames.append(frame)
        numbers[name] = lost(step)
    return Drawing(fig, numbers, shown=frames)
