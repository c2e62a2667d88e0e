"""The gradient and the height of a field at points of the chart, and the form of its exact gradient."""

import math
from functools import cache

import numpy as np
from numpy.typing import ArrayLike

from renderer.checks import check_kind, not_allowed
from renderer.kernels import MAX_ALGEBRAIC
from renderer.machines import at_points
from renderer.scene.fields import field_kernels
from renderer.scene.methods import GradientMethod, checked_method
from renderer.scene.scene import Scene
from renderer.shader.shader import difference


def algebraic_powers(scene: Scene, method: GradientMethod) -> tuple[int, int] | None:
    """Return the whole powers (for u, for v) of the algebraic form of a scene's gradient; None if it is not taken so.

    Raises ValueError if the form "algebraic" is asked for where there is none.
    """
    if method.name != "exact" or method.form == "general":
        return None
    wave_numbers = field_kernels(scene.field)["wave_numbers"]
    a, b = wave_numbers(scene.ku, scene.kv) if wave_numbers else (math.nan, math.nan)
    if a % 2 == 0 and b % 1 == 0 and max(abs(a), abs(b)) <= MAX_ALGEBRAIC:
        return int(a) // 2, int(b)
    if method.form == "algebraic":
        wave_numbers = f"a field whose wave number in u is even, that in v whole, at most {MAX_ALGEBRAIC} in magnitude"
        of_scene = f"not '{scene.field}' with ku = {scene.ku:g}, kv = {scene.kv:g}"
        raise not_allowed("form", method.form, f"{wave_numbers}, {of_scene}")
    return None


def _chart_points(u: ArrayLike, v: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    try:
        x, y = np.broadcast_arrays(np.asarray(u, np.float64), np.asarray(v, np.float64))
    except (TypeError, ValueError):
        raise not_allowed("(u, v)", (u, v), "numbers, or arrays of shapes that go together") from None
    inside = (x >= 0) & (x <= 1) & (y >= 0) & (y <= 1)
    if not inside.all():
        raise ValueError(f"(u, v) = ({x[~inside][0]}, {y[~inside][0]}) is not allowed: u and v in [0, 1]")
    return x, y


def height_at(scene: Scene, u: ArrayLike, v: ArrayLike) -> np.ndarray:
    """Return h(u, v) of the scene's field, an array of the broadcast shape. Raises ValueError off the chart, [0, 1]².

    At u = 1 the formula is taken there, though the sphere's meridian is u = 0.

    >>> from renderer import Scene, height_at
    >>> height_at(Scene(field="sine"), [0.0, 0.0625], 0.125).tolist()
    [0.0, 1.0]
    """
    check_kind("scene", scene, Scene)
    here = _chart_points(u, v)
    return _at(here, field_kernels(scene.field)["height"], scene.ku, scene.kv)[0]


def _at(here, kernel, *numbers):
    """Return a kernel's outputs at chart points, arrays of these points' shape."""
    u, v = here
    return tuple(np.array(each).reshape(u.shape) for each in at_points(kernel, u.ravel(), v.ravel(), *numbers))


@cache
def _slopes_of(field, name):
    """Return the function of (u, v, k_u, k_v, ε) that takes a field's difference."""
    kernels = field_kernels(field)

    def slopes(u, v, k_u, k_v, eps):
        return difference(kernels, name, u, v, k_u, k_v, eps)

    return slopes


def gradient_at(scene: Scene, u: ArrayLike, v: ArrayLike, method: GradientMethod) -> tuple[np.ndarray, np.ndarray]:
    """Return (h_u, h_v) at chart points by `method` (exact: the general form), arrays of the broadcast shape.

    u and v ∈ [0, 1], else ValueError; so too where `render` refuses the method for the scene.

    >>> from renderer import Scene, central, exact, gradient_at
    >>> for method in (exact(), central(1e-3)):
    ...     h_u, h_v = gradient_at(Scene(field="sine"), [0.03, 0.1], 0.2, method)
    ...     print(h_u.round(3).tolist())
    [10.769, -11.951]
    [10.768, -11.95]
    """
    check_kind("scene", scene, Scene)
    here = _chart_points(u, v)
    if checked_method("method", method).name == "exact":
        algebraic_powers(scene, method)  # which refuses a form that there is none of
        return _at(here, field_kernels(scene.field)["gradient"], scene.ku, scene.kv)
    return _at(here, _slopes_of(scene.field, method.name), scene.ku, scene.kv, method.eps)
