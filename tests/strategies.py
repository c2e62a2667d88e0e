"""Hypothesis strategies: accepted scenes, rasters and gradient methods, edges of the domain included; rejected values.

The examples are the same every time.
"""

import math
from itertools import product

import numpy as np
from hypothesis import HealthCheck, settings
from hypothesis.strategies import (
    SearchStrategy,
    booleans,
    builds,
    composite,
    floats,
    integers,
    just,
    lists,
    none,
    one_of,
    sampled_from,
    tuples,
)

from renderer import Light, Scene, central, central4, exact, forward
from renderer.kernels import FIELDS
from renderer.scene.scene import BUMPS, MODELS

unhealthy = [HealthCheck.too_slow, HealthCheck.filter_too_much]
settings.register_profile("same", max_examples=100, derandomize=True, deadline=None, suppress_health_check=unhealthy)
settings.load_profile("same")


def rounded(low, high):
    """Draw numbers in [low, high] with six decimals, edges included: no denormals, which do not scale."""
    return floats(low, high).map(lambda x: round(x, 6))


def triples(numbers):
    """Draw three numbers."""
    return tuples(numbers, numbers, numbers)


wave_numbers = one_of(
    integers(-70, 70).map(float),
    rounded(-100, 100),
    sampled_from([0.0, -0.0, 0.5, -0.5, 1.0, 2.5, 64.0, -64.0, 66.0, 1e-300, 5e-324, 2.0**20, -(2.0**20)]),
)
betas = one_of(rounded(-2, 2), sampled_from([0.0, -0.0, 0.35, 5e-324, -5e-324, 1e-300, 1e20, 1e100, -1e100]))
shares = sampled_from([n / 64 for n in range(65)])
weights = one_of(shares, sampled_from([0.0, 0.1, 5.0, 1e6]))
shininesses = one_of(
    integers(1, 200).map(float), rounded(0.001, 200), sampled_from([1e-3, 0.5, 1.0, 32.0, 1e6, 999999.5])
)
radii = one_of(just(1.0), rounded(0.1, 10), integers(-60, 60).map(lambda n: 10.0**n))
ratios = one_of(just(0.25), rounded(0.01, 0.99), sampled_from([1e-6, 1e-3, 0.999999, 1 - 1e-9]))
colors = one_of(none(), triples(shares), triples(sampled_from([0.0, 1.0, 1e6])))
steps = one_of(
    floats(0.5, 16).map(lambda n: 10.0**-n).filter(lambda x: x <= 0.5), sampled_from([0.5, 1e-3, 1e-16, 1e-30, 1e-40])
)
"""ε of a difference."""

differences = one_of(builds(make, steps) for make in (central, forward, central4))
methods = one_of(sampled_from([exact(), exact("general")]), differences)


def rasters(largest=24):
    """Draw (width, height): odd and even, wide and tall, one pixel across, and one that puts a pixel on the pole."""
    sizes, one = integers(1, largest), just(1)
    return one_of(tuples(sizes, sizes), tuples(sizes, one), tuples(one, sizes), just((21, 20)))


def scaled_triple(triple, factor):
    """Return a triple of lengths in another unit."""
    return tuple(factor * c for c in triple)


_sides = rounded(-20, 20)
_heights = rounded(1.01, 20), rounded(-20, -1.01), sampled_from([1.01, 5.0, 9e8])
_grazing = tuples(rounded(1.5, 20) | rounded(-20, -1.5), _sides, sampled_from([1e-6, 0.01]))
_positions = one_of(_grazing, *(tuples(_sides, _sides, height) for height in _heights))
"""Positions of lights in radii of A: above, far, grazing the floor, below it; outside A always."""
_lights = lists(tuples(_positions, colors), max_size=5)
_centers = triples(rounded(-3, 3))
_ball_radii = one_of(rounded(0.05, 1), sampled_from([0.01, 0.32, 2.0]))
_rest = {
    "ambient": triples(weights),
    "albedo_a": triples(shares),
    "albedo_b": triples(shares),
    "ka": weights,
    "kd": weights,
    "ks": weights,
    "shininess": shininesses,
    "model": sampled_from(MODELS),
    "floor_tint": shares,
    "field": sampled_from(sorted(FIELDS)),
    "ku": wave_numbers,
    "kv": wave_numbers,
    "beta": betas,
    "bump": sampled_from(BUMPS),
    "horizon": booleans(),
}


