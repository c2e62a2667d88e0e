"""Another book with the same tools, tests/examples/second_book/: proved and built by two commands, and kept apart."""

import json
import shutil
from types import SimpleNamespace

from book.editions.pages import parsed
from proofs.engine.project import FILE, PROJECT, project_of
from proofs.engine.theorem import all_theorems
from tests.processes import python
from tests.test_contributing import EXAMPLES, shell
from verify import conftest
from verify.evidence.sources import ROOT

EXAMPLE, ID = EXAMPLES / "second_book", "distance_from_focus"


def test_a_second_book_is_proved_and_built_and_writes_nothing_of_this_one(tmp_path):
    folder = shutil.copytree(EXAMPLE, tmp_path / "a book", ignore=shutil.ignore_patterns(".*", "_build", "_generated"))
    shell(folder, f"TOOLS={ROOT} . ./run.sh")
    (entry,) = json.loads((folder / "pages" / "_generated" / "proofs.json").read_text("utf-8"))["theorems"]
    assert [entry[of] for of in ("id", "grade", "statements", "killed")] == [ID, "proved", 1, "2/2"]
    site = folder / "pages" / "_build" / "html"
    page = parsed((site / "index.html").read_text("utf-8"))
    assert [number.get_text() for number in page.select("span.number")] == ["0.4", "0.6"]
    assert (site / page.select_one("#fig-orbit img")["src"]).is_file()
    listing, script = (page.select_one(f"{of} .provenance a")["href"] for of in (f"#theorem-{ID}.proved", "#fig-orbit"))
    assert (site / listing.partition("#")[0]).is_file()
    assert (site / script).read_bytes() == (EXAMPLE / "kepler" / "figures" / "orbit.py").read_bytes()
    ours = [*PROJECT.generated.glob("*.json"), *PROJECT.certificates.iterdir()]
    assert not [path for path in ours if path.stem == "orbit" or ID in path.read_text("utf-8")]


def test_where_no_file_names_a_project_this_one_is_read_and_nothing_is_written(tmp_path, monkeypatch):
    (tmp_path / FILE).write_text("[tool.other]")
    outside = project_of(tmp_path)
    assert outside == PROJECT._replace(writable=False) and project_of(EXAMPLE / "pages").root == EXAMPLE
    entries = [{"id": id, "grade": "proved", "expected": "proved", "uses": []} for id in all_theorems()]
    monkeypatch.setattr(conftest, "EVIDENCE", entries)
    for command in ("proofs.engine.certificate", "renderer.generate", "book"):
        _, refusal = python("-m", command, status=1, cwd=tmp_path, env={"PYTHONPATH": str(ROOT)})
        assert "nothing is written" in refusal
    session = SimpleNamespace(config=SimpleNamespace(getoption=lambda name: None))
    for project in (outside, PROJECT):
        monkeypatch.setattr(conftest, "PROJECT", project._replace(pages=tmp_path))
        conftest.pytest_sessionfinish(session, 0)
        assert conftest.PROJECT.report.is_file() == project.writable
