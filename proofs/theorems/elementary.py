"""The accuracy of our own elementary functions. See verify/checkers/measurements/half_turns.py."""

from proofs.engine.theorem import Theorem

functions = Theorem(
    id="elementary_functions",
    title="Sine, cosine and arctangent of the kernels",
    statement=r"In float64 the kernels' $\sin\pi x$ is off by at most 1.34 units in the last place, $\cos\pi x$ by "
    r"1.53, $\sin\pi(ku)$ and $\cos\pi(ku)$ of an exact product by 2.52 and 2.09, and $\operatorname{atan2}(y, x)/\pi$ "
    "by 2.50.",
    hypotheses=(
        "round to nearest; nothing underflows or overflows; the unit is that of the float64 nearest to the exact value",
        r"the whole range: $|r| \le \frac14 + 2^{-30}$ after the reduction, which is exact but for the rounding of a "
        r"product's $r$; $0 \le t \le 1$ of the smaller over the larger side, in eight octants",
    ),
    expected="certified",
)
