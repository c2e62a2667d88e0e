"""The highlight: from one root and one division; Lipschitz in the normal for a whole shininess p ≥ 1, not for p < 1."""

from proofs.formulas.shading import (
    along_halfway,
    blinn_squared,
    halfway,
    halfway_squared,
    light_distance,
    light_scale,
    phong,
)
from proofs.theorems.language import *

apart, turned = real("apart turned")

n, m, omega = vectors("n m omega")
z = real("z")
_units = [equation(squared(p), 1) for p in (n, m, omega)]
_scalar = Claim(
    "along_a_direction",
    (apart**2 - dot(n - m, omega) ** 2 >= 0, both_ways(apart, dot(n, omega) - dot(m, omega))),
    (apart >= 0, equation(apart**2, squared(n - m)), _units[2]),
    squares=cross(n - m, omega),
)


def unclamped(program: Program) -> Expr:
    """Return the program's base of the highlight before its clamp at 0, with μ written out."""
    (clamped,) = program[specular_base].atoms(Max)
    (inner,) = {*clamped.args} - {0}
    return inner.xreplace({mu: program[mu]})


def _seen_from(normal_of_light, program):
    """Return the same with another normal."""
    return unclamped(program.at({bumped: normal_of_light, towards: omega}))


_cosines = _of_n, _of_m, _between = dot(n, omega), dot(m, omega), dot(n, m)
_gram_part = _of_n**2 + _of_m**2 - 2 * _of_n * _of_m * _between


def _gram_of(a, b, c):
    """Return the Gram determinant of three unit vectors, from their scalar products."""
    return 1 + 2 * a * b * c - a**2 - b**2 - c**2


def _reflected(p):
    return 2 * dot(p, omega) * p - omega


_a, _b, _c = real("a b c")
_gram = Claim("gram", equation(dot(n, cross(m, omega)) ** 2, _gram_of(*_cosines)), _units)
_swing = Claim(
    "mirror",
    (
        equation(squared(_reflected(n) - _reflected(m)), 4 * _gram_part),
        equation(squared(n - m), 2 - 2 * _between),
        [equation(_seen_from(p, phong), dot(_reflected(p), view)) for p in (n, m)],
    ),
    _units[:2],
)
_twice = Claim(
    "twice",
    (4 * apart**2 >= turned**2, 2 * apart >= turned),
    (
        apart >= 0,
        _gram_of(_a, _b, _c) >= 0,
        equation(turned**2, 4 * (_a**2 + _b**2 - 2 * _a * _b * _c)),
        equation(apart**2, 2 - 2 * _c),
    ),
    squares=1 - _c,
)
_parallel = {n: (1, 0, 0), m: (-1, 0, 0), apart: 2}

theorem = Theorem(
    "specular_lipschitz",
    "The highlight is Lipschitz in the normal",
    {
        r"""In the unit vector $N'$ the cosine $\mu = N'\cdot\omega$ is 1-Lipschitz, the $p$-th power of Blinn's base
        $p$-Lipschitz, and that of Phong's $2p$-Lipschitz.""": (
            _scalar,
            _gram,
            _swing,
            _twice,
            coq("specular_lipschitz__highlight 140da31cf50c05c4"),
        ),
        r"$|x^p - z^p| \le p\,|x-z|$ for all $x, z$ in $[0, 1]$.": coq(
            "specular_lipschitz__whole_power 8f37305216359278"
        ),
    },
    hypotheses=r"$p$ is whole and not negative; $\hat v$ is a unit vector, $L \ne P$",
    steps={
        r"$|n\cdot\omega - m\cdot\omega| \le |n-m|$ for a unit $\omega$, or unit $H/|H|$": "Lagrange's identity",
        r"$\max(0, \cdot)$ and the clip do not increase a distance": "by cases",
        r"$R = 2(n\cdot\omega)n - \omega$ turns by at most $2|\Delta n|$": "the Gram determinant is a square",
        r"$x^p - z^p = (x-z)\,S_p$, $p - S_p = (1-x)A_p + (1-z)B_p$": "induction on $p$",
        "$S_p, A_p, B_p \\ge 0$": "so they start, and each is a sum of products of such; induction on $p$",
    },
    mutants=(
        variant("Phong's base is 1-Lipschitz", _twice, apart >= turned),
        variant("the reflection without its factor 2", _swing, equation(_swing.shows[0].lhs, _gram_part)),
    ),
    side_conditions=SideCondition(
        r"$\omega$ has length 1",
        "along_a_direction",
        holds=_parallel | {omega: (1, 0, 0)},
        fails=_parallel | {omega: (2, 0, 0)},
    ),
)

bound = real("bound")
_root = Claim("root", bound * x >= sqrt(x), (x >= 0, x <= 1, bound >= 1))

below_one = Theorem(
    "highlight_below_one",
    "A shininess below 1",
    r"For every $p > 0$ the power $x^p$ is Lipschitz on $[0, 1]$ (at $p = 1/2$: $\sqrt x \le L x$).",
    hypotheses="$L \\ge 1$",
    claims=_root,
    refuted_at={x: "1/4096", bound: 32},
    steps={r"$L = 32$: $\sqrt x = 1/64 > 32/4096 = 1/128$": "and $x = 1/4L^2$ for any other $L$"},
    mutants=(
        variant("true where x ≥ 1/L²", _root, given=(_root.given, bound * sqrt(x) >= 1)),
        variant(
            "false for every L, at x = 1/4L²",
            Claim(
                "any_bound",
                (positive(bound, z), sqrt(z**2) > bound * z**2),
                (bound >= 1, z >= 0, equation(2 * bound * z, 1)),
            ),
        ),
    ),
)


_base, _length = real("specular_base_plain halfway_length_plain")
_opposite = Claim("opposite", equation(mu, -dot(bumped, view)), (light_distance > 0, zero(halfway)), blinn_squared)
_base_squared = Claim(
    "base",
    equation(blinn_squared[specular_base], _base**2),
    (
        equation(light_scale * light_distance * halfway_squared, 1),
        equation(light_distance**2 * _length**2, halfway_squared),
        equation(light_distance * _length * _base, along_halfway),
    ),
)

from_one_root = Theorem(
    "squared_highlight",
    "The highlight from one root and one division",
    {
        r"""With $d = L - P$, $k = d + |d|\hat v$ and $s = 1/(|d|\,k\cdot k)$: $\mu = (N'\cdot d)(k\cdot k)s$, and the
        square of Blinn's base is $(N'\cdot k)^2 |d| s$ where $N'\cdot k \ge 0$; so are both as the kernels
        print them.""": (_base_squared, coq("squared_highlight__formulas 70ef6d786f0b14a4")),
        r"Where $\omega = -\hat v$, $\mu = -N'\cdot\hat v$.": _opposite,
    },
    hypotheses=(
        "$L \\ne P$",
        r"$\omega \ne -\hat v$, except in the last sentence",
        r"""of the claim about the base, a step: $|d|^2|H|^2 = k\cdot k$ and $|d||H|\,b = N'\cdot k$, $H =
        \omega + \hat v$,
        $b$ the base (assumed)""",
    ),
    steps={
        r"$k = |d|(\omega + \hat v)$": "so its direction is the halfway vector's",
        r"$(N'\cdot k)^2/(k\cdot k)$ does not depend on the length of $k$": "nor does its sign, as $|d| > 0$",
    },
    mutants=(
        variant("the base, not its square", _base_squared, equation(blinn_squared[specular_base], _base)),
        variant("whatever the light's direction", _opposite, given=light_distance > 0),
    ),
)
