"""Program of the simulator: the renderer's own shader and kernels as WebAssembly, and the numbers that go with them.

A script, so that a page opened from a disk has it too.
"""

import json
from collections.abc import Callable, Iterable, Mapping
from dataclasses import asdict, replace
from functools import cache
from itertools import product

import numpy as np
from matplotlib import colormaps
from PIL import ImageColor

from book.drawing.palette import OF_TERMS
from book.editions.inlined import base64_gzip
from book.programs.painting_code import NUMBERS, PAINTERS, PAINTING, SIZE_BITS, SRGB_CELLS
from book.programs.webassembly import LANES, compiled_module, emitted
from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.step_bounds import TERMS
from renderer import Light, Scene, kernels
from renderer.files.record import text_of
from renderer.files.srgb import tables, thresholds
from renderer.kernels import FIELDS, HEIGHT_EVALUATIONS, LIGHT_MODELS, MAX_ALGEBRAIC
from renderer.machines.drawing_code import arguments
from renderer.machines.forms import flat
from renderer.machines.points_code import inputs_of
from renderer.operations import where
from renderer.picture.views import DIVERGING
from renderer.scene.raster import Raster
from renderer.shader.numbers import LIGHT_FORM, SCENE_FORM, SHADOWS, Shot, Want, scene_numbers
from renderer.shader.shader import ANGLES, CHART, PLANES, SLOPES, WORK
from renderer.shader.slopes import sloped_group
from verify.accuracy.creases import crease_point, crease_rates
from verify.accuracy.step_terms import BOUNDS, slope_bound

SCENE = Scene()
MODELS = {name: replace(SCENE, model=name) for name in LIGHT_MODELS}
FLAT = (SCENE.field, "flat")  # the same for every field
WAYS = list(product(FIELDS, ("general", *HEIGHT_EVALUATIONS)))
WAYS += [(name, "algebraic") for name, field in FIELDS.items() if field["wave_numbers"]] + [FLAT]

GENERAL = [(name, "general") for name in FIELDS]
STORED = (SCENE.field, "stored")
BY = {
    "by_beta": "beta",
    "by_ku": "ku",
    "by_lamp": "lights[0].position[0]",
}  # {view: by what it has the picture's slope}

OFF_A = Want((FLAT,), tuple(Shot(scene).want.lights[0] for scene in MODELS.values()), SCENE.shininess.is_integer())
WANTS = {
    "draw_chambers": OFF_A._replace(colors=False),
    "draw_elsewhere": OFF_A._replace(chambers_known=True, surfaces="elsewhere"),
    "draw_chart": OFF_A._replace(chambers_known=True, surfaces="a", colors=False, stored=(*ANGLES, *CHART)),
    "draw_a": OFF_A._replace(ways=tuple(WAYS), chambers_known=True, surfaces="a", stored=SLOPES, charted=True),
    "draw_own": OFF_A._replace(ways=(STORED,), chambers_known=True, surfaces="a", charted=True),
    "draw_sloped": OFF_A._replace(
        ways=(*GENERAL, STORED), chambers_known=True, charted=True, by=tuple(BY.values()), around=sloped_group
    ),
}
"""The drawings; a picture is all of them, one after another. A's chart is kept for the next picture.

`draw_own` takes the slopes that the page has computed of the reader's own field; `draw_sloped`, but by k_u, of any.
"""


def points_of(method: str) -> Callable:
    """Return the kernel (u, v, ε) → u and v of each point at which a difference takes the height, in its order."""

    def points(u, v, epsilon):
        places = []

        def height(*place):
            places.extend(place[:2])
            return u

        getattr(kernels, method)(height, u, v, 0.0, 0.0, epsilon)
        return tuple(places)

    points.__name__ = f"points_of_{method}"
    return points


def slopes_of(method: str) -> Callable:
    """Return the kernel (u, v, ε, the heights at these points) → h_u and h_v by a difference; at most eight heights."""

    def slopes(u, v, epsilon, h_1, h_2, h_3, h_4, h_5, h_6, h_7, h_8):
        heights = iter((h_1, h_2, h_3, h_4, h_5, h_6, h_7, h_8))
        return getattr(kernels, method)(lambda *_: next(heights), u, v, 0.0, 0.0, epsilon)

    slopes.__name__ = f"slopes_of_{method}"
    return slopes


OVER_POINTS = (
    *(kernels.image_extent, kernels.image_x, kernels.image_y, crease_point),
    *(kernels.point_on_a, kernels.bumped_normal, kernels.slope, kernels.light_cosine, kernels.chart_radians),
    kernels.surface_slopes,
    *(kernels.normal_of_b, kernels.normal_of_floor, slope_bound, *BOUNDS.values()),
    *(crease_rates(field) for field in HEIGHT_FIELDS.values() if field.creases),
    *(FIELDS[name][role] for name in FIELDS for role in ("height", "kink", "straddling")),
    *(field["wave_numbers"] for field in FIELDS.values() if field["wave_numbers"]),
    *(kernel_of(method) for method in HEIGHT_EVALUATIONS for kernel_of in (points_of, slopes_of)),
)
OF_VECTORS = {
    **{name: (1, getattr(kernels, name)) for name in ("sinpi", "cospi", "exp", "log", "sign")},
    "atan2pi": (1, lambda tangent: kernels.atan2pi(tangent, 1.0)),
    "below": (1, lambda number: where(number < 0.0, 1.0, 0.0)),
    "at_most": (1, lambda number: where(number <= 0.0, 1.0, 0.0)),
    "choice": (3, lambda condition, one, other: where(condition > 0.0, one, other)),
}
"""Functions that the reader's own field calls in the page: {name: (of how many numbers, kernel)}."""
SMALLEST = -16  # the logarithmic scale of differences runs from 10^SMALLEST to 1
TERM_COLOURS = ("#000000", *OF_TERMS)  # none, then TERMS


