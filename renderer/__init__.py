"""The renderer: a bumped sphere A, a small sphere B and a floor, drawn in float64 by kernels printed from `proofs/`.

A name is imported when it is first asked for, so that `renderer.generate` runs while kernels.py does not fit the rest.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:  # _HOMES, for type checkers
    from renderer.generate.custom_fields import (
        HeightField as HeightField,
        cospi as cospi,
        k_u as k_u,
        k_v as k_v,
        sinpi as sinpi,
        u as u,
        v as v,
    )
    from renderer.picture.drawing import render as render, stage_of as stage_of
    from renderer.picture.fit import fit as fit
    from renderer.picture.frame import Frame as Frame
    from renderer.picture.pixel_record import pixel as pixel
    from renderer.picture.sweep import records as records, sweep as sweep
    from renderer.scene.methods import central as central, central4 as central4, exact as exact, forward as forward
    from renderer.scene.scene import Light as Light, Scene as Scene
    from renderer.shader.gradients import gradient_at as gradient_at, height_at as height_at
    from renderer.version import __version__ as __version__

_HOMES = {
    "Frame": "picture.frame",
    "HeightField": "generate.custom_fields",
    "Light": "scene.scene",
    "Scene": "scene.scene",
    "central": "scene.methods",
    "central4": "scene.methods",
    "cospi": "generate.custom_fields",
    "exact": "scene.methods",
    "fit": "picture.fit",
    "forward": "scene.methods",
    "gradient_at": "shader.gradients",
    "height_at": "shader.gradients",
    "k_u": "generate.custom_fields",
    "k_v": "generate.custom_fields",
    "pixel": "picture.pixel_record",
    "records": "picture.sweep",
    "render": "picture.drawing",
    "sinpi": "generate.custom_fields",
    "stage_of": "picture.drawing",
    "sweep": "picture.sweep",
    "u": "generate.custom_fields",
    "v": "generate.custom_fields",
    "__version__": "version",
}
__all__ = [n for n, home in _HOMES.items() if home not in ("generate.custom_fields", "version")]  # none imports SymPy


if not TYPE_CHECKING:  # whose own list it would hide

    def __getattr__(name: str) -> Any:
        if name not in _HOMES:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        value = getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)
        globals()[name] = value
        return value


def __dir__() -> list[str]:
    return __all__
