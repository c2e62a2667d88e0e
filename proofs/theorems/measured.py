"""Statements about float64's programs, the seed's formulas and pictures: measured, enclosed, or pinned.

The measurements are in verify/measurements."""

from proofs.formulas.certified import ALGEBRAIC_GRADIENT, GENERAL_GRADIENT, POWER_RATE, PROVED, SINE
from proofs.formulas.height_fields import gradient
from proofs.theorems.enclosing_rules import LIMITS, not_tiny
from proofs.theorems.language import *

products = Theorem(
    "crease_products",
    "A rounded product puts points on a crease",
    r"""Of the 1,824 float64 numbers nearest to some $m/k$, $0 < m < k \le 64$, that are not $m/k$ itself, the
    rounded product $k u$ is a whole number for 1,756: sine reduced in half-turns then takes the point to be on
    the crease. With the product exact it takes none.""",
    hypotheses=(
        "every $k$ and $m$, exhaustively: counted in fractions and by floats",
        "the heights are those of the kernel that draws",
    ),
    expected="certified",
)

contrast = Theorem(
    "crease_contrast",
    "The error at the creases, against the rest",
    r"""In the default scene at $256^2$ and $\varepsilon = 10^{-3}$ the mean error where the kink flag is set is
    four orders of magnitude, within $0.5$, above that elsewhere on A, not one.""",
    hypotheses="""the pictures of exact arithmetic, by the bounds that both are drawn with, which are taken to hold
    (pixel_accuracy); the flags as they are drawn""",
    expected="certified",
)

dark = Theorem(
    "dark_difference",
    "The difference canvas stays dark",
    r"""In the default scene at $256^2$ the largest $|\Delta I| \times 100$ on A, over half an 8-bit level, is
    at most $1$ at $\varepsilon = 10^{-8}$, $10^{-9}$ and $10^{-10}$: a canvas with that gain is black there.""",
    hypotheses=("linear light", "float64's two pictures: each of A's pixels and channels, exactly"),
    expected="certified",
)

pole = Theorem(
    "pole_accuracy",
    "The printed frame and chart toward the pole",
    r"""In float64 the vector $g$ of the default field, by the seed's $\sin\varphi = \sqrt{1-N_z^2}$ and $v =
    \arccos(N_z)/\pi$, is off by more than $10^{-7}$ near $\sin\varphi = 10^{-4}$, by more than $10^{-3}$ near
    $6\cdot10^{-7}$ without the fallback, and by more than 20 with it; from $\rho$ and $t$ by less than
    $10^{-12}$.""",
    hypotheses=(
        "the largest of 200 points near each latitude, against 50 digits; the seed's forms with libm",
        "measured, since nothing is proved of libm's functions, which differ from machine to machine",
    ),
    expected="measured",
)


pixels = Theorem(
    "pixel_accuracy",
    "A pixel against the reference",
    {
        r"""Every channel of a pixel is within the bound that is counted with it of its exact value: by the program that
        is recorded from the shader, for every field, bump and model, and up to five lights.""": coq(
            "pixel_accuracy__recorded 8486f1dd97b8d06e"
        ),
        r"""Coq itself finds how far a channel can be off, without the machine: at ten pixels of the default scene, each
        in a chamber of its own, by at most $18\cdot10^{-14}$; and by at most $100\cdot10^{-14}$ over a range of scenes,
        whatever their colours and reflections, at ten pixels of these chambers and, by the slopes of *sine*, *ridges*
        and *rings* and by each model, at six of A.""": coq("pixel_accuracy__computed a49ff26b27e7c69e"),
    },
    hypotheses=(
        *LIMITS,
        "float64 numbers; all this of what the channel needs; whole powers are recorded as the default scene's: of "
        "others the bounds are measured",
        r"the scene's numbers are within their bounds, a constant $m\,2^e$ of $d$ bits within $2^{d+e-54}$, half of "
        r"its last digit; what is missed is $2^{1023}$ away; the pixels are of $256^2$",
        r"of the range colours, $k_a$, $k_d$ and $k_s$ are from 0 to 1, $\beta$ from $0.3$ to $0.4$, coordinates of "
        r"lights up to $2^{-5}$ from the default scene's, places up to $2^{-11}$ from the centres of the ten pixels; "
        r"slopes are off by at most $2^{-44}$, products of two colours by $2^{-51}$, and shadows lie in boxes whose "
        r"ends are within $2^{-4}$ of the default scene's; no light is black, $k_s > 0$; $100\cdot10^{-14} = 10^{-12}$",
    ),
    expected="proved",
)


def _slopes_in_float64(field, rates):
    """Return the claim that Coq proves of a field's general form: each slope, and the rate in its error's bound."""
    program, given = gradient(field), []
    near = {slope: GENERAL_GRADIENT * Pow(2, -53) * (pi * Max(1, Abs(rate))) for slope, rate in rates.items()}
    for coordinate, rate in ((u, k_u), (v, k_v)):
        if coordinate in program.reaches(*rates):
            given = [*given, coordinate >= 0, coordinate <= 1, Abs(rate) <= 2**20, not_tiny(rate * coordinate)]
    return Rounded(field.name, program, near, given)


