"""The book's own Sphinx extension: numbers, figures, ids; what is unknown fails the build."""

import json
import re

import pytest
from jupyter_cache.executors import utils
from nbformat.v4 import new_code_cell, new_notebook

from book.extension import pages
from book.extension.numbers import typeset
from renderer.intervals import Interval
from tests import one_page
from verify.evidence import records

STALE = {name: f"measured at commit {name}; the code has changed since" for name in ("frames", "simulator")}
LABEL = {"machine": "two cores", "date": "2025-01-01", "commit": "abc1234"}
TIMES = {"time_ms": 16.25, "time_ms_low": 15.5, "time_ms_high": 18.75, "quick_ms": 1.5}
FIGURE = """:::{chapter-figure} %s
:alt: a falling curve
:width: page

The RMS is {number}`%s.rms_1e-3|.2g`.
:::"""


@pytest.fixture
def book(tmp_path, monkeypatch):
    """A book folder with two drawn figures, one from a stale record, beside two committed benchmarks, one stale."""
    folder, results = tmp_path / "book", tmp_path / "verify" / "benchmark" / "results"
    (folder / "_generated").mkdir(parents=True)
    results.mkdir(parents=True)
    (folder / "sweep.py").touch()
    numbers = {"rms_1e-3": 0.01214, "rms_1e-3_lower": 0.01212, "rms_1e-3_upper": 0.01216, "flips": 0}
    for id, undecided, reads in (("sweep", 0, []), ("old", 1234, [records.RECORDS["simulator"].path])):
        drawn = {"kind": "svg", "size": [640, 300], "numbers": numbers, "source": "book/sweep.py", "function": "sweep"}
        drawn |= {"data": f"{id}.csv", "key": f"{id}9abcdef", "reads": reads}
        drawn |= {"certified": {"within": 8.1e-10, "undecided": undecided, "pixels": 4096}}
        files = {"json": json.dumps(drawn), "csv": "step\n0.001\n"}
        files |= dict.fromkeys(("svg", "dark.svg"), '<svg xmlns="http://www.w3.org/2000/svg"/>')
        for suffix, text in files.items():
            (folder / "_generated" / f"{id}.{suffix}").write_text(text)
    for name in ("frames", "machines"):
        (results / f"{name}.json").write_text(json.dumps({"label": LABEL, "numbers": TIMES}))
    monkeypatch.setattr(records, "remark", STALE.get)
    return folder


def test_a_page_shows_figures_and_numbers_and_says_which_are_stale(book):
    times = "{number}`bench:%s.time_ms .1f` ms{spread}`bench:%s.time_ms|.0f`, no{spread}`bench:%s.quick_ms`."
    labels = [f"{times % (3 * (name,))}\n\n```{{benchmark-label}} {name}\n```" for name in ("machines", "frames")]
    figures = [FIGURE % (id, id) for id in ("sweep", "old")]
    html, warnings = one_page.build(book, "\n\n".join([*labels, "## Figures", *figures, "See {numref}`fig-sweep`."]))
    assert warnings == ""
    mark = '<abbr class="stale" title="{}">{}</abbr>'
    for stale, since in (("", ""), (mark.format(STALE["frames"], "†"), "; the code has changed since")):
        assert f"Measured on two cores, 2025-01-01, at commit abc1234{since}.</p>" in html
        assert f'<span class="number">16.2{stale}</span> ms (16 to 19), no.' in html
    for stale in ("", mark.format(STALE["simulator"], "††")):
        assert f'The RMS is <span class="number">0.012{stale}</span>.' in html
    sentences = {name: f"{text[0].upper()}{text[1:]}." for name, text in STALE.items()}
    notes = [sentences["simulator"], f"† {sentences['frames']}", f"†† {sentences['simulator']}"]
    assert re.findall(r'<p class="stale">(.*?)</p>', html) == notes
    assert 'id="fig-sweep"' in html and 'href="#fig-sweep"><span class="std std-numref">Fig. 1</span>' in html
    assert html.count('alt="a falling curve"') == 4
    assert 'class="plot only-dark"' in html and 'class="plot only-light"' in html
    assert all(name in html for name in ("sweep.json", "sweep.csv", "sweep.py", "sweep9abcdef"))
    off = r"every colour within 8.1\s×\s10<sup>−10</sup> of its own formula in exact arithmetic \(rounding alone\)"
    but = ", but for 1,234 of 4,096 pixels that rounding leaves undecided"
    assert re.findall(f"{off}, certified(.*?)</p>", html) == ["", but]


