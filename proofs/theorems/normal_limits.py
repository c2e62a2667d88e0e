"""The angle by which the bump turns the normal, its limits β → 0 and β → ±∞, and the shadow line that they leave."""

from proofs.formulas.bump import g, m_length, perturbed
from proofs.theorems.language import *
from proofs.theorems.normal import at, tangent

_g_squared, cosine = squared(g), dot(normal, bumped)
_turned = cross(normal, bumped)
_clear = {normal[:2]: ("-2/3", "2/3")}  # samples keep N_z off zero


_angle = Claim(
    "angle",
    (equation(m_length * cosine, 1), cosine > 0, equation(squared(_turned), beta**2 * _g_squared * cosine**2)),
    tangent,
    perturbed,
    squares=beta * g,
    ranges=_clear,
)

angle = Theorem(
    "angle_of_the_bump",
    "The angle between N and N'",
    {
        r"""The angle between $N$ and $N'$ is $\arctan(|\beta||g|)$: $N\cdot N' = 1/|M| > 0$ and $|N\times N'|^2 =
        \beta^2|g|^2\,(N\cdot N')^2$.""": (_angle, coq("angle_of_the_bump__arctangent a806f429d58d0d0f"))
    },
    short={r"The angle between $N$ and $N'$ is $\arctan(|\beta||g|)$.": _angle},
    hypotheses=(r"$|N| = 1$", r"$N\cdot g = 0$"),
    steps={
        r"$N\cdot M = 1$, so $N\cdot N' = 1/|M|$": r"$|N| = 1$, $N\cdot g = 0$",
        r"$|N\times N'|^2 = 1-(N\cdot N')^2 = \beta^2|g|^2/|M|^2$": (
            r"Lagrange's identity, $|M|^2 = 1+\beta^2|g|^2$",
            "unit_length",
        ),
        r"the tangent is $|\beta||g|$, the angle less than $\pi/2$": "the cosine is positive",
    },
    mutants=(
        variant("the sine is |β||g|", _angle, equation(squared(_turned), beta**2 * _g_squared)),
        variant("the tangent is |β||g|²", _angle, equation(squared(_turned), beta**2 * _g_squared**2 * cosine**2)),
        variant("at least 45°", _angle, 2 * cosine**2 <= 1),
    ),
    side_conditions=SideCondition(
        r"$N\cdot g = 0$", "angle", holds=at(7), fails=at(1, (0, 0, 1)), undefined=at(-1, (0, 0, 1))
    ),
)

w = real("w")
_w = equation(w, Abs(beta) * sqrt(_g_squared))
_moved = bumped - normal
_small = Claim(
    "small_beta",
    (
        m_length >= 1,
        equation(m_length * squared(_moved), 2 * (m_length - 1)),
        beta**2 * _g_squared - squared(_moved) >= 0,
        equation(w**2, beta**2 * _g_squared),
        w >= 0,
        w >= sqrt(squared(_moved)),
    ),
    (tangent, _w),
    perturbed,
    squares=beta * g,
    ranges=_clear,
)
_still = Claim("zero_beta", equations(bumped, normal), (tangent, zero(beta)), perturbed, ranges=_clear)
_flat = Claim("zero_height", equations(bumped, normal), (tangent, zero(g)), perturbed, ranges=_clear)


def _large(name, side):
    """Return the claim for β of the given sign, ±1."""
    direction = side * g / sqrt(_g_squared)
    gap = bumped - direction
    return Claim(
        name,
        (
            positive(sqrt(_g_squared), w),
            equation(w**2, beta**2 * _g_squared),
            equation(m_length**2, 1 + w**2),
            m_length >= w,
            equation(m_length * dot(bumped, direction), w),
            equation(m_length * squared(gap), 2 * (m_length - w)),
            equation(m_length * (m_length + w) * squared(gap), 2),
            at_least(1, w**2 * squared(gap)),
            at_least(1, w * sqrt(squared(gap))),
        ),
        (tangent, side * beta > 0, _g_squared > 0, _w),
        perturbed,
        squares=beta * g,
        ranges=_clear,
    )


_up, _down = _large("large_beta", 1), _large("large_negative_beta", -1)

