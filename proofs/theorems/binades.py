"""Steps that float64 cannot take: where every slope is 0. Coq proves it of the printed difference."""

from proofs.theorems.language import *

_in_u, _in_v = coq("binades__dies_in_u 4e948466f72c3067", "binades__dies_in_v 2b82896f35d16ceb")

theorem = Theorem(
    "binades",
    "The slope dies by binades",
    {
        r"""For a float64 number $u$, $2^k \le u < 2^{k+1} \le 1$, let $s = 2^{k-52}$ be the spacing there. Where $0 <
        \varepsilon < s/2 = 2^{k-53}$ and $u > 2^k$, or $0 < \varepsilon \le 2^{k-54}$, a quarter of it, and $u = 2^k$,
        $\mathrm{fl}(u \pm \varepsilon) = u$, and the computed $h_u$ is exactly 0 for every height;""": _in_u,
        "in $v$ the same, up to $v = 1$.": _in_v,
        r"""At the tie $\varepsilon = s/2$, for $u$ or $v = ms$ with $2^{52} < m < 2^{53} - 1$, it is 0 where
        $m$ is even,
        and twice the slope of $h = u$ or $h = v$ where $m$ is odd.""": coq("binades__tie e5e620cbf1c26408"),
        r"At the pole $v = 0$ the difference is that from 0 to $\varepsilon$,": coq("binades__pole 2407589d6ae5b3f3"),
        r"""and at the seam $u = 0$ half of that, of the rise from 0 to $\varepsilon$, since $u - \varepsilon$ becomes
        exactly 1.""": coq("binades__seam d608ce7f0d0f458c"),
    },
    short={
        r"""Where $0 < \varepsilon < s/2$ and $2^k < u < 2^{k+1} \le 1$, or $0 < \varepsilon \le s/4$ and $u = 2^k$, the
        computed $h_u$ is exactly 0, whatever the height;""": _in_u,
        "the same holds in $v$.": _in_v,
    },
    hypotheses=(
        r"$\varepsilon$ is a float64 number; at the pole $\varepsilon \le 1$, at the seam $\varepsilon \le 2^{-54}$",
        r"at the seam $h(1, v) = h(0, v)$, and the rise is 0 or at least $2^{-1021}$; of a tie $-1021 \le k \le -1$",
    ),
    steps={
        r"$u = ms$, $2^{52} \le m < 2^{53}$: $u \pm \varepsilon = (m \pm t)s$, $t < \frac12$": "the binade's grid",
        r"the nearest whole number to $m \pm t$ is $m$": "below $2^k$ the grid is twice as fine: $2t \\le \\frac12$",
        "both heights are $h(u, v)$: their difference is 0": "rounded, halved and divided it stays 0",
        r"$t = \frac12$: to the even neighbour, $m$ itself or $m \pm 1$": "ties go to even",
    },
)
