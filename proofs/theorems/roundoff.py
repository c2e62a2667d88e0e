"""The rounding error of the central difference in floating point, the best step, and the floor that it leaves."""

from sympy import Rational

from proofs.engine.claim import Claim, at_least, equation, greater
from proofs.engine.theorem import Edge, Mutant, SideCondition, Step, Theorem
from proofs.formulas.difference_cases import of_heights
from proofs.formulas.finite_difference import h_u_minus, h_u_plus
from proofs.formulas.symbols import epsilon, h_u, real
from proofs.theorems.clamped import both_ways

unit, evaluation, argument, steepest = real("unit evaluation argument steepest")
here, mean, off_plus, off_minus, first, second = real("here mean off_plus off_minus first second")
truncation, rounding, best = real("truncation rounding best")

_computed = of_heights({h_u_plus: here + 2 * epsilon * mean + off_plus, h_u_minus: here + off_minus})
_rounded = h_u * (1 + first) * (1 + second)
_growth, _each = (1 + first) * (1 + second), evaluation + steepest * argument
_whole = _each * (1 + unit) ** 2 / epsilon + steepest * (2 * unit + unit**2)
_magnitudes = ((unit, first), (unit, second), (_each, off_plus), (_each, off_minus), (steepest, mean))
_model = Claim(
    "bound",
    (
        at_least(1 + first, 0),
        at_least(1 + second, 0),
        at_least(_growth, 0),
        at_least((1 + unit) ** 2 - _growth, 0),
        at_least(_growth - (1 - unit) ** 2, 0),
        *both_ways(2 * unit + unit**2, _growth - 1),
        at_least(_each, 0),
        at_least(steepest, 0),
        equation(epsilon * (_rounded - mean), (off_plus - off_minus) * _growth / 2 + epsilon * mean * (_growth - 1)),
        *both_ways(_each * _growth, (off_plus - off_minus) * _growth / 2),
        *both_ways(_each * (1 + unit) ** 2, (off_plus - off_minus) * _growth / 2),
        *both_ways(steepest * (2 * unit + unit**2), mean * (_growth - 1)),
        *both_ways(epsilon * _whole, epsilon * (_rounded - mean)),
        *both_ways(_whole, _rounded - mean),
    ),
    (
        epsilon > 0,
        unit > 0,
        unit < 1,
        evaluation >= 0,
        argument >= 0,
        *(relation for bound, quantity in _magnitudes for relation in both_ways(bound, quantity)),
    ),
    _computed,
    ranges=(
        (unit, (0, Rational(1, 4))),
        *((d, (Rational(-1, 4), Rational(1, 4))) for d in (first, second)),
        *((e, (0, 3)) for e in (evaluation, argument, epsilon, steepest)),
    ),
)

