"""How far what kernels compute can be off: what theorems say of it, and bounds are made of."""

from sympy import Rational

SINE = Rational(33, 10)
"""A sine and a cosine of half-turns, in units of 2⁻⁵³: theorem elementary_functions, as all that follows."""
POWER, POWER_RATE = Rational(5, 2), Rational(3, 100)
"""A power, of itself, in the same units: the first, and the second times |p ln x|."""
SMALL_POWER = Rational(1, 2**57)
"""A power of exp(−40) or more is a `power`; what is below this, a little above exp(−40), may be a `small_power`."""

ROUNDINGS = {
    "sinpi": Rational(5),
    "cospi": Rational(5),
    "atan2pi": Rational(5),
    "exp": Rational(11, 5),
    "log": Rational(26, 25),
    "power": POWER + POWER_RATE * 40,
    "small_power": POWER + POWER_RATE * 709,
}
"""{function: how far its float64 value can be off, of itself, in units of 2⁻⁵³}"""

GENERAL_GRADIENT, ALGEBRAIC_GRADIENT = 10, 50
"""How far a slope can be off, in units of 2⁻⁵³ π max(1, |k|) and of 2⁻⁵³ π (1 + k) k: theorems gradient_accuracy (which
is measured) and algebraic_gradient_accuracy."""

NORMAL, COSINE, BLINN, SQUARED, PHONG, SHARE = 12, 45, 32, 80, 56, 8
"""How far a component of N', a light's cosine, the base of Blinn's highlight, its square, the base of Phong's and a
channel can be off, in units of 2⁻⁵³: theorem colour_accuracy."""
