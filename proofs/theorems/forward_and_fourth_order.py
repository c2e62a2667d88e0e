"""The bounds of the forward and of the fourth-order difference, in exact arithmetic and of float64's programs."""

from proofs.theorems.language import *

theorem = Theorem(
    "forward_and_fourth_order",
    "The forward and the fourth-order difference",
    {
        r"""For every $h$ with $|h''| \le S$ the forward difference, and the backward one, is within
        $\frac\varepsilon2S$ of $h'$;""": coq("forward_and_fourth_order__forward 766675637fcde5ff"),
        r"""with $|h^{(5)}| \le S$ that of fourth order is within $\frac{\varepsilon^4}{30}S$.""": coq(
            "forward_and_fourth_order__fourth 5e370d9202dddea0"
        ),
        r"""Float64's forward difference of a wave $a\sin\pi kw$, $|a| \le 1$, is within $\frac\varepsilon2L^2 +
        \frac{L\alpha}{\varepsilon/2}(1+\kappa) + \frac8{2^{53}\varepsilon/2}(1+\kappa) + L\kappa$ of its slope
        $L\,a\cos\pi kw$, $L = \pi k$, $\kappa = 2\cdot2^{-53} + (2^{-53})^2$: in $u$ with $\alpha = 4\cdot2^{-53}$,
        in $v$, where it is the backward one past the pole, with $\alpha = (v+\varepsilon)2^{-53}$;""": coq(
            "forward_and_fourth_order__forward_in_float64_u 1af5367a9618d293",
            "forward_and_fourth_order__forward_in_float64_v a3682b85611975ee",
        ),
        r"""that of fourth order within $\frac{\varepsilon^4}{30}L^5 + \frac{L(8\alpha+\beta)}{6\varepsilon}(1+\kappa) +
        \frac{12}{2^{53}\varepsilon}(1+\kappa) + \frac53L\kappa$, $\kappa = (1+2^{-53})^5 - 1$: in $u$ with $\alpha =
        \beta = 4\cdot2^{-53}$, in $v$ with $\alpha = (v+\varepsilon)2^{-53}$, $\beta = (v+2\varepsilon)2^{-53}$;
        and where $\mathrm{fl}(v + 2\varepsilon) > 1$ or $2\varepsilon > v$ it is the central difference in
        $v$.""": coq(
            "forward_and_fourth_order__fourth_in_float64_u 232793164c4a61f2",
            "forward_and_fourth_order__fourth_in_float64_v ab62bd33a5fc2b2a",
        ),
        r"""Sine's heights are those of such waves, in $u$ and in $v$; ridges', where all samples are on one side of
        each crease; and rings', with $2k_v$.""": coq("forward_and_fourth_order__heights_in_float64 674035eef41a457b"),
    },
    hypotheses=(
        r"""$0 < \varepsilon \le 1$, of fourth order $\varepsilon \le \frac12$; $u$, $v$ in $[0, 1]$, and $v +
        2\varepsilon \le 1$ where fourth order is not the central difference; $k > 0$; $\varepsilon$, $k_u$, $k_v$ and
        the points at which a height is taken are float64 numbers""",
        r"in $u$ nothing wraps, as rounded, or $k$ is even, $2n$ with a whole $n$: so beside the seam, too",
        r"""heights are computed within $7.6\cdot2^{-53}$, where a wave number times a coordinate is 0 or at least
        $2^{-969}$, and at most $2^{21}$, in size""",
    ),
    steps={
        r"$|h(x \pm \varepsilon) - h(x) \mp \varepsilon h'(x)| \le \frac12\varepsilon^2S$": "integrated",
        r"fourth order: three times, of $|h'''(x+t) + h'''(x-t) - h'''(x+2t) - h'''(x-2t)| \le 3t^2S$": "likewise",
        r"the weights $8, -8, -1, 1$ over $12\varepsilon$": "of the errors of heights and arguments; five roundings",
    },
)
