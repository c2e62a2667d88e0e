"""Another book with the same tools, tests/examples/second_book/: proved and built by two commands, and kept apart."""

import json
import shutil
from dataclasses import replace
from types import SimpleNamespace

import pytest

from book.editions.pages import parsed
from proofs.engine.project import FILE, PROJECT, Project, project_of
from proofs.engine.theorem import all_theorems
from tests.test_contributing import EXAMPLES, shell
from verify import conftest
from verify.sources import ROOT

EXAMPLE, ID = EXAMPLES / "second_book", "distance_from_focus"


@pytest.fixture(scope="module")
def second(tmp_path_factory):
    """A copy of it, built as its page says."""
    folder = tmp_path_factory.mktemp("second") / "a book"
    built = shutil.ignore_patterns(".*", "_build", "_generated", "certificates", "__pycache__")
    shutil.copytree(EXAMPLE, folder, ignore=built)
    shell(folder, f"TOOLS={ROOT} . ./run.sh")
    return folder


def test_it_is_proved_and_its_false_variants_are_not(second):
    (entry,) = json.loads((second / "pages" / "_generated" / "proofs.json").read_text("utf-8"))["theorems"]
    assert (entry["id"], entry["grade"], entry["statements"]) == (ID, "proved", 1)
    assert [m["refused"] and m["counterexample"] is not None for m in entry["mutants"]] == [True, True]


def test_its_page_has_the_card_the_numbers_the_figure_and_their_sources(second):
    site = second / "pages" / "_build" / "html"
    page = parsed((site / "index.html").read_text("utf-8"))
    card, figure = page.find(id=f"theorem-{ID}"), page.find(id="fig-orbit")
    assert "proved" in card["class"] and "Theorem 1" in card.get_text()
    assert [number.get_text() for number in page.select("span.number")] == ["0.4", "0.6"]
    drawn_by, numbers = ((site / link["href"]).read_bytes() for link in figure.select("a.download")[::2])
    assert drawn_by == (second / "kepler" / "figures" / "orbit.py").read_bytes()
    assert json.loads(numbers)["numbers"] == {"e": 0.6, "nearest": 0.4}
    assert (site / "_images" / "orbit.svg").is_file()
    listing = next(link["href"].partition("#")[0] for link in card.select("a.internal") if link.get_text() == "source")
    assert "Distance from the focus" in parsed((site / listing).read_text("utf-8")).get_text()
    for link in page.select("link[rel=stylesheet], script[src]"):
        assert (site / (link.get("href") or link["src"]).partition("?")[0]).is_file(), link


def test_nothing_of_this_book_is_written(second):
    """Neither the report, nor a figure, a certificate or a stamp."""
    if PROJECT.report.is_file():
        theorems = json.loads(PROJECT.report.read_text("utf-8"))["theorems"]
        assert {entry["id"] for entry in theorems} == all_theorems().keys()
    for folder in (PROJECT.generated, PROJECT.certificates, ROOT / ".stamps"):
        assert not [path for path in folder.rglob("*") if path.stem in (ID, "orbit")]


def test_the_nearest_file_names_the_project_and_where_it_names_none_nothing_is_written(tmp_path, monkeypatch):
    assert (project_of(EXAMPLE / "pages").root, project_of(ROOT / "book" / "chapter").root) == (EXAMPLE, ROOT)
    assert project_of(EXAMPLE).writable and project_of(EXAMPLE) == Project.read(EXAMPLE)
    for text in (None, "[tool.other]"):
        if text:
            (tmp_path / FILE).write_text(text)
        (tmp_path / "below").mkdir(exist_ok=True)
        found = project_of(tmp_path / "below")
        assert (found.root, found.theorems, found.writable) == (ROOT, PROJECT.theorems, False)
    all_of_them = [{"id": id, "grade": "cited", "expected": "cited", "uses": []} for id in all_theorems()]
    monkeypatch.setattr(conftest, "EVIDENCE", all_of_them)
    config = SimpleNamespace(getoption=lambda name: None)
    for writable in (False, True):
        monkeypatch.setattr(conftest, "PROJECT", replace(PROJECT, pages=tmp_path, writable=writable))
        conftest.pytest_sessionfinish(SimpleNamespace(config=config), 0)
        assert conftest.PROJECT.report.is_file() == writable
