"""Every stress sweep by name: what the tests check and the figures draw."""

from collections.abc import Callable, Iterable
from functools import lru_cache, partial

from proofs.formulas.shading import LIGHT_MODELS
from proofs.formulas.symbols import normal, point
from verify.accuracy.gradient_errors import OF_WAVES
from verify.stability import geometry, shading
from verify.stability.sweep import Sweep
from verify.stability.wave_numbers import EDGES, large_wave_numbers


def _of_each(name: str, function: Callable, registry: Iterable[str]) -> dict[str, Callable]:
    """Return {name: the function of the registry's first entry, name_ENTRY: that of another}."""
    first, *others = registry
    return {name: partial(function, first)} | {f"{name}_{entry}": partial(function, entry) for entry in others}


SWEEPS: dict[str, Callable[..., Sweep]] = {
    "pole": geometry.toward_the_pole,
    "pole_general": partial(geometry.toward_the_pole, form="general"),
    "silhouette": geometry.toward_the_silhouette,
    "near_to_far": geometry.from_near_to_far,
    "hit_of_b": partial(geometry.smaller_and_smaller_b, point),
    "normal_of_b": partial(geometry.smaller_and_smaller_b, normal),
    "shadow": shading.beside_a_shadow,
    "wave_numbers_edges": partial(large_wave_numbers, "ridges", [(k, k) for k in EDGES], samples=200),
    "amplitude": shading.any_amplitude,
    "light_distance": shading.near_and_far_lights,
    "shininess": shading.any_shininess,
    "shininess_fractional": partial(shading.any_shininess, whole=False),
    **_of_each("wave_numbers", large_wave_numbers, OF_WAVES),
    **_of_each("opposite_light", shading.opposite_light, LIGHT_MODELS),
}


@lru_cache
def sweep(name: str) -> Sweep:
    """Return a sweep, measured once."""
    return SWEEPS[name]()
