"""What the small interactives of §1 to §3 ask at a point, put together from the renderer's kernels and programs.

Functions of float64 numbers, NumPy's arrays or traced values, as the kernels are: the still pictures call them here,
the pages as WebAssembly, compiled beside the simulator's (`book.simulator_module`).
"""

from collections.abc import Callable

from sympy import Symbol

from proofs.engine.program import Program
from proofs.formulas import bump
from renderer import kernels
from renderer.generate.kernels import function_of
from renderer.kernels import cospi, sinpi
from renderer.operations import Number

DEGREES = 180.0  # in half a turn


def angles_at(u: Number, v: Number) -> tuple[Number, ...]:
    """Return cos θ, sin θ, cos φ, sin φ of a point of the chart: θ = 2πu − π, φ = πv."""
    return -cospi(2.0 * u), -sinpi(2.0 * u), cospi(v), sinpi(v)


def tilt(h_u: Number, h_v: Number, beta: Number) -> Number:
    """Return the angle between N and N' in degrees: its tangent is β|g|, by theorem angle_of_the_bump."""
    return DEGREES * kernels.atan2pi(abs(beta) * kernels.slope(h_u, h_v), 0.0 * beta + 1.0)


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
    """Return h of ridges, its gradient, the tilt in degrees, and μ = N'·ω for a light, not below 0."""
    angles, gradient = angles_at(u, v), kernels.gradient_ridges(u, v, k_u, k_v)
    bumped, point = kernels.bumped_normal(*angles, *gradient, beta), kernels.point_on_a(*angles, radius)
    mu, _ = kernels.phong(*point, light_x, light_y, light_z, *bumped, 0.0, 0.0, 1.0)
    return kernels.height_ridges(u, v, k_u, k_v), *gradient, tilt(*gradient, beta), kernels.maximum(0.0, mu)


def with_every_line(name: str, program: Program) -> tuple[Callable, tuple[Symbol, ...]]:
    """Return a program as a function that returns all of its lines, and their symbols."""
    symbols = tuple(symbol for symbol, _ in program.definitions)
    return function_of(Program(name, program.inputs, program.definitions, symbols)), symbols


bump_lines, BUMP_LINES = with_every_line("bump_lines", bump.bumped_normal)

IDEAS = (angles_at, bump_at, bump_lines)
"""What `book.simulator_module` compiles for them."""
