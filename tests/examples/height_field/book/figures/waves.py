"""Waves on the chart, and how far float64 turns their gradient out of its direction."""

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import plot
from renderer import Scene, exact, gradient_at, height_at


@figure
def waves() -> Drawing:
    """The height of waves on the chart, k_u = 7 and k_v = 3."""
    scene = Scene(field="waves", ku=7, kv=3)
    u, v = np.meshgrid(np.linspace(0, 1, 360, endpoint=False), np.linspace(0, 1, 180))
    h, (h_u, h_v) = height_at(scene, u, v), gradient_at(scene, u, v, exact())
    fig, ax = plot(height=3)
    ax.imshow(h, extent=(0, 1, 1, 0), aspect="auto", cmap="gray")
    ax.set(xlabel="$u$", ylabel="$v$")
    turned = np.abs(scene.kv * h_u - scene.ku * h_v).max() / np.hypot(h_u, h_v).max()
    return Drawing(fig, numbers={"turned": turned}, data={"u": u[0], "v": v[:, 0], "h": h})
