"""The rounding error of the central difference in floating point, the best step, and the floor that it leaves."""

from proofs.formulas.difference_cases import of_heights
from proofs.formulas.finite_difference import h_u_minus, h_u_plus
from proofs.formulas.step_bounds import (
    argument,
    best,
    best_step,
    evaluation,
    excess,
    floor,
    rounding,
    rounding_bound,
    span,
    steepest,
    three_roundings,
    truncation,
    two_roundings,
    unit,
)
from proofs.theorems.language import *

here, mean, off_plus, off_minus, growth = real("here mean off_plus off_minus growth")
first, second, third = real("first second third")

_each = evaluation + steepest * argument
_factors = both_ways(unit, first, second, third)
_unit = (unit > 0, unit < 1)
_both = (1 + first) * (1 + second)
_two = Claim(
    "two_roundings", both_ways(two_roundings[excess], growth - 1), (_unit, _factors[:4], equation(growth, _both))
)
_three = Claim(
    "three_roundings",
    (
        nonnegative((1 + unit) ** 2 - _both, _both - (1 - unit) ** 2),
        both_ways((1 - unit) * three_roundings[excess], (1 - unit) * (growth - 1)),
        both_ways(three_roundings[excess], growth - 1),
    ),
    (_unit, _factors, equation(growth * (1 + third), _both)),
)


_off = off_plus - off_minus
_bound = rounding_bound[rounding].xreplace({span: 2 * epsilon})
_in_u = Claim(
    "in_u",
    (
        both_ways(2 * _each, _off),
        both_ways(2 * _each * (1 + excess), _off * growth),
        both_ways(steepest * excess, mean * (growth - 1)),
        equation(2 * epsilon * (h_u * growth - mean), _off * growth + 2 * epsilon * mean * (growth - 1)),
        both_ways(2 * epsilon * _bound, 2 * epsilon * (h_u * growth - mean)),
        both_ways(_bound, h_u * growth - mean),
    ),
    (epsilon > 0, both_ways(excess, growth - 1), both_ways(_each, off_plus, off_minus), both_ways(steepest, mean)),
    of_heights({h_u_plus: here + 2 * epsilon * mean + off_plus, h_u_minus: here + off_minus}),
    ranges={
        (off_plus, off_minus, mean): ("-1/4", "1/4"),
        (evaluation, argument, excess, steepest): (0, 3),
        epsilon: (0, HALF),
    },
)


def _at(error):
    """Return a constant height whose two samples are off by 1, up and down, because of `error` alone."""
    other = {evaluation: argument, argument: evaluation}[error]
    none = {(other, here, mean, excess): 0, off_minus: -1, steepest: int(error is argument)}
    return none | {(growth, epsilon, error, off_plus): 1}


