"""Measurements, citations and cited lemmas: the grades that they reach, and failures."""

import math
from dataclasses import replace
from fractions import Fraction
from functools import partial

import numpy as np
import pytest
from flint import arb
from sympy import symbols

from proofs.engine.theorem import Theorem
from proofs.formulas.certified import SINE as MOST
from verify.accuracy import sine
from verify.checkers import proof_checker
from verify.checkers.grades import graded, summary
from verify.checkers.measurements import REGISTERED, Enclosure, Measurement, examine, measurements, measures

x = symbols("x", real=True)
SOME = Theorem("measured_here", "A measurement", "At most 2.42 roundings.", expected="measured")


@pytest.fixture
def measured(monkeypatch):
    """Return a function that examines a theorem by a function and its false variants, which are forgotten."""
    assert SOME.id not in measurements()

    def examined(function, false, **changes):
        monkeypatch.setitem(REGISTERED, SOME.id, [])
        measures(SOME.id, false)(function)
        return examine(replace(SOME, **changes))

    return examined


NUMBERS = np.arange(10.0)


def squares(bound=81.0, **more):
    return Measurement(**{"values": NUMBERS**2, "bound": bound, "quantity": "squares"} | more)


def test_a_measurement_holds_and_rejects_its_false_variant(measured):
    false = {"at most 80": {"bound": 80}}
    examination = measured(squares, false)
    assert (examination.grade, examination.mutants, examination.mutants_killed) == ("measured", 1, 1)
    (entry,) = examination.record["measurements"]
    assert (entry["certified"], entry["worst"]) == (False, 80.0)
    assert entry["false_variants"] == [{"variant": "at most 80", "rejected": True}]
    assert measured(squares, false, expected="certified").grade == "measured"  # short of what was expected
    blind = measured(squares, {"at most 81": {"bound": 81}})
    assert blind.problems == ["squares: does not reject the false variant “at most 81”"]
    assert measured(squares, {"no bound": {"bound": math.inf}}).mutants_killed == 0  # no claim, and no false one


UNSEEN = {
    "no words": {"quantity": ""},
    "what does not hold": {"holds": False},
    "a constant": {"values": np.tile(0.5, (4, 25))},
    "infinite": {"values": [1.0, math.inf]},
    "beyond its bound": {"values": NUMBERS**3},
}


@pytest.mark.parametrize("changes", UNSEEN.values(), ids=UNSEEN)
def test_what_a_measurement_says_of_itself_does_not_count(changes, measured):
    examination = measured(lambda bound=81.0: squares(bound, **changes), {"at most 1": {"bound": -1}})
    assert examination.grade == "failed"


def test_without_a_measurement_nothing_is_measured():
    assert proof_checker.examine(SOME).grade == "failed"
    with pytest.raises(ValueError, match="false variant"):
        measures(SOME.id, false={})


SINE = Enclosure(sine.pieces, {"x": ((0.001, 0.25),)}, sine.errors, MOST, "sine, in roundings")


def forged(pieces):
    """Return a function that returns pieces, and looks like one of `verify`."""
    return forged_with(lambda *points: pieces)


def forged_with(function):
    """Return a function that looks like one of `verify`."""
    function.__module__, function.__name__ = sine.__name__, f"forged_{id(function)}"
    vars(sine)[function.__name__] = function
    return function


def elsewhere(points):
    return 0 * points


elsewhere.__module__ = "verify.accuracy.differences"


OWN = [(Fraction(0), Fraction(1, 2), Fraction(242, 100))]
TAMPERED = {
    "pieces of its own": {"pieces": lambda: OWN},
    "nothing": {"pieces": forged([])},
    "no range of its variable": {"over": {"x": ()}},
    "a function that its module has not": {"at": elsewhere},
    "an infinite bound": {"bound": arb("inf")},
    "a bound that is a float": {"bound": 2.42},
    "one number": {"pieces": forged([(arb(0.125), arb(0.125), arb(1))]), "over": {"x": ((0.125, 0.125),)}},
    "no value": {"at": partial(forged(np.zeros((0, 1))))},
    "a smaller bound": {"bound": Fraction(133, 100)},
    "wide ends": {"pieces": forged([(arb(0, 5), arb(1, 5), arb(1))]), "over": {"x": ((0.0, 1.0),)}},
    "a gap": {"pieces": forged(SINE.enclosed[:300] + SINE.enclosed[301:])},
    "beyond its pieces": {"over": {"x": ((0.001, 0.51),)}},
    "another function": {"at": forged_with(lambda points: 8 * sine.errors(points))},
    "its own function": {"at": lambda points: 0 * points},
}


@pytest.mark.parametrize("changes", TAMPERED.values(), ids=TAMPERED)
def test_an_enclosure_is_taken_apart_and_tried(changes):
    assert replace(SINE, **changes).why_refused()


WORDS = [
    *((words, "certified") for words in (SOME.statement, r"$\sin\pi x$ is off by 2.42 $\mu$, $\mu = 2^{-53}$.")),
    ("At most 2.4 roundings.", "failed"),
    (r"At most 2.42 roundings at all $x$, $y$.", "failed"),
    (r"$|f(x)| \le 2.42$ for every $x$", "failed"),
    (r"$\sin\pi\varphi x$ is off by 2.42 roundings.", "failed"),
    (r"$\sin\pi x_1$ is off by 2.42 roundings.", "failed"),
]


@pytest.mark.parametrize(("words", "grade"), WORDS)
def test_what_is_enclosed_is_what_the_words_state(words, grade, measured):
    false = {"at most 1.33": {"bound": Fraction(133, 100)}}
    examination = measured(
        lambda bound=SINE.bound: replace(SINE, bound=bound), false, expected="certified", statement=words
    )
    assert examination.grade == grade


STATED = {
    "sine_of_half_turns": {"ku": ((0, 0.25 + 2**-30),)},
    "algebraic_gradient_accuracy": {
        "R/e": ((1e-6, 1 - 1e-9),),
        r"\rho/\rho_s": ((0, math.sqrt(0.9)),),
        **dict.fromkeys(("k_u", "k_v"), ((-64, 64),)),
    },
    "pole_accuracy": 2 * 200,
}


@pytest.mark.parametrize("id", STATED)
def test_no_range_and_no_sample_is_narrower_than_the_words_state(id):
    ((function, _),) = measurements()[id]
    evidence = function()
    assert getattr(evidence, "over", evidence.samples) == STATED[id]


def test_what_rests_on_a_cited_lemma_says_so():
    """A theorem that Coq proves names no lemma, as its proof needs none, and no other theorem."""
    lemma = {"relation": "x >= sin(x)", "source": "Blinn1978"}
    examination = {"id": "lemma", "grade": "proved", "uses": [], "cited_lemmas": [lemma]}
    user = {"id": "user", "grade": "proved", "uses": ["lemma"]}
    for formal, *told in (
        ((), "proved, given Blinn1978", "proved, given Blinn1978"),
        (("lemma",), "proved", "proved"),
        (("user",), "proved, given Blinn1978", "proved"),
    ):
        assert [entry["grade_line"] for entry in graded([examination, user], formal)] == told
    assert summary(graded([examination, user])) == {"proved_given_cited": 2}
