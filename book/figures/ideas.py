"""The still pictures of the small interactives: what paper shows, and a page on which no script runs."""

from dataclasses import replace

import numpy as np
from matplotlib.patches import Circle, Wedge
from numpy.typing import ArrayLike

from book.drawing.registry import Drawing, figure
from book.drawing.style import canvas, colour_of, curve, decades, dots, label, pixel_axes, pixel_text, plot
from book.figures.chapter_scene import SCENE, SIZE, symbolic
from book.programs.idea_kernels import BALLS, bump_at, lines_at, slope_parts, two_slopes
from book.worked import COLUMN, ROW
from renderer import HeightField, kernels, render
from renderer.picture.views import image_view, to_bytes

PARALLEL, POINT = 0.125, 0.453  # v of the circle, u of the point on it
LIGHT = SCENE.lights[0]
WORDS = {  # by the height where they stand
    18: "the height $h$ along the circle, and its slope at the point",
    136: "the surface stays flat; its normals lean",
    214: "the light without the bump",
    258: "and with it",
}


def along_circle(u: ArrayLike, beta: float = BALLS["beta"]) -> tuple[np.ndarray, ...]:
    """Return h, h_u, the slope, the tilt in degrees and μ at points of the circle."""
    return bump_at(np.asarray(u, float), PARALLEL, SCENE.ku, SCENE.kv, beta, SCENE.radius, *LIGHT.position)


def _draw_normals(ax, u, size, role, width):
    """Draw the tilted normals at points of the circle as arrows of so many units of the axes' height."""
    _, _, slope, tilt, _ = along_circle(u)
    turn = -np.radians(np.sign(slope) * tilt)
    ax.quiver(u, np.zeros_like(u), size * np.sin(turn), size * np.cos(turn), scale=1, scale_units="y", angles="uv",
              units="dots", color=colour_of(role), width=width)  # fmt: skip


def heights_unseen() -> dict[str, float]:
    """Return how far two pictures of two landscapes differ at most: h and h + 5; a hill and a hollow, a lamp each.

    The second are on a flat wall, of ridges; the hollow's lamp stands as far on the other side.
    """
    scene = replace(SCENE, bump="surface", field=HeightField("raised", "abs(sin(8*pi*u)*sin(4*pi*v)) + 5"))
    raised, level = (render(each, SIZE, SIZE).rgb for each in (scene, replace(scene, field="ridges")))
    slopes = kernels.gradient_ridges(*np.random.default_rng(56).random((2, SIZE**2)), SCENE.ku, SCENE.kv)
    hill, hollow = (
        kernels.light_cosine(0, 0, 0, side * 3, side * 2, 4, *(-side * s for s in slopes), 1) for side in (1, -1)
    )
    return {"raised": np.abs(raised - level).max(), "hollow": np.abs(hill - hollow).max()}


@figure
def slope_is_texture() -> Drawing:
    """The height along a circle of the sphere, the normals that its slope tilts, the light that they catch."""
    fig, u = canvas(590, 308), np.linspace(0, 1, 513)
    h, (at_h, slope, *_) = along_circle(u)[0], along_circle(POINT)
    top = pixel_axes(fig, 0, 26, 590, 84, xlim=(-0.01, 1.01), ylim=(-0.1, 1.12))
    curve(top, u, h, "ink", label="height", linewidth=1.2)
    ends = np.array([-0.035, 0.035])
    curve(top, POINT + ends, at_h + ends * slope, "symbolic", linewidth=2)
    curve(top, POINT, at_h, "symbolic", linestyle="", marker="o", markersize=7)
    middle = pixel_axes(fig, 0, 130, 590, 70, xlim=(-0.01, 1.01), ylim=(-12, 58))
    curve(middle, [0, 1], [0, 0], "ink", linewidth=1.2)
    few = (np.arange(16) + 0.65 - 0.3 * (np.arange(16) % 2)) / 16  # so near the tops that they do not cross
    _draw_normals(middle, few, 24, "muted", 1)
    _draw_normals(middle, POINT, 42, "symbolic", 3)
    between = (u[1:] + u[:-1]) / 2
    for at, high, beta in ((220, 20, 0.0), (264, 32, BALLS["beta"])):
        shown = to_bytes(np.repeat(along_circle(between, beta)[-1][None, :, None], 3, axis=2))
        pixel_axes(fig, 6, at, 578, high).imshow(shown, aspect="auto", interpolation="nearest")
    for below, words in WORDS.items():
        pixel_text(fig, 6, below, words, "muted")
    _, _, steepest, angle, _ = along_circle(1e-9)
    return Drawing(fig, {"steepest": steepest, "steepest_angle": angle, "beta": BALLS["beta"], **heights_unseen()})