theorem = Theorem(
    "roundoff_bound",
    "The rounding error of the central difference",
    {
        r"""For every $h$ with $|h'| \le L$, samples off by at most $\eta$, arguments by at most $\alpha$ and a
        factor in
        $1 \pm \kappa$: $|\hat D_\varepsilon h - D_\varepsilon h| \le \frac{2(\eta + L\alpha)}S(1+\kappa) +
        L\kappa$, in $u$
        and in $v$ over the span $S = 2\varepsilon$, and clamped at the pole over $S = v + \varepsilon$.""": (
            _in_u,
            coq("roundoff_bound__of_any_height 2d6961583ad00c59"),
        ),
        r"In the standard model, with unit roundoff $\mu$, $\kappa = 2\mu + \mu^2$: $1 + \kappa = (1+\mu)^2$;": _two,
        r"where the span is rounded as well, $\kappa = (3\mu + \mu^2)/(1-\mu)$.": _three,
    },
    hypotheses=(
        r"$\mathrm{fl}(a \circ b) = (a \circ b)(1+d)$, $|d| \le \mu < 1$; $2\varepsilon$ is exact; nothing underflows",
        r"""$\eta, \alpha$: parameters: of the evaluation of $h$, and of the rounded $u \pm \varepsilon$, wrapped,
        or $v \pm \varepsilon$, clamped""",
        r"""assumed in the claim of the first sentence, a step: $\alpha$ moves $h$ by at most $L\alpha$, and
        $|D_\varepsilon h| \le L$""",
    ),
    steps={
        r"$\hat D = (D + (e_+-e_-)/S)\,\gamma$": r"the line, with $|e_\pm| \le \eta + L\alpha$",
        r"$\gamma = (1+d_1)(1+d_2)$, or that over $1+d_3$: $|\gamma - 1| \le \kappa$": (
            r"$|d_i| \le \mu$: difference, quotient, span"
        ),
        "the two parts, added": "each is within its bound",
    },
    mutants=(
        variant(
            "half of it: the two errors share 2ε",
            _in_u,
            both_ways(_each / (2 * epsilon) * (1 + excess) + steepest * excess, h_u * growth - mean),
            at=_at(evaluation),
        ),
        variant(
            "without the slope times the argument's error",
            _in_u,
            both_ways(evaluation / epsilon * (1 + excess) + steepest * excess, h_u * growth - mean),
            at=_at(argument),
        ),
        variant("one rounding for two", _two, unit >= growth - 1, at={(unit, first, second): "1/4", growth: "25/16"}),
        variant(
            "the span's rounding costs nothing",
            _three,
            2 * unit + unit**2 >= growth - 1,
            at={(unit, first, second): "1/4", third: "-1/4", growth: "25/12"},
        ),
    ),
    side_conditions=SideCondition(
        r"$\varepsilon > 0$", "in_u", undefined={tuple({here, *_in_u.names()[0]} - {h_u}): 0}
    ),
)

_least_value = best_step[floor]
_positive = (truncation > 0, best > 0, epsilon > 0, equation(rounding, best_step[rounding]))
_least = Claim(
    "least",
    (
        positive(truncation * best, best**2, rounding),
        nonnegative(
            truncation * (epsilon + 2 * best), epsilon * (truncation * epsilon**2 - 3 * truncation * best**2) + rounding
        ),
        truncation * epsilon**2 + rounding / epsilon >= _least_value,
        equation(truncation * best**2 + rounding / best, _least_value),
        equation(_least_value**3, Rational(27, 4) * truncation * rounding**2),
    ),
    _positive,
)

best_step_theorem = Theorem(
    "best_step",
    "The best step, and the floor that it leaves",
    {
        r"""For $T, E > 0$ the bound $T\varepsilon^2 + E/\varepsilon$ is least at $\varepsilon = (E/2T)^{1/3}$, where
        it is $3T^{1/3}(E/2)^{2/3}$: no step goes below that floor.""": (
            _least,
            coq("best_step__roots b72f9cbafaef8f40"),
        )
    },
    hypotheses=(r"$T, E, \varepsilon > 0$", r"$T$ from the truncation bound, $E$ from the rounding bound"),
    steps={
        r"""$\varepsilon_0^3 = E/2T$: $\varepsilon(T\varepsilon^2 - 3T\varepsilon_0^2) + E =
        T(\varepsilon-\varepsilon_0)^2(\varepsilon+2\varepsilon_0)$""": "expansion; not negative",
        r"at $\varepsilon_0$ it is $3T\varepsilon_0^2$, whose cube is $\tfrac{27}4TE^2$": "arithmetic",
    },
    mutants=(
        variant("at (E/T)^{1/3}", _least, given=(_positive[:3], equation(rounding, truncation * best**3))),
        variant("the floor 4Tε₀²", _least, truncation * epsilon**2 + rounding / epsilon >= 4 * truncation * best**2),
    ),
    side_conditions=SideCondition(
        r"$\varepsilon > 0$", "least", undefined={truncation: 1, best: 1, rounding: 2, epsilon: 0}
    ),
)
