"""What a page or a theorem calls the worst, the largest or the most says of what, and that is computed again.

It names a certificate, a raster or a number of cases: `tests.counted_again` has how each is found out once more.
"""

import re
import tomllib
from collections.abc import Callable
from functools import partial
from typing import Any

import pytest

from book.assembly.results import formatted, look_up, parse
from proofs.engine.theorem import all_theorems
from proofs.formulas.enclosed import RULES
from tests.counted_again import BOOK, COUNTED, OVER_A_RASTER
from verify.accuracy.differences import PER_DECADE
from verify.checkers.measurements.creases import SIZE
from verify.checkers.measurements.pole import POINTS

PAGES = sorted([*BOOK.glob("chapter/**/*.md"), *BOOK.glob("checked/**/*.md")])
CLAIMS = sorted(BOOK.glob("ledger/claims/*.toml"))
EXTREME = re.compile(r"\b(worst|largest|maximum|at most|never exceeds?|never above)\b", re.IGNORECASE)
MEASURED = re.compile(r"\{number\}`[^`]+`")
OF_AN_EXTREME = re.compile(r"\{number\}`[\w:.-]*(worst|largest|_most)[|`]")
ROLE = re.compile(r"\{[\w-]+\}`[^`]*`")
NUMBER = r"\{number\}`([^`]+)`"
CASES = re.compile(NUMBER + r"(?:²| (?:random |sampled |chart )*(?:points|places|errors|pixels|scenes|steps)\b)")
EVERY = re.compile(r"\bevery (?:pixel|point)\b")
SQUARED = re.compile(rf"(\d+)²|{NUMBER}(?:²| pixels across)")
THEOREM = re.compile(r"\{theorem-ref\}`([^`|]+)")
CERTAIN = ("proved", "certified", "argued")
OF_A_THEOREM = {
    "dark_difference": f"${SIZE}^2$",
    "pole_accuracy": f"of {POINTS} points",
    "difference_bounds": {40: "forty"}[PER_DECADE],
    "enclosing_rules": {7: r"of $x + y$, $xy$, $x/y$, $\sqrt x$, $\lfloor x \rfloor$"}[len(RULES)],
}
"""{theorem: how it says of what its extreme is one}"""


def sentences(text):
    """Return the sentences of a page in MyST, without code, and without the options of a directive."""
    text = re.sub(r"^```.*?^```", "", text, flags=re.DOTALL | re.MULTILINE)
    text = re.sub(r"^:\w+:.*$", "", text, flags=re.MULTILINE)
    paragraphs = (" ".join(part.split()) for part in re.split(r"\n\s*\n|^:::.*$|^#.*$", text, flags=re.MULTILINE))
    return [s for paragraph in paragraphs for s in re.split(r"(?<=[.!?:)])\s+(?=[A-Z*`\[{$(])", paragraph) if s]


def extremes(text):
    """Return the sentences of a page that give a measured extreme."""
    found = (s for s in sentences(text) if MEASURED.search(s))
    return [s for s in found if OF_AN_EXTREME.search(s) or EXTREME.search(ROLE.sub("", s))]


def differs(again: Callable[[], Any], cited: str, number: Callable[..., Any]) -> bool:
    """Return whether a number, as it is printed, is another one when it is computed again."""
    id, key, spec = parse(cited)
    return formatted(number(id, key), spec) != formatted(again(), spec)


