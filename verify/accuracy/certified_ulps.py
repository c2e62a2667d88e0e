"""Certified errors of our elementary functions, in units in the last place, over their whole reduced range.

The range is cut into pieces. On each the error is at most that of the polynomial, as it stands with its float64
coefficients, plus that of the rounded lines. The polynomial is compared with the function's series term by term, so
that nothing cancels; the lines go through `verify.evaluate.rounding`. Every number is a ball or its upper end.

The reduction before it is exact (Sterbenz), but for one rounding where product_error is added. Below 2^-12 the lines
scale with their argument, but for its square, which is enclosed down to 0: the piece that ends there stands for all
smaller ones, down to where a product underflows. exp, log and power are in `verify.accuracy.exponential_ulps`.
"""

import math
from collections.abc import Callable
from functools import cache, partial
from itertools import pairwise

import numpy as np
from flint import arb, arb_series, ctx

from proofs.engine.program import Program, chain
from proofs.formulas import elementary as e
from renderer import kernels
from verify.accuracy.exponential_ulps import exponential_pieces, logarithm_pieces, power_pieces
from verify.accuracy.pieces import FIRST, PRECISION, SMALLEST, Piece, Series, ball, lines, piece_ends
from verify.evaluate import code_of
from verify.evaluate.balls import BALLS
from verify.evaluate.rounding import ZERO, Rounded, between, run

SMALL = 50  # a power below exp(−50) is a small one


def error_in_ulps(computed: float, exact: arb) -> float:
    """Return |computed − exact ball| in units in the last place of exact; infinite for a missed zero."""
    if exact.is_zero():
        return 0.0 if computed == 0 else math.inf
    return float(abs(arb(computed) - exact).mid()) / math.ulp(float(exact.mid()))


def errors_in_ulps(name: str, *arguments: np.ndarray) -> np.ndarray:
    """Return the errors of what PIECES names at float64 arrays of one shape."""
    kernel, of_product = name.removeprefix("small_").removesuffix("_of_product"), name.endswith("_of_product")
    computed = getattr(kernels, kernel)(*(kernels.two_product(*arguments) if of_product else arguments))

    def exactly(*case):
        balls = [arb(number) for number in case]
        return BALLS[kernel](*([math.prod(balls)] if of_product else balls))

    with ctx.workprec(200):
        exact = np.frompyfunc(exactly, len(arguments), 1)(*arguments)
        return np.frompyfunc(error_in_ulps, 2, 1)(computed, exact).astype(float)


@cache
def sine_pieces(cosine: bool = False, of_product: bool = False, program: Program = e.sine_of_half_turns) -> list[Piece]:
    """Return the Pieces of the sine's polynomial (or the cosine's) over the reduced argument, 0 ≤ r ≤ 1/4.

    of_product: the argument has been rounded once, as it is after `two_product`.
    """
    near = e.cosine_near if cosine else e.sine_near
    with ctx.workprec(PRECISION):
        code = code_of(lines(program, after=[*e.reduction][:4], until=(near,)))
        function = arb_series.cos_pi if cosine else arb_series.sin_pi
        series = Series(program.expand(near, until=(e.remainder,)), e.remainder, function)
        end = arb(2) ** -2 + arb(2) ** -30  # |product − quarters/2| ≤ 1/4, and |product_error| < 2^-30
        cuts = () if cosine else [(arb(2) ** -n).asin() / arb.pi() for n in range(1, 2 - SMALLEST)]
        return [
            _sine_piece(code, series, near.name, low, high, cosine, of_product)
            for low, high in pairwise(piece_ends(FIRST, end, cuts))
        ]


def _sine_piece(code, series, near, low, high, cosine, of_product):
    smallest = high <= 2 * FIRST
    ends = (ZERO if smallest and cosine else low, high)
    r = between(*ends) * (1 + arb(0, arb(2) ** -52 if of_product else 0))  # as it is after rounding
    true = [end.cos_pi() if cosine else end.sin_pi() for end in ends]
    steepest = arb.pi() * (high.sin_pi() if cosine else ends[0].cos_pi()).abs_upper()
    moved = steepest * Rounded(r, rounds=of_product, ends=ends).error
    known = {"z": (0 if smallest else r.lower() ** 2, r.upper() ** 2), near: (*true, series.error(r) + moved)}
    return Piece(low, high, run(code, {"remainder": Rounded(r)}, known)[near].ulps())


@cache
def half_turn_pieces(cosine: bool, of_product: bool = False, **changed: Program) -> list[Piece]:
    """Return the Pieces of sinpi (or cospi) over 0 ≤ x ≤ 1/2 (the rest by symmetry).

    Beyond a quarter the polynomial is the other one, of 1/2 − x.
    """
    own, other = (sine_pieces(polynomial, of_product, **changed) for polynomial in (cosine, not cosine))
    return own + [Piece(0.5 - piece.high, 0.5 - piece.low, piece.ulps) for piece in other]