theorem = Theorem(
    id="roundoff_bound",
    source="DLMF",
    title="The rounding error of the central difference",
    section="s4",
    statement=r"Of the difference in $u$, in the standard model, with unit roundoff $\mu$, heights off by at "
    r"most $\eta$ and arguments by at "
    r"most $\alpha$: $|\hat D_\varepsilon h - D_\varepsilon h| \le "
    r"\frac{\eta + L\alpha}{\varepsilon}(1+\mu)^2 + L(2\mu+\mu^2)$, $L = \sup|h'|$.",
    hypotheses=(
        r"$\mathrm{fl}(a \circ b) = (a \circ b)(1+d)$, $|d| \le \mu < 1$; $2\varepsilon$ is exact; nothing underflows",
        r"$\eta, \alpha$: parameters: of the evaluation of $h$, and of the rounded $u \pm \varepsilon$, wrapped",
        r"the mean value theorem: $\alpha$ moves $h$ by at most $L\alpha$, and $|D_\varepsilon h| \le L$",
    ),
    claims=(_model,),
    steps=(
        Step(r"$\hat D = (D + (e_+-e_-)/2\varepsilon)(1+d_1)(1+d_2)$", r"the line, with $|e_\pm| \le \eta + L\alpha$"),
        Step(r"$|(1+d_1)(1+d_2) - 1| \le 2\mu + \mu^2$", r"$|d_i| \le \mu$"),
        Step("the two parts, added", "each is within its bound"),
    ),
    mutants=(
        Mutant(
            "half of it: the two errors share 2ε",
            _model.but(shows=both_ways(_each / (2 * epsilon) * (1 + unit) ** 2, h_u - mean)),
        ),
        Mutant(
            "without the slope times the argument's error",
            _model.but(shows=both_ways(evaluation / epsilon * (1 + unit) ** 2 + steepest * 3 * unit, _rounded - mean)),
        ),
        Mutant(
            "one rounding for two",
            _model.but(shows=both_ways(_each * (1 + unit) / epsilon + steepest * unit, _rounded - mean)),
            at=(
                *((s, Rational(1, 4)) for s in (unit, first, second)),
                *((s, 1) for s in (mean, steepest, epsilon)),
                *((s, 0) for s in (evaluation, argument, off_plus, off_minus)),
            ),
        ),
    ),
    side_conditions=(
        SideCondition(
            r"$\varepsilon > 0$",
            "bound",
            (Edge(tuple((s, 0) for s in sorted({here, *_model.names()[0]} - {h_u}, key=str)), "undefined"),),
        ),
    ),
)

_positive = (truncation > 0, best > 0, epsilon > 0, equation(rounding, 2 * truncation * best**3))
_least = Claim(
    "least",
    (
        greater(truncation * best, 0),
        greater(best**2, 0),
        greater(rounding, 0),
        at_least(truncation * (epsilon + 2 * best), 0),
        at_least(epsilon * (truncation * epsilon**2 - 3 * truncation * best**2) + rounding, 0),
        at_least(truncation * epsilon**2 + rounding / epsilon, 3 * truncation * best**2),
        equation(truncation * best**2 + rounding / best, 3 * truncation * best**2),
        equation((3 * truncation * best**2) ** 3, Rational(27, 4) * truncation * rounding**2),
    ),
    _positive,
    squares=(epsilon - best,),
    ranges=((best, (0, 3)), (epsilon, (0, 3)), (rounding, (0, 3))),
)

best_step = Theorem(
    id="best_step",
    title="The best step, and the floor that it leaves",
    section="s4",
    statement=r"For $T, E > 0$ the bound $T\varepsilon^2 + E/\varepsilon$ is least at "
    r"$\varepsilon = (E/2T)^{1/3}$, where it is $3T^{1/3}(E/2)^{2/3}$: no step goes below that floor.",
    hypotheses=(r"$T, E, \varepsilon > 0$", r"$T$ from the truncation bound, $E$ from the rounding bound"),
    claims=(_least,),
    steps=(
        Step(
            r"$\varepsilon_0^3 = E/2T$: $\varepsilon(T\varepsilon^2 - 3T\varepsilon_0^2) + E = "
            r"T(\varepsilon-\varepsilon_0)^2(\varepsilon+2\varepsilon_0)$",
            "expansion; not negative",
        ),
        Step(r"at $\varepsilon_0$ it is $3T\varepsilon_0^2$, whose cube is $\tfrac{27}4TE^2$", "arithmetic"),
    ),
    mutants=(
        Mutant("at (E/T)^{1/3}", _least.but(given=(*_positive[:3], equation(rounding, truncation * best**3)))),
        Mutant(
            "the floor 4Tε₀²",
            _least.but(shows=(at_least(truncation * epsilon**2 + rounding / epsilon, 4 * truncation * best**2),)),
        ),
    ),
    side_conditions=(
        SideCondition(
            r"$\varepsilon > 0$",
            "least",
            (Edge(((truncation, 1), (best, 1), (rounding, 2), (epsilon, 0)), "undefined"),),
        ),
    ),
)
