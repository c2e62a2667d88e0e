"""Program of the simulator's loupe and its certified bounds, with the numbers beside it: a second program.

The renderer's own difference is run on a height that notes each point at which it is asked for, and its value there.
A picture's bounds are the renderer's, by the machine of `renderer.machines.enclosing_machine`.
"""

from collections.abc import Callable
from itertools import product

from book.programs.simulator_module import OFF_A, SCENE, WAYS, script
from proofs.formulas.finite_difference import HEIGHTS
from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.step_bounds import TERMS
from renderer.generate.programs import difference_of, differences
from renderer.kernels import FIELDS, HEIGHT_EVALUATIONS, maximum, minimum
from renderer.machines.forms import flat
from renderer.operations import Number, nan
from renderer.picture.differences import nearest_and_furthest
from renderer.shader.numbers import Shot
from renderer.shader.rounded_inputs import bound_of_x, bound_of_y, of_scene
from renderer.shader.shader import difference
from verify.accuracy.step_terms import BOUNDS, RULES, slope_terms

BY_ROUNDING = [TERMS.index(term) for term in ("argument rounding", "roundoff")]


def _noise(name, method, *at):
    """Return how much of the difference of heights rounding may make, then how far a slope is off: in u, and in v.

    By the theorems, over the span of the samples; NaN where none covers the field.
    """
    if (name, method) not in BOUNDS:
        return (nan,) * 4
    _, v, *_, epsilon = at
    in_u, in_v = (sum(terms[n] for n in BY_ROUNDING) for terms in slope_terms(HEIGHT_FIELDS[name], method)(*at))
    span = RULES[method].span * epsilon
    clamped = minimum(span, minimum(1.0, v + epsilon) - maximum(0.0, v - epsilon))
    return in_u * span, in_v * clamped, *BOUNDS[name, method](*at)[2:]


def samples_of(name: str, method: str) -> Callable:
    """Return the function (u, v, k_u, k_v, ε) → the samples of a difference, its slopes, and bounds of their errors.

    In order: u', v' and h of each height that it takes; h_u and h_v; how much rounding may change the difference of
    heights in u, and in v; and the two proved bounds.
    """

    def samples(u: Number, v: Number, k_u: Number, k_v: Number, epsilon: Number) -> tuple[Number, ...]:
        at, taken = (u, v, k_u, k_v, epsilon), []

        def height(*there):
            h = FIELDS[name]["height"](*there)
            taken.extend((*there[:2], h))
            return h

        slopes = difference(FIELDS[name] | {"height": height}, method, *at)
        return *taken, *slopes, *_noise(name, method, *at)

    samples.__name__ = f"samples_{method}_{name}"
    return samples


SAMPLES = {samples_of(*pair): pair for pair in product(FIELDS, HEIGHT_EVALUATIONS)}
KERNELS = (*SAMPLES, bound_of_x, bound_of_y, nearest_and_furthest)
BOUNDED = {"draw_bounded": OFF_A._replace(ways=tuple(WAYS), bounds=True)}
"""A whole picture, each colour's bound, and where a chamber or a crease's side is open."""


def _step(name: str) -> int:
    """Return how many steps a height of this name is away."""
    return 0 if name == "h_here" else (-1 if "minus" in name else 1) * (2 if name.endswith("2") else 1)


def _called(axis: str, step: int) -> str:
    return f"{axis} {'−' if step < 0 else '+'} {'2' * (abs(step) == 2)}ε" if step else axis


def pairs_of(name: str, method: str, axis: str) -> list[list[dict]]:
    """Return the pairs of heights that a difference subtracts along an axis, as `samples` returns them.

    Each is {name of the argument, step: how many ε away, at: the argument's place among the outputs, h: the height's}.
    """
    program = differences()[difference_of(method, HEIGHT_FIELDS[name])]
    names = [s.name for s, _ in program.definitions if s in HEIGHTS]
    steps = {n: _step(height) for n, height in enumerate(names) if height.startswith((f"h_{axis}_", "h_here"))}
    order = sorted(steps, key=lambda n: -steps[n])
    if not any(steps.values()):
        return []
    samples = [
        {"name": _called(axis, steps[n]), "step": steps[n], "at": 3 * n + "uv".index(axis), "h": 3 * n + 2}
        for n in order
    ]
    half = len(samples) // 2
    return [list(pair) for pair in zip(samples[:half], reversed(samples[half:]), strict=True)]


def pairs() -> dict[str, dict[str, list]]:
    """Return {kernel: {axis: its pairs}}."""
    return {kernel.__name__: {axis: pairs_of(*pair, axis) for axis in "uv"} for kernel, pair in SAMPLES.items()}


def source() -> str:
    """Return the text of the script that the page loads when it is asked to."""
    data = {"pairs": pairs(), "scene_bounds": flat(of_scene(Shot(SCENE)))}
    words = "what the loupe asks at a pixel, and what bounds the colours"
    return script(words, "Simulator.closer", "Simulator.closer.program", BOUNDED, KERNELS, data, {})
