"""What is drawn: a bumped sphere A, a small sphere B, a floor, in float64, by kernels printed from `proofs/`.

A name is imported when it is first asked for, so that `renderer.generate` runs while kernels.py does not fit the rest.
"""

from importlib import import_module

_HOMES = {
    "Frame": "picture.frame",
    "Light": "scene.scene",
    "Scene": "scene.scene",
    "central": "scene.methods",
    "central4": "scene.methods",
    "exact": "scene.methods",
    "forward": "scene.methods",
    "gradient_at": "shader.gradients",
    "height_at": "shader.gradients",
    "pixel": "picture.pixel_record",
    "render": "picture.drawing",
    "stage_of": "picture.drawing",
}
__all__ = list(_HOMES)


def __getattr__(name):
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)
    globals()[name] = value
    return value


def __dir__():
    return __all__
