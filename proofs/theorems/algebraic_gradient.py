"""The algebraic gradient is the trigonometric one: powers of (cos + i sin) by induction on the power."""

from proofs.formulas.algebraic_form import base_of_u, base_of_v, complex_product, complex_square
from proofs.formulas.height_fields import cos_u, cos_v, factors, sin_u, sin_v
from proofs.theorems.frame import angles, place
from proofs.theorems.language import *

n, sign, alpha, gamma = real("n sign alpha gamma")
_number, _other, _product = complex_product.inputs[:2], complex_product.inputs[2:], complex_product.outputs
real_part, imaginary_part = _number


def _powers(base):
    """Return the states of baseⁿ, by repeated `complex_product`."""
    following = complex_product.at({_other: [b.xreplace(angles) for b in base]}).expand(_product)
    return tuple(zip(_number, (1, 0), following, strict=True))


def _factors(field, wave_numbers):
    """Return a field's trigonometric factors in the angles θ, φ of the chart, for given wave numbers."""
    return {name: factor.subs(wave_numbers).subs(place) for name, factor in factors(field).definitions}


_plain = Induction("power", n, equations(_number, (cos(n * alpha), sin(n * alpha))), _powers((cos(alpha), sin(alpha))))
_backwards = Induction(
    "negative_power", n, equations(_number, (cos(-n * alpha), sin(-n * alpha))), _powers((cos(alpha), -sin(alpha)))
)
_sine = _factors(sine, {k_u: 2 * n, k_v: n})
_in_u = Induction(
    "in_u",
    n,
    (
        equations(_number, (_sine[cos_u], _sine[sin_u])),
        equations(_number, (sign * cos(n * theta), sign * sin(n * theta))),
        equation(sign, cos(n * pi)),
        zero(sin(n * pi)),
    ),
    (*_powers(base_of_u), (sign, 1, -sign)),
)
_in_v = Induction("in_v", n, equations(_number, (_sine[cos_v], _sine[sin_v])), _powers(base_of_v))
_rings = _factors(rings, {k_v: n / 2})
_rings_in_v = _in_v.but(name="rings_in_v", shows=equations(_number, (_rings[cos_v], _rings[sin_v])))


def _on_circle(program, turned, total):
    at = {program.inputs: [f(a) for a in turned for f in (cos, sin)]}
    return equations(_product, (cos(total), sin(total))), (), program.at(at)


_square = Claim("square", *_on_circle(complex_square, (alpha,), 2 * alpha))
_times = Claim("product", *_on_circle(complex_product, (alpha, gamma), alpha + gamma))
_reciprocal = Claim(
    "reciprocal",
    equations(_product, (1, 0)),
    equation(real_part**2 + imaginary_part**2, 1),
    complex_product.at({_other: (real_part, -imaginary_part)}),
)

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
        variant("k_u odd", _in_u, equation(real_part, _factors(sine, {k_u: 2 * n + 1, k_v: n})[cos_u])),
        variant("rings with k_v", _rings_in_v, equation(real_part, _factors(rings, {k_v: n})[cos_v])),
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
