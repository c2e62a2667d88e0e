"""On a smooth surface Oren and Nayar's light is Lambert's."""

from sympy import Pow

from proofs.engine.claim import Claim, equation
from proofs.engine.theorem import Mutant, Step, Theorem
from proofs.formulas.shading import light_direction, light_distance, oren_nayar
from proofs.formulas.symbols import bumped, dot, mu, view

_smooth = Claim("smooth", (equation(mu, light_direction[mu]),), (light_distance > 0,), oren_nayar(0))

theorem = Theorem(
    id="smooth_is_lambert",
    title="A smooth surface is Lambert's",
    statement=r"At $\sigma = 0$, Oren and Nayar's $\mu$ is $N'\cdot\omega$.",
    hypotheses=(r"$L \ne P$",),
    claims=(_smooth,),
    steps=(Step("$A = 1$ and $B = 0$", r"$\sigma = 0$"),),
    mutants=(
        Mutant("σ = 1/2", _smooth.but(lines=oren_nayar(Pow(2, -1)))),
        Mutant("N' towards the eye", _smooth.but(shows=(equation(mu, dot(bumped, view)),))),
    ),
)
