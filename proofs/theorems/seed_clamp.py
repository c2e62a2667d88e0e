"""The seed's word on the clamp at the pole, refuted: it does not always cost an order."""

from sympy import Abs, Rational

from proofs.engine.claim import Claim, at_least, equation
from proofs.engine.theorem import Mutant, Step, Theorem
from proofs.formulas.difference_cases import at_pole
from proofs.formulas.height_fields import HeightField
from proofs.formulas.symbols import epsilon, h_v, v


def _at_zero_of(h):
    """Return the error of the clamped difference at v = 0 of a field h(v)."""
    field = HeightField("at_zero", h)
    return (at_pole(field).expand(h_v) - field.gradient()[1]).subs(v, 0)


_steps = (epsilon > 0, epsilon <= 1)
_costs = Claim("costs_an_order", (at_least(Abs(_at_zero_of(v - v**3)), epsilon),), _steps)

always_first_order = Theorem(
    id="seed_clamp",
    title="The seed's clamp always costs an order",
    statement=r"At the pole the one-sided difference is of first order for every field: at $v = 0$ that of "
    r"$h = v - v^3$ errs by $\varepsilon$ at least.",
    hypotheses=(r"$0 < \varepsilon \le 1$",),
    claims=(_costs,),
    refuted_at=((epsilon, Rational(1, 2)),),
    steps=(Step(r"the error is $-\varepsilon^2$: $1/4$ at $\varepsilon = 1/2$", "$h$ is odd"),),
    mutants=(
        Mutant("of v − v³ it is −ε²", Claim("odd", (equation(_at_zero_of(v - v**3), -(epsilon**2)),), _steps)),
        Mutant("of v + v², not odd, it is ε", Claim("not_odd", (equation(_at_zero_of(v + v**2), epsilon),), _steps)),
    ),
)
