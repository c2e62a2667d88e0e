"""The gradients of the three fields, as the kernels print them: exact differences, and the sign of ridges."""

from proofs.formulas.height_fields import gradient
from proofs.theorems.language import *

_of_sine = [Derivative(sine.expression, c) for c in (u, v)]


def _difference(field, coordinate, slope, frequency):
    """Return f h(+ε) − f h = f h (cos fε − 1) + h' sin fε, which says that h' is the derivative."""
    h, angle = field.expression, frequency * epsilon
    moved = h.subs(coordinate, coordinate + epsilon)
    return equation(frequency * (moved - h), frequency * h * (cos(angle) - 1) + slope * sin(angle))


_sine = Claim(
    "sine",
    (
        equation(h_u, pi * k_u * cos(pi * k_u * u) * sin(pi * k_v * v)),
        equation(h_v, pi * k_v * sin(pi * k_u * u) * cos(pi * k_v * v)),
        equations((h_u, h_v), _of_sine),
        _difference(sine, u, h_u, pi * k_u),
        _difference(sine, v, h_v, pi * k_v),
    ),
    lines=gradient(sine),
)
_rings = Claim(
    "rings",
    (
        equation(h_v, 2 * pi * k_v * cos(2 * pi * k_v * v)),
        equations((h_u, h_v), [Derivative(rings.expression, c) for c in (u, v)]),
        _difference(rings, v, h_v, 2 * pi * k_v),
    ),
    lines=gradient(rings),
)
_p = sine.expression
_ridges = [
    Claim(
        f"ridges_{name}",
        (
            equations((h_u, h_v), [Derivative(ridges.expression, c) for c in (u, v)]),
            equations((h_u, h_v), [side * s for s in _of_sine]),
        ),
        side * _p > 0,
        gradient(ridges),
    )
    for name, side in SIDES
]
_printed = Claim("ridges_on_creases", zero(h_u, h_v), zero(_p), gradient(ridges))
p, d = real("p d")
_same = equation(Abs(p + d), Abs(p) + sign(p) * d)
_near = Claim("same_sign", _same, (p > 0, p + d >= 0))
_mirrored = Claim("same_sign_below", _same, (p < 0, p + d <= 0))

theorem = Theorem(
    "gradients",
    "The gradients of the three fields",
    r"""Sine: $h_u = \pi k_u\cos\pi k_u u\,\sin\pi k_v v$, $h_v = \pi k_v\sin\pi k_u u\,\cos\pi k_v v$. Rings:
    $h_u = 0$, $h_v = 2\pi k_v\cos 2\pi k_v v$. Ridges, $|p|$ with sine's height $p$:
    $\operatorname{sign}(p)\,p_u$ and $\operatorname{sign}(p)\,p_v$, its derivative where $p \ne 0$; on the
    creases the kernels print 0.""",
    hypotheses="any real $k_u$, $k_v$",
    claims=(_sine, _rings, _ridges, _printed, _near, _mirrored),
    steps={
        r"""$\omega(h(u+\varepsilon)-h(u)) = \omega h(\cos\omega\varepsilon-1) + h_u\sin\omega\varepsilon$,
        $\omega = \pi k_u$""": r"the addition formulas; divided by $\omega\varepsilon$ it tends to $h_u$",
        "the same in $v$, and for rings with $2\\pi k_v$": "the addition formulas",
        r"$|p+d| = |p| + \operatorname{sign}(p)\,d$ for $|d| \le |p|$": "by the sign of $p$",
        r"on the creases $\operatorname{sign}(p) = 0$": "the kernels' sign",
    },
    mutants=(
        variant("sine with its factors swapped", _sine, equation(h_u, h_v)),
        variant("the other sign", _sine, _difference(sine, u, -h_u, pi * k_u)),
        variant("rings with πk_v", _rings, _difference(rings, v, h_v, pi * k_v)),
        variant("ridges without the sign", _ridges[1], equation(h_u, _of_sine[0])),
    ),
    side_conditions=SideCondition(
        r"$|d| \le |p|$: no crease is crossed", "same_sign", holds={p: 1, d: -1}, fails=({p: 1, d: -2}, {p: 0, d: 1})
    ),
)
