"""The still pictures of the small interactives: what paper shows, and a page on which no script runs."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Circle, Polygon, Wedge
from numpy.typing import ArrayLike

from book.drawing.registry import Drawing, figure
from book.drawing.style import canvas, curve, label, palette, pixel_axes, pixel_text, plot
from book.extension.worked import COLUMN, ROW
from book.figures.chapter_scene import SCENE, SIZE, on_picture, symbolic
from book.idea_kernels import BUMP_LINES, angles_at, bump_at, bump_lines, lines_at, two_slopes
from renderer import Scene, exact, kernels, render
from renderer.generate.creases import crease_point
from renderer.picture.views import image_view, to_bytes

PARALLEL, POINT = 0.125, 0.453  # v of the circle, u of the point on it
LIGHT = SCENE.lights[0]


def along_circle(u: ArrayLike, beta: float = SCENE.beta) -> tuple[np.ndarray, ...]:
    """Return h, h_u, h_v, the tilt in degrees and μ at points of the circle."""
    return bump_at(np.asarray(u, float), PARALLEL, SCENE.ku, SCENE.kv, beta, SCENE.radius, *LIGHT.position)


def _draw_normals(ax: Axes, u: ArrayLike, size: float, **look: Any) -> None:
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
    with np.errstate(divide="ignore", invalid="ignore"):  # a selection computes both of its sides
        on_circle = crease_point(1.0, 0.0, np.append(u, POINT), PARALLEL, SCENE.eye, SCENE.radius)
    x, y = on_picture(frame, *on_circle)
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


FRAME = ("normal", "e_theta", "e_phi", "g", "m", "bumped")


@figure
def tilted_frame() -> Drawing:
    """N, the tangent vector βg, M = N + βg and N' at a point of the sphere."""
    u, v, beta, turn, tip = 0.53, 0.2, 0.07, 0.95, 0.42
    c, fig, gradient = palette(), canvas(640, 400), kernels.gradient_ridges(u, v, SCENE.ku, SCENE.kv)
    lines = dict(zip(BUMP_LINES["lines"], bump_lines(*angles_at(u, v), *gradient, beta), strict=True))
    vectors = {name: np.array([lines[f"{name}_{axis}"] for axis in "xyz"], float) for name in FRAME}
    right = np.array([-np.sin(turn), np.cos(turn), 0])
    up = np.array([-np.sin(tip) * np.cos(turn), -np.sin(tip) * np.sin(turn), np.cos(tip)])
    ax = pixel_axes(fig, 0, 0, 640, 400, xlim=(-320, 320), ylim=(-164, 236))

    def place(points):
        return 150 * np.array([points @ right, points @ up])

    ax.add_patch(Circle((0, 0), 150, facecolor=c["surface"], edgecolor=c["muted"]))
    steps, nets = np.linspace(0, 1, 97), {}
    meridians = [(np.full(97, m / SCENE.ku), steps) for m in range(int(SCENE.ku))]
    parallels = [(steps, np.full(97, m / SCENE.kv)) for m in range(1, int(SCENE.kv))]
    for number, (along, down) in enumerate(meridians + parallels):
        points = np.stack(kernels.point_on_a(*angles_at(along, down), 1.0), axis=1)
        x, y = np.where(points @ np.cross(right, up) > 0, place(points), np.nan)
        curve(ax, x, y, "rule", linewidth=1)
        nets[number] = {"x": x, "y": y}
    at, e_theta, e_phi = (vectors[name] for name in ("normal", "e_theta", "e_phi"))
    corners = [at + 0.34 * (a * e_theta + b * e_phi) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    ax.add_patch(Polygon([place(p) for p in corners], facecolor=c["symbolic"], alpha=0.14))
    tangent = beta * vectors["g"]
    corner = np.array([at + end for end in (at, vectors["m"], tangent)])
    curve(ax, *place(corner), "muted", linewidth=0.9, linestyle=(0, (2, 3)))
    for name, end, role, width, aside in (  # where its name stands, in points
        ("$N$", at, "ink", 1.2, -14),
        (r"$\beta g$", tangent, "symbolic", 2.2, 6),
        ("$M$", vectors["m"], "muted", 0.9, 6),
        ("$N'$", vectors["bumped"], "ink", 3, -14),
        (r"$e_\theta$", 0.34 * e_theta, "muted", 0.9, 6),
        (r"$e_\varphi$", 0.34 * e_phi, "muted", 0.9, -14),
    ):
        _arrow(ax, place(at), place(at + end), color=c[role], linewidth=width)
        label(ax, place(at + end), name, role, (aside, 3))
    ax.plot(*place(at), "o", color=c["symbolic"], markersize=8, markeredgecolor="white")
    return Drawing(fig, {"u": u, "v": v, "beta": beta}, {"net": nets} | vectors)


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


@figure("two_slopes")
def two_slope_lines() -> Drawing:
    """Ridges across a crease: the tangent at a point, and the secant of a step that reaches over the crease."""
    at, eps = 0.139, 0.03
    fig, ax = plot(height=2.9)
    u, rest = np.linspace(0.06, 0.25, 381), (PARALLEL, SCENE.ku, SCENE.kv, eps)
    heights = two_slopes(u, *rest)[1]
    left, middle, right, numeric, slope, _ = two_slopes(np.float64(at), *rest)
    curve(ax, u, heights, "ink", linewidth=1.3)
    for role, steepness, through, words in (
        ("symbolic", slope, middle, "the slope"),
        ("numeric", numeric, (left + right) / 2, "the difference"),
    ):
        ends = np.array([-1, 1]) * min(0.04, 0.5 / abs(steepness))
        curve(ax, at + ends, through + steepness * ends, role, words, linewidth=2)
    ax.plot([at - eps, at + eps], [left, right], "o", color=palette()["numeric"], markersize=6)
    ax.plot(at, middle, "o", color=palette()["symbolic"], markersize=7)
    ax.set(xlabel="$u$", ylabel="$h$", ylim=(-0.12, 1.25))
    return Drawing(fig, {"u": at, "eps": eps, "numeric": numeric, "slope": slope}, {"u": u, "height": heights})


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
