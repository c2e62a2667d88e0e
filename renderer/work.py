"""What a frame took: pixels, gradients, heights, shadow tests, highlights, as the kernels counted them."""

import numpy as np

from renderer.chambers import FLOOR, SPHERE_A, SPHERE_B, SURFACE_BITS


def work_done(stage, bump, counts, shadow_tests):
    """Return how many of each kind were computed, a dict.

    counts: (bands, 3), what the kernels added up (`renderer.shading.WORK`). `pixels` is {chamber code: pixels}.
    """
    gradients, powers, terms = (int(total) for total in np.sum(counts, axis=0))
    chambers = {code: int(pixels) for code, pixels in enumerate(stage.pixel_counts) if pixels}
    surfaces = {"pixels_a": SPHERE_A, "pixels_b": SPHERE_B, "pixels_floor": FLOOR}
    pixels = {name: sum(n for code, n in chambers.items() if code & SURFACE_BITS == s) for name, s in surfaces.items()}
    return pixels | {
        "pixels": chambers,
        "gradient_evaluations": 0 if bump.heights else gradients,
        "algebraic_gradients": gradients if bump.algebraic else 0,
        "height_evaluations": bump.heights * gradients,
        "shadow_tests": shadow_tests,
        "specular_powers": powers,
        "light_terms": terms,
    }
