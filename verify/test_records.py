"""A record is stale when its code has changed, and not before; `make evidence` measures what is stale and no more."""

import json
from types import SimpleNamespace

import pytest

from verify import evidence, records, sources
from verify.records import RESULTS, Record, Run, read, why_stale

FILES = {
    "verify/__init__.py": "",
    "verify/run.py": '"""A run."""\nfrom proofs.law import law\nprint(law(2))\n',
    "verify/other.py": "print(1)\n",
    "proofs/__init__.py": "",
    "proofs/law.py": 'def law(x):\n    """Its words."""\n    return x + 1  # why\n',
    "proofs/table.json": "[1]",
    "proofs/words.md": "Words.",
    "proofs/test_law.py": "assert True\n",
    "requirements.lock": "numpy==1.0 \\\n    --hash=a\npillow==1.0\n",
}
FAKE = {
    name: Record(name, RESULTS, f"-m verify.{module}", (f"verify/{module}.py",), ("numpy",))
    for name, module in (("sums", "run"), ("ones", "other"))
}


def forget():
    for function in (records.code_of, sources._direct_imports, sources._module_files, sources.without_prose):
        function.cache_clear()


@pytest.fixture
def project(tmp_path, monkeypatch):
    """A small project with two records, whose runs have just been."""
    for name, text in FILES.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    (tmp_path / RESULTS).mkdir()
    for module in (records, sources, evidence):
        monkeypatch.setattr(module, "ROOT", tmp_path)
    monkeypatch.setattr(records, "RECORDS", FAKE)
    monkeypatch.setattr(evidence, "RECORDS", FAKE)
    forget()
    for name in FAKE:
        Run(name).write({"numbers": {"found": 3}})
    yield tmp_path
    forget()


def edit(place, old, new):
    text = place.read_text()
    assert old in text
    place.write_text(text.replace(old, new))
    forget()


@pytest.mark.parametrize(
    ("name", "old", "new", "why"),
    [
        ("proofs/law.py", "x + 1", "x - 1", "proofs/law.py changed"),
        ("verify/run.py", "law(2)", "law(3)", "verify/run.py changed"),
        ("proofs/table.json", "1", "2", "proofs/table.json changed"),
        ("requirements.lock", "numpy==1.0", "numpy==1.1", "numpy changed"),
        ("proofs/law.py", "# why", "# because", None),
        ("proofs/law.py", "Its words.", "Other\n\n    words.", None),
        ("proofs/words.md", "Words", "Others", None),
        ("proofs/test_law.py", "True", "1", None),
        ("verify/other.py", "1", "2", None),
        ("requirements.lock", "pillow==1.0", "pillow==1.1", None),
    ],
)
def test_a_record_is_stale_if_its_code_changed_and_only_then(project, name, old, new, why):
    assert why_stale("sums") is None and records.remark.__wrapped__("sums") is None
    edit(project / name, old, new)
    assert why_stale("sums") == why
    said = f"measured at commit {read('sums')['label']['commit']}; the code has changed since"
    assert records.remark.__wrapped__("sums") == (said if why else None)


def test_the_hashes_are_those_of_the_code_that_ran(project):
    run = Run("sums")
    edit(project / "proofs/law.py", "x + 1", "x - 1")
    run.write({"numbers": {}, "label": {"browser": "none"}})
    assert why_stale("sums") == "proofs/law.py changed" and read("sums")["label"]["browser"] == "none"


@pytest.mark.parametrize(
    ("key", "value", "why"),
    [
        ("numbers", {"found": 4}, "changed after"),
        ("code", {}, "changed after"),
        ("seal", "0" * 16, "changed after"),
        ("code", None, "does not say"),
        ("seal", None, "does not say"),
    ],
)
def test_a_record_that_was_edited_by_hand_is_stale(project, key, value, why):
    content = {name: part for name, part in (read("sums") | {key: value}).items() if part is not None}
    (project / FAKE["sums"].path).write_text(json.dumps(content))
    assert why in why_stale("sums")


def test_what_was_measured_with_other_options_is_not_kept(project, capsys, tmp_path):
    def measure(rounds, only):
        return {"numbers": {"rounds": rounds, "only": only}}

    def run(*arguments):
        records.command("sums", "A run.", measure, [*map(str, arguments)], rounds=9, only="")
        return read("sums")["numbers"]

    assert run("--rounds", 1) == run("--only", "a") == {"found": 3}
    assert capsys.readouterr().out.count("not kept") == 2
    run("--rounds", 1, "--output", tmp_path)
    assert json.loads((tmp_path / "sums.json").read_text())["numbers"] == {"rounds": 1, "only": ""}
    assert run() == {"rounds": 9, "only": ""}
    with pytest.raises(SystemExit, match="2"):
        run("--rounds", 0)


@pytest.fixture
def runs(project, monkeypatch):
    """The records that were measured, by a run that does what a test makes of it."""
    found = SimpleNamespace(made=[], status=0, writes=True)

    def run(command, **_):
        name = next(name for name, record in FAKE.items() if command[1:] == record.command.split())
        found.made.append(name)
        if found.writes:
            Run(name).write({"numbers": {"found": 5}})
        return SimpleNamespace(returncode=found.status)

    monkeypatch.setattr(evidence.subprocess, "run", run)
    monkeypatch.setattr(records, "commit", lambda: "abc1234")
    return found


def test_only_what_is_stale_is_measured(project, runs, capsys):
    assert evidence.main([]) == 0 and runs.made == []
    edit(project / "proofs/law.py", "x + 1", "x - 1")
    assert evidence.main(["--list"]) == 0 and runs.made == []
    assert "stale: proofs/law.py changed: python -m verify.run" in capsys.readouterr().out
    assert evidence.main(["ones"]) == 0 and runs.made == []
    assert evidence.main(["sums", "ones"]) == 0 and runs.made == ["sums"]
    assert [read(name)["numbers"]["found"] for name in FAKE] == [5, 3]
    assert evidence.main([]) == 0 and runs.made == ["sums"]
    with pytest.raises(SystemExit, match="2"):
        evidence.main(["nothing"])


def test_what_cannot_be_measured_is_said(project, runs, capsys, monkeypatch):
    edit(project / "proofs/law.py", "x + 1", "x - 1")
    runs.writes, runs.status = False, 3
    assert evidence.main([]) == 1 and "still stale: sums: its run ended with status 3" in capsys.readouterr().out
    needy = Record("sums", RESULTS, "-m verify.run", ("verify/run.py",), needs=("no_such_library",))
    monkeypatch.setitem(FAKE, "sums", needy)
    assert evidence.main([]) == 1 and runs.made == ["sums"]
    assert "it needs no_such_library, which is not installed" in capsys.readouterr().out


def test_what_was_written_before_an_interruption_stays(project, runs, capsys, monkeypatch):
    for path in ("verify/run.py", "verify/other.py"):
        edit(project / path, "print", "str")
    whole = evidence.renew

    def stopped(name):
        if runs.made:
            raise KeyboardInterrupt
        return whole(name)

    monkeypatch.setattr(evidence, "renew", stopped)
    before = read("ones")
    assert evidence.main([]) == 1 and read("ones") == before and why_stale("sums") is None
    said = capsys.readouterr().out
    assert "measured anew: sums\n" in said and "still stale: ones: its run was stopped" in said
