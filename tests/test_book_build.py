"""The stages of `python -m book`: what is skipped, what is run again, what a failure leaves behind."""

import shutil
import subprocess
from pathlib import Path

import pytest
from playwright.sync_api import expect

import book.__main__ as command_line
from book.assembly import report, stamps, watch, website
from book.extension import pages
from tests.processes import run
from verify.evidence.sources import ROOT


def test_theorems_run_again_when_something_changed_and_until_they_pass(stamped, monkeypatch):
    commands = []

    def run(command, **options):
        commands.append(Path(command[3]).name)
        if len(commands) > 1:
            raise subprocess.CalledProcessError(1, command)
        report.REPORT.touch()

    monkeypatch.setattr(subprocess, "run", run)
    monkeypatch.setattr(report, "REPORT", stamped / "proofs.json")
    monkeypatch.setattr(report, "reported_hashes", lambda: {"a": "1"})
    for _ in range(2):
        report.make()
    assert commands == ["test_theorems.py"]
    report.REPORT.unlink()
    for count in (2, 3):
        with pytest.raises(subprocess.CalledProcessError):
            report.make()
        assert len(commands) == count


def test_a_watched_page_is_built_alone_as_often_as_it_is_saved(tmp_path, monkeypatch):
    """In a book of three pages with this one's settings, built in this process and without the simulator."""
    for name in ("_templates", "static"):
        shutil.copytree(website.BOOK / name, tmp_path / name)
    for name in ("_config.yml", "references.bib"):
        shutil.copy(website.BOOK / name, tmp_path)
    (tmp_path / "_toc.yml").write_text(
        "format: jb-book\nroot: index\nparts: [{caption: One, chapters: [{file: s1}, {file: api}]}]\n"
    )
    (tmp_path / "index.md").write_text("# Page\n\nSee [](s1.md).\n\n```{bibliography}\n```\n")
    (tmp_path / "s1.md").write_text("(s1)=\n# Bumps\n\nAn aardvark, by {cite}`Blinn1978`.\n")
    (tmp_path / "api.md").write_text("# API\n\n```{eval-rst}\n.. autofunction:: renderer.scene.methods.exact\n```\n")
    monkeypatch.setattr(pages, "PROGRAMS", {})
    html = tmp_path / "watched" / "html"
    with watch.builder(tmp_path, html.parent) as build:
        build()
        before = (html / "api.html").stat().st_mtime_ns
        for words, wrong in {"{no-such-role}`a`": "no-such-role", "$\\no$": "\\no", "Two zebras": ""}.items():
            (tmp_path / "s1.md").write_text(f"(s1)=\n# Bumps\n\n{words}.\n")
            assert wrong in (output := build()) and bool(output) == bool(wrong)
            (tmp_path / "index.md").write_text(f"# Page\n\n{words and 'Another'} edit.\n\n```{{bibliography}}\n```\n")
            assert build() == output  # of a page that is as wrong as it was
    assert "Two zebras" in (html / "s1.html").read_text("utf-8")
    assert before == (html / "api.html").stat().st_mtime_ns


def test_a_watched_page_shows_what_is_wrong_until_it_is_not(browser, tmp_path):
    (tmp_path / "index.html").write_text("<html><body class='a'><p>before</p></body></html>")
    site = watch.Site(tmp_path, 0)
    tab = browser.new_page()
    tab.goto(f"http://localhost:{site.server_port}/")
    for wrong in ("s1.md:3: WARNING: <no> & such", ""):
        site.wrong = wrong
        site.built += 1
        expect(tab.locator(".wrong")).to_have_text(wrong)
    tab.close()
    site.shutdown()


@pytest.fixture
def places(stamped, monkeypatch):
    """A folder with a book of two pages, its work and its site, and a text beside them."""
    places = {"SITE": "html", "INDEX": "html/index.html", "WORK": "work", "CACHES": "caches", "BOOK": "book"}
    for name, place in places.items():
        monkeypatch.setattr(website, name, stamped / place)
    monkeypatch.setattr(stamps, "ROOT", stamped)
    monkeypatch.setattr(website, "execution_cache", lambda: website.CACHES / "one")
    monkeypatch.setattr(website, "site_hashes", lambda: stamps.file_hashes(website.BOOK.iterdir(), root=stamped))
    website.BOOK.mkdir()
    for name in ("s1.md", "s2.md", "text.toml"):
        (website.BOOK / name).write_text(PAGE)
    return stamped


PAGE = """(label)=
# Bumps

The slope {number}`a.b`, of [§2](#s2), and (aside) a word.

:::{figure} a
:alt: a curve
:::
"""
AGAIN = [  # of the page what is changed, by what it is replaced, and the pages that are read again
    ("a word", "one word", ["s1"]),
    *(
        (was, f"{was[:-2]}x{was[-2:]}", None)
        for was in ("(label)=", "# Bumps", "`a.b`", "(#s2)", "{figure} a", ": a curve")
    ),
]


