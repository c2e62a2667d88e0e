"""Every stress sweep by name: what the tests check and the figures draw."""

from functools import lru_cache

from verify.stability import geometry, shading, wave_numbers
from verify.stability.sweep import Sweep

SWEEPS = {
    "pole": geometry.toward_the_pole,
    "pole_general": lambda: geometry.toward_the_pole(form="general"),
    "silhouette": geometry.toward_the_silhouette,
    "near_to_far": geometry.from_near_to_far,
    "wave_numbers": lambda: wave_numbers.large_wave_numbers("sine"),
    "wave_numbers_edges": lambda: wave_numbers.large_wave_numbers(
        "ridges", [0.0, 5e-324, 1e-300, 2.0**20, -(2.0**20)], samples=200
    ),
    "wave_numbers_ridges": lambda: wave_numbers.large_wave_numbers("ridges"),
    "wave_numbers_rings": lambda: wave_numbers.large_wave_numbers("rings"),
    "amplitude": shading.any_amplitude,
    "light_distance": shading.near_and_far_lights,
    "opposite_light": shading.opposite_light,
    "opposite_light_phong": lambda: shading.opposite_light("phong"),
    "shininess": shading.any_shininess,
    "shininess_fractional": lambda: shading.any_shininess(whole=False),
}


@lru_cache
def sweep(name: str) -> Sweep:
    """Return a sweep, measured once."""
    return SWEEPS[name]()
