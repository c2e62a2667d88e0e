"""Contrast of a crease in the default scene, and the floats that a rounded product puts on one."""

from collections.abc import Sequence
from fractions import Fraction
from functools import cache, partial

import numpy as np

from renderer import Scene, central, render
from renderer.picture.differences import difference_on_a
from renderer.picture.facts import crease_contrast
from renderer.shader.gradients import height_at
from verify.checkers.measurements import Measurement, measures

SIZE, MOST = 256, 64
FIRST_LEVEL = 0.5 / 255  # what rounds to the first of 255 levels


@measures("crease_products", false={"all of them": {"count": 1824}, "our kernel does so too": {"zeros": 1756}})
def rounded_products_hit_the_crease(beside: int = 1824, count: int = 1756, zeros: int = 0) -> Measurement:
    """Count the nearest floats to all m/k, 0 < m < k ≤ 64, that are not m/k: k·u rounds to m for most of them."""
    floats = [(k, m / k) for k in range(2, MOST + 1) for m in range(1, k) if Fraction(m / k) * k != m]
    rounded = [(k * u).is_integer() for k, u in floats]
    kernel = [height_at(Scene(ku=float(k)), u, 0.125) == 0 for k, u in floats]
    return Measurement(
        np.array([rounded, kernel], float),
        of=partial(np.sum, axis=1),
        claimed=(count, zeros),
        bound=0,
        holds=len(floats) == beside,
        quantity="floats beside a crease whose product k·u rounds to a whole number; heights of 0 in the kernel",
        numbers={"beside": len(floats), "rounded_onto": sum(rounded), "kernel_zeros": sum(kernel)},
    )


@cache
def _exact():
    return render(Scene(), SIZE, SIZE)


def _difference(step):
    return render(Scene(), SIZE, SIZE, central(step), stage=_exact().stage)


@measures("crease_contrast", false={"one order, as the seed says": {"orders": 1}})
def contrast(orders: float = 4) -> Measurement:
    """Measure the mean error at the kink flag against that elsewhere on A, at ε = 10⁻³, in orders of magnitude."""
    kink, delta = _exact().kink[_exact().stage.on_a], np.abs(difference_on_a(_difference(1e-3), _exact()))

    def apart(delta):
        return np.log10(delta[kink].mean() / delta[~kink].mean())

    on, off = crease_contrast(_difference(1e-3), _exact())
    return Measurement(
        delta,
        of=apart,
        claimed=orders,
        bound=0.5,
        quantity="orders of magnitude between the mean error at the kink flag and elsewhere, 256², ε = 1e-3",
        numbers={"on": on, "off": off, "orders": apart(delta)},
    )


@measures("dark_difference", false={"at 1e-12 it is dark too": {"steps": (1e-8, 1e-12)}})
def dark(steps: Sequence[float] = (1e-8, 1e-9, 1e-10)) -> Measurement:
    """Measure the largest |ΔI| × 100 on A: it stays below half a level of 255."""
    differences = 100 * np.abs([difference_on_a(_difference(step), _exact()) for step in steps])
    return Measurement(
        differences,
        bound=FIRST_LEVEL,
        quantity="the largest |ΔI| × 100 on A, 256², linear light",
        numbers={f"at_{step:g}": value for step, value in zip(steps, differences.max(axis=(1, 2)), strict=True)},
    )
