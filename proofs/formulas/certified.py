"""Error bounds of the kernels, as theorems state them and as the enclosing machine charges them."""

from fractions import Fraction

SINE = Fraction("2.42")
"""A sine and a cosine of half-turns of a product, in units of 2⁻⁵³: theorem sine_of_half_turns."""

PROVED = {
    "of_product_relative": Fraction(19, 4),
    "atan2pi": Fraction(5, 2),
    "exp": Fraction(11, 5),
    "log": Fraction(41, 40),
    "power": Fraction(5, 2),
}
POWER_RATE = Fraction(3, 100)
"""{a function of theorem elementary_functions: the bound of its error}, in the same units, all but atan2pi's relative;
a power xᵖ by POWER_RATE |p ln x| more."""

ROUNDINGS = {
    "sinpi": Fraction("5.04"),
    "cospi": Fraction("5.04"),
    "atan2pi": Fraction(5),
    "exp": Fraction(2),
    "log": Fraction("1.04"),
    "power": Fraction(3),
    "small_power": Fraction("22.06"),
}
"""{function: the relative error that the enclosing machine charges}, in the same units: more than that PROVED,
or than half of it where a function rises or falls: that is charged twice. Theorem enclosing_rules."""

SMALL_POWER = Fraction(1, 2**72)
"""A power of exp(−50) or more is a `power`; what is below this, a little above exp(−50), may be a `small_power`."""

GENERAL_GRADIENT, ALGEBRAIC_GRADIENT = 10, 50
"""Bounds of the error of a slope, in units of 2⁻⁵³ π max(1, |k|) and of 2⁻⁵³ π (1 + k) k: theorems gradient_accuracy
and algebraic_gradient_accuracy."""

NORMAL, COSINE, BLINN, SQUARED, PHONG, SHARE = 12, 45, 32, 80, 56, 8
"""Bounds of the errors of a component of N', a light's cosine, the base of Blinn's highlight, its square, the base of
Phong's and a channel, in units of 2⁻⁵³: theorem colour_accuracy."""