@cache
def angle_pieces(program: Program = e.angle_in_half_turns) -> list[Piece]:
    """Return the Pieces of atan2pi over t = smaller/larger, 0 ≤ t ≤ 1: the worst of the eight octants."""
    with ctx.workprec(PRECISION):
        compared = [program[s].args[0][1] for s in (e.middle, e.steep)]  # smaller > c · larger
        first, second = (ball(relation.lts.coeff(e.larger)) for relation in compared)
        slack = arb(2) ** -52  # the comparison's product is rounded
        cuts = [(arb.pi() / 2**n).tan() for n in range(3, 3 - SMALLEST)]
        arcs = [
            (0, 0, piece_ends(FIRST, first * (1 + slack), cuts)),
            (1, 0, piece_ends(first * (1 - slack), second * (1 + slack), cuts)),
            (1, 1, piece_ends(second * (1 - slack), arb(1))),
        ]
        analysis = _Angle(program)
        return [
            analysis.piece(low, high, middle, steep) for middle, steep, ends in arcs for low, high in pairwise(ends)
        ]


class _Angle:
    """The lines of atan2pi in three parts: to the ratio, to the angle in the first octant, to the angle."""

    MANTISSAS = 8

    def __init__(self, program):
        given = (e.larger, e.smaller, e.middle, e.steep)
        self.to_node = code_of(lines(program, given, (e.node, e.node_value, e.node_correction)))
        self.to_ratio = code_of(lines(program, given, (e.ratio,)))
        self.to_octant = code_of(lines(program, (*given, e.node, e.ratio), (e.first_octant,)))
        self.octants = [code_of(self._decided(program, *choice)) for choice in ((0, 0), (0, 1), (1, 0), (1, 1))]
        arctangent = program.expand(e.small_part, until=(e.ratio, e.node_correction)) - e.node_correction
        self.series = Series(arctangent, e.ratio, lambda t: t.atan() / arb.pi())

    @staticmethod
    def _decided(program, *branches):
        """Return the last lines with the octant chosen: 0 the reflection, 1 the value as it is."""
        chosen = zip((e.first_quadrant, e.half_plane), branches, strict=True)
        return chain("octant", {s: program[s].args[branch][0] for s, branch in chosen})

    def piece(self, low, high, middle, steep):
        smallest = high <= 2 * FIRST
        choice = {"middle": Rounded(middle), "steep": Rounded(steep)}
        selected = run(self.to_node, dict(choice))
        node, value, correction = (selected[name].value for name in ("node", "node_value", "node_correction"))
        ends = [(end - node) / (1 + node * end) for end in (low, high)]
        ratio = Rounded(between(*ends), self._ratio_error(low, high, choice, ends), ends=ends)
        true = [end.atan() / arb.pi() for end in (low, high)]
        off = (correction - (node.atan() / arb.pi() - value)).abs_upper()
        small = [end - value for end in true]
        known = {"small_part": (*small, self.series.error(ratio.value) + off), "first_octant": true}
        if smallest:
            known["ratio_squared"] = (0, high**2)
        scope = run(self.to_octant, choice | {"ratio": ratio, "node": Rounded(node)}, known)
        return Piece(low, high, max(self._octants(scope["first_octant"], smallest)))

    def _octants(self, octant, smallest):
        """Return the ulps of the angle in the four octants above the axis; the others are their mirror images."""
        for number, code in enumerate(self.octants):
            low = ZERO if smallest and number < 3 else octant.smallest
            start = Rounded(between(low, octant.largest), octant.error, ends=(low, octant.largest))
            ends = [run(code, {"first_octant": Rounded(end)})["half_plane"].value for end in (low, octant.largest)]
            yield run(code, {"first_octant": start}, {"half_plane": ends})["half_plane"].ulps()

    def _ratio_error(self, low, high, choice, ends):
        """Return how far the rounded ratio can be off, whatever the mantissa of `larger`."""
        worst, t = ZERO, between(low, high)
        for i in range(self.MANTISSAS):
            larger = between(1 + arb(i) / self.MANTISSAS, 1 + arb(i + 1) / self.MANTISSAS)
            sides = choice | {"larger": Rounded(larger), "smaller": Rounded(t * larger)}
            worst = max(worst, run(self.to_ratio, sides, {"ratio": ends})["ratio"].error)
        return worst


def moderate_power_pieces() -> list[Piece]:
    """Return those of what is at least e^-SMALL."""
    return [piece for piece in power_pieces() if piece.high <= SMALL]


PIECES: dict[str, Callable[..., list[Piece]]] = {
    "sinpi": partial(half_turn_pieces, False),
    "cospi": partial(half_turn_pieces, True),
    "sinpi_of_product": partial(half_turn_pieces, False, True),
    "cospi_of_product": partial(half_turn_pieces, True, True),
    "atan2pi": angle_pieces,
    "exp": exponential_pieces,
    "log": logarithm_pieces,
    "power": moderate_power_pieces,
    "small_power": power_pieces,
}
"""{name: what returns the pieces of its range}"""


def at(name: str, points: np.ndarray, other: np.ndarray) -> tuple[np.ndarray, ...]:
    """Return arguments of a kernel at points of its pieces; other: positive numbers, for what a point leaves open."""
    if name == "atan2pi":
        return points * other, other
    if name.endswith("_of_product"):
        return points / other, other
    return (np.exp(-other), points / other) if name.endswith("power") else (points,)


def errors_on_pieces(name: str, points: np.ndarray) -> np.ndarray:
    """Return the errors in ulps at an array of points of the pieces; what they leave open is drawn, always the same."""
    return errors_in_ulps(name, *at(name, points, np.random.default_rng(3).uniform(1, 2, points.shape)))
