"""The algebraic gradient is the trigonometric one: powers of (cos + i sin) by induction on the power."""

from proofs.formulas.algebraic_form import (
    base_of_u,
    base_of_v,
    complex_product,
    complex_square,
    imaginary_part,
    other_imaginary,
    other_real,
    product_imaginary,
    product_real,
    real_part,
)
from proofs.formulas.height_fields import HEIGHT_FIELDS, cos_u, cos_v, factors, sin_u, sin_v
from proofs.theorems.frame import angles
from proofs.theorems.language import *

n, sign, alpha, gamma = real("n sign alpha gamma")
_chart = {u: (theta + pi) / (2 * pi), v: phi / pi}
_alternating = (sign, 1, -sign)


def _product(parts, others):
    """Return the lines of `complex_product` for two complex numbers."""
    given = dict(zip(complex_product.inputs, (*parts, *others), strict=True))
    return [complex_product[p].xreplace(given) for p in (product_real, product_imaginary)]


def _powers(base):
    """Return the states of baseⁿ, by repeated `complex_product`."""
    base = [b.xreplace(angles) for b in base]
    following = _product((real_part, imaginary_part), base)
    return tuple(zip((real_part, imaginary_part), (1, 0), following, strict=True))


def _factors(field, wave_numbers):
    """Return a field's trigonometric factors in the angles θ, φ of the chart, for given wave numbers."""
    program = factors(HEIGHT_FIELDS[field])
    return {name: program[name].subs(wave_numbers).subs(_chart) for name in program.outputs}


_power = equation(real_part, cos(n * alpha)), equation(imaginary_part, sin(n * alpha))
_plain = Induction("power", n, _power, _powers((cos(alpha), sin(alpha))))
_backwards = Induction(
    "negative_power",
    n,
    (equation(real_part, cos(-n * alpha)), equation(imaginary_part, sin(-n * alpha))),
    _powers((cos(alpha), -sin(alpha))),
)
_sine = _factors("sine", {k_u: 2 * n, k_v: n})
_in_u = Induction(
    "in_u",
    n,
    (
        equation(real_part, _sine[cos_u]),
        equation(imaginary_part, _sine[sin_u]),
        equation(real_part, sign * cos(n * theta)),
        equation(imaginary_part, sign * sin(n * theta)),
        equation(sign, cos(n * pi)),
        equation(sin(n * pi), 0),
    ),
    (*_powers(base_of_u), _alternating),
)
_in_v = Induction(
    "in_v", n, (equation(real_part, _sine[cos_v]), equation(imaginary_part, _sine[sin_v])), _powers(base_of_v)
)
_rings = _factors("rings", {k_v: n / 2})
_rings_in_v = _in_v.but(
    name="rings_in_v", shows=(equation(real_part, _rings[cos_v]), equation(imaginary_part, _rings[sin_v]))
)


def _on_circle(program, turned, total):
    parts = (f(a) for a in turned for f in (cos, sin))
    given = dict(zip(program.inputs, parts, strict=True))
    return equations(_parts, (cos(total), sin(total))), (), program.at(given)


_parts = product_real, product_imaginary
_square = Claim("square", *_on_circle(complex_square, (alpha,), 2 * alpha))
_times = Claim("product", *_on_circle(complex_product, (alpha, gamma), alpha + gamma))
_reciprocal = Claim(
    "reciprocal",
    equations(_parts, (1, 0)),
    equation(real_part**2 + imaginary_part**2, 1),
    complex_product.at({other_real: real_part, other_imaginary: -imaginary_part}),
)
_half = _factors("sine", {k_u: 2 * n + 1, k_v: n})

theorem = Theorem(
    "algebraic_gradient",
    "The algebraic gradient is the trigonometric one",
    r"""For every whole $n \ge 0$, with $\pi u = (\theta+\pi)/2$ and $\pi v = \varphi$: $(-\cos\theta -
    i\sin\theta)^n = (-1)^n(\cos n\theta + i\sin n\theta)$ has the parts $\cos\pi k_u u$, $\sin\pi k_u u$ for $k_u
    = 2n$; and $(\cos\varphi+i\sin\varphi)^n$ has $\cos\pi k_v v$, $\sin\pi k_v v$ for $k_v = n$, and rings'
    factors for $2k_v = n$. A negative wave number conjugates; $n = 0$ gives $1$ and $0$.""",
    hypotheses="$k_u$ even, $k_v$ whole (rings: $2k_v$ whole)",
    claims=(_plain, _backwards, _in_u, _in_v, _rings_in_v, _square, _times, _reciprocal),
    steps={
        r"$(c+is)^0 = 1$; $(c+is)^{n+1} = (c+is)^n(c+is)$": "induction, by the lines of complex_product",
        r"$\cos(n\theta+n\pi) = (-1)^n\cos n\theta$": "the sign is carried along",
        r"$\cos(-n\alpha) = \cos n\alpha$, $\sin(-n\alpha) = -\sin n\alpha$": "the powers of $c-is$",
        "$(c+is)(c-is) = c^2+s^2 = 1$": "so the conjugate's powers are those with a negative exponent",
        "squaring doubles the angle, a product adds the angles": "so any order of squarings and products does",
    },
    mutants=(
        variant("without the sign", _in_u, equation(real_part, cos(n * theta))),
        variant("k_u odd", _in_u, equation(real_part, _half[cos_u])),
        variant("rings with k_v", _rings_in_v, equation(real_part, _factors("rings", {k_v: n})[cos_v])),
        variant("a negative power does not conjugate", _backwards, states=_plain.states),
        variant("squaring keeps the angle", _square, _on_circle(complex_square, (alpha,), alpha)[0]),
    ),
    side_conditions=SideCondition(
        "the conjugate is the reciprocal on the unit circle, and not off it",
        "reciprocal",
        holds={real_part: "3/5", imaginary_part: "4/5"},
        fails=({real_part: "3/5", imaginary_part: 1}, {real_part: 0, imaginary_part: 0}),
    ),
)
