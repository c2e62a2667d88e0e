"""The default scene in NumPy, tiles of rows: what one writes who knows NumPy well and has no compiler.

The lines are the proofs', printed as NumPy with its own sin, cos and arctan2. A tile's pixels are sorted by the surface
that is seen, and each surface is shaded by the lines that it needs; equal lines are computed once.
"""

from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from typing import Any

import numpy as np
from sympy import Expr, Function, Symbol

from proofs.engine.program import Program, chain
from proofs.formulas.camera import image_extent, image_point, surface, visible_surface
from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.pixel import pixel, rgb
from proofs.formulas.symbols import ball_on, floor_on, x, y
from renderer import Scene
from renderer.generate.kernels import function_of
from verify.reference import scene_values

TILE_PIXELS = 2**14


NUMPY = vars(np) | {
    "square_of": np.square,
    "Constant": float,
    "two_product": lambda a, b: (a * b,),
    "sinpi": lambda x: np.sin(np.pi * x),
    "cospi": lambda x: np.cos(np.pi * x),
    "atan2pi": lambda y, x: np.arctan2(y, x) / np.pi,
}
"""NumPy's own functions, its trigonometric ones in place of sinpi and its kin."""


SQUARE_OF = Function("square_of")


def without_repeats(program: Program) -> Program:
    """Return the program with a line that says what an earlier one says replaced by the earlier one's name."""
    first: dict[Expr, Symbol] = {}
    same: dict[Symbol, Symbol] = {}
    for symbol, expression in program.definitions:
        expression = expression.xreplace(same)
        same[symbol] = first.setdefault(expression, symbol)
    lines = {symbol: expression for expression, symbol in first.items()}
    return Program(program.name, program.inputs, lines, [same.get(s, s) for s in program.outputs])


def on_surface(program: Program, number: int) -> Program:
    """Return the program of a pixel for one surface: image point → colour, every choice of the surface decided."""
    decided = {surface: number, ball_on: 1, floor_on: 1}
    given = (surface, x, y)
    lines = {s: e.xreplace(decided) for s, e in program.definitions if s not in given}
    return without_repeats(chain(f"surface_{number}", lines).keep(*rgb))


def numpy_function(program: Program) -> Callable[[Mapping[str, Any]], Any]:
    """Return the program as a function of {input: value}, a square by `np.square`."""
    squared = {
        s: e.replace(lambda power: power.is_Pow and power.exp == 2, lambda power: SQUARE_OF(power.base))
        for s, e in program.definitions
    }
    function = function_of(Program(program.name, program.inputs, squared, program.outputs), names=NUMPY)
    return lambda values: function(*(values[s.name] for s in program.inputs))


@cache
def tile_functions(field: str, model: str, lights: int) -> tuple:
    """Return (extent, image point, visible surface, {surface: colour}), each from `numpy_function`."""
    whole = pixel(HEIGHT_FIELDS[field], model, lights)
    shades = {number: numpy_function(on_surface(whole, number)) for number in (1, 2, 3)}
    return *(numpy_function(program) for program in (image_extent, image_point, visible_surface)), shades


def numpy_tiles(scene: Scene, wide: int, high: int, threads: int = 1) -> tuple[np.ndarray, np.ndarray]:
    """Return (rgb (high, wide, 3) in [0, 1], surface (high, wide)) of a scene with both spheres and a floor."""
    extent, point, visible, shades = tile_functions(scene.field, scene.model, len(scene.lights))
    values = scene_values(scene, width=float(wide), height=float(high), column=np.arange(wide, dtype=np.float64))
    values["half"] = extent(values)
    planes, surfaces = np.empty((3, high, wide)), np.empty((high, wide), np.uint8)

    @np.errstate(all="ignore")  # a thread starts with NumPy's own settings
    def tile(top):
        rows = np.arange(top, min(high, top + step), dtype=np.float64)[:, None]
        at_x, at_y = np.broadcast_arrays(*point(values | {"row": rows}))
        band, here = planes[:, top : top + step], surfaces[top : top + step]
        here[:] = visible(values | {"x": at_x, "y": at_y})
        for number, shade in shades.items():
            seen = here == number
            if seen.any():
                for plane, channel in zip(band, shade(values | {"x": at_x[seen], "y": at_y[seen]}), strict=True):
                    plane[seen] = channel

    step = max(1, TILE_PIXELS // wide)
    with ThreadPoolExecutor(threads) as pool:
        list(pool.map(tile, range(0, high, step)))
    return np.moveaxis(planes, 0, -1), surfaces
