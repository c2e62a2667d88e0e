"""The error of powers of cos t + i sin t by rounded squarings and products, and of a gradient made of them."""

from proofs.formulas.algebraic_form import complex_product, complex_square
from proofs.formulas.step_bounds import excess, unit
from proofs.theorems.language import *

first, second, third, fourth, growth = real("first second third fourth growth")
off_first, off_second, off, own, most, most_other = real("off_first off_second off own most most_other")
size, other_size, exact, other_exact, value, other_value = real("size other_size exact other_exact value other_value")
real_part, imaginary_part, other_real, other_imaginary = complex_product.inputs
_squared, _multiplied = (program.expand(program.outputs) for program in (complex_square, complex_product))
_modulus = real_part**2 + imaginary_part**2
_moduli = _modulus * (other_real**2 + other_imaginary**2)
_terms = _real_1, _real_2, _imaginary_1, _imaginary_2 = (
    real_part * other_real,
    imaginary_part * other_imaginary,
    real_part * other_imaginary,
    imaginary_part * other_real,
)
_kappa = equation(excess, (1 + unit) ** 3 - 1)
_unit = (unit >= 0, unit <= QUARTER)
_small = {(unit, first, second, third, fourth, excess): ("-1/8", "1/8")}

_three = Claim(
    "three_roundings_of_one",
    (
        nonnegative((1 + unit) ** 2 - (1 + first) * (1 + second), (1 + first) * (1 + second) - (1 - unit) ** 2),
        both_ways((1 + unit) ** 3 - 1, growth - 1),
    ),
    (_unit, both_ways(unit, first, second, third), equation(growth, (1 + first) * (1 + second) * (1 + third))),
    ranges=_small,
)
_square = Claim(
    "square",
    (
        equation(_squared[0] ** 2 + _squared[1] ** 2, _modulus**2),
        nonnegative(excess**2 - first**2, excess**2 - second**2),
        excess**2 * _modulus**2 >= off_first**2 + off_second**2,
    ),
    (equations((off_first, off_second), (first * _squared[0], second * _squared[1])), both_ways(excess, first, second)),
    squares=_squared,
)
_twice = 2 * unit + unit**2
_product = Claim(
    "product",
    (
        equation(_multiplied[0] ** 2 + _multiplied[1] ** 2, _moduli),
        nonnegative(*(_twice**2 - d**2 for d in (first, second, third, fourth))),
        2 * _twice**2 * (_real_1**2 + _real_2**2) >= off_first**2,
        2 * _twice**2 * (_imaginary_1**2 + _imaginary_2**2) >= off_second**2,
        excess**2 >= 2 * _twice**2,
        excess**2 * _moduli >= off_first**2 + off_second**2,
    ),
    (
        unit >= 0,
        _kappa,
        equation(off_first, first * _real_1 - second * _real_2),
        equation(off_second, third * _imaginary_1 + fourth * _imaginary_2),
        both_ways(_twice, first, second, third, fourth),
    ),
    squares=(first * _real_1 + second * _real_2, third * _imaginary_1 - fourth * _imaginary_2, _terms),
    ranges=_small,
)
_power = Claim(
    "power",
    (
        most >= size,
        most_other >= other_size,
        most * most_other >= size * other_size,
        excess * most * most_other >= own,
        (most - 1) * most_other >= off_first * other_size,
        (1 + excess) * most * most_other - 1 >= off,
    ),
    (
        nonnegative(excess, size, other_size, off_first, off_second),
        most - 1 >= off_first,
        most_other - 1 >= off_second,
        1 + off_first >= size,
        1 + off_second >= other_size,
        excess * size * other_size >= own,
        own + off_first * other_size + off_second >= off,
    ),
    ranges={
        (excess, size, other_size, off_first, off_second): ("1/4", 1),
        (own, off): (0, "1/8"),
        (most, most_other): (2, 3),
    },
)
_factors = Claim(
    "factors",
    (
        both_ways(most_other, other_value),
        both_ways((most - 1) * most_other, (value - exact) * other_value),
        both_ways(most_other - 1, exact * (other_value - other_exact)),
        both_ways(most * most_other - 1, value * other_value - exact * other_exact),
    ),
    (
        both_ways(1, exact, other_exact),
        both_ways(most - 1, value - exact),
        both_ways(most_other - 1, other_value - other_exact),
    ),
    ranges={(exact, other_exact, value, other_value): (-1, 1), (most, most_other): (1, 2)},
)

theorem = Theorem(
    "rounded_powers",
    "What a power by repeated squaring loses",
    {
        r"""In the standard model, with unit roundoff $\mu$ and $\kappa = (1+\mu)^3-1$, a rounded square or
        product of complex numbers is off by at most $\kappa$ of its size.""": (_three, _square, _product),
        r"""Where $\hat a$, $\hat b$ are within $A-1$, $B-1$ of $a$, $b$ of size 1, their rounded product is
        within $(1+\kappa)AB-1$ of $ab$.""": _power,
        r"""So squarings and products, in any order, each off by at most $\kappa$ of its size, take a number
        within $\delta$ of $\cos t + i\sin t$ to one within $(1+\delta)^n(1+\kappa)^{n-1}-1$ of $\cos nt +
        i\sin nt$.""": (coq("rounded_powers__error 65877edd2496cbcc")),
        r"Factors of size at most 1 that are within $A-1$ and $B-1$ have a product within $AB-1$.": _factors,
    },
    hypotheses=(
        r"$\mathrm{fl}(a \circ b) = (a \circ b)(1+d)$, $|d| \le \mu \le \tfrac14$; nothing underflows",
        "assumed in the second sentence: the triangle's inequality, and that sizes multiply",
    ),
    steps={
        r"$|\hat a\hat b - ab| \le |\hat a - a||\hat b| + |\hat b - b| \le (A-1)B + B-1$": (
            r"$|a| = 1$, $|\hat b| \le B$"
        ),
        r"$\kappa|\hat a||\hat b| \le \kappa AB$, so $(1+\kappa)AB-1$ in all": "the product's own rounding, added",
        r"$A_n = (1+\delta)^n(1+\kappa)^{n-1}$ has $(1+\kappa)A_mA_n = A_{m+n}$": "induction over the products",
    },
    mutants=(
        variant(
            "a product costs one rounding",
            _product,
            unit**2 * _moduli >= off_first**2 + off_second**2,
            at={
                (real_part, other_real): 1,
                (imaginary_part, other_imaginary, second, third, fourth, off_second): 0,
                (first, off_first): "17/64",
                unit: "1/8",
                excess: "217/512",
            },
        ),
        variant(
            "errors add without a second order",
            _power,
            excess + most + most_other - 2 >= off,
            at={(excess, off_first, off_second): 1, (size, other_size, most, most_other): 2, own: 4, off: 7},
        ),
        variant("the larger error alone", _factors, both_ways(most - 1, value * other_value - exact * other_exact)),
    ),
)
