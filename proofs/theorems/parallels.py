"""How many parallels on which a field is creased are seen."""

from sympy import Rational, cos, pi, sin

from proofs.engine.claim import Claim, equation, greater
from proofs.engine.theorem import Clause, Step, Theorem, variant
from proofs.formulas.camera import parallel_radius
from proofs.formulas.symbols import cos_phi, eye, radius, real, rho, sin_phi
from proofs.theorems.cited import sine_inside_half_turn

a, b = real("a b")
_halves = (a + b) / 2, (b - a) / 2
_near, _far = cos(pi * a), cos(pi * b)
_falling = Claim(
    "falling",
    (equation(_near - _far, 2 * sin(pi * _halves[0]) * sin(pi * _halves[1])), greater(_near, _far)),
    (a >= 0, b - a > 0, 1 - b >= 0),
    cited=tuple(map(sine_inside_half_turn, _halves)),
)
_nearer = Claim("nearer", (greater(eye * _near, radius),), (eye > 0, _near > _far, eye * _far >= radius))
_default = Claim(
    "count",
    tuple(
        greater(one, other)
        for one, other in (
            (cos(pi / 4), Rational(1, 4)),
            (Rational(1, 4), cos(pi / 2)),
            (cos(pi / 2), cos(3 * pi / 4)),
            (cos(3 * pi / 4), cos(pi)),
        )
    ),
)
_poles = Claim("pole", (equation(rho, 0),), (equation(sin_phi, 0), equation(cos_phi, 1), eye > radius), parallel_radius)

theorem = Theorem(
    id="visible_parallels",
    title="How many creased parallels are seen",
    statement=(
        Clause(r"From pole to pole the cosine falls: $\cos\pi a > \cos\pi b$ for $0 \le a < b \le 1$.", (_falling,)),
        Clause(
            r"So if the parallel $v = b$ is seen, $\cos\pi b \ge R/e$, so is each nearer the pole: of "
            "$v = m/k_v$ the first ones, up to some $m$.",
            (_nearer,),
        ),
        Clause("$m = 0$ is the pole, a point.", (_poles,)),
        Clause(
            r"In the default scene, $k_v = 4$ and $R/e = \frac14$, one circle is seen: "
            r"$\cos\frac\pi4 > \frac14 > \cos\frac\pi2 > \cos\frac{3\pi}4 > \cos\pi$.",
            (_default,),
        ),
    ),
    hypotheses=(
        "$e > R > 0$",
        r"a parallel is seen, where no other body hides it, exactly if $\cos\varphi \ge R/e$ (on the rim if equal)",
        r"$\sin\pi x > 0$ for $0 < x < 1$ (cited)",
    ),
    steps=(
        Step(r"the parallel $\varphi = \pi m/k_v$ is a circle", r"$v = \varphi/\pi$", ("kink_loci",)),
        Step(r"it is seen where $\cos\varphi \ge R/e$", "the near hit", ("visible_iff",)),
        Step(r"$\cos\pi a-\cos\pi b = 2\sin\pi\frac{a+b}2\sin\pi\frac{b-a}2 > 0$", "both sines are positive"),
        Step(r"$\frac{\sqrt2}2 > \frac14 > 0 > -\frac{\sqrt2}2 > -1$", "the exact values"),
    ),
    mutants=(
        variant("two circles", _default, greater(cos(pi / 2), Rational(1, 4))),
        variant("the cosine rises", _falling, greater(_far, _near)),
        variant("the pole has a circle", _poles, greater(rho, 0)),
    ),
)
