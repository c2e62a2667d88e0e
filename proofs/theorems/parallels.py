"""How many parallels on which a field is creased are seen."""

from sympy import Rational, cos, pi, sin

from proofs.engine.claim import Claim, equation, greater
from proofs.engine.theorem import Mutant, Step, Theorem
from proofs.formulas.camera import parallel_radius
from proofs.formulas.symbols import cos_phi, eye, lengths_of_a, radius, real, rho, sin_phi
from proofs.theorems.kink_loci import theorem as kink_loci

a, b = real("a b")
_falling = Claim(
    "falling",
    (equation(cos(a) - cos(b), 2 * sin((a + b) / 2) * sin((b - a) / 2)), greater(cos(a), cos(b))),
    (sin((a + b) / 2) > 0, sin((b - a) / 2) > 0),
)
_default = kink_loci.claim("count")
_poles = Claim(
    "pole",
    (equation(rho, 0),),
    (equation(sin_phi, 0), equation(cos_phi, 1), *lengths_of_a, eye > radius),
    parallel_radius,
)

theorem = Theorem(
    id="visible_parallels",
    title="How many creased parallels are seen",
    section="s3",
    statement=r"The parallel $v = m/k_v$ is seen, where no other body hides it, exactly if $\cos(\pi "
    r"m/k_v) \ge R/e$ (on the rim if equal). "
    r"The cosine falls from $m = 0$ to $m = k_v$, so the first ones are seen, up to some $m$; $m = 0$ is "
    r"the pole, a point. In the "
    r"default scene, $k_v = 4$ and $R/e = \frac14$, it is one circle: $\cos\frac\pi4 > \frac14 > "
    r"\cos\frac\pi2 > \cos\frac{3\pi}4$.",
    hypotheses=(r"$0 \le m \le k_v$", "$e > R > 0$"),
    claims=(_falling, _default, _poles),
    uses=("kink_loci", "visible_iff"),
    steps=(
        Step(r"the parallel $\varphi = \pi m/k_v$ is a circle", r"$v = \varphi/\pi$", ("kink_loci",)),
        Step(r"it is seen where $\cos\varphi \ge R/e$", "the near hit", ("visible_iff",)),
        Step(r"$\cos a-\cos b = 2\sin\frac{a+b}2\sin\frac{b-a}2 > 0$", r"$0 \le a < b \le \pi$: sines are positive"),
        Step(r"$\frac{\sqrt2}2 > \frac14 > 0 > -\frac{\sqrt2}2$", "the exact values"),
    ),
    mutants=(
        Mutant("two circles", _default.but(shows=(greater(cos(pi / 2), Rational(1, 4)),))),
        Mutant("the cosine rises", _falling.but(shows=(greater(cos(b), cos(a)),))),
        Mutant("the pole has a circle", _poles.but(shows=(greater(rho, 0),))),
    ),
)
