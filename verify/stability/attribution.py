"""Where the error of a central difference comes from, pixel by pixel: which of its terms is the largest.

computed − derivative = (exact quotient − derivative) + (quotient at the rounded arguments − exact quotient)
+ (computed − quotient at the rounded arguments). The first is truncation, unless a crease lies within ε (straddling)
or v ± ε leaves the chart (one-sided). The second is what rounding u ± ε costs, the third the rounding of h.
"""

import numpy as np

from proofs.engine.program import Program
from proofs.formulas.creases import straddling
from proofs.formulas.finite_difference import central
from proofs.formulas.height_fields import HEIGHT_FIELDS, gradient
from proofs.formulas.symbols import epsilon, h_u, h_v
from renderer import central as central_difference
from renderer import gradient_at
from verify.evaluate.arrays import in_balls, in_float64

TERMS = ("truncation", "argument rounding", "roundoff", "straddling", "one-sided")
_MOVED = ("u_plus", "u_minus", "v_plus", "v_minus", "span_v")


def _split(field):
    """Return the program of a central difference in two: where it samples, and the quotient of given samples."""
    whole = central(field)
    moved = tuple(s for s, _ in whole.definitions if s.name in _MOVED)
    where = Program("moved", whole.inputs, tuple(d for d in whole.definitions if d[0] in moved), moved)
    lines = tuple(d for d in whole.definitions if d[0] not in moved)
    return where, Program("quotient", (*whole.inputs, *moved), lines, (h_u, h_v))


def _number(balls):
    return np.array([np.nan if b is None else float(b.mid()) for b in np.ravel(balls)])


def _minus(a, b):
    return np.array([np.nan if p is None or q is None else float((p - q).mid()) for p, q in zip(a, b, strict=True)])


def terms(scene, u, v, eps):
    """Return (values, kinds): for each point of the chart the six signed terms, (6, n), and their kinds, (6, n).

    Rows: h_u's three terms, then h_v's. Kinds index TERMS.
    """
    field = HEIGHT_FIELDS[scene.field]
    inputs = {"u": u, "v": v, "k_u": scene.ku, "k_v": scene.kv, epsilon.name: eps}
    where, quotient = _split(field)
    moved = in_float64(where, inputs)
    moved["span_v"] = np.where((v + eps <= 1) & (v - eps >= 0), 2 * eps, moved["span_v"])
    right, exact = in_balls(gradient(field), inputs), in_balls(central(field), inputs)
    rounded = in_balls(quotient, inputs | moved)
    computed = gradient_at(scene, u, v, central_difference(eps))
    values, kinds = [], []
    for name, number, first in zip(("h_u", "h_v"), computed, _first_kinds(field, inputs), strict=True):
        at_rounded = _number(rounded[name])
        values += [_minus(exact[name], right[name]), _minus(rounded[name], exact[name]), number - at_rounded]
        kinds += [first, np.full(len(u), 1), np.full(len(u), 2)]
    return np.array(values), np.array(kinds)


def _first_kinds(field, inputs):
    """Return the kind of the first term, in u and in v."""
    flags = straddling(field)
    in_u = in_float64(flags, inputs | {"k_v": 0.0})[flags.outputs[0].name] > 0
    in_v = in_float64(flags, inputs | {"k_u": 0.0})[flags.outputs[0].name] > 0
    v, eps, k = inputs["v"], inputs["epsilon"], inputs["k_v"]
    outside = (v + eps > 1) | (v - eps < 0)
    at_the_end = outside & np.isin(np.rint(k * v), (0.0, k))  # the crease in reach is the pole: no sample is beyond it
    return np.where(in_u, 3, 0), np.where(in_v & ~at_the_end, 3, np.where(outside, 4, 0))


def dominant(scene, u, v, eps):
    """Return which term is the largest at each point: an index into TERMS, −1 where all are zero."""
    values, kinds = terms(scene, u, v, eps)
    largest = np.abs(values).argmax(axis=0)
    at = (largest, np.arange(values.shape[1]))
    return np.where(values[at] == 0, -1, kinds[at])


def shares(kinds):
    """Return {term: its share of the points}."""
    return {name: float(np.mean(kinds == index)) for index, name in enumerate(TERMS)}


def over_the_image(frame, eps):
    """Return the dominant term at every pixel of a frame, (height, width) int; −2 off A."""
    data = frame.surface_data
    on_a = ~np.isnan(data["u"])
    result = np.full(on_a.shape, -2)
    result[on_a] = dominant(frame.scene, data["u"][on_a], data["v"][on_a], eps)
    return result


def shares_by_step(frame, steps, points=400, seed=10):
    """Return {term: its share for each step}, over random pixels of A in the frame."""
    data, random = frame.surface_data, np.random.default_rng(seed)
    on_a = np.flatnonzero(~np.isnan(data["u"]))
    chosen = random.choice(on_a, points, replace=False)
    u, v = data["u"].ravel()[chosen], data["v"].ravel()[chosen]
    table = [shares(dominant(frame.scene, u, v, eps)) for eps in steps]
    return {name: np.array([row[name] for row in table]) for name in TERMS}
