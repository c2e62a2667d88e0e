"""The seed's check of ∂N'/∂β by a one-sided difference with step 10⁻⁷, and the truncation that it cannot pass."""

from sympy import Abs, Rational

from proofs.engine.claim import Claim, at_least, equation
from proofs.engine.theorem import Mutant, Step, Theorem
from proofs.formulas.bump import bumped, bumped_by_beta, g, m, normal_by_beta, perturbed
from proofs.formulas.symbols import beta
from proofs.theorems.normal import at, derivative, tangent

STEP, AGREEMENT = Rational(1, 10**7), Rational(1, 10**12)

_by_difference = (perturbed.expand(bumped[0]).subs(beta, beta + STEP) - perturbed.expand(bumped[0])) / STEP
_derivative = perturbed.expand(normal_by_beta.expand(bumped_by_beta[0]))
_error = Abs(_by_difference - _derivative)
_verifies = Claim("verifies", (at_least(AGREEMENT, _error),), tangent)
_m = perturbed.expand(m[0])
_linear = Claim("linear", (equation((_m.subs(beta, beta + STEP) - _m) / STEP, g[0]),))

# |M| = (t + 1/t)/2 is rational where β g_x = (t − 1/t)/2: t = 2 at β, and 2 + 4·10⁻⁶ at β + 10⁻⁷.
_before, _after = ((t - 1 / t) / 2 for t in (Rational(2), 2 + Rational(4, 10**6)))
_g_x = (_after - _before) / STEP
_point = at((0, 0, 1), (_g_x, 0, 0), _before / _g_x)

theorem = Theorem(
    id="seed_step_in_beta",
    title="The seed's check of the normal's derivative",
    statement=r"The one-sided difference of $N'$ with step $\Delta\beta = 10^{-7}$ is $\partial N'/\partial\beta$ to "
    r"$10^{-12}$.",
    hypotheses=(r"$|N| = 1$, $N\cdot g = 0$; the first component, in exact arithmetic",),
    claims=(_verifies,),
    refuted_at=_point,
    steps=(
        Step(r"$N = (0, 0, 1)$, $g = (g_x, 0, 0)$: $N'_x = b/\sqrt{1+b^2}$, $b = \beta g_x$", "the lines"),
        Step(
            r"$g_x \approx 25$, $b = 3/4$: the error is $2.3\cdot10^{-5}$, by the second derivative",
            r"$\sqrt{1+b^2}$ is rational at $\beta$ and $\beta + \Delta\beta$",
        ),
    ),
    mutants=(
        Mutant("before normalising it is exact: M is linear in β", _linear),
        Mutant("the formula itself is exact", derivative.claim("derivative")),
    ),
)
