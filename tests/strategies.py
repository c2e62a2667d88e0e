"""Hypothesis strategies: accepted scenes, rasters and gradient methods, edges of the domain included; rejected values.

The quick profile is the default and gives the same examples every time; HYPOTHESIS_PROFILE=long draws many new ones.
"""

import math
import os

from hypothesis import HealthCheck, settings, strategies as st

from renderer import Light, Scene, central, central4, exact, forward
from renderer.kernels import FIELDS
from renderer.scene.scene import MODELS

_common = {"deadline": None, "suppress_health_check": [HealthCheck.too_slow, HealthCheck.filter_too_much]}
settings.register_profile("quick", max_examples=100, derandomize=True, **_common)
settings.register_profile("long", max_examples=5000, **_common)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "quick"))


def rounded(low, high):
    """Numbers in [low, high] with six decimals, edges included: no denormals, which do not scale."""
    return st.floats(low, high).map(lambda x: round(x, 6))


def triples(numbers):
    """Three numbers."""
    return st.tuples(numbers, numbers, numbers)


wave_numbers = st.one_of(
    st.integers(-70, 70).map(float),
    rounded(-100, 100),
    st.sampled_from([0.0, -0.0, 0.5, -0.5, 1.0, 2.5, 64.0, -64.0, 66.0, 1e-300, 5e-324, 2.0**20, -(2.0**20)]),
)
betas = st.one_of(rounded(-2, 2), st.sampled_from([0.0, -0.0, 0.35, 5e-324, -5e-324, 1e-300, 1e20, 1e100, -1e100]))
shares = st.sampled_from([n / 64 for n in range(65)])
weights = st.one_of(shares, st.sampled_from([0.0, 0.1, 5.0, 1e6]))
shininesses = st.one_of(
    st.integers(1, 200).map(float), rounded(0.001, 200), st.sampled_from([1e-3, 0.5, 1.0, 32.0, 1e6, 999999.5])
)
radii = st.one_of(st.just(1.0), rounded(0.1, 10), st.integers(-60, 60).map(lambda n: 10.0**n))
ratios = st.one_of(st.just(0.25), rounded(0.01, 0.99), st.sampled_from([1e-6, 1e-3, 0.999999, 1 - 1e-9]))
colors = st.one_of(st.none(), triples(shares), triples(st.sampled_from([0.0, 1.0, 1e6])))
steps = st.one_of(
    st.floats(0.5, 16).map(lambda n: 10.0**-n).filter(lambda x: x <= 0.5),
    st.sampled_from([0.5, 1e-3, 1e-16, 1e-30, 1e-40]),
)
"""ε of a difference."""

differences = st.one_of(st.builds(make, steps) for make in (central, forward, central4))
methods = st.one_of(st.sampled_from([exact(), exact("general")]), differences)


def rasters(largest=24):
    """(width, height): odd and even, wide and tall, one pixel across, and one that puts a pixel on the pole."""
    sizes, one = st.integers(1, largest), st.just(1)
    return st.one_of(st.tuples(sizes, sizes), st.tuples(sizes, one), st.tuples(one, sizes), st.just((21, 20)))


def scaled_triple(triple, factor):
    """A triple of lengths in another unit."""
    return tuple(factor * c for c in triple)


_sides = rounded(-20, 20)
_heights = rounded(1.01, 20), rounded(-20, -1.01), st.sampled_from([1.01, 5.0, 9e8])
_grazing = st.tuples(rounded(1.5, 20) | rounded(-20, -1.5), _sides, st.sampled_from([1e-6, 0.01]))
_positions = st.one_of(_grazing, *(st.tuples(_sides, _sides, height) for height in _heights))
"""Positions of lights in radii of A: above, far, grazing the floor, below it; outside A always."""
_lights = st.lists(st.tuples(_positions, colors), max_size=5)
_centers = triples(rounded(-3, 3))
_ball_radii = st.one_of(rounded(0.05, 1), st.sampled_from([0.01, 0.32, 2.0]))
_rest = {
    "ambient": triples(weights),
    "albedo_a": triples(shares),
    "albedo_b": triples(shares),
    "ka": weights,
    "kd": weights,
    "ks": weights,
    "shininess": shininesses,
    "model": st.sampled_from(MODELS),
    "floor_tint": shares,
    "field": st.sampled_from(sorted(FIELDS)),
    "ku": wave_numbers,
    "kv": wave_numbers,
    "beta": betas,
}


def _accepts(**fields):
    try:
        Scene(**fields)
    except ValueError:
        return False
    return True


@st.composite
def scenes(draw, **fixed):
    """Accepted scenes; `fixed` gives a field as a value or as a strategy, `radius` and `ratio` as strategies."""
    radius = draw(fixed.pop("radius", radii))
    eye = radius / draw(fixed.pop("ratio", ratios))
    while not 1e-6 <= radius / eye <= 1 - 1e-9:  # the rounding of the quotient at the domain's edges
        eye = math.nextafter(eye, 4 * radius)
    place = {"radius": radius, "eye": eye}
    ball = {"ball_center": scaled_triple(draw(_centers), radius), "ball_radius": radius * draw(_ball_radii)}
    place |= ball if _accepts(**place, **ball, lights=()) else {"ball": False}
    place["ball"] = place.get("ball", True) and draw(st.booleans() | st.just(True))
    place["floor"] = draw(st.booleans())
    lights = []
    for position, color in draw(_lights):
        light = Light(scaled_triple(position, radius), color)
        if _accepts(**place, lights=(light,)):
            lights.append(light)
    chosen = {**place, "lights": tuple(lights)}
    for name, value in {**_rest, **fixed}.items():
        chosen[name] = draw(value) if isinstance(value, st.SearchStrategy) else value
    return Scene(**chosen)


_looks = (
    {"field": "ridges", "model": "blinn", "shininess": 32.0},
    {"field": "sine", "model": "phong", "shininess": 7.5},
    {"field": "rings", "model": "blinn", "shininess": 7.0},
)
looks = st.sampled_from(_looks).flatmap(lambda look: scenes(**look))
"""Scenes of a few looks, for tests that are about neither field nor light: every combination is code to compile."""

NUMBER_FIELDS = ("radius", "eye", "ball_radius", "ka", "kd", "ks", "shininess", "floor_tint", "ku", "kv", "beta")
TRIPLE_FIELDS = ("ball_center", "ambient", "albedo_a", "albedo_b")
not_numbers = st.sampled_from([math.nan, math.inf, -math.inf, "1", b"1", None, True, (), [1.0], 1j, 10**400])
not_triples = st.one_of(
    st.sampled_from([None, 1.0, "abc", b"abc", (), (0.1,), (0.1, 0.1), (0.1,) * 4]),
    st.tuples(st.just(0.1), not_numbers, st.just(0.1)),
)
unknown_names = st.one_of(st.text(max_size=5), st.none(), st.integers()).filter(lambda n: n not in (*FIELDS, *MODELS))
rejected_fields = st.one_of(
    st.tuples(st.sampled_from(NUMBER_FIELDS), not_numbers),
    st.tuples(st.sampled_from(TRIPLE_FIELDS), not_triples),
    st.tuples(st.sampled_from(["field", "model"]), unknown_names),
    st.tuples(st.sampled_from(["ball", "floor"]), st.sampled_from([None, "yes", 2, math.nan, ()])),
    st.tuples(st.just("lights"), st.sampled_from([None, 1.0, "no", ((5, 5, 5),), (None,)])),
)
"""(field, value): a value that no Scene accepts for that field."""
