"""Programs of the small interactives of §1 to §3, put together from the renderer's kernels and programs.

Functions of float64 numbers, NumPy's arrays or traced values, as the kernels are: the still pictures call them here,
the pages as WebAssembly, beside the simulator's (`book.programs.simulator_module`).
"""

from functools import cache

import numpy as np
from sympy import Integer

from book.programs.simulator_module import script
from proofs.engine.program import Program
from proofs.formulas.chart import chart_inverse
from proofs.formulas.displacement import blinn_normal, displaced_normal, h_phi, h_theta
from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.pixel import pixel
from proofs.formulas.symbols import column, half, height, row, shininess, width, x, y
from renderer import Scene, kernels, render
from renderer.generate.kernels import function_of
from renderer.operations import Number, sqrt
from verify.accuracy.frontiers.fiction import angle_maps
from verify.accuracy.step_terms import SLOPE_TERMS
from verify.reference import scene_values

DEGREES = 180.0  # in half a turn


angles_at = function_of(chart_inverse.keep(*chart_inverse.outputs, name="angles_at"))
in_radians = function_of(displaced_normal.keep(h_theta, h_phi, name="in_radians"))
BLINN, DISPLACED = function_of(blinn_normal), function_of(displaced_normal)


def bump_at(
    u: Number,
    v: Number,
    k_u: Number,
    k_v: Number,
    beta: Number,
    radius: Number,
    light_x: Number,
    light_y: Number,
    light_z: Number,
) -> tuple[Number, ...]:
    """Return h of ridges, h_u, the slope along the parallel, the surface's own tilt in degrees, and μ, not below 0."""
    angles, gradient = angles_at(u, v), kernels.gradient_ridges(u, v, k_u, k_v)
    slopes = kernels.surface_slopes(angles[3], radius, *gradient)
    bumped, point = kernels.bumped_normal(*angles, *slopes, beta), kernels.point_on_a(*angles, radius)
    mu = kernels.light_cosine(*point, light_x, light_y, light_z, *bumped)
    # The tangent of the angle between N and N' is β|g|, by theorem angle_of_the_bump.
    tilt = DEGREES * kernels.atan2pi(abs(beta) * kernels.slope(*slopes), 0.0 * beta + 1.0)
    return kernels.height_ridges(u, v, k_u, k_v), gradient[0], -slopes[0], tilt, kernels.maximum(0.0, mu)


def surfaces(
    u: Number, v: Number, k_u: Number, k_v: Number, beta: Number, light_x: Number, light_y: Number, light_z: Number
) -> tuple[Number, ...]:
    """Return a point of the unit sphere, the same displaced by βh of ridges, and max(0, μ) for each of six normals.

    These are the chapter's, that with its sign mended, its scale, its metric, the displaced surface's own, there, and
    the sphere's.
    """
    angles, slopes = angles_at(u, v), kernels.gradient_ridges(u, v, k_u, k_v)
    h, light = kernels.height_ridges(u, v, k_u, k_v), (light_x, light_y, light_z)
    smooth, raised = (kernels.point_on_a(*angles, radius) for radius in (0.0 * h + 1.0, beta * h + 1.0))
    lit = []
    for point, normal in (
        (smooth, kernels.bumped_normal(*angles, *slopes, beta)),
        (smooth, kernels.bumped_normal(*angles, *slopes, -beta)),
        (smooth, kernels.bumped_normal(*angles, *in_radians(*slopes), -beta)),
        (smooth, BLINN(*angles, *slopes, beta)),
        (raised, DISPLACED(*angles, *slopes, beta, h)),
        (smooth, smooth),
    ):
        length = sqrt(sum((part * part for part in normal[1:]), normal[0] * normal[0]))
        mu = kernels.light_cosine(*point, *light, *normal) / length
        lit.append(kernels.maximum(0.0, mu))
    return *smooth, *raised, *lit


def two_slopes(u: Number, v: Number, k_u: Number, k_v: Number, epsilon: Number) -> tuple[Number, ...]:
    """Return h of ridges at u − ε, u and u + ε, h_u by the central difference and exact, and 1 where it straddles."""
    heights = tuple(kernels.height_ridges(at, v, k_u, k_v) for at in (u - epsilon, u, u + epsilon))
    numeric, _ = kernels.central(kernels.height_ridges, u, v, k_u, k_v, epsilon)
    exact, _ = kernels.gradient_ridges(u, v, k_u, k_v)
    return *heights, numeric, exact, kernels.straddling_ridges(u, v, k_u, k_v, epsilon)


def slope_parts(u: Number, v: Number, k_u: Number, k_v: Number, epsilon: Number) -> tuple[Number, ...]:
    """Return the proved bounds of three parts of h_u's error, of ridges: the step's reach, rounded u ± ε, heights."""
    (truncation, arguments, heights, straddling, _), _ = SLOPE_TERMS["ridges"](u, v, k_u, k_v, epsilon)
    return truncation + straddling, arguments, heights


def seen_along_a_ray() -> Program:
    """Return the program of a whole pixel of ridges from its image point on, to all of its lines.

    The highlight's power is a product.
    """
    program, shine = pixel(HEIGHT_FIELDS["ridges"]), {shininess: Integer(Scene().shininess)}
    inputs = (x, y, *(s for s in program.inputs if s not in (*PLACE, shininess)))
    lines = tuple((s, e.xreplace(shine)) for s, e in program.definitions if s not in (x, y, half))
    return Program("pixel_lines", inputs, lines, [symbol for symbol, _ in lines])


PLACE = (column, row, width, height)
PIXEL = seen_along_a_ray()
pixel_lines = function_of(PIXEL)
PIXEL_LINES = {"inputs": [s.name for s in PIXEL.inputs], "lines": [s.name for s in PIXEL.outputs]}

BALLS = {"beta": 0.12, "turn": 0.5, "tip": 0.45, "lamp": (-0.8, 0.7), "away": 6.0, "ka": 0.4}
"""Of the three balls: β, how the eye stands, the lamp at first, in radians to the right and up, and how far away."""

IDEAS = (bump_at, surfaces, two_slopes, slope_parts, kernels.shadow, pixel_lines)
"""Functions that are compiled for them."""


@cache
def angles() -> tuple[float, ...]:
    """Return the median angle of each of the five normals to the displaced surface's, in degrees, over A in 256²."""
    return *(float(np.nanmedian(degrees)) for degrees in angle_maps(render(Scene(), 256, 256)).values()), 0.0


def scene_inputs(scene: Scene) -> dict[str, float]:
    """Return {name: value} of the inputs of PIXEL that a scene gives: all but the image point."""
    values = scene_values(scene, column=0, row=0, width=1, height=1, epsilon=0)
    return {s.name: float(values[s.name]) for s in PIXEL.inputs if s.name in values}


def lines_at(scene: Scene, x: float, y: float) -> dict[str, float]:
    """Return {line: value} of PIXEL at an image point."""
    inputs = scene_inputs(scene) | {"x": x, "y": y}
    with np.errstate(all="ignore"):
        values = pixel_lines(*(np.float64(inputs[name]) for name in PIXEL_LINES["inputs"]))
    return {name: float(value) for name, value in zip(PIXEL_LINES["lines"], values, strict=True)}


def source() -> str:
    """Return the text of the script that their pages load."""
    data = {"lines": {"pixel_lines": PIXEL_LINES}, "given": scene_inputs(Scene()), "balls": BALLS}
    words = "what the small interactives ask of the renderer's kernels"
    return script(words, "Ideas.data", "Ideas.program", {}, IDEAS, data, {})
