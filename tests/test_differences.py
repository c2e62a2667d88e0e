"""The difference of two pictures is enclosed, whatever is open; and only digits that are certain are printed."""

from decimal import Decimal
from itertools import chain, combinations

import numpy as np
import pytest
from flint import arb, ctx

from renderer import Scene, central, render
from renderer.picture.differences import Interval, certain_digits, distance_on_a, enclosed_distance, rms
from renderer.picture.frame import Frame
from verify.accuracy.pixels import BITS, COLORS, truth_of

SIDE = 12
SCENE = Scene(field="sine")


def colours_of(frame, exactly):
    """Return a frame's colours on A as numbers of 256 bits: its own float64 ones, or the true ones of its formula."""
    for row, column in np.argwhere(frame.stage.on_a).tolist():
        truth = truth_of(frame, column, row)
        own = (arb(float(part)) for part in frame.rgb[row, column])
        yield from (truth[name] for name in COLORS) if exactly else own


def missed(method, bounds):
    """Return which of the largest and the RMS difference from the exact picture certainly lie outside their ends."""
    frame, reference = render(SCENE, SIDE, SIDE, method, bounds=bounds), render(SCENE, SIDE, SIDE, bounds=True)
    with ctx.workprec(BITS):
        delta = [a - b for a, b in zip(colours_of(frame, bounds), colours_of(reference, True), strict=True)]
        mean = sum((part * part for part in delta), arb(0)) / len(delta)
        truth = max((abs(part) for part in delta), key=float), mean.sqrt()
        found = zip(distance_on_a(frame, reference), truth, strict=True)
        return [not (arb(each.lower) <= true <= arb(each.upper)) for each, true in found]


PAIRS = [(central(eps), bounds) for eps in (1e-2, 1e-6, 1e-9) for bounds in (False, True)]


@pytest.mark.parametrize("method, bounds", PAIRS)
def test_the_truth_lies_between_the_ends(method, bounds):
    assert missed(method, bounds) == [False, False]


def test_bounds_that_are_left_out_are_noticed(monkeypatch):
    monkeypatch.setattr(Frame, "bounds", property(lambda frame: np.zeros_like(frame.rgb)))
    assert all(any(missed(*pair)) for pair in PAIRS[2:])


def test_ends_are_close():
    """As close as rounding, or as the bounds of a picture that stands for the exact one."""
    plain, bounded = render(SCENE, SIDE, SIDE), render(SCENE, SIDE, SIDE, bounds=True)
    for each in distance_on_a(render(SCENE, SIDE, SIDE, central(1e-2)), plain):
        assert each.lower <= each.value <= each.upper <= each.lower * (1 + 1e-12)
    assert distance_on_a(plain, plain)[1] == Interval(0, 0, 0)
    largest, _ = distance_on_a(plain, bounded)
    assert (largest.value, largest.lower) == (0.0, 0.0)
    assert largest.upper == pytest.approx(bounded.bounds[bounded.stage.on_a].max(), rel=1e-14)


def made(seed, shape=(3, 4)):
    """Return made-up differences, how far they are off, which pixels are on A, and of which that is undecided."""
    random = np.random.default_rng(seed)
    size = 10.0 ** random.uniform(-200 if seed % 3 == 0 else -3, 0)
    delta, within = size * random.uniform(-1, 1, (*shape, 3)), 0.5 * size * random.random((*shape, 3))
    return delta, within, random.random(shape) < 0.6, random.random(shape) < 0.4


def choices(delta, within, on_a, undecided):
    """Yield (largest, RMS) of every choice of the pixels that are on A, all colours as near or as far as may be."""
    places, distance = np.flatnonzero(undecided), np.abs(delta)
    for subset in chain.from_iterable(combinations(places, count) for count in range(len(places) + 1)):
        chosen_on_a = (on_a & ~undecided).ravel()
        chosen_on_a[list(subset)] = True
        for colours in (np.maximum(distance - within, 0.0), distance + within):
            chosen = colours.reshape(-1, 3)[chosen_on_a]
            unit = chosen.max(initial=0.0) or 1.0
            yield chosen.max(initial=0.0), unit * rms(chosen / unit)


def worst_of_choices(seed, decided=False):
    """Return how far beyond an end a choice is, and how far an end is from all choices, relative to the upper end.

    decided: whether the ends are those of a mask with nothing open.
    """
    *differences, undecided = made(seed)
    ends = enclosed_distance(*differences, undecided & (not decided))
    beyond, away = [], []
    for end, of_choices in zip(ends, zip(*choices(*differences, undecided), strict=True), strict=True):
        unit = end.upper or 1.0
        beyond += [(end.lower - min(of_choices)) / unit, (max(of_choices) - end.upper) / unit]
        away += [(min(of_choices) - end.lower) / unit, (end.upper - max(of_choices)) / unit]
    return max(beyond), max(away)


def test_every_choice_is_covered_and_the_ends_are_reached():
    found = np.array([worst_of_choices(seed) for seed in range(60)])
    assert found[:, 0].max() < 1e-15
    assert np.median(found[:, 1]) < 1e-14


def test_a_mask_that_is_taken_as_decided_is_noticed():
    assert sum(worst_of_choices(seed, decided=True)[0] > 1e-3 for seed in range(60)) > 40


def test_what_either_picture_leaves_open_is_open(monkeypatch):
    pair = render(SCENE, SIDE, SIDE, central(1e-2), bounds=True), render(SCENE, SIDE, SIDE, bounds=True)
    for undecided in pair:
        whole = property(lambda frame, undecided=undecided: np.full(frame.raster.shape, frame is undecided))
        monkeypatch.setattr(Frame, "open", whole)
        assert [end.lower for end in distance_on_a(*pair)] == [0.0, 0.0]


def ends_at_random(seed):
    """Return ends of which 0 to 16 digits agree."""
    random = np.random.default_rng(seed)
    middle = 10.0 ** random.uniform(-30, 3)
    half = middle * 10.0 ** random.uniform(-16, 0)
    return max(0.0, middle - half), middle + half


def uncertain(printed, lower, upper, digits):
    """Return whether a number between the ends is printed otherwise when it is rounded to as many digits."""
    count = len(Decimal(printed or 0).as_tuple().digits)
    between = np.linspace(lower, upper, 9).tolist()
    rounded = ({float(f"{each:.{k}g}") for each in between} for k in range(count, digits + 1))
    return bool(printed) and {float(printed)} not in rounded


@pytest.mark.parametrize("digits", [1, 4, 15])
def test_what_is_printed_is_certain(digits):
    ends = [ends_at_random(seed) for seed in range(2000)]
    printed = [certain_digits(*each, digits) for each in ends]
    assert not any(uncertain(text, *each, digits) for text, each in zip(printed, ends, strict=True))
    assert 0.02 < np.mean([text == "" for text in printed]) < 0.4
    of_middle = [f"{sum(each) / 2:.{digits}g}" for each in ends]  # false variants: the middle, and an end
    of_lower = [f"{lower:.{digits}g}" for lower, _ in ends]
    for false in (of_middle, of_lower):
        assert sum(uncertain(text, *each, digits) for text, each in zip(false, ends, strict=True)) > 50
