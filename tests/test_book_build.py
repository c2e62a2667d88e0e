"""The stages of `python -m book`: what is skipped, what is run again, what a failure leaves behind."""

import subprocess
import sys

import pytest

from book.build import check, stamps, website


@pytest.fixture
def stamped(monkeypatch, tmp_path):
    """Stamps in a folder of their own."""
    monkeypatch.setattr(stamps, "STAMPS", tmp_path / "stamps")
    return tmp_path


@pytest.fixture
def runs(monkeypatch):
    """The commands that would have been run, and the status that they end with."""
    commands, status = [], [0]

    def run(command, **options):
        commands.append(command)
        if status[0]:
            raise subprocess.CalledProcessError(status[0], command)

    monkeypatch.setattr(subprocess, "run", run)
    return commands, status


def test_check_runs_again_only_when_something_changed(stamped, monkeypatch, runs):
    commands, _ = runs
    source = stamps.ROOT / "pyproject.toml"
    monkeypatch.setattr(check, "sources", lambda: [source])
    check.check()
    check.check()
    assert len(commands) == 1
    assert commands[0][1:4] == ["-m", "pytest", "verify"]
    monkeypatch.setattr(check, "sources", lambda: [source, stamps.LOCK_FILE])
    check.check()
    assert len(commands) == 2


def test_check_that_fails_is_not_remembered_as_passed(stamped, monkeypatch, runs):
    commands, status = runs
    monkeypatch.setattr(check, "sources", lambda: [stamps.LOCK_FILE])
    check.check()
    monkeypatch.setattr(check, "sources", lambda: [])
    status[0] = 1
    for _ in range(2):
        with pytest.raises(subprocess.CalledProcessError):
            check.check()
    assert len(commands) == 3


def test_check_reaches_code_and_data_but_no_prose():
    names = {path.relative_to(stamps.ROOT).as_posix() for path in check.sources()}
    assert {"requirements.lock", "pyproject.toml", "book/build/stamps.py", "tests/data/seed_64.npz"} <= names
    assert any(name.startswith("proofs/") for name in names)
    assert not any(name.endswith(".md") for name in names if name.startswith("book/"))


def test_failed_build_leaves_the_old_site_and_no_stamp(stamped, monkeypatch):
    site, work = stamped / "html", stamped / "book"
    site.mkdir()
    (site / "index.html").write_text("old")
    for name, value in {"BOOK": work, "SITE": site, "INDEX": site / "index.html"}.items():
        monkeypatch.setattr(website, name, value)
    monkeypatch.setattr(website, "sources", lambda: {"a": "1"})
    monkeypatch.setattr(website, "execution_cache", lambda: website.CACHES)
    monkeypatch.setattr(website, "CACHES", stamped / "caches")
    stamps.write("site", {"a": "0"})

    def half_written(folder, cache):
        (folder / "_build" / "html").mkdir(parents=True)
        raise subprocess.CalledProcessError(1, "jupyter-book")

    monkeypatch.setattr(website, "build_into", half_written)
    with pytest.raises(subprocess.CalledProcessError):
        website.build()
    assert (site / "index.html").read_text() == "old"
    assert stamps.read("site") is None
    assert not (work / "_build" / "next").exists()


def test_build_does_not_inherit_what_would_change_its_bytes(monkeypatch, tmp_path):
    monkeypatch.setenv("MPLBACKEND", "agg")
    monkeypatch.setenv("TZ", "Asia/Tokyo")
    environment = website.environment(tmp_path)
    assert "MPLBACKEND" not in environment
    assert (environment["TZ"], environment["PYTHONHASHSEED"]) == ("UTC", "0")


def test_unreadable_stamp_counts_as_none(stamped):
    stamps.write("x", {"a": 1})
    assert stamps.read("x") == {"a": 1}
    (stamps.STAMPS / "x.json").write_text("{")
    assert stamps.read("x") is None


def test_unknown_figure_is_a_usage_error():
    command = [sys.executable, "-m", "book", "figures", "no_such_figure"]
    done = subprocess.run(command, cwd=stamps.ROOT, capture_output=True, text=True)
    assert done.returncode == 2
    assert "no figure is called no_such_figure; there are: " in done.stderr
