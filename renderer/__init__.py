"""What is drawn: a bumped sphere A, a small sphere B, a floor, in float64, by kernels generated from `proofs/`."""

import sys

from renderer import back_end

if "renderer.generate" not in sys.orig_argv:  # the generator has to run while the kernels do not fit the rest
    if back_end.choose() == back_end.NUMPY:
        back_end.use_numpy()

    from renderer.frame import Frame
    from renderer.gradients import gradient_at, height_at
    from renderer.methods import central, central4, exact, forward
    from renderer.pixel import pixel
    from renderer.render import render, stage_of
    from renderer.scene import Light, Scene

    __all__ = [
        "Frame",
        "Light",
        "Scene",
        "central",
        "central4",
        "exact",
        "forward",
        "gradient_at",
        "height_at",
        "pixel",
        "render",
        "stage_of",
    ]
