"""What the simulator's loupe and its certified bounds run, and the numbers that go with it: a second program, for whom asks.

Where a difference takes the height, and what it finds there, is noted while the renderer's own difference runs. A
picture's bounds are the renderer's, by the machine of `renderer.machines.enclosing`.
"""

import json
from collections.abc import Callable
from itertools import product

from book.simulator_module import OFF_A, SCENE, WAYS, packed
from proofs.formulas.finite_difference import HEIGHTS
from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.step_bounds import TERMS
from renderer import exact
from renderer.generate.programs import difference_of, differences
from renderer.generate.step_terms import SLOPE_TERMS
from renderer.kernels import FIELDS, HEIGHT_EVALUATIONS, maximum, minimum
from renderer.machines.points_code import inputs_of
from renderer.machines.rounded_inputs import bound_of_x, bound_of_y, of_scene
from renderer.machines.webassembly import compiled_module
from renderer.operations import Number
from renderer.shader.numbers import flat, scene_numbers
from renderer.shader.shader import difference

BY_ROUNDING = [TERMS.index(term) for term in ("argument rounding", "roundoff")]


def samples_of(name: str, method: str) -> Callable:
    """Return the function (u, v, k_u, k_v, ε) → u', v' and h of each height that a difference takes, then h_u and h_v."""

    def samples(u: Number, v: Number, k_u: Number, k_v: Number, epsilon: Number) -> tuple[Number, ...]:
        taken: list[Number] = []

        def height(*at):
            found = FIELDS[name]["height"](*at)
            taken.extend((*at[:2], found))
            return found

        slopes = difference(FIELDS[name] | {"height": height}, method, u, v, k_u, k_v, epsilon)
        return *taken, *slopes

    samples.__name__ = f"samples_{method}_{name}"
    return samples


def noise_of(name: str) -> Callable:
    """Return the function (u, v, k_u, k_v, ε) → how much of the central difference of the heights rounding may make.

    Once for u, once for v: what the theorems allow it in the slope, times the span of the samples.
    """

    def noise(u: Number, v: Number, k_u: Number, k_v: Number, epsilon: Number) -> tuple[Number, Number]:
        in_u, in_v = (sum(terms[n] for n in BY_ROUNDING) for terms in SLOPE_TERMS[name](u, v, k_u, k_v, epsilon))
        return in_u * 2.0 * epsilon, in_v * (minimum(1.0, v + epsilon) - maximum(0.0, v - epsilon))

    noise.__name__ = f"noise_{name}"
    return noise


SAMPLES = {samples_of(*pair): pair for pair in product(FIELDS, HEIGHT_EVALUATIONS)}
KERNELS = (*SAMPLES, *map(noise_of, SLOPE_TERMS), bound_of_x, bound_of_y)
BOUNDED = {"draw_bounded": OFF_A._replace(ways=tuple(WAYS), bounds=True)}
"""A whole picture, each colour's bound, and where a chamber or a crease's side is open."""


def taken() -> dict[str, list[str]]:
    """Return {kernel: the names of the heights that it notes, in their order}."""
    programs = differences()
    return {
        kernel.__name__: [
            s.name for s, _ in programs[difference_of(method, HEIGHT_FIELDS[name])].definitions if s in HEIGHTS
        ]
        for kernel, (name, method) in SAMPLES.items()
    }


def source() -> str:
    """Return the text of the script that the page loads when it is asked to."""
    module, outputs = compiled_module(BOUNDED, {kernel.__name__: kernel for kernel in KERNELS}, {})
    data = {
        "kernels": {k.__name__: [len(inputs_of(k)), outputs[k.__name__]] for k in KERNELS},
        "taken": taken(),
        "scene_bounds": flat(of_scene(SCENE, scene_numbers(SCENE, exact()))),
    }
    return (
        "// Printed from proofs/ by `python -m book`: what the loupe asks at a pixel, and what bounds the colours.\n"
        f"Simulator.closer = {json.dumps(data, separators=(',', ':'))};\n"
        f'Simulator.closer.program = "{packed(module)}";\n'
    )
