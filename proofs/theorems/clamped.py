"""The difference that is clamped at the pole v = 0: first order in general, second order where the field is odd."""

from proofs.formulas.difference_cases import at_pole, pole_clamps
from proofs.formulas.finite_difference import central, span_v, v_minus, v_plus
from proofs.formulas.height_fields import HeightField
from proofs.formulas.step_bounds import clamped_bound, third_derivative, truncation
from proofs.theorems.language import *

_clamp = Claim(
    "clamp", (equation(v_plus, v + epsilon), zero(v_minus), equation(span_v, v + epsilon)), pole_clamps, central(sine)
)
_parabola = HeightField("parabola", v**2 / 2)
_at_zero = Claim(
    "at_the_pole_itself", equation(h_v - _parabola.gradient()[1], (epsilon - v) / 2), pole_clamps, at_pole(_parabola)
)

first_order = Theorem(
    "clamped_difference",
    "The difference clamped at the pole",
    {
        r"""For $0 \le v < \varepsilon$ the central difference is $(h(v+\varepsilon) - h(0))/(v+\varepsilon)$,""": (
            _clamp,
            coq("clamped_difference__of_the_fields 1289e79079e163f6"),
        ),
        r"""and for every $h$ whose slope $h_v$ is Lipschitz with $S$ on $[0, v+\varepsilon]$, as
        $\sup|h_{vv}|$ is, where
        there is one, $|D_\varepsilon h - h_v| \le \frac{\varepsilon^2+v^2}{2(\varepsilon+v)}S$: first order.""": (
            coq("clamped_difference__of_any_height 34c5ae28ba23b70c")
        ),
        r"""No smaller factor will do: $h(w) = \tfrac12(w-v)|w-v|$, $S = 1$, attains it; at $v = 0$ so does
        $w^2/2$.""": (_at_zero, coq("clamped_difference__attained 3c4320bc36060948")),
    },
    hypotheses=r"$\varepsilon > 0$, $0 \le v < \varepsilon$, $v + \varepsilon \le 1$",
    steps={
        r"$h(v+\varepsilon) = h + \varepsilon h_v + \tfrac12\varepsilon^2 a$, $h(0) = h - v h_v + \tfrac12 v^2 b$": (
            r"$|a|, |b| \le S$, as $h_v$ is Lipschitz"
        ),
        r"$v_- = 0$, $v_+ = v+\varepsilon$, divided by $v+\varepsilon$": "the lines' own cases, decided",
        r"$(v+\varepsilon)|D_\varepsilon h - h_v| \le S(\varepsilon^2+v^2)/2$": "the two remainders, added",
        "equality": "the remainders of $(w-v)|w-v|/2$ are $\\varepsilon^2/2$ and $-v^2/2$",
    },
    mutants=(
        variant(
            "w²/2 attains the bound off the pole",
            _at_zero,
            equation(at_pole(_parabola).expand(h_v) - v, (epsilon**2 + v**2) / (2 * (epsilon + v))),
        ),
        variant("divided by 2ε", _clamp, equation(span_v, 2 * epsilon)),
    ),
    side_conditions=(
        SideCondition(
            r"$v < \varepsilon$", "clamp", holds={v: "1/8", epsilon: "1/8"}, fails={v: "1/4", epsilon: "1/8"}
        ),
        SideCondition(r"$v + \varepsilon \le 1$", "clamp", fails={v: "1/2", epsilon: "3/4"}),
    ),
)

_odd_ridge = Abs(sin(pi * k_u * u)) * sin(pi * k_v * v)
_odd = chain("odd", {real("h_sine h_rings h_ridge"): (sine.expression, rings.expression, _odd_ridge)})
_are_odd = Claim("odd", [equation(h, -field) for h, field in _odd.definitions], lines=_odd.at({v: -v}))
_first_ridge = Claim(
    "first_ridge",
    (
        _odd_ridge >= 0,
        _odd_ridge >= ridges.expression,
        ridges.expression >= _odd_ridge,
        equation(ridges.expression, _odd_ridge),
    ),
    (k_v > 0, v >= 0, 1 - k_v * v >= 0),
    cited=sine_of_half_turn(k_v * v),
)
_room = clamped_bound[truncation].xreplace({third_derivative: S.One})


def _error(h):
    """Return the error of the clamped difference of a field h(v)."""
    field = HeightField("of_v", h)
    return at_pole(field).expand(h_v) - field.gradient()[1]


