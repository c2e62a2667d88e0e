"""Ways to a picture's slope, timed beside the picture: ours, with bounds, by ten numbers; a difference; JAX's jvp."""

import operator
import time
from collections.abc import Callable
from functools import partial
from importlib.util import find_spec
from itertools import chain, repeat
from typing import Any

import numpy as np

from renderer import exact, render
from renderer.machines.forms import COLORS, flat, of_form
from renderer.shader.numbers import SCENE_FORM
from verify.benchmark.frames import calls
from verify.benchmark.timing import Case, numbers_by_calls, ratios
from verify.coq.recorded_pixel import DEFAULT, SHOT, WANTS, recorded
from verify.coq.recorder import values_of

SCENE, SIDE, STEP = SHOT.scene, SHOT.raster.width, 1e-5
TEN = ("beta", "ku", "kv", "ka", "kd", "ks", "shininess", *(f"lights[0].position[{axis}]" for axis in range(3)))
RATIOS = {
    "by_beta": ("beta_ms", "picture_ms"),
    "by_ten": ("ten_ms", "general_ms"),
    "certified": ("beta_bounded_ms", "bounded_ms"),
    "difference_to_slope": ("difference_ms", "beta_ms"),
    "jax_to_slope": ("jax_ms", "beta_ms"),
}
"""{number: (the time that is so many times as long, as this one)}"""


def picture_by(arrays: Any, beta: Any) -> list:
    """Return the planes of the default scene's colours, by NumPy's functions or JAX's in the place of our kernels."""

    def done(name, *taken):
        match name:
            case "sinpi" | "cospi":
                return getattr(arrays, name[:3])(np.pi * taken[0])
            case "atan2pi":
                return arrays.arctan2(*taken) / np.pi
            case "product_error":
                return arrays.zeros(())  # of which a library's sine has no use
        return (getattr(operator, f"__{name}__", None) or getattr(arrays, name))(*taken)

    recorder, (numbers, lights), (x, y) = recorded(), SHOT.numbers, SHOT.raster.image_points(SCENE)
    scene = of_form(SCENE_FORM, numbers)
    scene.beta = beta
    inputs = chain((x, y[:, None], 0.0, 0.0), flat(scene), lights.ravel(), repeat(0.0))
    values = values_of(recorder.lines, map(arrays.asarray, inputs), done)
    drawing = len(WANTS) * len(lights) + WANTS.index(DEFAULT)
    return [values[recorder.outputs[color][drawing]] for color in COLORS]


def by_jax() -> Any:
    """Return a function that draws the picture and its slope by β, by JAX's jvp."""
    import jax

    jax.config.update("jax_enable_x64", True)
    drawn = jax.jit(lambda beta: jax.jvp(partial(picture_by, jax.numpy), (beta,), (1.0,)))
    return lambda: jax.block_until_ready(drawn(SCENE.beta))


def slope_numbers(rounds: int) -> dict[str, float]:
    """Return the processor's times of pictures and slopes, CASE_ms, and ratios. JAX only where it is installed.

    The ways take turns call by call, on one thread: what else runs on the machine is in no ratio.
    """
    draw = partial(render, SCENE, SIDE, SIDE, threads=1)
    beside = [SCENE.with_numbers({"beta": SCENE.beta + move}) for move in (STEP, -STEP)]
    ways: dict[str, Callable] = {
        "picture": draw,
        "bounded": partial(draw, bounds=True),
        "general": partial(draw, gradient=exact("general")),
        "beta": partial(draw, derivatives=["beta"]),
        "beta_bounded": partial(draw, derivatives=["beta"], bounds=True),
        "ten": partial(draw, derivatives=TEN),
        "difference": lambda: [render(scene, SIDE, SIDE, threads=1) for scene in beside],
    }
    ways |= {"jax": by_jax()} if find_spec("jax") else {}
    cases = [Case(name, way, visits=rounds * calls(SIDE), clock=time.process_time) for name, way in ways.items()]
    times = numbers_by_calls(cases, "slopes")
    return {"side": SIDE} | times | ratios(times, RATIOS)
