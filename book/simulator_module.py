"""What the simulator runs: the renderer's own shader and kernels as WebAssembly, and the numbers that go with them.

A script, so that a page opened from a disk has it too.
"""

import json
from base64 import b64encode
from dataclasses import asdict, replace
from functools import cache
from itertools import product

from matplotlib import colormaps
from sympy import diff

from proofs.formulas import step_bounds
from proofs.formulas.camera import parallel_radius
from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.symbols import k_u, k_v, u, v
from renderer import Light, Scene, exact, kernels
from renderer.generate.kernels import function_of
from renderer.kernels import FIELDS, HEIGHT_EVALUATIONS, LIGHT_MODELS, MAX_ALGEBRAIC
from renderer.machines.drawing_code import ARGUMENTS
from renderer.machines.points_code import inputs_of
from renderer.machines.webassembly import LANES, compiled_module
from renderer.numbers import LIGHT_FORM, SCENE_FORM, flat, numbers_of, scene_numbers, style_of
from renderer.shader import ANGLES, CHART, SLOPES, WORK, Want

SCENE = Scene()
MODELS = {name: replace(SCENE, model=name) for name in LIGHT_MODELS}
FLAT = (SCENE.field, "flat")  # the same for every field
WAYS = [*product(FIELDS, ("general", *HEIGHT_EVALUATIONS))]
WAYS += [(name, "algebraic") for name, field in FIELDS.items() if field["wave_numbers"]] + [FLAT]

_off_a = Want((FLAT,), tuple(map(style_of, MODELS.values())), SCENE.shininess.is_integer())
WANTS = {
    "draw_chambers": _off_a._replace(colors=False),
    "draw_elsewhere": _off_a._replace(given=True, surfaces="elsewhere"),
    "draw_chart": _off_a._replace(given=True, surfaces="a", colors=False, kept=(*ANGLES, *CHART)),
    "draw_a": _off_a._replace(ways=tuple(WAYS), given=True, surfaces="a", kept=SLOPES, charted=True),
}
"""The drawings; a picture is all of them, one after another. A's chart is kept for the next picture."""

OVER_POINTS = (
    *(kernels.image_extent, kernels.image_x, kernels.image_y, function_of(parallel_radius)),
    *(kernels.point_on_a, kernels.bumped_normal, kernels.slope, kernels.phong),
    *(kernels.normal_of_b, kernels.normal_of_floor),
    *map(function_of, step_bounds.BOUNDS),
    *(FIELDS[name][role] for name in FIELDS for role in ("height", "kink", "straddling")),
    *(field["wave_numbers"] for field in FIELDS.values() if field["wave_numbers"]),
)


def _scenes():
    """Return {B is on, each light is on, as 0 or 1: the scene's and the lights' numbers}: what else varies is set."""
    found = {}
    for ball, *on in product((False, True), repeat=1 + len(SCENE.lights)):
        lights = tuple(a if lit else Light(a.position, None) for a, lit in zip(SCENE.lights, on, strict=True))
        numbers, rows = numbers_of(replace(SCENE, ball=ball, lights=lights), exact())
        found["".join(str(int(part)) for part in (ball, *on))] = {"scene": numbers.tolist(), "lights": rows.tolist()}
    return found


def _offsets():
    """Return {name: where it begins among the scene's numbers}."""
    sizes = {name: len(value) if isinstance(value, tuple) else 1 for name, value in vars(SCENE_FORM).items()}
    return {name: sum(list(sizes.values())[:number]) for number, name in enumerate(sizes)}


def _creases(field):
    """Return [[u or v, the coefficients of k_u and k_v in how often it is met]] of creases along a coordinate line."""
    found = []
    for factor in field.creases:
        rates = [(str(c), diff(factor.args[0], c)) for c in (u, v) if factor.has(c)]
        if len(rates) == 1:
            found += [[c, *(float(rate.coeff(k)) for k in (k_u, k_v))] for c, rate in rates]
    return found


def _way_indices(name):
    """Return {way: its index} of a field."""
    return {way: number for number, (field, way) in enumerate(WAYS) if field == name or way == "flat"}


def data(outputs):
    """Return what the page and its workers know beside the module. outputs: {kernel: how many}."""
    return {
        "scene": asdict(SCENE),
        "scenes": _scenes(),
        "offsets": _offsets(),
        "light_size": len(flat(LIGHT_FORM)),
        "fields": {n: {"ways": _way_indices(n), "creases": _creases(f)} for n, f in HEIGHT_FIELDS.items()},
        "models": {
            n: {"index": number, "power": scene_numbers(scene, exact()).power}
            for number, (n, scene) in enumerate(MODELS.items())
        },
        "max_algebraic": MAX_ALGEBRAIC,
        "arguments": ARGUMENTS,
        "counts": len(WORK),
        "lanes": LANES,
        "kernels": {k.__name__: [len(inputs_of(k)), outputs[k.__name__]] for k in OVER_POINTS},
        "inferno": bytes(colormaps["inferno"](range(256), bytes=True)[:, :3]).hex(),
    }


@cache
def source():
    """Return the text of the script that the page loads."""
    module, outputs = compiled_module(WANTS, {kernel.__name__: kernel for kernel in OVER_POINTS})
    return (
        "// Printed from proofs/ by `python -m book`: the renderer's shader and kernels, and the numbers beside them.\n"
        '"use strict";\nvar Simulator = Simulator || {};\n'
        f"Simulator.data = {json.dumps(data(outputs), separators=(',', ':'))};\n"
        f'Simulator.program = "{b64encode(module).decode()}";\n'
    )