def objections(sentence: str, number: Callable[..., Any]) -> list[str]:
    """Return what is wrong with what an extreme says that it is one of; number: (id, key) → a figure's number."""
    theorems, cited = THEOREM.findall(sentence), re.findall(NUMBER, sentence)
    found = [f"{id} is no certificate" for id in theorems if all_theorems()[id].expected not in CERTAIN]
    cases, known = CASES.findall(sentence), len(theorems)
    for case in cases:
        key = ".".join(parse(case)[:2])
        if key not in COUNTED:
            found.append(f"{key} is not counted again")
        elif differs(COUNTED[key], case, number):
            found.append(f"{key} is not {COUNTED[key]()}")
    side = SQUARED.search(sentence) if EVERY.search(sentence) else None
    if side:
        across = int(side[1] or number(*parse(side[2])[:2]))
        for key, again in ((c, OVER_A_RASTER[k]) for c in cited if (k := ".".join(parse(c)[:2])) in OVER_A_RASTER):
            cases.append(key)
            if differs(partial(again, across), key, number):
                found.append(f"{key} is another one of {across}²")
    elif EVERY.search(sentence):
        found.append("every pixel of which raster?")
    return found if known or cases else [*found, "of what?"]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_an_extreme_is_of_what_it_says(site, page):
    check(extremes(page.read_text(encoding="utf-8")))


@pytest.mark.parametrize("file", CLAIMS, ids=lambda file: file.stem)
def test_a_claim_is_too(site, file):
    claims = tomllib.loads(file.read_text(encoding="utf-8"))["claim"]
    check(s for claim in claims for words in claim.values() if isinstance(words, str) for s in extremes(words))


def check(said):
    """Check that nothing is wrong with sentences."""
    assert {s: wrong for s in said if (wrong := objections(s, partial(look_up, BOOK)))} == {}


def test_a_measured_theorem_says_so_too():
    for theorem in all_theorems().values():
        said = " ".join((theorem.words, *theorem.hypotheses))
        if theorem.expected == "measured" and EXTREME.search(said):
            assert OF_A_THEOREM[theorem.id] in said, theorem.id


@pytest.mark.parametrize("sentence", [
    "The worst error of $g$ is {number}`stability_pole.pole_worst|.1e`.",
    "The error never exceeds\n{number}`a.b|.2g` roundings.",
    "- It is {number}`accuracy_chart.ours_median|.1f`, at most {number}`accuracy_chart.b|.1f`.",
    "Its value is {number}`three_pictures.largest|.3g`.",
    ":::{chapter-figure} a\n:alt: every pixel\nThe largest is {number}`a.b`. It was certified.\n:::",
])  # fmt: skip
def test_an_extreme_of_nothing_is_found(sentence):
    (found,) = extremes(f"A page. \n\n{sentence}\n\nMore.")
    assert "of what?" in objections(found, lambda *_: 1)


TRUE = {
    "The largest of {number}`frontier_wall.points|,` random points is {number}`a.largest`.": 10_000,
    "Over every pixel of {number}`certified_bounds.whole_side`² it is {number}`certified_bounds.sine_bound|.1e` at "
    "most.": 256,
    "By {theorem-ref}`truncation_bound` it is {number}`a.b` at most.": 0,
}  # fmt: skip


def figures(n):
    """Return a look-up that has n for a number of cases, and the certified bound of sine at 256²."""
    return lambda id, key: OVER_A_RASTER[f"{id}.{key}"](256) if key == "sine_bound" else n


@pytest.mark.parametrize("sentence", TRUE)
def test_what_is_so_is_left_alone(sentence):
    assert objections(sentence, figures(TRUE[sentence])) == []


@pytest.mark.parametrize(("sentence", "n"), [
    (next(iter(TRUE)), 10_001),
    (list(TRUE)[1], 128),
    ("Over every pixel of 128² it is {number}`certified_bounds.sine_bound|.1e` at most.", 0),
    ("Over every pixel it is {number}`certified_bounds.sine_bound|.1e` at most.", 0),
    ("The largest of {number}`a.points|,` points is {number}`a.largest`.", 0),
    ("By {theorem-ref}`pole_accuracy` it is {number}`a.b` at most.", 0),
    ("The certified bound is {number}`a.b` at most.", 0),
])  # fmt: skip
def test_a_wrong_number_of_cases_is_rejected(sentence, n):
    assert objections(sentence, figures(n))
