"""A sentence that gives a worst, a largest or a most says of what: a certificate, a raster, a number of cases."""

import re
import tomllib

import pytest

from proofs.engine.theorem import all_theorems
from verify.evidence.sources import ROOT

BOOK = ROOT / "book"
PATTERNS = ("chapter/**/*.md", "checked/**/*.md", "ledger/claims/*.toml")
WRITTEN = sorted(path for pattern in PATTERNS for path in BOOK.glob(pattern))
EXTREME = re.compile(r"\b(worst|largest|maximum|at most|never exceeds?|never above)\b", re.IGNORECASE)
MEASURED = re.compile(r"\{number\}`[^`]+`")
OF_AN_EXTREME = re.compile(r"\{number\}`[\w:.-]*(worst|largest|_most)[|`]")
ROLE = re.compile(r"\{[\w-]+\}`[^`]*`")
NUMBER = r"\{number\}`([^`]+)`"
CASES = re.compile(NUMBER + r"(?:²| (?:random |sampled |chart )*(?:points|places|errors|pixels|scenes|steps)\b)")
EVERY = re.compile(r"\bevery (?:pixel|point)\b")
SQUARED = re.compile(rf"(\d+)²|{NUMBER}(?:²| pixels across)")
THEOREM = re.compile(r"\{theorem-ref\}`([^`|]+)")
CERTAIN = ("proved", "certified")


def sentences(text):
    """Return the sentences of a page in MyST, without code, and without the options of a directive."""
    text = re.sub(r"(?ms)^```.*?^```|^:\w+:.*?$", "", text)
    parts = re.split(r"(?m)\n\s*\n|^:::.*$|^#.*$", text)
    paragraphs = (" ".join(part.split()) for part in parts)
    return [s for paragraph in paragraphs for s in re.split(r"(?<=[.!?:)])\s+(?=[A-Z*`\[{$(])", paragraph) if s]


def extremes(text):
    """Return the sentences of a page that give a measured extreme."""
    measured = (s for s in sentences(text) if MEASURED.search(s))
    return [s for s in measured if OF_AN_EXTREME.search(s) or EXTREME.search(ROLE.sub("", s))]


def objections(sentence):
    """Return the faults of a sentence that gives an extreme: of nothing, or by a theorem that is no certificate."""
    theorems = THEOREM.findall(sentence)
    faults = [f"{id} is no certificate" for id in theorems if all_theorems()[id].expected not in CERTAIN]
    of_raster = EVERY.search(sentence)
    if of_raster and not SQUARED.search(sentence):
        faults.append("every pixel of which raster?")
    return faults if theorems or of_raster or CASES.search(sentence) else [*faults, "of what?"]


def texts_of(path):
    """Return a page's text, or what the claims of a file say."""
    text = path.read_text("utf-8")
    if path.suffix == ".md":
        return [text]
    return [words for claim in tomllib.loads(text)["claim"] for words in claim.values() if isinstance(words, str)]


@pytest.mark.parametrize("path", WRITTEN, ids=lambda path: path.stem)
def test_an_extreme_is_of_something(path):
    faults = {s: objections(s) for text in texts_of(path) for s in extremes(text)}
    assert {s: wrong for s, wrong in faults.items() if wrong} == {}


OF_WHAT = ["of what?"]
FAULTS = {
    "The worst error of $g$ is {number}`pole.far_worst|.1e`.": OF_WHAT,
    "The error never exceeds\n{number}`a.b|.2g` roundings.": OF_WHAT,
    "- It is {number}`accuracy_chart.ours_median|.1f`, at most {number}`accuracy_chart.b|.1f`.": OF_WHAT,
    "Its value is {number}`three_pictures.largest|.3g`.": OF_WHAT,
    ":::{chapter-figure} a\n:alt: every pixel\nThe largest is {number}`a.b`. It was certified.\n:::": OF_WHAT,
    "The certified bound is {number}`a.b` at most.": OF_WHAT,
    "The largest of {number}`frontier_wall.points|,` random points is {number}`a.largest`.": [],
    "Over every pixel of {number}`certified_bounds.side`² it is {number}`certified_bounds.bound|.1e`, at most.": [],
    "Over every pixel it is {number}`certified_bounds.sine_bound|.1e` at most.": ["every pixel of which raster?"],
    "By {theorem-ref}`truncation_bound` it is {number}`a.b` at most.": [],
    "By {theorem-ref}`pole_accuracy` it is {number}`a.b` at most.": ["pole_accuracy is no certificate"],
}


@pytest.mark.parametrize("sentence", FAULTS)
def test_an_extreme_of_nothing_or_of_a_sample_is_found(sentence):
    (extreme,) = extremes(f"A page. \n\n{sentence}\n\nMore.")
    assert objections(extreme) == FAULTS[sentence]
