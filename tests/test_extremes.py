"""What a page or a theorem calls the worst, the largest or the most says of what, and that is computed again.

It names a certificate, a raster or a number of cases: `tests.counted_again` has how each is found out once more.
"""

import re
import tomllib
from functools import partial

import pytest

from book.assembly.results import formatted, look_up, parse
from proofs.engine.theorem import all_theorems
from proofs.formulas.enclosed import RULES
from tests.counted_again import BOOK, COUNTED, OVER_A_RASTER
from verify.accuracy.differences import PER_DECADE
from verify.checkers.measurements.creases import SIZE
from verify.checkers.measurements.pole import POINTS

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
CERTAIN = ("proved", "certified", "argued")
OF_A_THEOREM = {
    "dark_difference": f"${SIZE}^2$",
    "pole_accuracy": f"of {POINTS} points",
    "difference_bounds": {40: "forty"}[PER_DECADE],
    "enclosing_rules": {12: r"of $x + y$, $xy$, $x/y$, $\sqrt x$, $\lfloor x \rfloor$"}[len(RULES)],
}
"""{theorem: how it says of what its extreme is one}"""


def sentences(text):
    """Return the sentences of a page in MyST, without code, and without the options of a directive."""
    text = re.sub(r"(?ms)^```.*?^```|^:\w+:.*?$", "", text)
    parts = re.split(r"(?m)\n\s*\n|^:::.*$|^#.*$", text)
    paragraphs = (" ".join(part.split()) for part in parts)
    return [s for paragraph in paragraphs for s in re.split(r"(?<=[.!?:)])\s+(?=[A-Z*`\[{$(])", paragraph) if s]


def extremes(text):
    """Return the sentences of a page that give a measured extreme."""
    found = (s for s in sentences(text) if MEASURED.search(s))
    return [s for s in found if OF_AN_EXTREME.search(s) or EXTREME.search(ROLE.sub("", s))]


def name_of(cited):
    """Return "figure.number" of what a page cites."""
    return ".".join(parse(cited)[:2])


def objections(sentence, number):
    """Return what is wrong with what an extreme says that it is one of; number: (id, key) → a figure's number."""
    theorems, cited = THEOREM.findall(sentence), re.findall(NUMBER, sentence)
    found = [f"{id} is no certificate" for id in theorems if all_theorems()[id].expected not in CERTAIN]
    again = {case: COUNTED.get(name_of(case)) for case in CASES.findall(sentence)}
    side = SQUARED.search(sentence)
    if side and EVERY.search(sentence):
        across = int(side[1] or number(*parse(side[2])[:2]))
        of_raster = {key: OVER_A_RASTER[name] for key in cited if (name := name_of(key)) in OVER_A_RASTER}
        again |= {key: partial(extreme, across) for key, extreme in of_raster.items()}
    elif EVERY.search(sentence):
        found.append("every pixel of which raster?")
    for key, count in again.items():
        *name, spec = parse(key)
        if not count:
            found.append(f"{key} is not counted again")
        elif formatted(number(*name), spec) != formatted(count(), spec):
            found.append(f"{key} is not {count()}")
    return found if theorems or again else [*found, "of what?"]


def texts_of(path):
    """Return a page's text, or what the claims of a file say."""
    text = path.read_text("utf-8")
    if path.suffix == ".md":
        return [text]
    return [words for claim in tomllib.loads(text)["claim"] for words in claim.values() if isinstance(words, str)]


@pytest.mark.parametrize("path", WRITTEN, ids=lambda path: path.stem)
def test_an_extreme_is_of_what_it_says(site, path):
    said = {s: objections(s, partial(look_up, BOOK)) for text in texts_of(path) for s in extremes(text)}
    assert {s: wrong for s, wrong in said.items() if wrong} == {}


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


OF_POINTS = "The largest of {number}`frontier_wall.points|,` random points is {number}`a.largest`."
OF_A_RASTER = (
    "Over every pixel of {number}`certified_bounds.whole_side`² it is {number}`certified_bounds.sine_bound|.1e`."
)


@pytest.mark.parametrize("sentence, n, is_so", [
    (OF_POINTS, 10_000, True),
    (OF_POINTS, 10_001, False),
    (OF_A_RASTER, 256, True),
    (OF_A_RASTER, 128, False),
    ("By {theorem-ref}`truncation_bound` it is {number}`a.b` at most.", 0, True),
    ("By {theorem-ref}`pole_accuracy` it is {number}`a.b` at most.", 0, False),
    ("Over every pixel of 128² it is {number}`certified_bounds.sine_bound|.1e` at most.", 0, False),
    ("Over every pixel it is {number}`certified_bounds.sine_bound|.1e` at most.", 0, False),
    ("The largest of {number}`a.points|,` points is {number}`a.largest`.", 0, False),
    ("The certified bound is {number}`a.b` at most.", 0, False),
])  # fmt: skip
def test_a_wrong_number_of_cases_is_rejected(sentence, n, is_so):
    """n: what is cited as the number of cases, beside the certified bound of sine at 256²."""
    wrong = objections(sentence, lambda id, key: OVER_A_RASTER[f"{id}.{key}"](256) if key == "sine_bound" else n)
    assert (wrong == []) is is_so
