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
    "Light Scene": "scene.scene",
    "central central4 exact forward": "scene.methods",
    "fit": "picture.fit",
    "gradient_at height_at": "shader.gradients",
    "pixel": "picture.pixel_record",
    "records sweep": "picture.sweep",
    "render stage_of": "picture.drawing",
    "HeightField cospi k_u k_v sinpi u v": "generate.custom_fields",
    "__version__": "version",
}
_HOME = {name: home for names, home in _HOMES.items() for name in names.split()}
__all__ = [n for n, home in _HOME.items() if home not in ("generate.custom_fields", "version")]  # none imports SymPy


if not TYPE_CHECKING:  # whose own list it would hide

    def __getattr__(name: str) -> Any:
        if name not in _HOME:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        value = getattr(import_module(f"{__name__}.{_HOME[name]}"), name)
        globals()[name] = value
        return value


def __dir__() -> list[str]:
    return __all__