def test_the_work_on_pages_that_stay_is_kept(places, monkeypatch):
    """Not where a file beside them changed, or the kept work itself."""
    asked, page, text = [], website.BOOK / "s1.md", website.BOOK / "text.toml"

    def work(folder, cache, pages):
        asked.append(pages)
        assert {path.suffix for path in folder.rglob("*")} - {""} == (set() if pages is None else {".doctree", ".html"})
        for name in ("html/index.html", ".doctrees/s1.doctree"):
            stamps.write_whole(folder / "_build" / name, b"whole")

    def after(change):
        change()
        website.build()
        return asked[-1]

    monkeypatch.setattr(website, "build_into", work)
    assert after(lambda: None) is None
    for was, now, names in AGAIN:
        assert after(lambda was=was, now=now: page.write_text(PAGE.replace(was, now))) == names, was
        assert after(lambda: page.write_text(PAGE)) == names, was
    assert after(lambda: text.write_text("new")) is None
    assert after(lambda: shutil.rmtree(website.SITE)) == [] and website.INDEX.is_file()
    (website.WORK / "odd").touch()
    assert after(lambda: page.write_text(PAGE.replace("a word", "one word"))) is None


def test_failed_build_leaves_the_old_site_and_no_stamp_and_a_spoilt_site_is_built_again(places, monkeypatch):
    website.SITE.mkdir()
    website.INDEX.write_text("old")
    stamps.write("site", {"a": "0"})

    def half_written(folder, cache, pages):
        (folder / "_build" / "html").mkdir(parents=True)
        raise subprocess.CalledProcessError(1, "jupyter-book")

    monkeypatch.setattr(website, "build_into", half_written)
    with pytest.raises(subprocess.CalledProcessError):
        website.build()
    assert website.INDEX.read_text() == "old"
    assert stamps.read("site") is stamps.read("work") is None
    page = website.SITE / "s2.html"

    def complete(folder, cache, pages):
        made = folder / "_build" / "html"
        made.mkdir(parents=True, exist_ok=True)
        for name in (".buildinfo", website.INDEX.name, page.name):
            (made / name).write_text("whole")

    monkeypatch.setattr(website, "build_into", complete)
    for spoil in (website.build, page.unlink, lambda: page.write_text("who")):
        spoil()
        website.build()
        assert page.read_text() == "whole"


def test_unknown_figure_is_a_usage_error(stamped, capsys):
    assert command_line.main(["figures", "no_such_figure"]) == 2
    assert "no figure is called no_such_figure; there are: " in capsys.readouterr().err


PYTHON = """#!/bin/sh
case "$1 $2" in
"-c "*version_info*) exit {refuses} ;;
"-c "*) echo {version} ;;
--version*) echo "Python {version}" ;;
"-m venv") rm -rf .venv && mkdir -p .venv/bin && cp "$0" .venv/bin/python ;;
*) echo "{version} installs $8" >> installed ;;
esac
"""


@pytest.fixture
def make(tmp_path):
    """A function: arguments → what make prints where there are three Pythons, one of them too old, and two locks."""
    for name, refuses in (("3.11", 0), ("3.13", 0), ("3.9", 1)):
        (tmp_path / f"python{name}").write_text(PYTHON.format(version=name, refuses=refuses))
        (tmp_path / f"python{name}").chmod(0o755)
    for lock in ("requirements.lock", "requirements-book.lock"):
        (tmp_path / lock).write_text(lock)
    shutil.copy(ROOT / "Makefile", tmp_path)
    environment = {"PATH": f"{tmp_path}:/usr/bin:/bin"}
    return lambda *arguments, status=0: "".join(run("make", *arguments, cwd=tmp_path, env=environment, status=status))


def test_an_environment_is_of_the_python_that_is_named(make, tmp_path):
    of = lambda: run(tmp_path / ".venv/bin/python", "--version", cwd=tmp_path)[0].split()[1]  # noqa: E731
    make("PYTHON=python3.11", "environment-book")
    assert of() == "3.11"
    make("PYTHON=python3.13", "environment-book")
    make("environment-book")  # no Python is named
    assert "'python3.9' is " in make("PYTHON=python3.9", "environment-book", status=2)
    assert of() == "3.13"
    assert (tmp_path / "installed").read_text().splitlines() == [
        f"{version} installs requirements-book.lock" for version in ("3.11", "3.13")
    ]


def test_each_lock_is_installed_where_nothing_has_it(make, tmp_path):
    for target in ("environment-book", "environment-book", "environment", "environment-book", "environment"):
        make("PYTHON=python3.11", target)
    (tmp_path / "requirements-book.lock").write_text("new")
    (tmp_path / "requirements.lock").write_text("new, too")
    make("PYTHON=python3.11", "environment-book")
    locks = ("requirements-book", "requirements", "requirements-book")
    assert (tmp_path / "installed").read_text().splitlines() == [f"3.11 installs {lock}.lock" for lock in locks]
