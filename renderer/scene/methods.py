"""Methods for the gradient of the height field: exact, or a finite difference of step ε.

    difference  order  heights  at the seam, u = 0   at the poles, v = 0 and 1
    forward     1      3        u + ε wraps around   backward in v where v + ε > 1
    central     2      4        u ± ε wrap around    v ± ε clamped to [0, 1], over the clamped span: order 1 in v
    central4    4      8        u ± 2ε wrap around   central in v where v ± 2ε leaves [0, 1]

`heights` counts evaluations of h, of which a field that does not depend on u saves those in u. The order is that of the
error in ε where h is smooth within reach of the step, until rounding, of order 2⁻⁵³/ε, outweighs it.

>>> import math
>>> from renderer import Scene, central, central4, exact, forward, gradient_at
>>> scene, at = Scene(field="sine"), (0.03, 0.2)
>>> for method in (forward, central, central4):
...     slopes = [gradient_at(scene, *at, each)[0] for each in (exact(), method(1e-2), method(1e-3))]
...     print(method.__name__, round(math.log10(abs(slopes[1] - slopes[0]) / abs(slopes[2] - slopes[0]))))
forward 1
central 2
central4 4
"""

import warnings
from dataclasses import dataclass

from renderer.checks import check_choice, check_kind, check_number, not_allowed
from renderer.kernels import HEIGHT_EVALUATIONS

DIFFERENCES = tuple(HEIGHT_EVALUATIONS)
METHODS = ("exact", *DIFFERENCES)
FORMS = ("auto", "general", "algebraic")
DECADES = (1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6)  # steps of a table
SMALLEST_STEP = 1e-40  # a jump of h over a smaller step, times the largest β, squared, would overflow


@dataclass(frozen=True)
class GradientMethod:
    """A way to take the gradient: its name; for a difference the step ε in [1e-40, 1/2]; for `exact` alone the form.

    Make one with `exact`, `central`, `forward` or `central4`. Raises ValueError on anything else.
    """

    name: str
    eps: float | None = None
    form: str = "auto"

    def __post_init__(self):
        check_choice("gradient", self.name, METHODS)
        check_choice("form", self.form, FORMS)
        if self.name == "exact":
            if self.eps is not None:
                raise not_allowed("eps", self.eps, "none beside the exact gradient, which takes no step")
        else:
            check_choice("form", self.form, ("auto",))  # the others are the exact gradient's
            object.__setattr__(self, "eps", check_number("eps", self.eps, SMALLEST_STEP, 0.5))


def checked_method(name: str, method: GradientMethod) -> GradientMethod:
    """Return `method`, or raise ValueError, which calls it `name`, unless it is a GradientMethod."""
    return check_kind(name, method, GradientMethod, "exact(), central(eps), forward(eps) or central4(eps), no name")


def difference(name: str, eps: float) -> GradientMethod:
    """Return a difference by its name, for a sweep: without a warning. Raises ValueError on the exact gradient."""
    return GradientMethod(check_choice("gradient", name, DIFFERENCES), eps)


def warned(method: GradientMethod) -> GradientMethod:
    """Return `method`, after a warning where half the chart cannot tell its step from none."""
    if (method.eps or 1) < 2.0**-53:
        told = f"eps = {method.eps:g} is below 2^-53, the spacing of float64 in [1/2, 1)"
        warnings.warn(f"{told}: there u + eps is u or u + 2^-53, and a slope is 0 or wrong", stacklevel=3)
    return method


def exact(form: str = "auto") -> GradientMethod:
    """Return the exact gradient. `auto` takes the algebraic form where it applies, and the general one elsewhere.

    >>> from renderer import Scene, exact, gradient_at
    >>> h_u, h_v = gradient_at(Scene(field="sine"), 0.0, 0.125, exact())
    >>> bool(abs(h_u - 8 * 3.141592653589793) < 1e-14), bool(abs(h_v) < 1e-14)
    (True, True)
    """
    return GradientMethod("exact", form=form)


def central(eps: float, representable: bool = False) -> GradientMethod:
    """Return the central difference of step eps: second order, 4 height evaluations.

    representable: with the nearest step that is a multiple of 2^-52. Unless a power of two lies between u and u ± eps,
    float64 holds u ± eps exactly then, and the error that is left at the best step is several times less.

    >>> from renderer import Scene, central, gradient_at
    >>> h_u, _ = gradient_at(Scene(field="ridges"), 0.0, 0.125, central(1e-3))  # across a crease
    >>> bool(abs(h_u) < 1e-12)
    True
    >>> central(0.001, representable=True).eps - 0.001
    -1.1015494072452725e-16
    """
    if check_kind("representable", representable, bool):
        eps = (1.0 + check_number("eps", eps, 2.0**-52, 0.5)) - 1.0
    return warned(GradientMethod("central", eps))


def forward(eps: float) -> GradientMethod:
    """Return the forward difference of step eps: first order, 3 height evaluations.

    >>> from renderer import Scene, forward, gradient_at
    >>> h_u, _ = gradient_at(Scene(field="ridges"), 0.0, 0.125, forward(1e-3))  # from a crease, to one side
    >>> round(float(h_u), 2)
    25.13
    """
    return warned(GradientMethod("forward", eps))


def central4(eps: float) -> GradientMethod:
    """Return the fourth-order central difference of step eps: 8 height evaluations.

    >>> from renderer import central4
    >>> central4(1e-3)
    GradientMethod(name='central4', eps=0.001, form='auto')
    >>> central4(0.7)
    Traceback (most recent call last):
    ValueError: eps = 0.7 is not allowed: a finite number from 1e-40 to 0.5
    """
    return warned(GradientMethod("central4", eps))