@figure
def scene_from_the_side() -> Drawing:
    """The eye, a ray, the spheres, the floor and the lights, in the upright plane through the eye and B's centre."""
    fig, s, ink = canvas(640, 430), 0.52, colour_of("ink")
    way = np.array(SCENE.ball_center[:2]) / np.hypot(*SCENE.ball_center[:2])
    lines = lines_at(SCENE, *(s * way))

    def flat(point):
        return np.array([np.dot(point[:2], way), point[2]])

    hit, eye = flat([lines[f"point_{axis}"] for axis in "xyz"]), np.array([0, SCENE.eye])
    ax = pixel_axes(fig, 0, 0, 640, 430, xlim=(-3.3, 3.3), ylim=(-0.14, 4.3))
    ax.axhline(0, color=ink, linewidth=1.2)
    body = {"facecolor": colour_of("surface"), "edgecolor": ink, "linewidth": 1.2}
    ax.add_patch(Wedge((0, 0), SCENE.radius, 0, 180, **body))
    ax.add_patch(Circle(flat(SCENE.ball_center), SCENE.ball_radius, **body))
    curve(ax, *zip(eye, hit, strict=True), "symbolic", linewidth=2.2)
    curve(ax, *zip(hit, (s, 0), strict=True), "muted", linewidth=0.9, linestyle=(0, (2, 3)))
    for number, (words, aside) in enumerate((("first light", 4), ("second light", -70))):
        towards = flat(SCENE.lights[number].position) - hit
        near, hidden = hit + 1.25 * towards / np.linalg.norm(towards), lines[f"occluded_{number}"] > 0
        colour, dashes, words = ("muted", (0, (3, 3)), f"{words} (hidden)") if hidden else ("ink", "-", words)
        arrow = {"arrowstyle": "-|>", "shrinkA": 0, "shrinkB": 0, "color": colour_of(colour), "linestyle": dashes}
        ax.annotate("", near, hit, arrowprops=arrow)
        label(ax, near, words, "muted", (aside, 2))
    curve(ax, *zip(eye, hit, strict=True), "ink", linestyle="", marker="o", markersize=6)
    for at, words in (
        (eye + (0.1, 0), "the eye, $t = 0$"),
        ((-3.2, 0.06), "the floor, $t = 1$"),
        ((-0.04, 0.4), "$A$"),
        (flat(SCENE.ball_center) - 0.04, "$B$"),
        (hit + (-0.2, 0.08), "$P$"),
    ):
        ax.text(*at, words, color=ink)
    return Drawing(fig, data={"hit": hit, "ray": [s, 0.0]})


SMALL = 6e-17  # a step that float64 takes for another one


@figure("two_slopes")
def two_slope_lines() -> Drawing:
    """Ridges across a crease, tangent and secant; float64's staircase there; the error of the difference."""
    point, eps = np.float64(0.139), 0.03
    fig, (left, middle, right) = plot("page", 3.0, ncols=3)
    u, across, steps = np.linspace(0.06, 0.25, 381), np.linspace(-2, 2, 801), 10.0 ** np.arange(-17, -1.3, 0.05)

    def slopes(u, epsilon):
        return two_slopes(u, PARALLEL, SCENE.ku, SCENE.kv, epsilon)

    heights, (before, here, after, numeric, slope, _) = slopes(u, eps)[1], slopes(point, eps)
    low, _, high, small, *_ = slopes(point, SMALL)
    stairs, *sampled = ((h - here) / SMALL for h in (slopes(point + across * SMALL, SMALL)[1], low, high))
    curve(left, u, heights, "ink", label="height", linewidth=1.3)
    curve(middle, across, stairs, "ink", label="stairs", linewidth=1.3)
    for ax, x, y, role, steepness, words, reach in (
        (left, point, here, "symbolic", slope, "the slope", 0.02),
        (left, point, (before + after) / 2, "numeric", numeric, "the difference", -0.04),  # its left end is named
        (middle, 0, 0, "symbolic", slope, "", 2),
        (middle, 0, ((low + high) / 2 - here) / SMALL, "numeric", small, "", 1),
    ):
        ends = np.array([-reach, reach])
        curve(ax, x + ends, y + steepness * ends, role, words, "right" if reach > 0 else "left", linewidth=2)
    dots(left, [point - eps, point + eps], [before, after], "numeric", 6)
    dots(middle, [-1, 1], sampled, "numeric", 6)
    dots(left, [point], [here], "symbolic", 7)
    error = np.abs(slopes(point, steps)[3] - slope)
    dots(right, steps, error, "numeric", 2, name="error")
    parts = slope_parts(point, PARALLEL, SCENE.ku, SCENE.kv, steps)
    for name, part in zip(("reach", "arguments", "heights"), parts, strict=True):
        curve(right, steps, part, "bound", label=name, linewidth=0.9)
    left.set(xlabel="$u$", title="$h$", ylim=(-0.12, 1.25))
    middle.set(xlabel="away from $u$, in steps", title=r"$\varepsilon = 6\cdot 10^{-17}$", ylim=(-60, 60))
    decades(right, 4, 4, xlabel="step ε", title="error of $h_u$", ylim=(1e-14, 1e2))
    return Drawing(fig)


@figure
def pixel_worked() -> Drawing:
    """The chapter's scene, and a white frame around the pixel that is worked through."""
    frame = symbolic(size=SIZE // 2)
    picture = image_view(frame).copy()  # of half the size: the file that is mailed stays small
    down, across = np.indices(picture.shape[:2])
    away = np.maximum(np.abs(down - ROW // 2), np.abs(across - COLUMN // 2))
    picture[away == 3], picture[away == 2] = 0, 255
    return Drawing(picture, shown=(frame,))
