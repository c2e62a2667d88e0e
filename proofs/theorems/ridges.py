"""Where ridges is differentiable on its creases: at their crossings, and nowhere else on them."""

from sympy import Abs, Rational, Symbol, pi, sin

from proofs.engine.claim import CitedLemma, Claim, at_least, equation, greater
from proofs.engine.theorem import Edge, Mutant, SideCondition, Step, Theorem
from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.symbols import k_u, k_v, real, u, v
from proofs.theorems.cited import sine_of_quarter_turn

ridges, sine = HEIGHT_FIELDS["ridges"], HEIGHT_FIELDS["sine"]
to_u, to_v, m, n = real("to_u to_v m n")  # the step from the crossing u = m/k_u, v = n/k_v
_crossing = ridges.expression.subs({u: m / k_u + to_u, v: n / k_v + to_v})
_sines = sin(pi * k_u * to_u), sin(pi * k_v * to_v)
_whole = (equation(sin(pi * m), 0), equation(sin(pi * n), 0))
_small = tuple(
    CitedLemma(at_least((pi * k * d) ** 2, s**2), "DLMF")
    for k, d, s in zip((k_u, k_v), (to_u, to_v), _sines, strict=True)
)


def _symbol(e):
    return Symbol(str(e).replace(" ", ""), real=True)


_crossed = Claim(
    "crossing",
    (
        equation(_crossing**2, (_sines[0] * _sines[1]) ** 2),
        at_least((_sines[0] ** 2 + _sines[1] ** 2) ** 2, 4 * _crossing**2),
        at_least((pi * k_u * to_u) ** 2 + (pi * k_v * to_v) ** 2, _sines[0] ** 2 + _sines[1] ** 2),
    ),
    (k_u > 0, k_v > 0, *_whole),
    squares=(_symbol(_sines[0]) ** 2 - _symbol(_sines[1]) ** 2,),
    cited=_small,
)
_a, _b, _h, _d = real("a b h d")
_flat = Claim(
    "flat",
    (at_least(_a**2 + _b**2, 0), at_least(_a**2 + _b**2, 2 * _h)),
    (_h >= 0, at_least((_a**2 + _b**2) ** 2, 4 * _h**2)),
)


def _either_side(name, along, k, step, across):
    """Return the claim about a crease along = m/k, at a distance `step` on both sides, where `across` is sin πk'v."""
    sides = [ridges.expression.subs(along, m / k + side * step) for side in (1, -1)]
    sine_of_step, angle = sin(pi * k * step), pi * k * step
    return Claim(
        name,
        (
            equation(sides[0] ** 2, sine_of_step**2 * across**2),
            equation(sides[1] ** 2, sides[0] ** 2),
            at_least((4 * sine_of_step**2 - angle**2) * across**2, 0),
            at_least(4 * sides[0] ** 2, angle**2 * across**2),
        ),
        (k > 0, step > 0, 2 * k * step <= 1, equation(sin(pi * m), 0)),
        squares=(_symbol(across),),
        cited=(sine_of_quarter_turn(k * step),),
        ranges=((step, (0, Rational(1, 4))), (k, (Rational(1, 4), 3))),
    )


_on_u = _either_side("crease_in_u", u, k_u, to_u, sin(pi * k_v * v))
_on_v = _either_side("crease_in_v", v, k_v, to_v, sin(pi * k_u * u))
_right, _left, _slope = real("right left slope")  # h(m/k_u ± s)/s and πk_u |sin πk_v v|
_differ = Claim(
    "differ",
    (at_least(2 * _right, _slope), at_least(_slope, 0), greater(_right - _left, 0)),
    (_right >= 0, _slope > 0, 4 * _right**2 >= _slope**2, equation(_left, -_right)),
)
_level = ((_right, 0), (_left, 0), (_slope, 0))
_beyond = [ridges.expression.subs(u, m / k_u + side * to_u) for side in (1, -1)]


def _at(whole_u, whole_v):
    """Return a point at half a wave from u = whole_u, v = whole_v."""
    return ((k_u, 1), (k_v, 1), (m, whole_u), (n, whole_v), (to_u, Rational(1, 2)), (to_v, Rational(1, 2)))