def _scenes():
    """Return {B is on, each light is on, as 0 or 1: the scene's and the lights' numbers}: what else varies is set."""
    scenes = {}
    for ball, *on in product((False, True), repeat=1 + len(SCENE.lights)):
        lights = tuple(a if lit else Light(a.position, None) for a, lit in zip(SCENE.lights, on, strict=True))
        numbers, rows = Shot(replace(SCENE, ball=ball, lights=lights)).numbers
        scenes["".join(str(int(part)) for part in (ball, *on))] = {"scene": numbers.tolist(), "lights": rows.tolist()}
    return scenes


def _level_of_size(size):
    """Return the level of a difference on the logarithmic scale, as Matplotlib takes it from a share of a scale."""
    share = (np.log10(size) - SMALLEST) / -SMALLEST
    return np.clip(np.floor(256 * share), 0, 255)


def _colours(rows):
    """Return (…, 3) bytes as a canvas's opaque pixels, int32: red is the lowest byte."""
    return (np.asarray(rows, np.uint32) @ np.array([1, 1 << 8, 1 << 16], np.uint32) | 255 << 24).tolist()


def _tables():
    """Return what a painter reads, by name: cells of numbers, and where each level begins; palettes."""
    return {
        "srgb": {"cells": SRGB_CELLS, "thresholds": tables()[0][:-1].tolist()},
        "sizes": {"bits": SIZE_BITS, "thresholds": thresholds(_level_of_size).tolist()},
        "inferno": _colours(colormaps["inferno"](range(256), bytes=True)[:, :3]),
        "grey": _colours(np.arange(256)[:, None].repeat(3, axis=1)),
        "slopes": _colours(colormaps[DIVERGING](range(256), bytes=True)[:, :3]),
        "terms": _colours([*map(ImageColor.getrgb, TERM_COLOURS)]),
        "levels": _colours(
            [[level, 1, 0] for level in range(256)]
        ),  # for the page to colour; a difference of 0 has no 1
    }


def data() -> dict:
    """Return what the page and its workers know beside the module and its kernels."""
    sizes = [len(value) if isinstance(value, tuple) else 1 for value in vars(SCENE_FORM).values()]
    ways = {f: {way: n for n, (field, way) in enumerate(WAYS) if field == f or way == "flat"} for f in HEIGHT_FIELDS}
    return {
        "scene": asdict(SCENE),
        "scenes": _scenes(),
        "record": json.loads(text_of(Shot(SCENE, raster=Raster(256, 256)))) | {"machine": "webassembly"},
        "offsets": {name: sum(sizes[:number]) for number, name in enumerate(vars(SCENE_FORM))},
        "light_size": len(flat(LIGHT_FORM)),
        "shadows": sum(len(getattr(LIGHT_FORM, name)) for name in SHADOWS),
        "fields": {
            n: {"ways": ways[n], "sloped": GENERAL.index((n, "general")), "creases": len(f.creases)}
            for n, f in HEIGHT_FIELDS.items()
        },
        "models": {
            n: {"index": number, "power": scene_numbers(Shot(scene)).power}
            for number, (n, scene) in enumerate(MODELS.items())
        },
        "max_algebraic": MAX_ALGEBRAIC,
        "by": BY,
        "arguments": arguments(PLANES),
        "sloped": arguments(WANTS["draw_sloped"].shader.planes),
        "counts": len(WORK),
        "lanes": LANES,
        "painting": PAINTING,
        "emitted": emitted(OF_VECTORS),
        "numbers": NUMBERS,
        "tables": _tables(),
        "terms": TERMS,
        "term_colours": TERM_COLOURS,
    }


def script(
    words: str, place: str, module_place: str, wants: Mapping[str, Want], functions: Iterable[Callable], beside: dict,
    painters: Mapping[str, Callable] = PAINTERS, of_vectors: Mapping[str, tuple[int, Callable]] = {},
) -> str:  # fmt: skip
    """Return a script that puts a module, compressed, and what is known beside it, at two places, "Simulator.data".

    The module draws what is wanted and has the functions; of each, "kernels" says how many numbers it takes and gives.
    """
    module, outputs = compiled_module(wants, {each.__name__: each for each in functions}, painters, of_vectors)
    kernels_in = {each.__name__: [len(inputs_of(each)), outputs[each.__name__]] for each in functions}
    text, holder = json.dumps({"kernels": kernels_in} | beside, separators=(",", ":")), place.partition(".")[0]
    return (
        f"// Printed from proofs/ by `python -m book`: {words}.\n"
        f'"use strict";\nvar {holder} = {holder} || {{}};\n'
        f'{place} = {text};\n{module_place} = "{base64_gzip(module)}";\n'
    )


@cache
def source() -> str:
    """Return the text of the script that the page loads."""
    words = "the renderer's shader and kernels, and the numbers beside them"
    return script(words, "Simulator.data", "Simulator.program", WANTS, OVER_POINTS, data(), PAINTERS, OF_VECTORS)
