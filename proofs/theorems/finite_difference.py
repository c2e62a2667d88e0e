"""The central difference of a sine: the derivative times sinc, and the bound of its truncation."""

from proofs.formulas.difference_cases import INSIDE, inside, nothing_clamps, nothing_wraps
from proofs.formulas.finite_difference import central, span_v, v_minus, v_plus
from proofs.formulas.height_fields import HeightField
from proofs.theorems.language import *


def difference(field: HeightField, output: Symbol) -> Expr:
    """Return the central difference away from the seam and the poles, as one expression."""
    return inside(field).expand(output)


def _sinc(x):
    """Return sin x / x."""
    return sin(x) / x


def _times_sinc(name, field, output, frequency, given):
    slope = dict(zip((h_u, h_v), field.gradient(), strict=True))[output]
    shows = (
        equation(2 * epsilon * difference(field, output), 2 * slope / (pi * frequency) * sin(pi * frequency * epsilon)),
        equation(difference(field, output), slope * _sinc(pi * frequency * epsilon)),
    )
    (k,) = frequency.free_symbols
    return Claim(name, shows, (given, k > 0), ranges=INSIDE)


_u = _times_sinc("sine_in_u", sine, h_u, k_u, nothing_wraps)
_v = _times_sinc("sine_in_v", sine, h_v, k_v, nothing_clamps)
_rings = _times_sinc("rings_in_v", rings, h_v, 2 * k_v, nothing_clamps)
_clamp = Claim(
    "no_clamp",
    (equation(v_plus, v + epsilon), equation(v_minus, v - epsilon), equation(span_v, 2 * epsilon)),
    nothing_clamps,
    central(sine),
)
_cosine = Claim(
    "cosine",
    equation(
        (cos(pi * k_u * (u + epsilon)) - cos(pi * k_u * (u - epsilon))) / (2 * epsilon),
        -pi * k_u * sin(pi * k_u * u) * _sinc(pi * k_u * epsilon),
    ),
    (epsilon > 0, k_u > 0),
)

theorem = Theorem(
    "central_difference_of_sine",
    "The central difference of a sine",
    {
        r"""For $h = \sin\pi k_u u\,\sin\pi k_v v$ the central difference is the derivative times
        $\operatorname{sinc}$: $D_\varepsilon h_u = h_u \sin(\pi k_u\varepsilon)/(\pi k_u\varepsilon)$, the same in
        $v$; rings' own frequency is $2k_v$; and of $\cos\pi k u$ likewise.""": (
            _clamp,
            _u,
            _v,
            _rings,
            _cosine,
            coq(
                "central_difference_of_sine__nothing_wraps 2a2816b6e537b146",
                "central_difference_of_sine__nothing_clamps c2d00bafdb91b59b",
            ),
        )
    },
    hypotheses=(
        r"$\varepsilon > 0$, $k > 0$",
        r"nothing wraps or clamps: $\varepsilon \le u < 1 - \varepsilon$ or $\varepsilon \le v \le 1 - \varepsilon$",
    ),
    steps={
        r"$v_\pm = v \pm \varepsilon$, divided by $2\varepsilon$": "the lines' own cases, decided",
        r"$\sin(a+b) - \sin(a-b) = 2\cos a\sin b$": "the addition formulas",
        "divide by $2\\varepsilon$": "$\\varepsilon > 0$",
    },
    mutants=(
        variant("rings' frequency k_v", _times_sinc("rings_in_v", rings, h_v, k_v, nothing_clamps)),
        variant(
            "the step 2ε in sinc",
            _u,
            equation(difference(sine, h_u), sine.gradient()[0] * _sinc(2 * (pi * k_u * epsilon))),
        ),
        variant("the derivative itself", _u, equation(difference(sine, h_u), sine.gradient()[0])),
        variant("v clamped: span 2ε", _clamp, given=(epsilon > 0, epsilon < HALF, v >= 0, v <= 1)),
    ),
    side_conditions=(
        SideCondition(
            r"$\varepsilon \le v \le 1-\varepsilon$",
            "no_clamp",
            holds={v: "1/8", epsilon: "1/8"},
            fails={v: "1/8", epsilon: "1/7"},
        ),
        SideCondition(r"$\varepsilon > 0$", "cosine", undefined={u: "1/3", epsilon: 0, k_u: 8}),
    ),
)
