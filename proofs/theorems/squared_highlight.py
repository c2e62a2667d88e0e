"""The cheap highlight: Blinn–Phong's cosine and the square of its base from one root and one division."""

from proofs.engine.claim import Claim, equation
from proofs.engine.program import chain
from proofs.engine.theorem import Step, Theorem, variant
from proofs.formulas.pixel import instance
from proofs.formulas.shading import (
    along_halfway,
    blinn,
    blinn_squared,
    halfway,
    halfway_squared,
    light_distance,
    light_scale,
)
from proofs.formulas.symbols import Vector, mu, real, specular_base
from proofs.theorems.relations import equations

_plain = instance(blinn, "plain")
_both = chain("both", blinn_squared, _plain)
_mu, _base, _length = real("mu_plain specular_base_plain halfway_length_plain")
_plain_halfway = Vector(real(f"{s.name}_plain") for s in halfway)
_k = Claim("halfway", equations(halfway, light_distance * _plain_halfway), (light_distance > 0,), _both)
_cosine = Claim("cosine", (equation(mu, _mu),), (halfway_squared > 0,), _both)
_base_squared = Claim(
    "base",
    (equation(blinn_squared[specular_base], _base**2),),
    (
        equation(light_scale * light_distance * halfway_squared, 1),
        equation(light_distance**2 * _length**2, halfway_squared),
        equation(light_distance * _length * _base, along_halfway),
    ),
)

theorem = Theorem(
    id="squared_highlight",
    title="The highlight from one root and one division",
    statement=r"With $d = L - P$, $k = d + |d|\hat v$ and $s = 1/(|d|\,k\cdot k)$: $\mu = (N'\cdot d)(k\cdot k)s$, and "
    r"the square of Blinn's base is $(N'\cdot k)^2 |d| s$ where $N'\cdot k \ge 0$.",
    hypotheses=(
        "$L \\ne P$",
        r"$\omega \ne -\hat v$",
        r"with $H = \omega + \hat v$ and Blinn's base $b$: $|d|^2|H|^2 = k\cdot k$ and $|d||H|\,b = N'\cdot k$, "
        r"taken from $k = |d|H$ by hand",
    ),
    claims=(_k, _cosine, _base_squared),
    steps=(
        Step(r"$k = |d|(\omega + \hat v)$", "so its direction is the halfway vector's"),
        Step(r"$(N'\cdot k)^2/(k\cdot k)$ does not depend on the length of $k$", "nor does its sign, as $|d| > 0$"),
    ),
    mutants=(
        variant("k without |d|", _k, equation(halfway[0], _plain_halfway[0])),
        variant("the base, not its square", _base_squared, equation(blinn_squared[specular_base], _base)),
        variant("k twice as long", _k, equation(halfway[0], 2 * light_distance * _plain_halfway[0])),
    ),
)
