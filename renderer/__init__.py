"""What is drawn: a bumped sphere A, a small sphere B, a floor, in float64, by kernels printed from `proofs/`.

A name is imported when it is first asked for, so that `renderer.generate` runs while kernels.py does not fit the rest.
"""

from importlib import import_module

_NAMES = {
    "drawing": ("render", "stage_of"),
    "frame": ("Frame",),
    "gradients": ("gradient_at", "height_at"),
    "methods": ("central", "central4", "exact", "forward"),
    "pixel_record": ("pixel",),
    "scene": ("Light", "Scene"),
}
__all__ = sorted(name for names in _NAMES.values() for name in names)


def __getattr__(name):
    for module, names in _NAMES.items():
        if name in names:
            return getattr(import_module(f"{__name__}.{module}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
