"""The chapter's N' is not the displaced surface's normal: where they agree, and the angle between them (F18)."""

from sympy import Rational, expand, pi

from proofs.engine.claim import Claim, equation, greater
from proofs.engine.program import chain
from proofs.engine.theorem import Mutant, Step, Theorem, variant
from proofs.formulas.bump import bumped_normal, m
from proofs.formulas.displacement import displaced, displaced_normal, lift
from proofs.formulas.symbols import beta, cross, dot, h, h_u, h_v, normal, sin_phi
from proofs.theorems.displacement import raised
from proofs.theorems.frame import at_angle, on_circles
from proofs.theorems.relations import equations

_both = chain("both", displaced_normal, bumped_normal)
_metric = h_u**2 / (2 * pi * sin_phi) + h_v**2 / pi
_only_where_flat = Claim(
    "only_where_flat",
    (
        greater(1 / sin_phi, 0),
        greater(1 / pi, 0),
        greater(1 / pi / sin_phi, 0),
        greater(lift + 1 / (2 * pi * sin_phi), 0),
        greater(lift + 1 / pi, 0),
        equation(beta * h_u * (lift + 1 / (2 * pi * sin_phi)), 0),
        equation(beta * h_v * (lift + 1 / pi), 0),
        equation(beta * h_u, 0),
        equation(beta * h_v, 0),
    ),
    (*raised, *equations(cross(m, displaced), (0, 0, 0))),
    _both,
)
_where_flat = Claim(
    "where_flat", equations(displaced, lift * m), (sin_phi > 0, equation(beta * h_u, 0), equation(beta * h_v, 0)), _both
)
_angle = Claim(
    "angle",
    (
        equation(dot(m, displaced), lift - beta**2 * _metric),
        equation(dot(m, m), 1 + beta**2 * (h_u**2 + h_v**2)),
        equation(dot(displaced, displaced), lift**2 + beta**2 * ((h_u / (2 * pi * sin_phi)) ** 2 + (h_v / pi) ** 2)),
    ),
    (*on_circles, sin_phi > 0),
    _both,
)
_like_blinn = Claim(
    "like_blinn", (equation(dot(m, displaced), 1 + beta**2 * _metric),), (*on_circles, sin_phi > 0), _both
)

difference_theorem = Theorem(
    id="bump_is_not_displacement",
    title="The bumped normal is not the displaced surface's",
    statement=r"If $1+\beta h > 0$, $N' = M/|M|$ with $M = N+\beta g$ has the direction of the displaced surface's "
    r"normal $D$ exactly where $\beta g = 0$. The cosine of the angle between them is $\bigl(1+\beta "
    r"h-\beta^2(h_u^2/2\pi\sin\varphi + h_v^2/\pi)\bigr)/|M||D|$, $|M|^2 = 1+\beta^2(h_u^2+h_v^2)$, $|D|^2 = (1+\beta "
    r"h)^2+\beta^2(h_u^2/4\pi^2\sin^2\varphi + h_v^2/\pi^2)$.",
    hypotheses=(r"$\sin\varphi > 0$", r"$1+\beta h > 0$"),
    claims=(_only_where_flat, _where_flat, _angle),
    steps=(
        Step(
            r"$M\times D = 0$ gives $\beta h_u(1+\beta h+1/2\pi\sin\varphi) = 0 = \beta h_v(1+\beta h+1/\pi)$",
            "the frame's components",
        ),
        Step(r"so $\beta h_u = \beta h_v = 0$", "both factors are positive"),
        Step(r"$\beta g = 0$: $D = (1+\beta h)M$", "$D$ is the displaced surface's normal", ("displaced_normal",)),
        Step("the scalar products", "the frame is orthonormal"),
    ),
    mutants=(
        variant(
            "parallel only if h_u = h_v = 0, whatever β",
            _only_where_flat,
            equation(h_u, 0),
            at=(*at_angle(0, 1), (beta, 0), (h, 0), (h_u, 1), (h_v, 1)),
        ),
        Mutant("the opposite sign, as Blinn's", _like_blinn),
        variant(
            "without the metric",
            _angle,
            equation(dot(m, displaced), lift - beta**2 * (h_u**2 / (2 * pi) + h_v**2 / pi)),
        ),
    ),
)

_sides = [_both.expand(names) for names in (normal, m, displaced)]
_parallel = Claim(
    "parallel", (equation(expand(pi * dot(_sides[0], cross(*_sides[1:]))), 0),), (*on_circles, sin_phi > 0)
)

seed_theorem = Theorem(
    id="seed_bump_as_displacement",
    title="The bumped normal as the displaced surface's",
    statement=r"$N'$ is the normal of the displaced surface; in particular $\pi N\cdot(M\times D) = 0$.",
    claims=(_parallel,),
    refuted_at=(*at_angle(Rational(3, 5), Rational(4, 5)), (beta, 1), (h, 0), (h_u, 1), (h_v, 1)),
    steps=(
        Step(
            r"$\pi N\cdot(M\times D) = \pm\beta^2h_uh_v(1-1/2\sin\varphi) \ne 0$",
            r"$\beta = h_u = h_v = 1$, $\sin\varphi = 4/5$: the metric and the chart's scale turn the gradient",
        ),
    ),
    mutants=(
        variant("true where β = 0", _parallel, given=(*_parallel.given, equation(beta, 0))),
        variant(
            "on the same line (not the same way) where h_u = 0", _parallel, given=(*_parallel.given, equation(h_u, 0))
        ),
    ),
)
