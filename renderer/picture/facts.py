"""The facts about a scene that stand under the ε-table: each is computed when it is asked for."""

from dataclasses import replace
from itertools import product

import numpy as np

from renderer.kernels import FIELDS
from renderer.picture.drawing import render
from renderer.scene.methods import central, exact
from renderer.scene.scene import Scene
from renderer.shader.gradients import gradient_at

SMOOTH_POINT = (0.31, 0.47)
SMALL_SINE = 1e-4
SEED_MODELS = ("blinn", "phong")


def flips_everywhere(scene: Scene, width: int, height: int) -> tuple[int, int]:
    """Return (frames, flips): pixels whose chamber differs from the scene's own, over fields, β, ε, the seed's models.

    A custom field of the scene is one of the fields.
    """
    chambers, flips = render(scene, width, height).chambers, []
    fields, steps = dict.fromkeys((*FIELDS, scene.field)), (1e-1, 1e-3, 1e-6, 1e-12)
    for field, beta, eps, model in product(fields, (-1.0, 0.0, 0.35, 2.0), steps, SEED_MODELS):
        other = render(replace(scene, field=field, beta=beta, model=model), width, height, central(eps))
        flips.append(int(np.count_nonzero(other.chambers != chambers)))
    return len(flips), sum(flips)


def flat_difference(scene: Scene, width: int, height: int) -> float:
    """Return the largest |numeric − exact| over the whole picture at β = 0, by ε = 1e-3."""
    flat = replace(scene, beta=0.0)
    return float(np.abs(render(flat, width, height, central(1e-3)).rgb - render(flat, width, height).rgb).max())


def pixels_near_the_pole(scene: Scene, width: int, height: int) -> tuple[int, float]:
    """Return (how many pixels of A have sin φ below SMALL_SINE, the least sin φ on A)."""
    sines = render(scene, width, height).planes_on_a[3]
    return int((sines < SMALL_SINE).sum()), float(sines.min()) if sines.size else float("nan")


def facts(scene: Scene, width: int, height: int) -> list[tuple[str, str]]:
    """Return [(name, value)], both text: the facts of the chapter's table that the ε-table does not show."""
    sine, ridges = replace(scene, field="sine"), replace(scene, field="ridges")
    right = gradient_at(sine, *SMOOTH_POINT, exact())[0]
    errors = {eps: abs(gradient_at(sine, *SMOOTH_POINT, central(eps))[0] - right) for eps in (1e-3, 1e-4, 1e-6)}
    frames, flips = flips_everywhere(scene, width, height)
    h_u, h_v = (part + 0.0 for part in gradient_at(ridges, 0.125, SMOOTH_POINT[1], exact()))  # −0 prints as 0
    near, least = pixels_near_the_pole(scene, width, height)
    at = f"({SMOOTH_POINT[0]:g}, {SMOOTH_POINT[1]:g})"
    return [
        *((f"sine at {at}: error of h_u, eps = {eps:g}", f"{error:.4g}") for eps, error in errors.items()),
        (f"flips over {frames} frames (fields, beta, eps, models)", str(flips)),
        ("beta = 0: largest |numeric - exact|", f"{flat_difference(scene, width, height):g}"),
        ("ridges on the crease u = 1/8: exact (h_u, h_v)", f"({h_u:g}, {h_v:g})"),
        (f"pixels of A with sin(phi) < {SMALL_SINE:g} (least {least:.2g})", str(near)),
    ]
