"""How accurate the float64 programs are, measured against balls. See verify/checkers/measurements/accuracy.py."""

from proofs.engine.theorem import Step, Theorem

pixels = Theorem(
    id="pixel_accuracy",
    title="A pixel against the reference",
    statement=r"Where $1-(\rho/\rho_s)^2 \ge 0.01$, and as far from the outline of B, every channel of the default "
    r"scene is within $5\cdot10^{-14}$ of its exact value, for every field and both models; elsewhere, and for other "
    "exponents, within the radius of the same program in 53-bit balls.",
    hypotheses=(
        "$255^2$; 46 pixels of each kind: at random, at silhouettes and shadows' edges, nearest to the pole, the "
        "seam, the creases, the terminator and grazing light",
        "pixels whose side of a crease 53-bit balls leave open, those of the column $x = 0$, are counted apart",
    ),
    expected="measured",
)

gradients = Theorem(
    id="gradient_accuracy",
    title="The exact gradient against the reference",
    statement=r"With $\mu = 2^{-53}$, the general form is within $8\mu\,\pi\max(1,|k|)$ of the exact gradient at the "
    r"float64 $(u, v)$, $|k| \le 2^{20}$; the algebraic form within $8(1+k)\mu\,\pi k$ at the float64 image point, "
    r"$k \le 64$.",
    hypotheses=(
        r"$k_u u$ and $k_v v$ are 0 or above $10^{-285}$",
        r"the algebraic form: $1-(\rho/\rho_s)^2 \ge 0.1$, $\sin\varphi$ down to $10^{-150}$, $R/e$ from $10^{-6}$ to "
        r"$1-10^{-9}$, $k = \max(|k_u|,|k_v|)$, for rings $2|k_v|$",
    ),
    expected="measured",
)

_truncation = ("truncation_bound", "clamped_difference_of_odd", "crease_error_area")
_rounding = ("roundoff_bound", "elementary_functions")

differences = Theorem(
    id="difference_bounds",
    title="The U-curve lies below its bounds",
    statement=r"For $\varepsilon$ from $10^{-1}$ to $10^{-16}$ the truncation error, the error of the rounded "
    r"arguments and that of the rounded evaluation of the float64 central difference are each at most their proved "
    "bounds.",
    hypotheses=(
        "forty steps a decade; smooth points, $k$ from 1 to 512; beside a crease, at the pole, beside the seam for "
        "even, odd and fractional $k_u$",
    ),
    steps=(
        Step(
            "truncation: the exact quotient less the slope",
            r"three bounds, each in its place; elsewhere $|D|, |h'| \le \pi k$, and across a jump $J$ "
            r"$J/2\varepsilon$ more",
            uses=_truncation,
        ),
        Step(
            "arguments and evaluation: what remains",
            r"$\alpha$ is half a unit of $u \pm \varepsilon$; $\eta$ follows from the certified sine",
            uses=_rounding,
        ),
    ),
    expected="measured",
)

_orders = ("truncation_bound", "clamped_difference", "clamped_difference_of_odd", "crease_error_area")

slopes = Theorem(
    id="difference_slopes",
    title="The orders of the difference, fitted",
    statement=r"Fitted within 0.02: the truncation error falls like $\varepsilon^2$; clamped at the pole at "
    r"$v = \varepsilon/2$ it still does for the chapter's fields, and like $\varepsilon$ for $\cos\pi k_v v$; the RMS "
    r"error of ridges over the chart falls like $\sqrt\varepsilon$, with the theorem's constant within 2 %.",
    hypotheses=("the RMS by Gauss–Legendre quadrature between the creases and the ends of their bands",),
    steps=(Step("2; at the pole 1, where odd 2; ½", "as proved", uses=_orders),),
    expected="measured",
)