def test_unknown_numbers_are_refused_with_a_list_of_known_ones(book):
    """So is whatever else a page may get wrong: all of it on one page."""
    mistakes = {
        ":::{chapter-figure} sweep\n:width: page\n:::": "alt is required",
        ":::{chapter-figure} swep\n:alt: a curve\n:::": "unknown figure 'swep'; there are: old, sweep",
        ":::{chapter-figure} sweep\n:alt: a curve\n:width: half\n:::": "half",
        "A number: {number}`sweep.rsm`.": "'sweep' has no number 'rsm'; it has: flips, rms_1e-3",
        "A number: {number}`sweep.flips|.q`.": "number: ",
        "A number: {number}`sweep.rms_1e-3|.4g`.": "of a number from 0.01212 to 0.01216 is not certain",
        "A number: {number}`sweep`": "'sweep' is not of the form id.key",
        "A number: {number}`bench:fram.x`": "unknown benchmark 'fram'; there are: frames, machines",
        "A number: {number}`nothing.here`": "unknown figure 'nothing'",
        "```{benchmark-label} none\n```": "unknown benchmark 'none'; there are: frames, machines",
    }
    one_page.refused(book, mistakes)


LABELLED = """| {number}`bench:frames.quick_ms` |
|---|
| {number}`sweep.flips` |

```{benchmark-label} frames
```

{number}`bench:machines.quick_ms`

```{benchmark-label} machines
Of machines.
```

## In a table

| {number}`bench:frames.time_ms` |
|---|

```{benchmark-label} machines
```

## Behind a label, from a figure that is drawn from a record

```{benchmark-label} machines
```

{number}`old.flips`, {number}`bench:machines.time_ms`

## Two labels

{number}`bench:machines.quick_ms`, {number}`bench:frames.quick_ms`

```{benchmark-label} machines
```

```{benchmark-label} frames
```

### And none

{number}`old.flips`
"""


def test_a_number_under_the_label_of_another_record_is_refused(book):
    html, warnings = one_page.build(book, LABELLED)
    wrong = re.findall(r"index\.md:(\d+): ERROR: :number:`(\S+)` is not of machines, whose label it has", warnings)
    assert [id for _, id in wrong] == ["bench:frames.time_ms", "old.flips"] and warnings.count("ERROR") == 2
    assert all(id in LABELLED.splitlines()[int(line) - 3] for line, id in wrong)
    assert "Of machines. Measured on two cores" in html


def test_typesetting():
    for value, spec, expected in (
        (-6.116e-5, ".1e", "−6.1\u00a0×\u00a010−5"),
        (-1.5, None, "−1.5"),
        (0.5, ".0%", "50%"),
        (Interval(4.1e-11, 3.96e-11, 4.04e-11), None, "4\u00a0×\u00a010−11"),
    ):
        assert "".join(part.astext() for part in typeset(value, spec)) == expected


def test_a_stream_that_the_kernel_cuts_in_two_is_one(tmp_path):
    parts = "for part in ('a:', '\\n\\n  b\\n'):\n    print(part, end='', flush=True)\n    time.sleep(0.5)"
    notebook = new_notebook(cells=[new_code_cell(f"import time\n{parts}")])
    pages.join_streams(None)
    utils.single_nb_execution(notebook, tmp_path, timeout=60, allow_errors=False)
    assert [output.text for output in notebook.cells[0].outputs] == ["a:\n\n  b\n"]
