"""One program, two ways to run it: float64 and balls agree to rounding. Bits: `tests/test_machines.py`."""

from itertools import product

import numpy as np
import pytest
from flint import arb
from sympy import Or, Piecewise, sign, sqrt

from proofs.engine.program import chain
from proofs.engine.vectors import real
from proofs.formulas.finite_difference import METHODS
from proofs.formulas.height_fields import HEIGHT_FIELDS
from renderer import Scene, kernels
from renderer.generate import programs
from renderer.shader.shader import difference
from verify.evaluate.arrays import in_balls
from verify.evaluate.balls import Balls
from verify.reference import Undecided, reference_pixel

POINTS = 8
RANGES = {
    "eye": (3, 5), "radius": (0.5, 1), "ball_radius": (0.3, 0.5), "height": (64, 65), "width": (96, 97),
    "column": (0, 95), "row": (0, 63), "ball_on": (1, 1), "floor_on": (1, 1), "apex_height": (6, 9),
    "k_u": (-9, 9), "k_v": (-9, 9), "u": (0, 1), "v": (0, 1), "eps": (0.01, 0.05), "shininess": (0.5, 40),
    "specular_base": (0, 1), "product_error": (-1e-17, 1e-17), "number": (0, 2), "exponent": (0.001, 40),
}  # fmt: skip
EDGES = {"u": (0.0, 1 - 2.0**-53, 2.0**-10), "v": (0.3, 0.0, 1.0, 2.0**-10)}  # the seam and the poles


def difference_kernel(field, method):
    """Return a difference as a function of the chart point, the wave numbers and ε."""
    return lambda u, v, k_u, k_v, eps: difference(field, method, u, v, k_u, k_v, eps)


PRINTED = {name: (program, getattr(kernels, name)) for name, program in programs.named().items()} | {
    f"{method}_{name}": (program_of(HEIGHT_FIELDS[name]).at(programs.STEP), difference_kernel(field, method))
    for (name, field), (method, program_of) in product(kernels.FIELDS.items(), METHODS.items())
}
"""{name: (program, kernel)} of everything in renderer/kernels.py, a field's differences of its height"""


def random_inputs(program):
    """Return {name: array of POINTS} for a program's inputs, in its domain, the chart's edges among them."""
    rng = np.random.default_rng(len(program.name))
    theta, phi = rng.uniform(-np.pi, np.pi, POINTS), rng.uniform(0.01, np.pi - 0.01, POINTS)
    angles = {"cos_theta": np.cos(theta), "sin_theta": np.sin(theta), "cos_phi": np.cos(phi), "sin_phi": np.sin(phi)}
    values = {
        name: angles.get(name, rng.uniform(*RANGES.get(name, (-1, 1)), POINTS)) for name in map(str, program.inputs)
    }
    for coordinate, edges in EDGES.items():
        if coordinate in values:
            values[coordinate][: len(edges)] = edges
    return values


@pytest.mark.parametrize("name", PRINTED)
def test_balls_agree(name):
    """float64 against 256 bits: 1e-11, or what a difference of step ε ≥ 0.01 amplifies it to."""
    program, kernel = PRINTED[name]
    inputs, reference = random_inputs(program), Balls(program)
    with np.errstate(all="ignore"):
        outputs = kernel(*inputs.values())
    outputs = outputs if isinstance(outputs, tuple) else (outputs,)
    for point in range(POINTS):
        truth = reference({name: float(values[point]) for name, values in inputs.items()}, 256)
        for symbol, output in zip(program.outputs, outputs, strict=True):
            expected, ours = float(truth[symbol.name]), np.broadcast_to(output, POINTS)[point]
            assert ours == pytest.approx(expected, rel=1e-11, abs=1e-11, nan_ok=True), symbol


# Programs in balls say what they cannot decide

a, b, c, d = real("a b c d")
WIDE = {"a": arb(0, 1), "b": arb(0.5)}
LINES = [
    (Piecewise((1, Or(a < b, b > 0)), (5, True)), WIDE, (1,)),
    (sign(a), WIDE, (-1, 1)),
    (sign(a), {"a": arb(0)}, (0,)),
    (sqrt(a), {"a": arb(0, 4)}, (2,)),
]
"""[(a line, the balls of its inputs, what its ball contains)]: where that is one number, it is decided."""


@pytest.mark.parametrize("expression, values, contained", LINES)
def test_what_is_not_decided_is_enclosed(expression, values, contained):
    ball = Balls(chain("line", {d: expression}))(values, 53)["d"]
    assert all(ball.contains(number) for number in contained)
    assert ball.is_exact() == (contained in ((0,), (1,)))


def test_a_ball_that_decides_nothing_is_no_reference():
    """1/(a − b) with a = b = 1/3: the ball of the difference contains 0, so that of the quotient is all numbers."""
    lines = chain("lines", {c: 1 / (a / 3 - b / 3), d: a * b}, outputs=(c, d))
    assert [ball[0] is None for ball in in_balls(lines, {"a": [1.0], "b": [1.0]}).values()] == [True, False]


def test_a_pixel_on_the_silhouette_is_undecided():
    """ρ = ρ_s = 3.75: the discriminant is 0, so that its computed sign is noise at any number of digits."""
    scene = Scene(eye=5.0, radius=3.0, ball=False)
    with pytest.raises(Undecided, match=r"column = 10, row = 0: surface, rgb_red.* undecided at 100 digits"):
        reference_pixel(scene, 21, 20, 10, 0, digits=100)
    with pytest.raises(Undecided, match="column = 10, row = 9: rgb_red, rgb_green, rgb_blue undecided"):
        reference_pixel(scene, 21, 20, 10, 9)  # on a crease
    assert reference_pixel(scene, 21, 20, 11, 1)["surface"] == 1
