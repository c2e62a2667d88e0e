"""Stills of spheres: bumps beside the surfaces that they imitate."""

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import GAP, canvas, panels, pixel_picture, pixel_text
from book.figures.chapter_scene import FINE, SCENE, averaged, symbolic
from book.programs.idea_kernels import BALLS, angles, surfaces
from renderer.picture.views import to_bytes
from verify.accuracy.frontiers import fiction

TITLES = ("the chapter's normal", "its sign mended", "and its scale", "and its metric", "really displaced")
NAMES = ("chapter", "sign", "scale", "metric")  # of the numbers; the last angle is 0
SIDE, HIGH, UNIT, MIDDLE = 176, 170, 52, (106, 72)  # a still's pixels, those of the radius, where the centre is
TURN, TIP = -BALLS["turn"], BALLS["tip"]  # where the eye stands around and above, in radians
FLOOR, DISC = -1.4, (-0.6, -0.6, 2.2)  # the floor's height; its middle and radius
WIDE, BALL_TITLES = 180, ("really displaced", "bump-mapped", "painted")
DENSE = 2000  # points around the sphere: more than the finer pixels that they fall on
RED, GROUND, AMBIENT, SHADE = (0.72, 0.25, 0.17), (0.8, 0.77, 0.7), 0.08, 0.35
LIGHT = np.array(SCENE.lights[0].position)


RIGHT = np.array([-np.sin(TURN), np.cos(TURN), 0])
TOWARD = np.array([np.cos(TIP) * np.cos(TURN), np.cos(TIP) * np.sin(TURN), np.sin(TIP)])
UP = np.cross(TOWARD, RIGHT)


def _put(picture, points, colours, unit=UNIT, middle=MIDDLE):
    """Put the colours of points (3, n) where they fall: of several on a finer pixel the nearest to the eye."""
    columns = np.rint(FINE * (middle[0] + unit * (RIGHT @ points))).astype(int)
    rows = np.rint(FINE * (middle[1] - unit * (UP @ points))).astype(int)
    inside = (columns >= 0) & (columns < picture.shape[1]) & (rows >= 0) & (rows < picture.shape[0])
    order = np.flatnonzero(inside)[np.argsort((TOWARD @ points)[inside], kind="stable")]
    picture[rows[order], columns[order]] = colours[order]


def _over_sphere():
    """Return the chart's coordinates of points all over the sphere."""
    u, v = np.meshgrid((np.arange(DENSE) + 0.5) / DENSE, (np.arange(DENSE // 2) + 0.5) / (DENSE // 2))
    return u.ravel(), v.ravel()


def _as_bytes(picture):
    """Return a finer picture of linear light and opacity as a picture of bytes."""
    return averaged(np.dstack([to_bytes(picture[..., :3]), np.rint(255 * picture[..., 3]).astype(np.uint8)]))


def _stills():
    """Return the five pictures, (HIGH, SIDE, 4): transparent where there is nothing."""
    u, v = _over_sphere()
    values = np.array(surfaces(u, v, SCENE.ku, SCENE.kv, SCENE.beta, *LIGHT))
    x, y = np.array(np.meshgrid(*2 * [np.linspace(-1, 1, DENSE // 2)])).reshape(2, -1)
    x, y = DISC[2] * np.array([x, y])[:, x**2 + y**2 <= 1]
    ground = np.array([DISC[0] + x, DISC[1] + y, np.full(x.size, FLOOR)])
    stills = []
    for state, lit in enumerate(values[6:11]):
        points = values[3:6] if state == len(TITLES) - 1 else values[:3]
        away = (LIGHT[2] - FLOOR) / (LIGHT[2] - points[2])
        shadow = LIGHT[:, None] + away * (points - LIGHT[:, None])
        picture = np.zeros((FINE * HIGH, FINE * SIDE, 4))
        for place, colour, light in (
            (ground, GROUND, np.ones(x.size)),
            (shadow, GROUND, np.full(u.size, SHADE)),
            (points, RED, AMBIENT + (1 - AMBIENT) * lit),
        ):
            _put(picture, place, np.insert(light[:, None] * colour, 3, 1, axis=1))
        stills.append(_as_bytes(picture))
    return stills


@figure
def bump_surface() -> Drawing:
    """The sphere with its normal mended step by step, and really displaced: five stills with their angles."""
    fig = canvas(5 * (SIDE + GAP) - GAP, HIGH + 44)
    for number, (still, title, angle) in enumerate(zip(_stills(), TITLES, angles(), strict=True)):
        left = number * (SIDE + GAP)
        pixel_text(fig, left + 2, 15, title)
        pixel_text(fig, left + 2, 32, f"{angle:.{int(angle < 20)}f}° off" if angle else "0°: its own normal", "muted")
        pixel_picture(fig, left, 44, still)
    chapter, turned, _, blinn, _ = fiction.normals(SCENE, symbolic().data_on_a).values()
    off_blinn = {name: np.median(fiction.degrees(n, blinn)) for name, n in (("chapter", chapter), ("sign", turned))}
    return Drawing(
        fig, {"beta": SCENE.beta, "blinn": off_blinn} | dict(zip(NAMES, angles(), strict=False)), {"angle": angles()}
    )


@figure
def three_balls() -> Drawing:
    """Three balls under one lamp: really displaced, with the displaced surface's slopes alone, and painted."""
    to_right, up = BALLS["lamp"]
    flat = np.cos(up) * (np.sin(to_right) * RIGHT + np.cos(to_right) * TOWARD)
    lamp = BALLS["away"] * (flat + np.sin(up) * UP)
    values = np.array(surfaces(*_over_sphere(), SCENE.ku, SCENE.kv, BALLS["beta"], *lamp))
    # The paint makes the smooth ball look like the bump under the lamp's first place, but is no brighter than white.
    lights = values[10], values[9], np.minimum(values[9], values[11] / max(SCENE.albedo_a))
    pictures, dark = [], BALLS["ka"] * np.array(SCENE.ambient)
    for points, light in zip((values[3:6], values[:3], values[:3]), lights, strict=True):
        picture, colours = np.zeros((FINE * WIDE, FINE * WIDE, 4)), light[:, None] * SCENE.kd * np.array(SCENE.albedo_a)
        _put(picture, points, np.insert(dark + colours, 3, 1, axis=1), WIDE / 2.4, (WIDE / 2, WIDE / 2))
        pictures.append(_as_bytes(picture))
    return Drawing(panels(pictures, BALL_TITLES), {"beta": BALLS["beta"]})