def _accepts(**fields):
    try:
        Scene(**fields)
    except ValueError:
        return False
    return True


@composite
def scenes(draw, **fixed):
    """Draw accepted scenes; `fixed` gives a field as a value or as a strategy, `radius` and `ratio` as strategies."""
    radius = draw(fixed.pop("radius", radii))
    eye = radius / draw(fixed.pop("ratio", ratios))
    while not 1e-6 <= radius / eye <= 1 - 1e-9:  # the rounding of the quotient at the domain's edges
        eye = math.nextafter(eye, 4 * radius)
    place = {"radius": radius, "eye": eye}
    ball = {"ball_center": scaled_triple(draw(_centers), radius), "ball_radius": radius * draw(_ball_radii)}
    place |= ball if _accepts(**place, **ball, lights=()) else {"ball": False}
    place["ball"] = place.get("ball", True) and draw(booleans() | just(True))
    place["floor"] = draw(booleans())
    lights = []
    for position, color in draw(_lights):
        light = Light(scaled_triple(position, radius), color)
        if _accepts(**place, lights=(light,)):
            lights.append(light)
    chosen = {**place, "lights": tuple(lights)}
    for name, value in {**_rest, **fixed}.items():
        chosen[name] = draw(value) if isinstance(value, SearchStrategy) else value
    if abs(chosen["beta"]) > 1e50:  # of the surface's own bump at most 1e80 radii, also of another scene's radius
        chosen["bump"] = "chart"
    return Scene(**chosen)


_chart = {"bump": "chart", "horizon": False}
_looks = (
    {"field": "ridges", "model": "blinn", "shininess": 32.0, **_chart},
    {"field": "sine", "model": "phong", "shininess": 7.5, **_chart},
    {"field": "rings", "model": "blinn_gated", "shininess": 7.0, "bump": "surface", "horizon": True},
)
looks = sampled_from(_looks).flatmap(lambda look: scenes(**look))
"""Scenes of a few looks, for tests that are about neither field nor light: every combination is code to compile."""

NUMBER_FIELDS = ("radius", "eye", "ball_radius", "ka", "kd", "ks", "shininess", "floor_tint", "ku", "kv", "beta")
TRIPLE_FIELDS = ("ball_center", "ambient", "albedo_a", "albedo_b")
NOT_NUMBERS = [math.nan, math.inf, -math.inf, "1", b"1", None, True, (), [1.0], 1j, 10**400]
NOT_NUMBERS += [bytearray(b"1"), np.complex64(1), np.bool_(1)]
NOT_NUMBERS += [np.array(value, kind) for value in ("1", True, 1j) for kind in (None, object)]
NOT_TRIPLES = [None, 1.0, "abc", b"abc", (), (0.1,), (0.1, 0.1), (0.1,) * 4]
NOT_TRIPLES += [bytearray(3), {0, 0.5, 1}]
REJECTED = [
    *product(NUMBER_FIELDS, NOT_NUMBERS),
    *product(TRIPLE_FIELDS, [*NOT_TRIPLES, *((0.1, wrong, 0.1) for wrong in NOT_NUMBERS)]),
    *product(("field", "model"), ["", "other", None, 3]),
    *product(("ball", "floor"), [None, "yes", 2, math.nan, ()]),
    *product(("lights",), [None, 1.0, "no", ((5, 5, 5),), (None,), {}, set(), b""]),
]
"""[(field, value)]: a value that no Scene accepts for that field."""
