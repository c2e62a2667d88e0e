"""One picture from two scenes: mirrored, turned by a quarter, with its lights in another order.

The raster is centred 3/20 of its half-height below the axis. Where its height is a multiple of 20 the rows above and
below the axis are mirror images, and with an even width the columns and rows make one square grid about it.
"""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from renderer import Light, Scene, render
from renderer.picture.frame import Frame

SIZE = 120  # a multiple of 20, and even
SIDE = SIZE - 3 * SIZE // 20  # rows r and SIDE − 1 − r are mirror images


def moved(scene: Scene, move: Callable) -> Scene:
    """Return the scene with every position (x, y) replaced by move(x, y)."""

    def at(position):
        return (*move(position[0], position[1]), position[2])

    lights = tuple(Light(at(light.position), light.color) for light in scene.lights)
    return replace(scene, ball_center=at(scene.ball_center), lights=lights)


def about_the_axis(frame: Frame) -> list[np.ndarray]:
    """Return the largest square part of a frame about the axis: rgb, its bounds, surface, whether a pixel is open."""
    square = (slice(SIDE), slice((SIZE - SIDE) // 2, (SIZE + SIDE) // 2))
    return [plane[square] for plane in (frame.rgb, frame.bounds, frame.chambers & 3, frame.open)]


MOVES = {
    "mirrored in x": (lambda x, y: (-x, y), lambda image: image[:, ::-1]),
    "mirrored in y": (lambda x, y: (x, -y), lambda image: image[::-1]),
    "turned by a quarter": (lambda x, y: (-y, x), lambda image: np.rot90(image, -1)),
}
"""{name: (what it does to a position, how the picture becomes the first one's)}"""

# What has the symmetry: ridges is even about every crease; with k_u a multiple of 4 a quarter turn takes creases to
# creases. Rings does not depend on u. The floor's squares change colour under all three, so there is no floor.
SCENES = {
    "ridges": Scene(floor=False),
    "ridges, Phong": Scene(floor=False, model="phong", shininess=5.0),
    "ridges, k_u = 12, k_v = 7": Scene(floor=False, ku=12.0, kv=7.0),
    "rings": Scene(floor=False, field="rings"),
}


def difference(scene: Scene, move: str) -> tuple[float, int, int, int]:
    """Return (largest |ΔI|, how many are above both bounds, open pixels, pixels whose surface differs) after moving the
    picture back.

    On a crease the two pictures may take different sides: pixels that are open are counted apart, and others whose
    surface differs too.
    """
    position, back = MOVES[move]
    pictures = (render(s, SIZE, SIZE, bounds=True) for s in (scene, moved(scene, position)))
    (one, bound, surface, open_), (two, *others) = map(about_the_axis, pictures)
    bound, other, open_ = bound + back(others[0]), surface != back(others[1]), open_ | back(others[2])
    off, bound = np.abs(one - back(two))[~other & ~open_], bound[~other & ~open_]
    return float(off.max()), int((off > bound).sum()), int(open_.sum()), int(other.sum())


def permuted_lights(scene: Scene) -> float:
    """Return the largest |ΔI| over the rotations of the scene's lights, forwards and backwards."""
    orders = [scene.lights[start:] + scene.lights[:start] for start in range(len(scene.lights))]
    pictures = [render(replace(scene, lights=order), SIZE, SIZE).rgb for order in (*orders, *(o[::-1] for o in orders))]
    return float(np.abs(np.subtract(pictures, pictures[0])).max())


FIVE_LIGHTS = Scene(
    lights=tuple(Light((6 * np.cos(n), 6 * np.sin(n), 4.0 + n), (0.9, 0.3 + n / 8, 0.5)) for n in range(5))
)