gradients = Theorem(
    "gradient_accuracy",
    "The general form of the exact gradient against the reference",
    rf"With $\mu = 2^{{-53}}$, the general form is within ${GENERAL_GRADIENT}\mu\,\pi\max(1,|k|)$ of the "
    r"exact gradient of sine, ridges and rings at the float64 $(u, v)$: $k = k_u$ for $h_u$, $k_v$ for $h_v$, for "
    r"rings $2k_v$, of sizes up to $2^{20}$.",
    hypotheses=(
        r"$0 \le u, v \le 1$; $k_u u$ and $k_v v$ are 0 or, in size, at least $10^{-285}$",
        "of another field no bound is claimed",
        "nothing overflows",
    ),
    rounded=(
        [_slopes_in_float64(field, {h_u: k_u, h_v: k_v}) for field in (sine, ridges)],
        _slopes_in_float64(rings, {h_v: 2 * k_v}),
    ),
    steps={
        r"$k_u u = p + e$ exactly": "Dekker's product",
        r"$\sin\pi k_u u$ and $\cos\pi k_u u$ are off by $3.289\mu$": "exact reduction; two polynomials; quadrant",
        r"$\pi$ is off by $0.36\mu$ of itself; three products": "each rounds once",
        r"ridges: the side of a crease is never wrong": "no rounding changes the reduced argument's sign",
    },
)

algebraic_gradients = Theorem(
    "algebraic_gradient_accuracy",
    "What the algebraic form of the gradient can be off",
    rf"With $\mu = 2^{{-53}}$, the algebraic form is within ${ALGEBRAIC_GRADIENT}(1+k)\mu\,\pi k$ of the "
    r"exact gradient at the float64 image point, $k = \max(|k_u|,|k_v|) \le 64$, for rings $2|k_v|$.",
    hypotheses=(
        r"$1-(\rho/\rho_s)^2 \ge 0.1$; $R/e$ from $10^{-6}$ to $1-10^{-9}$; off the pole, and nothing underflows",
        r"ridges: $|\sin\pi k_u u|$ and $|\sin\pi k_v v|$ are above "
        rf"${ALGEBRAIC_GRADIENT}(1+k)\mu$, so that the side of every crease is "
        "certain; nearer than that the form may take the other one's slope",
    ),
    steps={
        r"$\cos\theta$, $\sin\theta$ are off by $4.1\mu$ of themselves, $\cos\varphi + i\sin\varphi$ by $44\mu$": (
            r"A's lines on intervals, over every box of $R/e$ and $\rho/\rho_s$"
        ),
        r"the powers $\tfrac12|k_u|$ and $|k_v|$, and their product with $\pi k$, four roundings": (
            r"$(1+\mu)^4A_uA_v-1$, for every pair of wave numbers",
            "rounded_powers",
            "algebraic_gradient",
        ),
    },
    expected="certified",
)

differences = Theorem(
    "difference_bounds",
    "The U-curve lies below its bounds",
    {
        r"""Float64's central difference of sine is within $\frac{\varepsilon^2}6L^3 + L\frac{u+\varepsilon}{2^{53}
        \varepsilon}(1+\kappa) + \frac8{2^{53}\varepsilon}(1+\kappa) + L\kappa$ of $h_u$, $L = \pi k_u$, $\kappa =
        2\cdot2^{-53} + (2^{-53})^2$: truncation, arguments, evaluation. So it is of $h_v$, with $v$ and $k_v$;""": coq(
            "difference_bounds__in_float64_u 6e7feebcedee12f7", "difference_bounds__in_float64_v 976baf659203cc91"
        ),
        "so are those of ridges, where both samples are on the point's side of each crease, and that of rings with "
        "$2k_v$.": coq("difference_bounds__rings_in_float64 071b8e71eb62816e"),
        r"""Clamped at the pole it is within $\frac{16/w + 2L}{2^{53}}(1+\kappa') + L\kappa'$, $w = v + \varepsilon$,
        $\kappa' = \frac{3\cdot2^{-53} + (2^{-53})^2}{1 - 2^{-53}}$, of the exact difference.""": coq(
            "difference_bounds__clamped_in_float64 8d6cd2910a267ab4"
        ),
        r"""Beside the seam sine's $h_u$, for even $k_u > 0$, is within $L\frac4{2^{53}\varepsilon}(1+\kappa) +
        \frac8{2^{53}\varepsilon}(1+\kappa) + L\kappa$ of the exact difference.""": coq(
            "difference_bounds__seam_in_float64 40ee5136e04e8e98"
        ),
    },
    hypotheses=(
        r"""$u$, $v$, $\varepsilon$, $k_u$, $k_v$ are float64 numbers, the wave number above 0; of the first
        two sentences $0 < \varepsilon \le u$, $\mathrm{fl}(u + \varepsilon) < 1$, or $0 < \varepsilon \le v \le 1 -
        \varepsilon$; of the third $0 \le v < \varepsilon$, $v + \varepsilon \le 1$; of the last $0 \le u \le 1$, $0 <
        \varepsilon \le 1$""",
        r"a wave number times a coordinate is 0 or at least $2^{-969}$, and at most $2^{21}$, in size",
    ),
    steps={
        "the exact quotient less the slope": ("a third derivative", "truncation_bound"),
        "arguments and evaluation: what remains": (
            r"$\alpha$ is half a unit of $u \pm \varepsilon$; $\eta$ is that of two sines and their product",
            ("roundoff_bound", "elementary_functions"),
        ),
    },
)