_attained = Claim("second_order_sharp", equation(_error(v**3 / 6), _room), pole_clamps)

_of_odd = coq("clamped_difference_of_odd__of_any_height 3f44cb35c6bf82f5")

second_order = Theorem(
    "clamped_difference_of_odd",
    "Where the field is odd, the clamp costs no order",
    {
        r"""Sine and rings are odd about $v = 0$; on $[0, 1/k_v]$ ridges is $|\sin\pi k_u u|\sin\pi k_v v$,
        which is.""": (_are_odd, _first_ridge),
        r"""For every odd $h$ of three derivatives and $0 \le v < \varepsilon$, $|D_\varepsilon h - h_v| \le
        \tfrac16(\varepsilon^2+2\varepsilon v-2v^2)S$, $S = \sup|h_{vvv}|$ on $[0, v+\varepsilon]$: second order.""": (
            _of_odd
        ),
        r"""So for sine with $S = (\pi k_v)^3$, for rings with $(2\pi k_v)^3$, and for ridges, where $v+\varepsilon \le
        1/k_v$, as for sine: no hump may end inside the step.""": coq(
            "clamped_difference_of_odd__of_the_fields d85f58473a8ac6dd"
        ),
        "$w^3/6$ attains the bound.": _attained,
    },
    short={
        """If $h$ is odd about the pole $v = 0$ and $|h_{vvv}|$ is bounded, the clamped difference is of second order
        there.""": _of_odd,
        "Sine and rings are odd, and so is ridges near the pole.": (_are_odd, _first_ridge),
    },
    hypotheses=(
        r"$\varepsilon > 0$, $0 \le v < \varepsilon$, $v + \varepsilon \le 1$, $k_v > 0$",
        r"""$h_v$ at $v = 0$ is the slope upwards; the rule of creases has 0 for ridges there, which is off by up
        to $\pi k_v$""",
    ),
    steps={
        r"$h(0) = 0$ and $h_{vv}(0) = 0$": "$h$ is odd",
        "the clamped difference divides by $v+\\varepsilon$": ("its lines", "clamped_difference"),
        r"$h(s) = s h_v(s/2) + \tfrac1{24}s^3 a$, $h_v(s/2) = h_v(v) + \tfrac12(s^2/4 - v^2)b$, $s = v+\varepsilon$": (
            r"$|a|, |b| \le S$, by Taylor's theorem"
        ),
        r"$D_\varepsilon h - h_v = s^2a/24 + (s^2/8 - v^2/2)b$": r"the two theorems; $v \le s/2$",
        r"$s^2/24 + s^2/8 - v^2/2 = (s^2 - 3v^2)/6$": "expansion",
        r"$s^2 - 3v^2 = \varepsilon^2 + 2\varepsilon v - 2v^2$": "expansion",
    },
    mutants=(
        variant("1 − v² is odd too", _are_odd, equation((1 - v**2).subs(v, -v), v**2 - 1)),
        variant(
            "w³/6 attains ε²/6 for v > 0",
            _attained,
            equation(at_pole(HeightField("cubic", v**3 / 6)).expand(h_v) - v**2 / 2, epsilon**2 / 6),
        ),
    ),
    side_conditions=SideCondition(
        "ridges up to its first crease, $k_v v \\le 1$",
        "first_ridge",
        holds={u: "1/3", k_u: 1, k_v: 4, v: "1/4"},
        fails={u: "1/3", k_u: 1, k_v: 4, v: "3/8"},
    ),
)

_steps = (epsilon > 0, epsilon <= 1)
_of_cubic = _error(v - v**3).subs(v, 0)
_costs = Claim("costs_an_order", Abs(_of_cubic) >= epsilon, _steps)

always_first_order = Theorem(
    "seed_clamp",
    "The seed's clamp always costs an order",
    r"""At the pole the one-sided difference is of first order for every field: at $v = 0$ that of $h = v - v^3$
    errs by $\varepsilon$ at least.""",
    hypotheses=r"$0 < \varepsilon \le 1$",
    claims=_costs,
    refuted_at={epsilon: "1/2"},
    steps={r"the error is $-\varepsilon^2$: $1/4$ at $\varepsilon = 1/2$": "$h$ is odd"},
    mutants=(
        variant("of v − v³ it is −ε²", Claim("odd", equation(_of_cubic, -(epsilon**2)), _steps)),
        variant(
            "of v + v², not odd, it is ε", Claim("not_odd", equation(_error(v + v**2).subs(v, 0), epsilon), _steps)
        ),
    ),
)
