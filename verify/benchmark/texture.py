"""Measure what a bumped normal costs, computed from the formula or fetched from a table:

    python -m verify.benchmark.texture                   (seconds, on a machine that does nothing else)

One thread, compiled loops of one kind over the pixels of A in raster order. Each gives the normal in the tangent frame:
from the exact gradient or a difference of the formula; from a bilinear normal map; from a bilinear table of heights,
by the interpolation's own derivative or by a central difference of it. A round counts by the least of its calls;
ratios are taken round by round; all carry their quartiles. Writes verify/benchmark/results/texture.json: commit it.
"""

from collections.abc import Callable
from functools import cache, partial
from itertools import product
from typing import Any

import llvmlite.ir as ir
import numpy as np

from proofs.engine.program import chain
from proofs.formulas.finite_difference import central
from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from renderer import Scene, exact, height_at, render
from renderer.generate.kernels import function_of
from renderer.machines.traced import WHOLE, Value
from verify.accuracy.frontiers.normal_map import baked, bumped_in_frame, unit_length
from verify.benchmark.methods.compiled import compiled_loop, loop_of
from verify.benchmark.timing import Case, numbers_by_rounds
from verify.evaluate.programs import algebraic_gradient
from verify.records import command

Points = tuple[np.ndarray, ...]
FIELD, SIDE, EPS = "sine", 512, 1e-3
SMALL, LARGE = 257, 2049  # a map that the processor's own memory holds, and one that it does not
ROUNDS, CALLS = 25, 4
SCENE = Scene(field=FIELD)
SCALARS = {"k_u": SCENE.ku, "k_v": SCENE.kv, "epsilon": EPS, "beta": SCENE.beta}
RATIOS = {"central_to_exact": ("central", "exact"), "central_to_algebraic": ("central", "algebraic"),
          "difference_to_derivative": ("height_difference", "height_derivative"),
          **{f"{slow}_to_map": (slow, "map_small") for slow in ("central", "exact", "algebraic")},
          "large_to_small": ("map_large", "map_small")}  # fmt: skip


def _from_formula(program):
    """Return the compiled loop from the points to N', by a program of the gradient."""
    return compiled_loop(chain(f"normal_{program.name}", program, bumped_in_frame), **SCALARS)


def _texel(table, row, column):
    """Return the channels of the texels at whole rows and columns, Values of which each lane is loaded by itself."""
    machine, channels = row.machine, table.shape[2]
    builder, texel = machine.builder, ir.VectorType(ir.FloatType(), channels)
    index = (row * float(table.shape[1]) + column).vector
    found = [ir.Constant(machine.vector, ir.Undefined)] * channels
    for lane in map(WHOLE, range(machine.lanes)):
        at = builder.mul(builder.fptosi(builder.extract_element(index, lane), WHOLE), WHOLE(4 * channels))
        place = builder.inttoptr(builder.add(at, WHOLE(table.ctypes.data)), texel.as_pointer())
        wide = builder.fpext(builder.load(place, align=4), ir.VectorType(machine.vector.element, channels))
        found = [builder.insert_element(f, builder.extract_element(wide, WHOLE(n)), lane) for n, f in enumerate(found)]
    return [Value(machine, vector) for vector in found]


def _corners(table, u, v):
    """Return (corners {(i, j): channels}, the share of the way to the next texel in u and in v)."""
    machine, texels = u.machine, float(len(table))
    low = [machine.floor(c * texels) for c in (u, v)]
    high = [machine.where(n + 1.0 >= texels, n + (1.0 - texels), n + 1.0) for n in low]
    ends = list(zip(low, high, strict=True))
    corners = {(i, j): _texel(table, ends[0][i], ends[1][j]) for i, j in product((0, 1), repeat=2)}
    return corners, u * texels - low[0], v * texels - low[1]


def _bilinear(table, u, v):
    """Return the channels of a bilinear interpolation, Values."""
    corners, s, t = _corners(table, u, v)
    sides = [[a + (b - a) * s for a, b in zip(corners[0, j], corners[1, j], strict=True)] for j in (0, 1)]
    return [a + (b - a) * t for a, b in zip(*sides, strict=True)]


_unit = function_of(unit_length)


def _from_map(normals, u, v):
    return _unit(*_bilinear(normals, u, v)[:3])


def _by_derivative(heights, u, v):
    corners, s, t = _corners(heights, u, v)
    (a,), (c,), (b,), (d,) = corners.values()
    size = SCENE.beta * len(heights)
    return _unit(((b - a) * (1.0 - t) + (d - c) * t) * size, ((c - a) * (1.0 - s) + (d - b) * s) * size, 1.0 + 0.0 * s)


def _by_difference(heights, u, v):
    step = 0.5 / len(heights)  # half a texel to either side, within the chart: the sample keeps clear of its ends
    above, below, right, left = (
        _bilinear(heights, *at)[0] for at in ((u + step, v), (u - step, v), (u, v + step), (u, v - step))
    )
    size = SCENE.beta / (2 * step)
    return _unit((above - below) * size, (right - left) * size, 1.0 + 0.0 * u)


def _loop(kernel, table):
    """Return a compiled loop over (u, v) that reads a table, float32 (rows, columns, channels), and keeps it alive."""
    table = np.ascontiguousarray(table, np.float32)
    run = loop_of(partial(kernel, table), 3)
    return lambda *points: (table, run(*points))[1]


def _four_channels(texels):
    normals = np.moveaxis(baked(SCENE, texels, exact()), 0, -1)
    return np.concatenate([normals, np.zeros_like(normals[..., :1])], axis=2)  # 16 bytes a texel, as textures are kept


def _heights(texels):
    return height_at(SCENE, *(np.mgrid[0:texels, 0:texels] / texels))[..., None]


@cache
def points() -> tuple[Points, Points]:
    """Return (chart points, angles) of the pixels of A in raster order, two texels of SMALL off the chart's ends."""
    frame = render(SCENE, SIDE, SIDE)
    chart = np.array([frame.data_on_a[name] for name in ("u", "v")])
    clear = ((chart > 2 / SMALL) & (chart < 1 - 2 / SMALL)).all(axis=0)
    return tuple(np.ascontiguousarray(a) for a in chart[:, clear]), tuple(frame.planes_on_a[:4, clear])


@cache
def ways() -> dict[str, tuple[Callable, Points]]:
    """Return {name: (function, its points)} of everything that is timed."""
    field, (chart, angles) = HEIGHT_FIELDS[FIELD], points()
    return {
        "algebraic": (_from_formula(algebraic_gradient(field, SCENE.ku, SCENE.kv)), angles),
        "exact": (_from_formula(gradient(field)), chart),
        "central": (_from_formula(central(field)), chart),
        "map_small": (_loop(_from_map, _four_channels(SMALL)), chart),
        "map_large": (_loop(_from_map, _four_channels(LARGE)), chart),
        "height_derivative": (_loop(_by_derivative, _heights(SMALL)), chart),
        "height_difference": (_loop(_by_difference, _heights(SMALL)), chart),
    }


def measure(rounds: int) -> dict[str, Any]:
    """Return the nanoseconds a point of every way, and their ratios."""
    count = len(points()[0][0])
    cases = [Case(name, partial(function, *at), CALLS, rounds, "ns", count) for name, (function, at) in ways().items()]
    numbers = numbers_by_rounds(cases, "normals", RATIOS)
    return {"numbers": numbers | {"points": count, "small": SMALL, "large": LARGE, "eps": EPS}}


main = partial(command, "texture", __doc__, measure, rounds=ROUNDS)

if __name__ == "__main__":
    main()
