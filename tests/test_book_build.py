"""The stages of `python -m book`: what is skipped, what is run again, what a failure leaves behind."""

import shutil
import subprocess

import pytest

import book.__main__ as command_line
from book.assembly import report, stamps, watch, website
from book.extension import pages

pytestmark = pytest.mark.filterwarnings("ignore:'BaseCommand' is deprecated")  # Jupyter Book's


def test_theorems_run_again_when_something_changed_and_until_they_pass(stamped, monkeypatch):
    commands = []

    def run(command, **options):
        commands.append(command[3])
        if len(commands) > 1:
            raise subprocess.CalledProcessError(1, command)
        report.REPORT.touch()

    monkeypatch.setattr(subprocess, "run", run)
    monkeypatch.setattr(report, "REPORT", stamped / "proofs.json")
    monkeypatch.setattr(report, "reported_hashes", lambda: {"a": "1"})
    for _ in range(2):
        report.make()
    assert commands == ["verify/test_theorems.py"]
    report.REPORT.unlink()
    for count in (2, 3):
        with pytest.raises(subprocess.CalledProcessError):
            report.make()
        assert len(commands) == count


@pytest.fixture
def small_book(stamped, monkeypatch):
    """A book of three pages with this one's settings, built in this process and without the simulator; its folder."""
    folder = stamped / "book"
    for name in ("_templates", "static"):
        shutil.copytree(website.BOOK / name, folder / name)
    for name in ("_config.yml", "references.bib"):
        shutil.copy(website.BOOK / name, folder)
    (folder / "_toc.yml").write_text(
        "format: jb-book\nroot: index\nparts: [{caption: One, chapters: [{file: s1}, {file: api}]}]\n"
    )
    (folder / "index.md").write_text("# Page\n\nSee [](s1.md).\n\n```{bibliography}\n```\n")
    (folder / "s1.md").write_text("(s1)=\n# Bumps\n\nAn aardvark, by {cite}`Blinn1978`.\n")
    (folder / "api.md").write_text("# API\n\n```{eval-rst}\n.. autofunction:: renderer.scene.methods.exact\n```\n")
    build, site = folder / "_build", folder / "_build" / "html"
    places = {"BOOK": folder, "SITE": site, "INDEX": site / "index.html", "WORK": build / "work"}
    for name, value in (places | {"CACHES": stamped / "caches"}).items():
        monkeypatch.setattr(website, name, value)
    monkeypatch.setattr(website, "site_hashes", lambda: {f"book/{p.name}": p.read_text() for p in folder.glob("*.md")})
    monkeypatch.setattr(website, "execution_cache", lambda: stamped / "caches" / "now")
    monkeypatch.setattr(pages, "PROGRAMS", {})

    def run(command, **options):
        from jupyter_book.cli.main import main

        main(command[3:], standalone_mode=False)
        return subprocess.CompletedProcess(command, 0)

    monkeypatch.setattr(subprocess, "run", run)
    return folder


def times(html):
    """When the other pages were written."""
    return [(html / name).stat().st_mtime_ns for name in ("index.html", "api.html")]


def test_a_watched_page_is_built_alone_as_often_as_it_is_saved(small_book):
    html = small_book / "watched" / "html"
    with watch.builder(small_book, html.parent) as build:
        build()
        before = times(html)
        for words in ("Two zebras", "{no-such-role}`a`", "Three zebras"):
            (small_book / "s1.md").write_text(f"(s1)=\n# Bumps\n\n{words}.\n")
            build()
    assert "Three zebras" in (html / "s1.html").read_text("utf-8")
    assert before[1] == times(html)[1]


def test_failed_build_leaves_the_old_site_and_no_stamp(small_book, monkeypatch):
    website.SITE.mkdir(parents=True)
    website.INDEX.write_text("old")
    stamps.write("site", {"a": "0"})

    def half_written(folder, cache):
        (folder / "_build" / "html").mkdir(parents=True)
        raise subprocess.CalledProcessError(1, "jupyter-book")

    monkeypatch.setattr(website, "build_into", half_written)
    with pytest.raises(subprocess.CalledProcessError):
        website.build()
    assert website.INDEX.read_text() == "old"
    assert stamps.read("site") is None


def test_unknown_figure_is_a_usage_error(stamped, capsys):
    assert command_line.main(["figures", "no_such_figure"]) == 2
    assert "no figure is called no_such_figure; there are: " in capsys.readouterr().err
