"""The still pictures of the small interactives: what paper shows, and a page on which no script runs."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Polygon, Wedge
from numpy.typing import ArrayLike

from book.drawing.palette import CSS_PIXELS_PER_INCH, readable
from book.drawing.registry import Drawing, figure
from book.drawing.style import label_line_end, palette, plot
from book.extension.worked import COLUMN, ROW
from book.figures.chapter_scene import SCENE, SIZE, on_picture, symbolic
from book.idea_kernels import BUMP_LINES, PIXEL_LINES, angles_at, bump_at, bump_lines, given, pixel_lines, two_slopes
from renderer import Scene, exact, kernels, render
from renderer.generate.creases import crease_point
from renderer.picture.views import image_view, to_bytes

PARALLEL, POINT = 0.125, 0.453  # v of the circle, u of the point on it
LIGHT = SCENE.lights[0]


def pixel_axes(fig: Figure, left: float, top: float, wide: float, high: float, **limits: Any) -> Axes:
    """Return axes that fill a box given in CSS pixels from the figure's upper left corner, without a frame."""
    width, height = (size * CSS_PIXELS_PER_INCH for size in fig.get_size_inches())
    ax = fig.add_axes([left / width, (height - top - high) / height, wide / width, high / height])
    ax.set_axis_off()
    ax.set(**limits)
    return ax


def canvas(wide: float, high: float) -> Figure:
    """Return a figure of so many CSS pixels, which the page shows at that size."""
    fig = Figure(figsize=(wide / CSS_PIXELS_PER_INCH, high / CSS_PIXELS_PER_INCH), layout="none")
    fig.pixel_exact = True
    return fig


def along_circle(u: ArrayLike, beta: float = SCENE.beta) -> tuple[np.ndarray, ...]:
    """Return h, h_u, h_v, the tilt in degrees and μ at points of the circle."""
    return bump_at(np.asarray(u, float), PARALLEL, SCENE.ku, SCENE.kv, beta, SCENE.radius, *LIGHT.position)


@figure("slope_is_texture")
def slope_is_texture() -> Drawing:
    """The height along a circle of the sphere, the normals that its slope tilts, the light that they catch."""
    fig, c = canvas(928, 308), palette()
    u, few = np.linspace(0, 1, 513), (np.arange(32) + 0.5) / 32
    (h, *_), (at_h, slope, _, tilt, lit), (*_, unlit) = along_circle(u), along_circle(POINT), along_circle(POINT, 0.0)
    top = pixel_axes(fig, 0, 26, 590, 84, xlim=(-0.01, 1.01), ylim=(-0.1, 1.12))
    top.plot(u, h, color=c["ink"], linewidth=1.2)
    run = 0.035
    top.plot([POINT - run, POINT + run], [at_h - run * slope, at_h + run * slope], color=c["symbolic"], linewidth=2)
    top.plot(POINT, at_h, "o", color=c["symbolic"], markersize=7)
    middle = pixel_axes(fig, 0, 130, 590, 70, xlim=(-0.01, 1.01), ylim=(-12, 58))
    middle.plot([0, 1], [0, 0], color=c["ink"], linewidth=1.2)
    _, slopes, _, tilts, _ = along_circle(few)
    arrows = {"scale": 1, "scale_units": "y", "angles": "uv", "units": "dots"}
    for at, leaning, turns, size, look in (
        (few, slopes, tilts, 24, {"color": c["muted"], "width": 1}),
        (POINT, slope, tilt, 42, {"color": c["symbolic"], "width": 3}),
    ):
        turn = np.radians(np.sign(leaning) * turns)
        middle.quiver(at, np.zeros_like(at), size * np.sin(turn), size * np.cos(turn), **arrows, **look)
    between = (u[1:] + u[:-1]) / 2
    strips = {beta: along_circle(between, beta)[4] for beta in (0.0, SCENE.beta)}
    for at, high, mu in ((220, 20, strips[0.0]), (264, 32, strips[SCENE.beta])):
        shown = to_bytes(np.repeat(mu[None, :, None], 3, axis=2))
        pixel_axes(fig, 6, at, 578, high).imshow(shown, aspect="auto", interpolation="nearest")
    frame = render(Scene(ball=False, lights=(LIGHT,)), 360, 360, exact(), crop=(30, 4, 300, 300))
    right = pixel_axes(fig, 628, 8, 300, 300)
    right.imshow(image_view(frame), interpolation="none", aspect="auto")
    with np.errstate(divide="ignore", invalid="ignore"):  # a selection computes both of its sides
        on_circle = crease_point(1.0, 0.0, np.append(u, POINT), PARALLEL, SCENE.eye, SCENE.radius)
    x, y = on_picture(frame, *on_circle)
    right.plot(x[:-1], y[:-1], color="white", linewidth=1, linestyle=(0, (3, 4)))
    right.plot(x[-1], y[-1], "o", color=c["symbolic"], markeredgecolor="white", markersize=8)
    for y_at, words in (
        (18, "the height $h$ along the circle, and its slope at the point"),
        (136, "the surface stays flat; its normals lean"),
        (214, "the light without the bump"),
        (258, "and with it"),
    ):
        fig.text(6 / 928, 1 - y_at / 308, words, color=c["muted"], va="baseline")
    numbers = {"u": POINT, "slope": slope, "tilt": tilt, "light": lit, "unlit": unlit}
    numbers |= {"steepest": np.pi * SCENE.ku, "worst": along_circle(1e-9)[3], "beta": SCENE.beta}
    data = {"u": u, "height": h, "between": between, "light": strips[SCENE.beta], "circle_x": x, "circle_y": y}
    return Drawing(fig, numbers=numbers, data=data)


