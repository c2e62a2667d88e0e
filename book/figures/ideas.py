"""The still pictures of the small interactives: what paper shows, and a page on which no script runs."""

import numpy as np
from matplotlib.patches import Circle, Wedge
from numpy.typing import ArrayLike

from book.drawing.registry import Drawing, figure
from book.drawing.style import canvas, curve, decades, dots, label, palette, pixel_axes, pixel_text, plot
from book.extension.worked import COLUMN, ROW
from book.figures.chapter_scene import SCENE, SIZE, place, symbolic
from book.idea_kernels import bump_at, lines_at, slope_parts, two_slopes
from renderer import Scene, exact, render
from renderer.picture.views import image_view, to_bytes

PARALLEL, POINT = 0.125, 0.453  # v of the circle, u of the point on it
LIGHT = SCENE.lights[0]


def along_circle(u: ArrayLike, beta: float = SCENE.beta) -> tuple[np.ndarray, ...]:
    """Return h, h_u, h_v, the tilt in degrees and μ at points of the circle."""
    return bump_at(np.asarray(u, float), PARALLEL, SCENE.ku, SCENE.kv, beta, SCENE.radius, *LIGHT.position)


def _draw_normals(ax, u, size, **look):
    """Draw the tilted normals at points of the circle as arrows of so many units of the axes' height."""
    _, slope, _, tilt, _ = along_circle(u)
    turn = np.radians(np.sign(slope) * tilt)
    ax.quiver(u, np.zeros_like(u), size * np.sin(turn), size * np.cos(turn), scale=1, scale_units="y", angles="uv",
              units="dots", **look)  # fmt: skip


@figure
def slope_is_texture() -> Drawing:
    """The height along a circle of the sphere, the normals that its slope tilts, the light that they catch."""
    fig, blue = canvas(928, 308), palette()["symbolic"]
    u = np.linspace(0, 1, 513)
    h, (at_h, slope, _, tilt, lit), unlit = along_circle(u)[0], along_circle(POINT), along_circle(POINT, 0.0)[-1]
    top = pixel_axes(fig, 0, 26, 590, 84, xlim=(-0.01, 1.01), ylim=(-0.1, 1.12))
    curve(top, u, h, "ink", linewidth=1.2)
    ends = np.array([-0.035, 0.035])
    curve(top, POINT + ends, at_h + ends * slope, "symbolic", linewidth=2)
    top.plot(POINT, at_h, "o", color=blue, markersize=7)
    middle = pixel_axes(fig, 0, 130, 590, 70, xlim=(-0.01, 1.01), ylim=(-12, 58))
    curve(middle, [0, 1], [0, 0], "ink", linewidth=1.2)
    _draw_normals(middle, (np.arange(16) + 0.5) / 16, 30, color=palette()["muted"], width=1)
    _draw_normals(middle, POINT, 42, color=blue, width=3)
    between = (u[1:] + u[:-1]) / 2
    light = along_circle(between)[-1]
    for at, high, mu in ((220, 20, along_circle(between, 0.0)[-1]), (264, 32, light)):
        shown = to_bytes(np.repeat(mu[None, :, None], 3, axis=2))
        pixel_axes(fig, 6, at, 578, high).imshow(shown, aspect="auto", interpolation="nearest")
    frame = render(Scene(ball=False, lights=(LIGHT,)), 360, 360, exact(), crop=(30, 4, 300, 300), bounds=True)
    right = pixel_axes(fig, 628, 8, 300, 300)
    right.imshow(image_view(frame), interpolation="none", aspect="auto")
    x, y = place(frame, np.append(u, POINT), PARALLEL)
    right.plot(x[:-1], y[:-1], color="white", linewidth=1, linestyle=(0, (3, 4)))
    right.plot(x[-1], y[-1], "o", color=blue, markeredgecolor="white", markersize=8)
    pixel_text(fig, 6, 18, "the height $h$ along the circle, and its slope at the point", "muted")
    pixel_text(fig, 6, 136, "the surface stays flat; its normals lean", "muted")
    pixel_text(fig, 6, 214, "the light without the bump", "muted")
    pixel_text(fig, 6, 258, "and with it", "muted")
    numbers = {"u": POINT, "slope": slope, "tilt": tilt, "light": lit, "unlit": unlit}
    numbers |= {"steepest": np.pi * SCENE.ku, "steepest_angle": along_circle(1e-9)[3], "beta": SCENE.beta}
    data = {"u": u, "height": h, "between": between, "light": light, "circle_x": x, "circle_y": y}
    return Drawing(fig, numbers, data, (frame,))


def _arrow(ax, start, end, **look):
    """Draw an arrow from a point to another."""
    ax.annotate("", end, start, arrowprops={"arrowstyle": "-|>", "shrinkA": 0, "shrinkB": 0} | look)


