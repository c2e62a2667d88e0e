"""A scene found again from its picture: least squares by the picture's exact slopes."""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from renderer.checks import check_whole, not_allowed
from renderer.picture.drawing import render
from renderer.scene.scene import Scene

COARSE = 8  # pixels: means over blocks of so many are fitted first, from further away, as no edge adds to their slopes
ENOUGH = {COARSE: 1e-3, 1: 1e-12}  # a step's share of a number, or of what is left
FIRST_DAMPING, MOST_DAMPING = 1e-3, 1e12


class Fitted(NamedTuple):
    """The scene found, and of each number by its name the standard error that what is left of the picture leaves.

    converged: whether a further step would change nothing; pictures: how many were drawn, with their slopes.
    """

    scene: Scene
    errors: dict[str, float]
    converged: bool
    pictures: int


def fit(scene: Scene, picture: np.ndarray, names: Iterable[str], pictures: int = 60) -> Fitted:
    """Return what is Fitted to a picture, (height, width, 3), by numbers of the scene from where they are on.

    names: of the numbers, as for `render`. pictures: at most as many are drawn. The steps are Gauss and Newton's,
    damped as Levenberg and Marquardt do. From far away it may end elsewhere, or not converge, and says so.

    >>> from renderer import Scene, fit, render
    >>> truth = Scene(field="sine", beta=0.35)
    >>> found = fit(Scene(field="sine", beta=0.3), render(truth, 32, 32).rgb, ["beta"])
    >>> found.converged, round(found.scene.beta, 9)
    (True, 0.35)
    """
    names, left = [*names], check_whole("pictures", pictures, 10**6)
    target = np.asarray(picture, np.float64)
    if target.ndim != 3 or target.shape[2] != 3 or not np.isfinite(target).all():
        raise not_allowed("picture", target.shape, "finite numbers, (height, width, 3)")

    def drawn(scene, block):
        """Return what the picture lacks, and its slopes, of which each is a column: means over blocks of pixels."""
        frame = render(scene, target.shape[1], target.shape[0], derivatives=names)
        lacking, *slopes = (_means(plane, block) for plane in (target - frame.rgb, *frame.derivatives.values()))
        return lacking, np.stack(slopes, axis=1)

    for block in (COARSE, 1) if min(target.shape[:2]) >= 4 * COARSE else (1,):
        lacking, slopes = drawn(scene, block)
        left, damping, converged = left - 1, FIRST_DAMPING, False
        while left > 0 and not converged and damping < MOST_DAMPING:
            normal, left = slopes.T @ slopes, left - 1
            step = np.linalg.lstsq(normal + damping * np.diag(normal.diagonal()), slopes.T @ lacking, rcond=None)[0]
            here = np.array([scene.number(name) for name in names])
            try:
                moved = scene.with_numbers(dict(zip(names, (here + step).tolist(), strict=True)))
                after = drawn(moved, block)
            except ValueError:  # no such scene
                damping *= 10.0
                continue
            rest, before = after[0] @ after[0], lacking @ lacking
            if rest > before:
                damping *= 10.0
                continue
            converged = bool((abs(step) <= ENOUGH[block] * abs(here)).all() or before - rest <= ENOUGH[block] * rest)
            scene, damping, (lacking, slopes) = moved, 0.1 * damping, after
    spread = np.linalg.pinv(slopes.T @ slopes).diagonal() * (lacking @ lacking) / (lacking.size - len(names))
    return Fitted(scene, dict(zip(names, np.sqrt(spread).tolist(), strict=True)), converged, pictures - left)


def _means(plane, block):
    """Return the means over blocks of a plane's pixels, channel by channel, one after another."""
    height, width = (side // block * block for side in plane.shape[:2])
    parts = plane[:height, :width].reshape(height // block, block, width // block, block, 3)
    return parts.mean(axis=(1, 3)).ravel()
