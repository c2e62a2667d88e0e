"""Small pictures beside the words that they are of: a crease enlarged, the four experiments, the pitfalls."""

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import panels
from book.figures.chapter_scene import averaged, enlarged, numeric, symbolic
from renderer import Scene, central, exact, kernels, render
from renderer.picture.frame import Frame
from renderer.picture.views import difference_logarithmic, image_view, slope_view

FINE_SIDE = 600  # a raster whose pixels' centres lie on the diagonals, as creases do
SMALL, LOW, HIGH = 200, -12, 0
EPS = 1e-2
CREASE_STEPS = (1e-2, 3e-3, 1e-3)
BETAS = (0.35, 0.1, 0.02, 0.0)


def step_name(eps: float) -> str:
    """Return a step as a title says it: ε = 0.003, or ε = 10⁻⁶ where it is a power of ten."""
    power = round(np.log10(eps))
    return rf"$\varepsilon = 10^{{{power}}}$" if np.isclose(eps, 10.0**power) else rf"$\varepsilon = {eps:g}$"


def cropped(scene: Scene, crop: tuple[int, int, int, int], *methods) -> list[Frame]:
    """Return the crop of the raster of FINE_SIDE, (left, top, width, height), by each method."""
    return [render(scene, FINE_SIDE, FINE_SIDE, method, crop=crop, bounds=True) for method in methods]


@figure
def crease_close_up() -> Drawing:
    """A diagonal crease of ridges, enlarged: by differences of three steps, and exactly."""
    frames = cropped(Scene(), (176, 330, 48, 48), *map(central, CREASE_STEPS), exact())
    pictures = [enlarged(image_view(frame), 4) for frame in frames]
    fig = panels(pictures, [*map(step_name, CREASE_STEPS), "symbolic"])
    zero = (frames[-1].planes_on_a[4:] == 0).all(axis=0).sum()
    return Drawing(fig, {"side": FINE_SIDE, "zero": zero}, shown=tuple(frames))


@figure
def sweep_of_sine() -> Drawing:
    """The difference of the pipelines' pictures of sine, at four steps."""
    right, steps, scale = symbolic("sine", SMALL), (1e-1, 1e-3, 1e-6, 1e-16), (-16, HIGH)
    frames = [numeric("sine", SMALL, eps, bounds=True) for eps in steps]
    pictures = [difference_logarithmic(frame.rgb - right.rgb, *scale) for frame in frames]
    return Drawing(panels(pictures, [*map(step_name, steps)], scale), shown=(*frames, right))


@figure
def flattening() -> Drawing:
    """Ridges for four amplitudes, down to none."""
    frames = [render(Scene(beta=beta), 2 * SMALL, 2 * SMALL, exact(), bounds=True) for beta in BETAS]
    titles = [rf"$\beta = {beta:g}$" for beta in BETAS]
    return Drawing(panels([averaged(image_view(frame), 2) for frame in frames], titles), shown=tuple(frames))


@figure
def pitfall_seam() -> Drawing:
    """Sine with an odd wave number at the seam, the ray to the left: by a difference, exactly, and their difference."""
    one, other = shown = cropped(Scene(field="sine", ku=7), (120, 232, 44, 44), central(EPS), exact())
    pictures = image_view(one), image_view(other), difference_logarithmic(one.rgb - other.rgb, LOW, HIGH)
    titles = ("numeric", "symbolic", "difference")
    return Drawing(panels([enlarged(each, 4) for each in pictures], titles, (LOW, HIGH)), {"eps": EPS}, shown=shown)


@figure
def light_backwards() -> Drawing:
    """Sphere A of ridges from above: its colour, its perturbed normal as a colour, and its slope."""
    side = 3 * 264
    frame = render(Scene(ball=False), side, side, exact(), bounds=True)
    planes, normals = frame.planes_on_a, np.zeros((side, side, 3))
    normals[frame.stage.on_a] = np.transpose(kernels.bumped_normal(*planes, frame.scene.beta))
    as_colour = np.where(frame.stage.on_a[..., None], np.rint(127.5 * (normals + 1)), 0).astype(np.uint8)
    pictures = [averaged(each) for each in (image_view(frame), as_colour, slope_view(frame))]
    return Drawing(panels(pictures, ("colour", "normal", "slope")), {"steepest": frame.slope.max()}, shown=(frame,))
