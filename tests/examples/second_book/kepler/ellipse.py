"""Kepler's ellipse: the planet by its eccentric anomaly E, and how far it is from the sun."""

from sympy import cos, sin, sqrt

from proofs.engine.vectors import real

a, e, E = real("a e E")
b = a * sqrt(1 - e**2)
planet = (a * cos(E), b * sin(E))
sun = (a * e, 0)
distance = a * (1 - e * cos(E))
