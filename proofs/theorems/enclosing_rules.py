"""The rules by which the enclosing machine bounds its results: theorems about its own float64 operations."""

from proofs.formulas.enclosed import RULES
from proofs.theorems.language import *

x_error, y_error, x_exact = real("x_error y_error x_exact")
_few = x_error <= Pow(2, 60), y_error <= Pow(2, 60)


def not_tiny(number: Expr) -> Basic:
    """Return that a number is 0 or above 10⁻²⁸⁵, in size."""
    return Or(equation(number, 0), Abs(number) * Pow(10, 285) >= 1)


_exponent = y * 2**10 >= 1, y <= 2**19, y_error <= 2**51 * y
_in_two = *_few, Abs(x * y) <= Pow(2, 21), not_tiny(x * y)

_rules = [
    Encloses(name, RULES[f"enclosed_{name}"], given)
    for name, given in {
        "sum": (),
        "product": _few,
        "quotient": (Abs(y) <= Pow(2, 960), Abs(y) - y_error * (1 + Pow(2, -19)) * Pow(2, -53) >= Pow(2, -59)),
        "root": (x >= 0, x_exact >= 0),
        "floor": _few[0],
        "nearest": _few[0],
        "selection": (),
        "sine": _in_two,
        "cosine": _in_two,
        "angle": x**2 + y**2 >= Pow(2, -10),
        "exponential": (x <= 704, x_error <= Pow(2, 55), not_tiny(x)),
        "logarithm": (x <= Pow(2, 1000), x_error <= Pow(2, 52) * x, x * Pow(10, 285) >= 1),
        "power": (x >= 0, x_exact >= 0, y * (x + x_error / 2**52 - 1) <= 32, not_tiny(x + x_error), *_exponent),
    }.items()
]

LIMITS = (
    "nothing overflows; of a product, sine, cosine, floor and nearest number the counts are at most $2^{60}$; "
    "neither what a root or a power is of nor what that stands for is negative",
    r"the divisor of a quotient, at most $2^{960}$, is $2^{-59}$ further from 0 than $1 + 2^{-19}$ times its bound",
    r"of a sine and a cosine $|xy| \le 2^{21}$, of an exponential $x \le 704$ and a count of at most $2^{55}$; of "
    "these three what is not 0 is at least $10^{-285}$",
    r"of an angle $x^2 + y^2 \ge 2^{-10}$",
    r"of a logarithm $10^{-285} \le x \le 2^{1000}$ and a count of at most $2^{52} x$",
    r"of a power $2^{-10} \le y \le 2^{19}$ and a count of at most $2^{51} y$; where $x$ has the count $n$, "
    r"$y(x + n/2^{52} - 1) \le 32$, and $x + n$ is 0 or at least $10^{-285}$; a power of 0 is 0, and in float64 one "
    r"below $2^{-1020}$ may be",
    r"of a sine and a cosine of which a factor stays exact, one factor is an exact 0, or both are exact, or what moves "
    r"the product counts at least $2^{-900}$; of an angle of two numbers without a count $y \ne 0$ or $x \ge 0$; in "
    "programs an exponential, a logarithm and the base of a power are of numbers with a count",
    "of a program all this of what its result needs: not of a side that a selection leaves out for certain",
    r"a literal has 53 bits, from $2^{-1074}$ on; below $2^{-1022}$ a rounding counts $2^{-1007}$; a count is made "
    r"a bound by $1048577/9444732965739290427392 = 2^{-53} + 2^{-73}$; $2^{10} = 1024$, $2^{19} = 524288$, $2^{53} = "
    r"9007199254740992$, $2^{59} = 576460752303423488$",
    r"counts take $7074237752028453/2251799813685248$ for $\pi(1 + 2^{-49})$, $562949953421313/562949953421312 = 1 + "
    r"2^{-49}$ for a bound's roundings, and for a function's own of a sine and a cosine "
    r"$5674535530486825/10141204801825835211973625643008$ of it and $2^{-1060}$, of a power 3 roundings, or below "
    r"$2^{-72}$ $6209337986237071/281474976710656$, and $2^{-1020}$",
)

theorem = Theorem(
    "enclosing_rules",
    "The rules of the enclosing machine",
    {
        r"""A number is within $n$ roundings, of $2^{-53}$ each, of what it stands for, and $n$ is counted in float64.
        By the machine's rules the float64 results of a sum $x + y$, product $xy$, quotient $x/y$, root $\sqrt x$, floor
        $\lfloor x \rfloor$, of the whole number nearest to $x$, of a sine $\sin\pi xy$, cosine $\cos\pi xy$, angle
        $\operatorname{atan2}(y, x)/\pi$, exponential $e^x$, logarithm $\ln x$, power $x^y$ and of a selection by
        $x < y$ are within their counts of the exact results, if the counts before are. Each operation makes a count too
        small by $2^{-49}$ of it at most, and $2^{28}$ of them, one after the other, by less than
        $3\cdot2^{-22}$.""": _rules,
        r"""So of every program of at most $2^{28}$ such operations, with selections by any condition: whatever float64
        computes is within the bound that the machine counts with it, and no divisor that this needs is 0. The machine
        finds numbers that stay exact: it counts 0 for a product with an exact 0, for an angle on an axis, and for the
        rounding of a sine or cosine that is 0; to a power with an exact exponent, one end of that.""": coq(
            "enclosing_rules__whole_programs ae1941201d5c1543"
        ),
    },
    hypotheses=LIMITS,
    rounded=_rules,
    steps={
        "what is inherited": r"$|ab - a'b'| \le |a||b - b'| + |b'||a - a'|$, and its like",
        "an angle turns": r"by $\arctan|xy' - x'y|/(xx' + yy')$, over no cut",
        "a power lies between its values at four ends": "the ends of what $x$ can be, with those of $y$",
        "a result's own rounding is at most one": r"of $2^{-53}$ of its size; below $2^{-1022}$, less than $2^{-1074}$",
        "the count's own roundings": r"at most eight factors $1 - 2^{-53}$",
    },
)
