"""What a page or a theorem calls the worst, the largest or the most says of what: certified, of every pixel, of n."""

import re
from pathlib import Path

import pytest

from proofs.engine.theorem import all_theorems

BOOK = Path(__file__).resolve().parent.parent / "book"
PAGES = sorted([*BOOK.glob("chapter/**/*.md"), *BOOK.glob("checked/**/*.md")])
EXTREME = re.compile(r"\b(worst|largest|maximum|at most|never exceeds?|never above)\b", re.IGNORECASE)
MEASURED = re.compile(r"\{number\}`[^`]+`")
OF_AN_EXTREME = re.compile(r"\{number\}`[\w:.-]*(worst|largest|_most)[|`]")
ROLE = re.compile(r"\{[\w-]+\}`[^`]*`")
ITS_CASES = re.compile(
    r"\bcertified\b|\bproved\b|\{theorem-ref\}|\bevery (pixel|point)\b"
    r"|\{number\}`[^`]+`²? (random |sampled |chart )*(points|places|errors|pixels|scenes|pictures|steps)\b"
)
A_THEOREMS_CASES = re.compile(r"256\^2|255\^2|\b\d+ (points|pixels)\b|\bsteps a decade\b|\bexhaustive")


def sentences(text):
    """Return the sentences of a page in MyST, without code, and without the options of a directive."""
    text = re.sub(r"^```.*?^```", "", text, flags=re.DOTALL | re.MULTILINE)
    text = re.sub(r"^:\w+:.*$", "", text, flags=re.MULTILINE)
    paragraphs = (" ".join(part.split()) for part in re.split(r"\n\s*\n|^:::.*$|^#.*$", text, flags=re.MULTILINE))
    return [s for paragraph in paragraphs for s in re.split(r"(?<=[.!?:)])\s+(?=[A-Z*`\[{$(])", paragraph) if s]


def of_nothing(text):
    """Return the sentences that give a measured extreme and not of what it is one."""
    return [
        sentence
        for sentence in sentences(text)
        if MEASURED.search(sentence)
        and (OF_AN_EXTREME.search(sentence) or EXTREME.search(ROLE.sub("", sentence)))
        and not ITS_CASES.search(sentence)
    ]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_an_extreme_says_of_what_it_is_one(page):
    assert of_nothing(page.read_text(encoding="utf-8")) == []


def test_a_measured_theorem_says_so_too():
    for theorem in all_theorems().values():
        said = " ".join((theorem.words, *theorem.hypotheses))
        assert theorem.expected != "measured" or not EXTREME.search(said) or A_THEOREMS_CASES.search(said), theorem.id


@pytest.mark.parametrize("sentence", [
    "The worst error of $g$ is {number}`stability_pole.pole_worst|.1e`.",
    "The error never exceeds\n{number}`a.b|.2g` roundings.",
    "- It is {number}`accuracy_chart.ours_median|.1f`, at most {number}`accuracy_chart.b|.1f`.",
    "Its value is {number}`three_pictures.largest|.3g`.",
    ":::{chapter-figure} a\n:alt: every pixel\nThe largest is {number}`a.b`. It was certified.\n:::",
])  # fmt: skip
def test_an_extreme_of_nothing_is_found(sentence):
    assert len(of_nothing(f"A page. \n\n{sentence}\n\nMore.")) == 1


@pytest.mark.parametrize("sentence", [
    "The worst of {number}`a.points|,` sampled points is off by {number}`a.worst|.1e`.",
    "Over every pixel it is {number}`a.b` at most.",
    "The certified bound is {number}`a.b` at most.",
    "No number, and the largest of all.",
    "A number, {number}`a.b`, of nothing.",
])  # fmt: skip
def test_what_names_its_cases_is_left_alone(sentence):
    assert of_nothing(sentence) == []
