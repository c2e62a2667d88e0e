"""Across the seam u = 0: which fields are continuous there, and which are differentiable (F11)."""

from sympy import Rational, cos, expand, pi, sin

from proofs.engine.claim import Claim, Induction, equation, greater
from proofs.engine.theorem import Edge, Mutant, SideCondition, Step, Theorem
from proofs.formulas.half_turns import sinpi
from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.symbols import k_u, k_v, real, u, v

n, alternating = real("n alternating")
sine, ridges, rings = (HEIGHT_FIELDS[name] for name in ("sine", "ridges", "rings"))
_whole, _in_v = equation(sin(pi * k_u), 0), sinpi(k_v * v)
_turned = sine.expression.subs(u, u + 1)


def jump(expression):
    """Return the change of an expression in u across the seam: at u = 0 less at u = 1."""
    return expression.subs(u, 0) - expression.subs(u, 1)


_slope = sine.gradient()[0]
_parity = Induction(
    "parity",
    n,
    (equation(cos(pi * n), alternating), equation(sin(pi * n), 0), equation(cos(2 * pi * n), 1)),
    ((alternating, 1, -alternating),),
)
_sine = Claim(
    "sine",
    (
        equation(jump(sine.expression), -sin(pi * k_u) * _in_v),
        equation(jump(_slope), pi * k_u * (1 - cos(pi * k_u)) * _in_v),
        equation(_turned, cos(pi * k_u) * sine.expression + sin(pi * k_u) * cos(pi * k_u * u) * _in_v),
    ),
)
_even = Claim("even", (equation(jump(sine.expression), 0), equation(jump(_slope), 0)), (equation(cos(pi * k_u), 1),))
_odd = Claim(
    "odd",
    (equation(jump(sine.expression), 0), equation(jump(_slope), 2 * pi * k_u * _in_v)),
    (equation(cos(pi * k_u), -1),),
)
_ridges = Claim(
    "ridges", (equation(ridges.expression.subs(u, 0), 0), equation(ridges.expression.subs(u, 1), 0)), (_whole,)
)
_step = real("step")
_beside = tuple(ridges.expression.subs(u, at) for at in (_step, 1 - _step))
_crease = Claim(
    "ridges_crease",
    (equation(_beside[1] ** 2, _beside[0] ** 2), equation(_beside[0] ** 2, sin(pi * k_u * _step) ** 2 * _in_v**2)),
    (_whole,),
)
_broken = Claim(
    "ridges_jump",
    (greater(-jump(ridges.expression), 0),),
    (sin(pi * k_u) ** 2 > 0, _in_v**2 > 0),
    ranges=tuple((s, (Rational(1, 8), Rational(7, 8))) for s in (k_u, k_v, v)),  # samples keep off the zeros
)
_smooth = Claim(
    "rings", (equation(rings.expression.subs(u, u + 1), rings.expression), equation(rings.gradient()[0], 0))
)

theorem = Theorem(
    id="seam",
    title="Which fields cross the seam smoothly",
    section="s3",
    statement=r"$\sin\pi k_u(u+1) = (-1)^{k_u}\sin\pi k_u u$ for whole $k_u$. Across $u = 0$, sine's height jumps by "
    r"$-\sin\pi k_u\,\sin\pi k_v v$ and its slope by $\pi k_u(1-\cos\pi k_u)\sin\pi k_v v$: it is $C^1$ for "
    r"even $k_u$, has a crease for odd $k_u$ and a jump otherwise. Ridges is continuous for whole $k_u$, and even "
    r"about the seam with $h = 0$ there: a crease for every $k_u \ne 0$, wherever $\sin\pi k_v v \ne 0$; for other "
    r"$k_u$ it jumps. Rings does not depend on $u$.",
    hypotheses=("$k_u$ is whole: $\\sin\\pi k_u = 0$; even: $\\cos\\pi k_u = 1$; odd: $\\cos\\pi k_u = -1$",),
    claims=(_parity, _sine, _even, _odd, _ridges, _crease, _broken, _smooth),
    steps=(
        Step(r"$\cos\pi n = (-1)^n$, $\sin\pi n = 0$", "induction"),
        Step(r"$h(0,v)-h(1,v)$ and $h_u(0,v)-h_u(1,v)$", "the field and its derivative at both ends"),
        Step(r"$h(s, v)^2 = h(1-s, v)^2 = \sin^2\pi k_u s\,\sin^2\pi k_v v$", "ridges, whole $k_u$; both are $\\ge 0$"),
        Step("the slopes on either side are opposite and not zero", "as on every crease", uses=("ridges_on_creases",)),
    ),
    uses=("ridges_on_creases",),
    mutants=(
        Mutant("C¹ for odd k_u", _odd.but(shows=_even.shows)),
        Mutant("continuous for every k_u", _sine.but(shows=(equation(jump(sine.expression), 0),))),
        Mutant("ridges continuous for every k_u", _ridges.but(given=())),
        Mutant("h(u + 1) = h for whole k_u", _sine.but(shows=(equation(_turned, sine.expression),), given=(_whole,))),
    ),
    side_conditions=(
        SideCondition(
            "$k_u$ is even",
            "even",
            (
                Edge(((k_u, 2), (k_v, 1), (v, Rational(1, 2))), "holds"),
                Edge(((k_u, 1), (k_v, 1), (v, Rational(1, 2))), "fails"),
                Edge(((k_u, Rational(3, 2)), (k_v, 1), (v, Rational(1, 2))), "fails"),
            ),
        ),
    ),
)

_periodic = Claim("slope", (equation(expand(jump(_slope) / pi), 0),), (_whole,))

seam_saved = Theorem(
    id="periodic_u_saves_the_seam",
    title="Periodic in u, so smooth across the seam",
    section="s7",
    statement=r"For whole $k_u$ sine is differentiable across $u = 0$: its slope is the same on both sides.",
    hypotheses=("$k_u$ is whole",),
    claims=(_periodic,),
    refuted_at=((k_u, 1), (k_v, 1), (v, Rational(1, 2))),
    steps=(Step(r"$k_u = 1$, $v = 1/2$, $k_v = 1$: the slope is $\pi$ at $u = 0$, $-\pi$ at $u = 1$", "arithmetic"),),
    mutants=(
        Mutant("true for even k_u", _periodic.but(given=(equation(cos(pi * k_u), 1),))),
        Mutant("true for the height", Claim("height", (equation(jump(sine.expression), 0),), (_whole,))),
    ),
    expected="refuted",
)