limits = Theorem(
    "normal_limits",
    "The bumped normal for small and large β",
    {
        r"$|N'-N| \le |\beta||g|$;": _small,
        r"for $\beta \ne 0$, $g \ne 0$, $|N' - \operatorname{sign}(\beta)\,g/|g|| \le 1/(|\beta||g|)$.": (_up, _down),
        r"$N' = N$ at $\beta = 0$, and where $g = 0$.": (_still, _flat),
    },
    hypotheses=(r"$|N| = 1$", r"$N\cdot g = 0$"),
    steps={
        r"$|N'-N|^2 = 2-2/|M|$": "$N\\cdot N' = 1/|M|$",
        r"$2-2/|M| \le |M|^2-1 = \beta^2|g|^2$": (r"$|M| \ge 1$", "unit_length"),
        r"$|N'\mp g/|g||^2 = 2(|M|-w)/|M| = 2/(|M|(|M|+w))$, $w = |\beta||g|$": r"$|M|^2-w^2 = 1$",
        r"it is at most $1/w^2$": r"$|M| \ge w$",
        "$M = N$ where $g = 0$ or $\\beta = 0$": r"$|N| = 1$",
    },
    mutants=(
        variant("half as far", _small, w >= 2 * sqrt(squared(_moved))),
        variant("N' → g/|g| for β → −∞ too", _down, dot(bumped, g) > 0),
        variant("|N' − g/|g||² ≤ ½/(β²|g|²)", _up, at_least(1, 2 * w**2 * (2 - 2 * dot(bumped, g) / sqrt(_g_squared)))),
    ),
    side_conditions=SideCondition(
        r"$\beta \ne 0$, $g \ne 0$",
        "large_beta",
        holds={**at("3/4"), w: "3/4"},
        fails={**at(0), w: 0},
        undefined={**at(1, (0, 0, 0)), w: 0},
    ),
)

_swing = beta * dot(g, towards)
_cosine = dot(normal, towards) + _swing
_within = Claim(
    "shadow_line",
    (
        equation(w**2, beta**2 * _g_squared),
        nonnegative(w, _g_squared - dot(g, towards) ** 2, w**2 - (_swing) ** 2, w + _swing),
        _cosine > 0,
        equation(m_length * dot(bumped, towards), _cosine),
        dot(bumped, towards) > 0,
    ),
    (tangent, _w, equation(squared(towards), 1), dot(normal, towards) > w),
    perturbed,
    squares=(cross(g, towards), beta * g),
    ranges=_clear,
)
_light = {towards: ("-3/5", 0, "4/5")}

shadow_line = Theorem(
    "shadow_line_moves_within",
    "How far the bump can move an attached shadow",
    r"""Where $N\cdot\omega > |\beta||g|$, also $N'\cdot\omega > 0$: the attached shadow's line moves only where
    $|N\cdot\omega| \le |\beta||g|$, and not at all at $\beta = 0$.""",
    hypotheses=(r"$|N| = |\omega| = 1$", r"$N\cdot g = 0$"),
    claims=_within,
    steps={
        r"$(g\cdot\omega)^2 \le |g|^2$": "Lagrange's identity",
        r"$M\cdot\omega = N\cdot\omega + \beta g\cdot\omega \ge N\cdot\omega - |\beta||g| > 0$": (
            "expansion; $|M| > 0$",
            "unit_length",
        ),
        "for the other side, the same with $-\\omega$": "nothing else changes",
    },
    mutants=(
        variant(
            "N·ω > ½|β||g| suffices",
            _within,
            given=(_within.given[:-1], dot(normal, towards) > w / 2),
            at={**at(1), g: ("4/3", 0, 0), towards: ("-3/5", 0, "4/5"), w: "4/3"},
        ),
        variant("N'·ω ≥ N·ω", _within, dot(bumped, towards) >= dot(normal, towards)),
    ),
    side_conditions=SideCondition(
        r"$N\cdot\omega > |\beta||g|$",
        "shadow_line",
        holds=({**at(1), **_light, w: 1}, {**at(0), **_light, w: 0}),
        fails=({**at("4/3"), **_light, w: "4/3"}, {**at(0), towards: (1, 0, 0), w: 0}),
    ),
)
