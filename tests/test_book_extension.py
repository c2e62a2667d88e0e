"""The book's own Sphinx extension: numbers, figures, ids; what is unknown fails the build."""

import json
import re
import shutil
from functools import partial

import pytest
from docutils import nodes
from jupyter_cache.executors import utils
from nbformat.v4 import new_code_cell, new_notebook

from book.assembly.results import UnknownResult, look_up, parse
from book.extension import pages
from book.extension.numbers import typeset
from renderer.picture.differences import Interval
from tests import one_page
from verify import records


@pytest.fixture
def book(tmp_path, monkeypatch):
    """A book folder with one drawn figure, beside one committed benchmark."""
    generated = tmp_path / "book" / "_generated"
    results = tmp_path / "verify" / "benchmark" / "results"
    for folder in (generated, results):
        folder.mkdir(parents=True)
    (tmp_path / "book" / "sweep.py").touch()
    sweep = {"kind": "svg", "size": [640, 300], "numbers": {"rms_1e-3": 0.01214, "flips": 0}}
    sweep |= {"source": "book/sweep.py", "function": "sweep", "data": "sweep.csv", "key": "0123456789abcdef"}
    (generated / "sweep.csv").write_text("step,rms\n0.001,0.01214\n")
    (generated / "sweep.json").write_text(json.dumps(sweep))
    for name in ("sweep.svg", "sweep.dark.svg"):
        (generated / name).write_text('<svg xmlns="http://www.w3.org/2000/svg"/>')
    monkeypatch.setattr(records, "remark", {}.get)
    label = {"machine": "two cores", "date": "2025-01-01", "commit": "abc1234"}
    numbers = {"time_ms": 16.25, "time_ms_low": 15.5, "time_ms_high": 18.75, "quick_ms": 1.5}
    (results / "frame.json").write_text(json.dumps({"label": label, "numbers": numbers}))
    return tmp_path / "book"


@pytest.mark.parametrize("text", ["", "sweep", "sweep.", "sweep.a|", "sweep.a b c"])
def test_role_text_that_says_nothing(text):
    with pytest.raises(UnknownResult, match=r"id\.key"):
        parse(text)


@pytest.mark.parametrize(
    ("id", "key", "known"),
    [("sweep", "rms", "rms_1e-3"), ("swep", "rms", "sweep"), ("bench:fram", "x", "frame"), ("../x", "a", "sweep")],
)
def test_unknown_numbers_are_refused_with_a_list_of_known_ones(book, id, key, known):
    with pytest.raises(UnknownResult, match=known):
        look_up(book, id, key)


@pytest.mark.parametrize(
    ("value", "spec", "expected"),
    [
        (6.116e-5, ".1e", "6.1\u00a0×\u00a010^−5"),
        (-6.116e-5, ".1e", "−6.1\u00a0×\u00a010^−5"),
        (1e-6, ".0e", "10^−6"),
        (2.5e20, None, "2.5\u00a0×\u00a010^20"),
        (-1.5, None, "−1.5"),
        ("one-sided", None, "one-sided"),
        (0.0121437, None, "0.01214"),
        (12, None, "12"),
        (True, None, "yes"),
        (1824, ",", "1,824"),
        (0.5, ".0%", "50%"),
        (Interval(0.0467, 0.04669, 0.04671), ".2f", "0.05"),
        (Interval(0.0467, 0.04669, 0.04671), None, "0.0467"),
        (Interval(4.1e-11, 3.96e-11, 4.04e-11), None, "4\u00a0×\u00a010^−11"),
    ],
)
def test_typesetting(value, spec, expected):
    parts = typeset(value, spec)
    text = "".join(f"^{part.astext()}" if isinstance(part, nodes.superscript) else part.astext() for part in parts)
    assert text == expected


@pytest.mark.parametrize("value", [Interval(0.5, 0.4, 0.6), Interval(7.28e-12, 6.99e-12, 7.63e-12)])
@pytest.mark.parametrize("spec", [None, ".1e", ".3g"])
def test_digits_that_are_not_certain_are_refused(value, spec):
    with pytest.raises(ValueError, match=f"of a number from {value.lower} to {value.upper} is not certain"):
        typeset(value, spec)


@pytest.fixture
def build_page(book):
    """Build one page with the extension; the page's HTML and the warnings."""
    return partial(one_page.build, book)


FIGURE = ":::{chapter-figure} %s\n%s\n\nThe RMS is {number}`sweep.rms_1e-3`.\n:::\n\nSee {numref}`fig-sweep`."


def test_figure_has_number_label_alt_text_and_provenance(build_page):
    html, warnings = build_page(FIGURE % ("sweep", ":alt: a falling curve\n:width: page"))
    assert warnings == ""
    assert 'id="fig-sweep"' in html
    assert html.count('alt="a falling curve"') == 2
    assert 'class="plot only-dark"' in html and 'class="plot only-light"' in html
    assert 'href="#fig-sweep"><span class="std std-numref">Fig. 1</span>' in html
    assert '<span class="number">0.01214</span>' in html
    assert all(name in html for name in ("sweep.json", "sweep.csv", "sweep.py")) and "figures</span> <span" in html
    assert "0123456789abcdef" in html
    assert "certified" not in html


