"""The four stress sweeps by name, and further entries of theirs: the table that tests and figures go by."""

from collections.abc import Callable
from functools import lru_cache, partial

from verify.accuracy.gradient_errors import OF_WAVES
from verify.stability import geometry
from verify.stability.sweep import Sweep
from verify.stability.wave_numbers import EDGES, large_wave_numbers

SWEEPS: dict[str, Callable[..., Sweep]] = {
    "pole": geometry.toward_the_pole,
    "pole_general": partial(geometry.toward_the_pole, form="general"),
    "silhouette": geometry.toward_the_silhouette,
    "near_to_far": geometry.from_near_to_far,
    **{f"wave_numbers_{field}": partial(large_wave_numbers, field) for field in OF_WAVES},
    "wave_numbers_edges": partial(large_wave_numbers, "ridges", EDGES, samples=200),
}


@lru_cache
def sweep(name: str) -> Sweep:
    """Return a sweep, measured once."""
    return SWEEPS[name]()
