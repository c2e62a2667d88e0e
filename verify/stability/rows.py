"""Every stress sweep by name: what the tests check and the figures draw."""

from collections.abc import Callable
from functools import lru_cache, partial

from proofs.formulas.shading import LIGHT_MODELS
from renderer.generate.step_terms import BOUNDS
from verify.stability import geometry, shading, wave_numbers
from verify.stability.sweep import Sweep

_field, *_fields = BOUNDS  # what the theorems cover
_model, *_models = LIGHT_MODELS
SWEEPS: dict[str, Callable[[], Sweep]] = {
    "pole": geometry.toward_the_pole,
    "pole_general": lambda: geometry.toward_the_pole(form="general"),
    "silhouette": geometry.toward_the_silhouette,
    "near_to_far": geometry.from_near_to_far,
    "wave_numbers": partial(wave_numbers.large_wave_numbers, _field),
    **{f"wave_numbers_{name}": partial(wave_numbers.large_wave_numbers, name) for name in _fields},
    "wave_numbers_edges": lambda: wave_numbers.large_wave_numbers(
        "ridges", [0.0, 5e-324, 1e-300, 2.0**20, -(2.0**20)], samples=200
    ),
    "amplitude": shading.any_amplitude,
    "light_distance": shading.near_and_far_lights,
    "opposite_light": partial(shading.opposite_light, _model),
    **{f"opposite_light_{name}": partial(shading.opposite_light, name) for name in _models},
    "shininess": shading.any_shininess,
    "shininess_fractional": lambda: shading.any_shininess(whole=False),
}


@lru_cache
def sweep(name: str) -> Sweep:
    """Return a sweep, measured once."""
    return SWEEPS[name]()