def describe(book, **more):
    """Add to what the drawn figure says of itself."""
    path = book / "_generated" / "sweep.json"
    path.write_text(json.dumps(json.loads(path.read_text()) | more))


def test_a_picture_says_how_far_its_colours_can_be_off(book, build_page):
    for undecided, said in ((0, "certified</p>"), (1234, "certified, but for 1,234 pixels that rounding leaves")):
        describe(book, certified={"within": 8.1e-10, "undecided": undecided})
        html, warnings = build_page(FIGURE % ("sweep", ":alt: a falling curve"))
        assert warnings == ""
        formula = "of its own formula in exact arithmetic (rounding alone), "
        assert f"every colour within 8.1\u00a0×\u00a010<sup>−10</sup> {formula}{said}" in html


def test_a_page_that_asks_for_uncertain_digits_fails(book, build_page):
    describe(book, numbers={"rms_1e-3": 0.01214, "rms_1e-3_lower": 0.01212, "rms_1e-3_upper": 0.01216})
    assert look_up(book, "sweep", "rms_1e-3") == Interval(0.01214, 0.01212, 0.01216)
    html, warnings = build_page("It is {number}`sweep.rms_1e-3|.2g`.")
    assert (warnings, "0.012</span>" in html) == ("", True)
    _, warnings = build_page("It is {number}`sweep.rms_1e-3|.4g`.")
    assert "of a number from 0.01212 to 0.01216 is not certain" in warnings


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (FIGURE % ("sweep", ":width: page"), r"index\.md:3.*alt is required"),
        (FIGURE % ("swep", ":alt: a curve"), r"index\.md:3.*unknown figure 'swep'; there are: sweep"),
        (FIGURE % ("sweep", ":alt: a curve\n:width: half"), r"index\.md:3.*half"),
        ("A number: {number}`sweep.rsm`.", r"index\.md:3.*no number 'rsm'; it has: flips, rms_1e-3"),
        ("A number: {number}`sweep.flips|.q`.", r"index\.md:3.*number: "),
        ("| a |\n|---|\n| {number}`nothing.here` |", r"index\.md:\d+.*unknown figure 'nothing'"),
        ("```{benchmark-label} none\n```", r"index\.md:3.*unknown benchmark 'none'; there are: frame"),
    ],
)
def test_what_is_unknown_fails_the_build(build_page, text, message):
    _, warnings = build_page(text)
    assert re.search(message, warnings), warnings


def test_benchmark_says_where_it_was_measured(build_page):
    times = "{number}`bench:frame.time_ms .1f` ms{spread}`bench:frame.time_ms|.0f`, no{spread}`bench:frame.quick_ms`."
    html, warnings = build_page(f"```{{benchmark-label}} frame\n```\n\n{times}")
    assert warnings == ""
    assert "Measured on two cores, 2025-01-01, at commit abc1234." in html
    assert '<span class="number">16.2</span> ms (16 to 19), no.' in html


def test_what_was_measured_before_the_code_changed_says_so(book, build_page, monkeypatch):
    """A record's numbers and label, numbers and picture of a figure that reads another; and a fresh one."""
    then = {name: f"measured at commit {name}; the code has changed since" for name in ("frames", "texture")}
    monkeypatch.setattr(records, "remark", then.get)
    results = book.parent / "verify" / "benchmark" / "results"
    for name in ("frames", "machines"):
        shutil.copy(results / "frame.json", results / f"{name}.json")
    describe(book, reads=[records.RECORDS["texture"].path])
    page = (
        "{number}`bench:frames.time_ms .1f`, {number}`bench:machines.time_ms .1f`.\n\n```{benchmark-label} frames\n```"
    )
    html, warnings = build_page(f"{page}\n\n{FIGURE % ('sweep', ':alt: a falling curve')}")
    assert warnings == ""
    mark = '<abbr class="stale" title="{}">{}</abbr>'
    assert (
        f'<span class="number">16.2{mark.format(then["frames"], "†")}</span>, <span class="number">16.2</span>.' in html
    )
    assert "at commit abc1234; the code has changed since.</p>" in html
    assert f"0.01214{mark.format(then['texture'], '††')}" in html
    said = {name: f"{text[0].upper()}{text[1:]}." for name, text in then.items()}
    notes = re.findall(r'<p class="stale">(.*?)</p>', html)
    assert notes == [said["texture"], f"† {said['frames']}", f"†† {said['texture']}"]


def test_a_stream_that_the_kernel_cuts_in_two_is_one(tmp_path):
    parts = "for part in ('a:', '\\n\\n  b\\n'):\n    print(part, end='', flush=True)\n    time.sleep(0.5)"
    notebook = new_notebook(cells=[new_code_cell(f"import time\n{parts}")])
    pages.join_streams(None)
    utils.single_nb_execution(notebook, tmp_path, timeout=60, allow_errors=False)
    assert [output.text for output in notebook.cells[0].outputs] == ["a:\n\n  b\n"]
