"""The certified errors of our elementary functions: what theorem elementary_functions says, and bounds are made of."""

from fractions import Fraction

CERTIFIED = {
    name: Fraction(units)
    for name, units in {
        "sinpi": "1.53",
        "cospi": "1.53",
        "sinpi_of_product": "2.52",
        "cospi_of_product": "2.52",
        "atan2pi": "2.50",
        "exp": "1.00",
        "log": "0.52",
        "power": "1.50",
        "small_power": "11.03",
    }.items()
}
"""{function: how far its float64 value can be off, in units in the last place}"""

SMALL_POWER = Fraction(1, 2**72)
"""A power of exp(−50) or more is a `power`; what is below this, a little above exp(−50), may be a `small_power`."""

GENERAL_GRADIENT, ALGEBRAIC_GRADIENT = 10, 50
"""How far a slope can be off, in units of 2⁻⁵³ π max(1, |k|) and of 2⁻⁵³ π (1 + k) k: theorems gradient_accuracy (which
is measured) and algebraic_gradient_accuracy."""

NORMAL, COSINE, BLINN, SQUARED, PHONG, SHARE = 12, 45, 32, 80, 56, 8
"""How far a component of N', a light's cosine, the base of Blinn's highlight, its square, the base of Phong's and a
channel can be off, in units of 2⁻⁵³: theorem colour_accuracy."""