@figure
def scene_from_the_side() -> Drawing:
    """The eye, a ray, the spheres, the floor and the lights, in the upright plane through the eye and B's centre."""
    c, fig, s = palette(), canvas(640, 430), 0.52
    way = np.array(SCENE.ball_center[:2]) / np.hypot(*SCENE.ball_center[:2])
    lines = lines_at(SCENE, *(s * way))

    def flat(point):
        return np.array([np.dot(point[:2], way), point[2]])

    hit = flat([lines[f"point_{axis}"] for axis in "xyz"])
    ax = pixel_axes(fig, 0, 0, 640, 430, xlim=(-3.3, 3.3), ylim=(-0.14, 4.3))
    ax.axhline(0, color=c["ink"], linewidth=1.2)
    body = {"facecolor": c["surface"], "edgecolor": c["ink"], "linewidth": 1.2}
    ax.add_patch(Wedge((0, 0), SCENE.radius, 0, 180, **body))
    ax.add_patch(Circle(flat(SCENE.ball_center), SCENE.ball_radius, **body))
    curve(ax, [0, hit[0]], [SCENE.eye, hit[1]], "symbolic", linewidth=2.2)
    curve(ax, [hit[0], s], [hit[1], 0], "muted", linewidth=0.9, linestyle=(0, (2, 3)))
    for number, (words, aside) in enumerate((("first light", 4), ("second light", -70))):
        towards = flat(SCENE.lights[number].position) - hit
        near, hidden = hit + 1.25 * towards / np.linalg.norm(towards), lines[f"occluded_{number}"] > 0
        colour, dashes, words = ("muted", (0, (3, 3)), f"{words} (hidden)") if hidden else ("ink", "-", words)
        _arrow(ax, hit, near, color=c[colour], linestyle=dashes)
        label(ax, near, words, "muted", (aside, 2))
    ax.plot([0, hit[0]], [SCENE.eye, hit[1]], "o", color=c["ink"], markersize=6)
    for at, words in (
        ((0.1, SCENE.eye), "the eye, $t = 0$"),
        ((-3.2, 0.06), "the floor, $t = 1$"),
        ((-0.04, 0.4), "$A$"),
        (flat(SCENE.ball_center) - 0.04, "$B$"),
        (hit + (-0.2, 0.08), "$P$"),
    ):
        ax.text(*at, words, color=c["ink"])
    return Drawing(fig, {"t_a": lines["t_a"]}, {"hit": hit, "ray": [s, 0.0]})


SMALL = 6e-17  # a step that float64 takes for another one


@figure("two_slopes")
def two_slope_lines() -> Drawing:
    """Ridges across a crease, tangent and secant; float64's staircase there; the error of the difference."""
    at, eps = 0.139, 0.03
    fig, (left, middle, right) = plot("page", 3.0, ncols=3)
    u, rest = np.linspace(0.06, 0.25, 381), (PARALLEL, SCENE.ku, SCENE.kv)
    heights = two_slopes(u, *rest, eps)[1]
    across = np.linspace(-2, 2, 801)
    stairs = two_slopes(at + across * SMALL, *rest, SMALL)[1]
    before, here, after, numeric, slope, _ = two_slopes(np.float64(at), *rest, eps)
    down, _, up, small, *_ = two_slopes(np.float64(at), *rest, SMALL)
    curve(left, u, heights, "ink", linewidth=1.3)
    curve(middle, across, (stairs - here) / SMALL, "ink", linewidth=1.3)
    for ax, x, y, role, steepness, words, reach in (
        (left, at, here, "symbolic", slope, "the slope", 0.02),
        (left, at, (before + after) / 2, "numeric", numeric, "the difference", 0.04),
        (middle, 0, 0, "symbolic", slope, "", 2),
        (middle, 0, ((down + up) / 2 - here) / SMALL, "numeric", small, "", 1),
    ):
        ends = np.array([-reach, reach])
        curve(ax, x + ends, y + steepness * ends, role, words, linewidth=2)
    dots(left, [at - eps, at + eps], [before, after], "numeric", 6)
    dots(middle, [-1, 1], [(down - here) / SMALL, (up - here) / SMALL], "numeric", 6)
    dots(left, [at], [here], "symbolic", 7)
    steps = 10.0 ** np.arange(-17, -1.3, 0.05)
    error = np.abs(two_slopes(np.float64(at), *rest, steps)[3] - slope)
    dots(right, steps, error, "numeric", 2)
    parts = dict(zip(("reach", "arguments", "heights"), slope_parts(np.float64(at), *rest, steps), strict=True))
    for part in parts.values():
        curve(right, steps, part, "bound", linewidth=0.9)
    left.set(xlabel="$u$", title="$h$", ylim=(-0.12, 1.25))
    middle.set(xlabel="away from $u$, in steps", title=r"$\varepsilon = 6\cdot 10^{-17}$", ylim=(-60, 60))
    decades(right, 4, 4, xlabel="step ε", title="error of $h_u$", ylim=(1e-14, 1e2))
    numbers = {"u": at, "eps": eps, "numeric": numeric, "slope": slope}
    stair = {"across": across, "stairs": (stairs - here) / SMALL}
    return Drawing(fig, numbers, {"u": u, "height": heights, "step": steps, "error": error} | parts | stair)


@figure
def pixel_worked() -> Drawing:
    """The chapter's scene, and a white frame around the pixel that is worked through."""
    frame = symbolic(size=SIZE // 2)
    picture = image_view(frame).copy()  # of half the size: the file that is mailed stays small
    row, column = ROW // 2, COLUMN // 2
    down, across = np.indices(picture.shape[:2])
    away = np.maximum(np.abs(down - row), np.abs(across - column))
    picture[away == 3], picture[away == 2] = 0, 255
    return Drawing(picture, numbers={"column": COLUMN, "row": ROW}, shown=(frame,))
