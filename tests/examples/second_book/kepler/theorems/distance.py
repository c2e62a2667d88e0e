"""The planet's distance from the sun, which is a focus of the ellipse."""

from kepler.ellipse import E, a, distance, e, planet, sun
from kepler.theorems.language import Claim, Theorem, equation, variant
from sympy import sin

(x, y), (focus, _) = planet, sun
bound_orbit = (a > 0, e >= 0, e < 1)
claim = Claim("distance", equation((x - focus) ** 2 + y**2, distance**2), bound_orbit)

distance_from_focus = Theorem(
    "distance_from_focus",
    title="Distance from the focus",
    statement=r"The planet at $(a\cos E, b\sin E)$, $b = a\sqrt{1 - e^2}$, is $a(1 - e\cos E)$ from the sun $(ae, 0)$.",
    claims=claim,
    steps={"Square and add.": r"$\cos^2 E + \sin^2 E = 1$"},
    mutants=(
        variant("from the other focus", claim, equation((x + focus) ** 2 + y**2, distance**2)),
        variant("not squeezed", claim, equation((x - focus) ** 2 + (a * sin(E)) ** 2, distance**2)),
    ),
)
