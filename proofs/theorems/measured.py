"""What the seed says of its pictures and its float64 formulas, and what was measured. See
verify/checkers/measurements."""

from proofs.engine.theorem import Theorem

products = Theorem(
    id="crease_products",
    title="A rounded product puts points on a crease",
    statement=r"Of the 1,824 float64 numbers nearest to some $m/k$, $0 < m < k \le 64$, that are not $m/k$ itself, the "
    r"rounded product $k u$ is a whole number for 1,756: sine reduced in half-turns then takes the point to be on the "
    r"crease. With the product exact it takes none.",
    hypotheses=("every $k$ and $m$, exhaustively", "the heights are those of the kernel that draws"),
    expected="measured",
)

contrast = Theorem(
    id="crease_contrast",
    title="The error at the creases, against the rest",
    statement=r"In the default scene at $256^2$ and $\varepsilon = 10^{-3}$ the mean error where the kink flag "
    "is set is about four orders of magnitude above that elsewhere on A, not one.",
    hypotheses=("four orders to the nearest whole order",),
    expected="measured",
)

dark = Theorem(
    id="dark_difference",
    title="The difference canvas stays dark",
    statement=r"In the default scene at $256^2$ the largest $|\Delta I| \times 100$ on A is below half an 8-bit level "
    r"at $\varepsilon = 10^{-8}$, $10^{-9}$ and $10^{-10}$: a canvas with that gain is black there.",
    hypotheses=("linear light",),
    expected="measured",
)

pole = Theorem(
    id="pole_accuracy",
    title="The printed frame and chart toward the pole",
    statement=r"In float64 the vector $g$ of the default field, by the seed's $\sin\varphi = \sqrt{1-N_z^2}$ and "
    r"$v = \arccos(N_z)/\pi$, is off by more than $10^{-7}$ near $\sin\varphi = 10^{-4}$, by more than $10^{-3}$ near "
    r"$6\cdot10^{-7}$ without the fallback, and by more than 20 with it; from $\rho$ and $t$ by less than $10^{-12}$.",
    hypotheses=("the largest of 200 points near each latitude, against 50 digits; the seed's forms with libm",),
    expected="measured",
)
