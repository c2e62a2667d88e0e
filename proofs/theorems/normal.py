"""The bumped normal: its length before normalising, and its derivative in β, which the seed checks by a difference."""

from proofs.formulas.bump import bumped_by_beta, bumped_normal, g, m, m_length, normal_by_beta, perturbed
from proofs.theorems.frame import on_circles
from proofs.theorems.language import *


def at(beta_at: Expr | int, g_at: Sequence = (1, 0, 0)) -> dict:
    """Return the inputs of `perturbed` where N points upward."""
    return {normal: (0, 0, 1), g: g_at, beta: beta_at}


tangent = (equation(squared(normal), 1), zero(dot(normal, g)))

_tangent = Claim(
    "g_is_tangent", (zero(dot(normal, g)), equation(squared(g), h_u**2 + h_v**2)), on_circles, bumped_normal
)
_length = Claim(
    "length",
    (
        equation(squared(m), 1 + beta**2 * squared(g)),
        squared(m) >= 1,
        m_length >= 1,
        equation(m_length**2, 1 + beta**2 * squared(g)),
        equation(squared(bumped), 1),
    ),
    tangent,
    perturbed,
    squares=beta * g,
)

unit_length = Theorem(
    "unit_length",
    "Normalising is never ill-conditioned",
    r"$N\cdot g = 0$, so $|M|^2 = 1 + \beta^2 |g|^2 \ge 1$ and $|N'| = 1$, for every $\beta$.",
    hypotheses=(r"$|N| = 1$", r"$g = h_u e_\theta + h_v e_\varphi$"),
    claims=(_tangent, _length),
    steps={
        r"$N\cdot g = 0$ and $|g|^2 = h_u^2 + h_v^2$": ("the frame is orthonormal", "tangent_frame"),
        r"$|M|^2 = |N|^2 + 2\beta N\cdot g + \beta^2|g|^2 = 1 + \beta^2|g|^2$": "expansion",
        r"$|M|^2 \ge 1$": "the rest is a sum of squares",
    },
    mutants=(
        variant("|M|² = 1 − β²|g|²", _length, equation(squared(m), 1 - beta**2 * squared(g))),
        variant("|M|² = 1 + β|g|²", _length, equation(squared(m), 1 + beta * squared(g))),
        variant("|M| > 1", _length, m_length > 1, at={beta: 0, normal: (1, 0, 0), g: (0, 1, 0)}),
        variant("N·g not zero", _length, given=tangent[:1]),
    ),
    side_conditions=SideCondition(r"$g \perp N$", "length", holds=at(1), undefined=at(-1, (0, 0, 1))),
)

_lines = chain("both", perturbed, normal_by_beta)
_slopes = [Derivative(b, beta) for b in perturbed.expand(bumped)]
_derivative = Claim("derivative", equations(_slopes, bumped_by_beta), squared(m) > 0, _lines)
_on_the_sphere = Claim("tangent_to_directions", zero(dot(bumped, bumped_by_beta)), squared(m) > 0, _lines)

derivative = Theorem(
    "normal_by_beta",
    "The normal's derivative in β",
    r"$\partial N'/\partial\beta = (I - N'N'^{\mathsf T})\,g/|M|$, tangent to the sphere of directions.",
    hypotheses=r"$M \ne 0$",
    claims=(_derivative, _on_the_sphere),
    steps={
        r"$\partial M/\partial\beta = g$, $\partial|M|/\partial\beta = M\cdot g/|M|$": "differentiation of the lines",
        "each component": "membership in the ideal of |M|² and 1/|M|",
        r"$M \ne 0$ for every $\beta$ where $g \perp N$": (r"$|M| \ge 1$ there", "unit_length"),
    },
    mutants=(
        variant("without the projection", _derivative, equations(_slopes, g / m_length)),
        variant("without 1/|M|", _derivative, equations(_slopes, bumped_by_beta * m_length)),
        variant("the sign turned", _derivative, equations(_slopes, -bumped_by_beta)),
    ),
    side_conditions=SideCondition(r"$M \ne 0$", "derivative", undefined=at(-1, (0, 0, 1))),
)


STEP, AGREEMENT = Rational(1, 10**7), Rational(1, 10**12)

_n = perturbed.expand(bumped[0])
_exact = perturbed.expand(normal_by_beta.expand(bumped_by_beta[0]))
_error = Abs((_n.subs(beta, beta + STEP) - _n) / STEP - _exact)
_verifies = Claim("verifies", at_least(AGREEMENT, _error), tangent)
_m = perturbed.expand(m[0])
_linear = Claim("linear", equation((_m.subs(beta, beta + STEP) - _m) / STEP, g[0]))

# |M| = (t + 1/t)/2 is rational where β g_x = (t − 1/t)/2: t = 2 at β, and 2 + 4·10⁻⁶ at β + 10⁻⁷.
_before, _after = ((t - 1 / t) / 2 for t in (Rational(2), 2 + Rational(4, 10**6)))
_g_x = (_after - _before) / STEP

theorem = Theorem(
    "seed_step_in_beta",
    "The seed's check of the normal's derivative",
    r"""The one-sided difference of $N'$ with step $\Delta\beta = 10^{-7}$ is $\partial N'/\partial\beta$ to
    $10^{-12}$.""",
    hypotheses=r"$|N| = 1$, $N\cdot g = 0$; the first component, in exact arithmetic",
    claims=_verifies,
    refuted_at=at(_before / _g_x, (_g_x, 0, 0)),
    steps={
        r"$N = (0, 0, 1)$, $g = (g_x, 0, 0)$: $N'_x = b/\sqrt{1+b^2}$, $b = \beta g_x$": "the lines",
        r"$g_x \approx 25$, $b = 3/4$: the error is $2.3\cdot10^{-5}$, by the second derivative": (
            r"$\sqrt{1+b^2}$ is rational at $\beta$ and $\beta + \Delta\beta$"
        ),
    },
    mutants=(
        variant("before normalising it is exact: M is linear in β", _linear),
        variant("the formula itself is exact", derivative.claim("derivative")),
    ),
)