def vectors_at(u: float, v: float, beta: float) -> dict[str, np.ndarray]:
    """Return {name: vector} of the lines that tilt the normal at a point of ridges."""
    gradient = bump_at(u, v, SCENE.ku, SCENE.kv, beta, SCENE.radius, *LIGHT.position)[1:3]
    lines = dict(zip(BUMP_LINES["lines"], bump_lines(*angles_at(u, v), *gradient, beta), strict=True))
    return {name: np.array([lines[f"{name}_{axis}"] for axis in "xyz"], float) for name in FRAME}


FRAME = ("normal", "e_theta", "e_phi", "g", "m", "bumped")


@figure("tilted_frame")
def tilted_frame() -> Drawing:
    """N, the tangent vector βg, M = N + βg and N' at a point of the sphere."""
    u, v, beta, turn, tip = 0.53, 0.2, 0.07, 0.95, 0.42
    c, fig, found = palette(), canvas(640, 400), vectors_at(0.53, 0.2, 0.07)
    right = np.array([-np.sin(turn), np.cos(turn), 0])
    up = np.array([-np.sin(tip) * np.cos(turn), -np.sin(tip) * np.sin(turn), np.cos(tip)])
    toward, at = np.cross(right, up), found["normal"]
    ax = pixel_axes(fig, 0, 0, 640, 400, xlim=(-320, 320), ylim=(-164, 236))
    place = lambda p: 150 * np.array([p @ right, p @ up])  # noqa: E731
    ax.add_patch(Circle((0, 0), 150, facecolor=c["surface"], edgecolor=c["muted"]))
    steps, data = np.linspace(0, 1, 97), {}
    nets = [(np.full(97, m / SCENE.ku), steps) for m in range(int(SCENE.ku))]
    nets += [(steps, np.full(97, m / SCENE.kv)) for m in range(1, int(SCENE.kv))]
    for number, (along, down) in enumerate(nets):
        points = np.stack(kernels.point_on_a(*angles_at(along, down), 1.0), axis=1)
        x, y = np.where((points @ toward)[:, None] > 0, np.apply_along_axis(place, 1, points), np.nan).T
        ax.plot(x, y, color=c["rule"], linewidth=1)
        data |= {f"net_{number}_x": x, f"net_{number}_y": y}
    corners = [at + 0.34 * (a * found["e_theta"] + b * found["e_phi"]) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    ax.add_patch(Polygon([place(p) for p in corners], facecolor=c["symbolic"], alpha=0.14))
    tangent = beta * found["g"]
    corner = np.transpose([place(at + end) for end in (at, found["m"], tangent)])
    ax.plot(*corner, color=c["muted"], linewidth=0.9, linestyle=(0, (2, 3)))
    for name, end, colour, width, aside in (  # where its name stands, in points
        ("$N$", at, "ink", 1.2, -14),
        (r"$\beta g$", tangent, "symbolic", 2.2, 6),
        ("$M$", found["m"], "muted", 0.9, 6),
        ("$N'$", found["bumped"], "ink", 3, -14),
        (r"$e_\theta$", 0.34 * found["e_theta"], "muted", 0.9, 6),
        (r"$e_\varphi$", 0.34 * found["e_phi"], "muted", 0.9, -14),
    ):
        arrow = {"arrowstyle": "-|>", "color": c[colour], "linewidth": width, "shrinkA": 0, "shrinkB": 0}
        ax.annotate("", place(at + end), place(at), arrowprops=arrow)
        ax.annotate(name, place(at + end), xytext=(aside, 3), textcoords="offset points", color=readable(c[colour]))
    ax.plot(*place(at), "o", color=c["symbolic"], markersize=8, markeredgecolor="white")
    return Drawing(fig, numbers={"u": u, "v": v, "beta": beta}, data=data | found)


def seen_at(x: float, y: float) -> dict[str, Any]:
    """Return {line: value} of the chapter's scene at an image point."""
    known = given(SCENE) | {"x": x, "y": y}
    with np.errstate(all="ignore"):
        found = pixel_lines(*(known[name] for name in PIXEL_LINES["inputs"]))
    return dict(zip(PIXEL_LINES["lines"], found, strict=True))


@figure("scene_from_the_side")
def scene_from_the_side() -> Drawing:
    """The eye, a ray, the spheres, the floor and the lights, in the upright plane through the eye and B's centre."""
    c, fig, s = palette(), canvas(640, 430), 0.52
    way = np.array(SCENE.ball_center[:2]) / np.hypot(*SCENE.ball_center[:2])
    found = seen_at(*(s * way))
    flat = lambda p: np.array([np.dot(p[:2], way), p[2]])  # noqa: E731
    hit = flat([float(found[f"point_{axis}"]) for axis in "xyz"])
    ax = pixel_axes(fig, 0, 0, 640, 430, xlim=(-3.3, 3.3), ylim=(-0.14, 4.3))
    ax.axhline(0, color=c["ink"], linewidth=1.2)
    body = {"facecolor": c["surface"], "edgecolor": c["ink"], "linewidth": 1.2}
    ax.add_patch(Wedge((0, 0), SCENE.radius, 0, 180, **body))
    ax.add_patch(Circle(flat(SCENE.ball_center), SCENE.ball_radius, **body))
    ax.plot([0, hit[0]], [SCENE.eye, hit[1]], color=c["symbolic"], linewidth=2.2)
    ax.plot([hit[0], s], [hit[1], 0], color=c["muted"], linewidth=0.9, linestyle=(0, (2, 3)))
    for number, (light, words) in enumerate(zip(SCENE.lights, ("first light", "second light"), strict=True)):
        towards = flat(light.position) - hit
        near, hidden = hit + 1.25 * towards / np.linalg.norm(towards), found[f"occluded_{number}"] > 0
        colour, dashes, words = ("muted", (0, (3, 3)), f"{words} (hidden)") if hidden else ("ink", "-", words)
        arrow = {"arrowstyle": "-|>", "color": c[colour], "linestyle": dashes, "shrinkA": 0, "shrinkB": 0}
        ax.annotate("", near, hit, arrowprops=arrow)
        aside = (-70 if number else 4, 2)
        ax.annotate(words, near, xytext=aside, textcoords="offset points", color=c["muted"])
    ax.plot([0, hit[0]], [SCENE.eye, hit[1]], "o", color=c["ink"], markersize=6)
    for at, words in (
        ((0.1, SCENE.eye), "the eye, $t = 0$"),
        ((-3.2, 0.06), "the floor, $t = 1$"),
        ((-0.04, 0.4), "$A$"),
        (flat(SCENE.ball_center) - 0.04, "$B$"),
        (hit + (-0.2, 0.08), "$P$"),
    ):
        ax.text(*at, words, color=c["ink"])
    return Drawing(fig, numbers={"t_a": float(found["t_a"])}, data={"hit": hit, "ray": [s, 0.0]})


@figure("two_slopes")
def two_slope_lines() -> Drawing:
    """Ridges across a crease: the tangent at a point, and the secant of a step that reaches over the crease."""
    (low, high), at, v, eps, c = (0.06, 0.25), 0.139, PARALLEL, 0.03, palette()
    fig, ax = plot(height=2.9)
    u = np.linspace(low, high, 381)
    curve = two_slopes(u, v, SCENE.ku, SCENE.kv, eps)[1]
    left, middle, right, numeric, slope, _ = map(float, two_slopes(np.float64(at), v, SCENE.ku, SCENE.kv, eps))
    ax.plot(u, curve, color=c["ink"], linewidth=1.3)
    for colour, steepness, through, words in (
        ("symbolic", slope, middle, "the slope"),
        ("numeric", numeric, (left + right) / 2, "the difference"),
    ):
        reach = min(0.04, 0.5 / abs(steepness))
        line = at + np.array([-reach, reach]), through + steepness * np.array([-reach, reach])
        ax.plot(*line, color=c[colour], linewidth=2)
        label_line_end(ax, line[0][1], line[1][1], words, c[colour])
    ax.plot([at - eps, at + eps], [left, right], "o", color=c["numeric"], markersize=6)
    ax.plot(at, middle, "o", color=c["symbolic"], markersize=7)
    ax.set(xlabel="$u$", ylabel="$h$", ylim=(-0.12, 1.25))
    numbers = {"u": at, "eps": eps, "numeric": numeric, "slope": slope}
    return Drawing(fig, numbers=numbers, data={"u": u, "height": curve})


@figure("pixel_worked")
def pixel_worked() -> Drawing:
    """The chapter's scene, and a white frame around the pixel that is worked through."""
    picture = image_view(symbolic(size=SIZE // 2)).copy()  # of half the size: the file that is mailed stays small
    row, column = ROW // 2, COLUMN // 2
    for reach, shade in ((3, 0), (2, 255)):
        inside = np.zeros(picture.shape[:2], bool)
        inside[row - reach : row + reach + 1, column - reach : column + reach + 1] = True
        inside[row - reach + 1 : row + reach, column - reach + 1 : column + reach] = False
        picture[inside] = shade
    return Drawing(picture, numbers={"column": COLUMN, "row": ROW})