slopes = Theorem(
    "difference_slopes",
    "The orders of the differences",
    {
        r"""With $E(\varepsilon)$ for difference less slope, $E/\varepsilon^p$ tends to a coefficient $C$ as
        $\varepsilon \to 0$, and where $C \ne 0$ the slope of $\ln|E|$ against $\ln\varepsilon$, from $\varepsilon$ to a
        fixed multiple of it, tends to $p$: of the central difference $p = 2$, $C = \frac16h'''$;""": coq(
            "difference_slopes__central ee62e222f1342514"
        ),
        r"of the forward and the backward one $p = 1$, $C = \pm\frac12h''$;": coq(
            "difference_slopes__forward 9a95406298b53e88"
        ),
        r"of that of fourth order $p = 4$, $C = -\frac1{30}$ times the fifth derivative.": coq(
            "difference_slopes__fourth 617f9ab7b7c8c288"
        ),
        r"""Clamped at the pole at $v = r\varepsilon$, $0 \le r < 1$, $p = 1$ and $C = \frac{1-r}2h''(0)$; where
        $h''(0) = 0$, as of odd fields, $p = 2$ and $C = \frac{1+2r-2r^2}6h'''(0)$.""": coq(
            "difference_slopes__clamped 076e456cf4d49962"
        ),
    },
    hypotheses=(
        "$h$ has the derivatives before the last that is named everywhere, and that one at the point",
        r"fourth order: the weights 8, −8, −1, 1 over $12\varepsilon$",
    ),
    steps={
        r"$F(\varepsilon)/\varepsilon^{n+1}$ tends to $L/(n+1)$ where $F(0) = 0$ and $F'/\varepsilon^n$ tends to $L$": (
            "Cauchy's mean value theorem, as often as there are derivatives"
        ),
        r"$\ln|E| = p\ln\varepsilon + \ln|E/\varepsilon^p|$": "the last part tends to $\\ln|C|$",
        "the RMS error of ridges": ("its limit's bound", "crease_error_area"),
    },
)


functions = Theorem(
    "sine_of_half_turns",
    "The sine and cosine of the kernels, in size",
    rf"""With $\mu = 2^{{-53}}$, the kernels' float64 $\sin\pi(ku)$ and $\cos\pi(ku)$ of an exact product are off by at
    most ${float(SINE)}\mu$.""",
    hypotheses=(
        "round to nearest; nothing underflows or overflows",
        r"""the whole range: $|r| \le \frac14 + 2^{-30}$ after the reduction, which is exact but for the rounding of
        $r$""",
    ),
    steps={
        "sine and cosine, over pieces of $r$": """the rounding of each line, the polynomial against the function's
        series, term by term, and the rounding of $r$"""
    },
    expected="certified",
)

_of = {name: float(most) for name, most in PROVED.items()}

relative = Theorem(
    "elementary_functions",
    "The elementary functions of the kernels",
    {
        rf"""With $\mu = 2^{{-53}}$, the kernels' float64 $\sin\pi(ab)$ and $\cos\pi(ab)$ of an exact product have a
        relative error of at most ${_of["of_product_relative"]}\mu$,""": coq(
            "elementary_functions__of_product_relative 784cb2b40e9bfb06"
        ),
        rf"$e^{{x+y}}$ of at most ${_of['exp']}\mu$": coq("elementary_functions__exp 157fef027a525886"),
        rf"and $\ln x$ of at most ${_of['log']}\mu$,": coq("elementary_functions__log 0a64b8b999e3816f"),
        rf"$x^p$ of at most $({_of['power']} + {float(POWER_RATE)}\,|p\ln x|)\mu$,": coq(
            "elementary_functions__power bd4612207f391409"
        ),
        rf"and $\operatorname{{atan2}}(y, x)/\pi$ of at most ${_of['atan2pi']}\mu$.": coq(
            "elementary_functions__atan2pi 8fdf7f947033ac01"
        ),
    },
    hypotheses=(
        "arguments are float64 numbers, but for $y$ of $e^{x+y}$",
        r"""$ab$ is 0 or at least $2^{-969}$ in size, and at most $2^{21}$; of it another $2^{-1074}$, of $\ln
        x$ $2^{-896}$""",
        r"$-708 \le x \le 709$, $|y| \le 2^{-42}$ of $e^{x+y}$; $0 < x \le 2^{1024} - 2^{971}$ of $\ln x$ and $x^p$",
        r"$1/2048 \le p \le 2^{20}$, $-707.99 \le p\ln x \le 708.99$; $\max(|x|, |y|) \ge 2^{-1018}$ of the angle",
    ),
)
