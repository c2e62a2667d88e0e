"""A scene found again from its picture: least squares by the picture's exact slopes."""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from renderer.checks import check_items, check_whole, not_allowed
from renderer.picture.drawing import render
from renderer.scene.scene import NUMBERS, Scene

COARSE = 8  # pixels: means over blocks of so many are fitted first, from further away, as no edge adds to their slopes
ENOUGH = {COARSE: 1e-3, 1: 1e-12}  # a step's share of a number, or of what is left
MOST_LIGHT = 1e4  # a colour is at most 1, but for noise
FIRST_DAMPING, MOST_DAMPING = 1e-3, 1e12


class Fitted(NamedTuple):
    """The scene found, and of each number by its name the standard error that what is left of the picture leaves.

    errors: infinite where the picture does not tell the numbers apart. converged: whether the last step changed next to
    nothing; pictures: how many were drawn, with their slopes.
    """

    scene: Scene
    errors: dict[str, float]
    converged: bool
    pictures: int


def fit(scene: Scene, picture: ArrayLike, names: Iterable[str], pictures: int = 60) -> Fitted:
    """Return what is Fitted to a picture, (height, width, 3), by numbers of the scene from where they are on.

    picture: linear light, or a Frame. names: of the numbers, as for `render`. pictures: some more may be drawn. The
    steps are Gauss and Newton's, damped as Levenberg and Marquardt do. From far away it may not converge, or end where
    the picture is nearest among its neighbours alone. Raises ValueError on what is not allowed.

    >>> from renderer import Scene, fit, render
    >>> truth = Scene(field="sine", beta=0.35)
    >>> found = fit(Scene(field="sine", beta=0.3), render(truth, 32, 32).rgb, ["beta"])
    >>> found.converged, round(found.scene.beta, 9)
    (True, 0.35)
    """
    picture, names = np.asarray(picture), [*dict.fromkeys(check_items("names", names, f"a list of {NUMBERS}"))]
    is_light = picture.dtype.kind == "f" and picture.ndim == 3 and picture.shape[2] == 3
    if not is_light or not (abs(picture) <= MOST_LIGHT).all():
        allowed = f"linear light, floats up to {MOST_LIGHT:g}, (height, width, 3)"
        raise not_allowed("picture", f"{picture.dtype} {picture.shape}", allowed)
    if not names:
        raise not_allowed("names", names, f"one or more {NUMBERS}")
    for name in names:
        scene.number(name, "names")
    drawn, pictures, (height, width, _) = 0, check_whole("pictures", pictures, 10**6, low=2), picture.shape

    def compared(scene, block):
        """Return what the picture lacks, and its slopes, of which each is a column: means over blocks of pixels."""
        frame = render(scene, width, height, derivatives=names)
        planes = np.stack([picture - frame.rgb, *frame.derivatives.values()], axis=-1)
        parts = planes[: height // block * block, : width // block * block]
        parts = parts.reshape(height // block, block, width // block, block, 3, -1).mean(axis=(1, 3))
        return np.split(parts.reshape(-1, 1 + len(names)), [1], axis=1)

    for block in (COARSE, 1) if min(height, width) >= 4 * COARSE else (1,):
        (lacking, slopes), damping, converged = compared(scene, block), FIRST_DAMPING, False
        drawn += 1
        while drawn < pictures and not converged and damping < MOST_DAMPING:
            normal, drawn, before = slopes.T @ slopes, drawn + 1, np.sum(lacking**2)
            step = np.linalg.lstsq(normal + damping * np.diag(normal.diagonal()), slopes.T @ lacking, rcond=None)[0]
            old = {name: scene.number(name) for name in names}
            moves = dict(zip(names, step[:, 0].tolist(), strict=True))
            try:
                moved = scene.with_numbers({name: old[name] + moves[name] for name in names})
                after = compared(moved, block)
            except ValueError:  # no such scene
                damping *= 10.0
                continue
            rest, share = np.sum(after[0] ** 2), ENOUGH[block]
            if rest > before:
                damping *= 10.0
                continue
            still = all(abs(moves[name]) <= share * abs(old[name]) for name in names)
            converged = still or bool(before - rest <= share * rest)
            scene, damping, (lacking, slopes) = moved, 0.1 * damping, after
    return Fitted(scene, dict(zip(names, _errors(lacking, slopes), strict=True)), converged, drawn)


def _errors(lacking, slopes):
    """Return the standard errors of the numbers; infinite where their slopes, columns, depend on each other."""
    size, free = np.linalg.norm(slopes, axis=0), lacking.size - slopes.shape[1]
    if free <= 0 or not size.all() or np.linalg.matrix_rank(slopes / size) < slopes.shape[1]:
        return [np.inf] * slopes.shape[1]
    spread = np.linalg.inv(slopes.T @ slopes / np.outer(size, size)).diagonal() / size**2
    return np.sqrt(spread * np.sum(lacking**2) / free).tolist()