crossings = Theorem(
    id="ridges_at_crossings",
    title="Ridges is differentiable where its creases cross",
    section="s3",
    statement=r"At $(a, b)$ from a crossing $u = m/k_u$, $v = n/k_v$ of creases inside the chart, "
    r"$0 \le h \le \pi^2(k_u^2a^2 + k_v^2b^2)/2$: $h$ is differentiable there, with derivative 0.",
    hypotheses=("$m$, $n$ whole; $k_u, k_v > 0$", r"$\sin^2 x \le x^2$ is cited"),
    claims=(_crossed, _flat),
    steps=(
        Step(r"$h^2 = (\sin\pi k_u a\,\sin\pi k_v b)^2$", "the addition formulas, $\\sin\\pi m = \\sin\\pi n = 0$"),
        Step(r"$2h \le \sin^2\pi k_u a + \sin^2\pi k_v b$", r"$2|pq| \le p^2+q^2$"),
        Step(r"$\le \pi^2(k_u^2a^2+k_v^2b^2)$, so $h = o(\sqrt{a^2+b^2})$", r"$\sin^2x \le x^2$"),
    ),
    mutants=(
        Mutant("half the bound", _flat.but(shows=(at_least(_a**2 + _b**2, 4 * _h),))),
        Mutant("on one crease only", _crossed.but(shows=_crossed.shows[:1], given=(k_u > 0, k_v > 0, _whole[0]))),
        Mutant("the sum for the product", _crossed.but(shows=(equation(_crossing**2, (_sines[0] + _sines[1]) ** 2),))),
    ),
    side_conditions=(
        SideCondition("$m$, $n$ whole", "crossing", (Edge(_at(1, 1), "holds"), Edge(_at(1, Rational(1, 2)), "fails"))),
    ),
)

on_creases = Theorem(
    id="ridges_on_creases",
    title="Ridges is not differentiable elsewhere on its creases",
    section="s3",
    statement=r"On a crease $u = m/k_u$ where $\sin\pi k_v v \ne 0$: "
    r"$h(m/k_u \pm s, v) = |\sin\pi k_u s||\sin\pi k_v v|$, so the slopes to either side are "
    r"$\pm\pi k_u|\sin\pi k_v v|$, and $h(m/k_u \pm s, v)/s \ge \pi k_u|\sin\pi k_v v|/2$ for "
    r"$0 < s \le 1/2k_u$: there is no derivative. The same on $v = n/k_v$.",
    hypotheses=("$m$ whole; $k_u > 0$", r"Jordan's inequality $|\sin x| \ge |x|/2$ for $|x| \le \pi/2$ is cited"),
    claims=(_on_u, _on_v, _differ),
    steps=(
        Step(r"$h^2 = \sin^2\pi k_u s\,\sin^2\pi k_v v$ on both sides", r"the addition formulas, $\sin\pi m = 0$"),
        Step(r"$h/s \ge \pi k_u|\sin\pi k_v v|/2$", "Jordan's inequality"),
        Step("the two quotients have opposite signs and do not tend to 0", r"$\sin\pi k_v v \ne 0$"),
    ),
    mutants=(
        Mutant("the sides differ in height", _on_u.but(shows=(greater(_beyond[0] ** 2, _beyond[1] ** 2),))),
        Mutant("whatever m is", _on_u.but(shows=_on_u.shows[:1], given=_on_u.given[:-1])),
        Mutant("differ at a crossing too", _differ.but(given=(_right >= 0, _slope >= 0, *_differ.given[2:])), _level),
    ),
    side_conditions=(
        SideCondition(
            r"$\sin\pi k_v v \ne 0$: the slope is not 0",
            "differ",
            (Edge(((_right, 1), (_left, -1), (_slope, 2)), "holds"), Edge(_level, "fails")),
        ),
    ),
)

_u_slope = sine.gradient()[0] / pi  # in half-turns
_one_slope = Claim("one_slope", (equation(Abs(_u_slope), -Abs(_u_slope)),), (equation(sin(pi * k_u * u), 0),))

differentiable = Theorem(
    id="ridges_differentiable",
    title="Ridges is differentiable",
    section="s7",
    statement=r"On a crease $k_u u = m$ the slopes of ridges to the right and to the left, $+|p_u|$ and $-|p_u|$ with "
    r"$p = \sin\pi k_u u\,\sin\pi k_v v$, are the same.",
    claims=(_one_slope,),
    refuted_at=((u, Rational(1, 4)), (v, Rational(1, 8)), (k_u, 8), (k_v, 4)),
    steps=(Step(r"$k_u = 8$, $k_v = 4$, $(u, v) = (1/4, 1/8)$: $+8\pi$ and $-8\pi$", "arithmetic"),),
    mutants=(
        Mutant("true at a crossing", _one_slope.but(given=(*_one_slope.given, equation(sin(pi * k_v * v), 0)))),
        Mutant("true where k_u = 0", _one_slope.but(given=(*_one_slope.given, equation(k_u, 0)))),
    ),
    expected="refuted",
)
