"""The orbit, drawn from the formulas that the theorem is about."""

import numpy as np
from kepler.ellipse import E, a, distance, e, planet
from sympy import lambdify

from book.drawing.registry import Drawing, figure
from book.drawing.style import plot


@figure
def orbit() -> Drawing:
    """An orbit of eccentricity 0.6, in half axes."""
    x, y, r = lambdify((a, e, E), (*planet, distance))(1, 0.6, np.linspace(0, 2 * np.pi, 201))
    fig, ax = plot(height=3)
    ax.plot(x, y)
    ax.plot(0.6, 0, "o")
    ax.set_aspect("equal")
    return Drawing(fig, numbers={"e": 0.6, "nearest": r.min()}, data={"x": x, "y": y})
