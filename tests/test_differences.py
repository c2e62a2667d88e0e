"""The difference of two pictures is enclosed, whatever is open; and only digits that are certain are printed."""

from decimal import Decimal
from itertools import chain, combinations

import numpy as np
import pytest

from renderer import Scene, central, render
from renderer.intervals import certain_digits, rms
from renderer.picture.differences import distance_on_a, enclosed_distance
from renderer.picture.frame import Frame

SIDE = 12
SCENE = Scene(field="sine")


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


def worst_of_choices(seed):
    """Return how far beyond an end a choice is, and how far an end is from all choices, relative to the upper end."""
    *differences, undecided = made(seed)
    ends = enclosed_distance(*differences, undecided)
    beyond, away = [], []
    for end, of_choices in zip(ends, zip(*choices(*differences, undecided), strict=True), strict=True):
        unit = end.upper or 1.0
        beyond += [(end.lower - min(of_choices)) / unit, (max(of_choices) - end.upper) / unit]
        away += [(min(of_choices) - end.lower) / unit, (end.upper - max(of_choices)) / unit]
    return max(beyond), max(away)


def test_every_choice_is_covered_and_the_ends_are_reached():
    excess = np.array([worst_of_choices(seed) for seed in range(60)])
    assert excess[:, 0].max() <= 0
    assert np.median(excess[:, 1]) < 1e-14


def test_what_either_picture_leaves_open_is_open(monkeypatch):
    pair = render(SCENE, SIDE, SIDE, central(1e-2), bounds=True), render(SCENE, SIDE, SIDE, bounds=True)
    for undecided in pair:
        everywhere = property(lambda frame, undecided=undecided: np.full(frame.raster.shape, frame is undecided))
        monkeypatch.setattr(Frame, "open", everywhere)
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


@pytest.mark.parametrize("digits", [1, 15])
def test_what_is_printed_is_certain(digits):
    ends = [ends_at_random(seed) for seed in range(1000)]
    printed = [certain_digits(*each, digits) for each in ends]
    assert not any(uncertain(text, *each, digits) for text, each in zip(printed, ends, strict=True))
    assert 0.02 < np.mean([text == "" for text in printed]) < 0.4
