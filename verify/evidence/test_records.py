"""A record is stale when its code has changed, and not before; `make evidence` measures what is stale and no more."""

import json
from dataclasses import replace
from types import SimpleNamespace

import pytest

from verify.evidence import __main__ as evidence, records, sources
from verify.evidence.records import RESULTS, Record, Run, read, why_stale

FILES = {
    "verify/__init__.py": "",
    "verify/run.py": '"""A run."""\nfrom proofs.law import law\nprint(law(2))\n',
    "verify/other.py": "print(1)\n",
    "proofs/__init__.py": "",
    "proofs/law.py": 'def law(x):\n    """Its words."""\n    return x + 1  # why\n',
    "proofs/table.json": "[1]",
    "proofs/words.md": "Words.",
    "proofs/test_law.py": "assert True\n",
    "requirements.lock": "numpy==1.0 \\\n    --hash=a\npillow==1.0\nnumpy==2.0\n",
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


def test_a_record_is_stale_if_its_code_changed_and_only_then(project):
    for name, old, new, why in (
        ("proofs/law.py", "x + 1", "x - 1", "proofs/law.py changed"),
        ("verify/run.py", "law(2)", "law(3)", "verify/run.py changed"),
        ("proofs/table.json", "[1]", "[2]", "proofs/table.json changed"),
        ("requirements.lock", "numpy==2.0", "numpy==2.1", "numpy changed"),
        ("proofs/law.py", "# why", "# because", None),
        ("proofs/law.py", "Its words.", "Other\n\n    words.", None),
        ("proofs/words.md", "Words", "Others", None),
        ("proofs/test_law.py", "True", "1", None),
        ("verify/other.py", "1", "2", None),
        ("requirements.lock", "pillow==1.0", "pillow==1.1", None),
    ):
        assert why_stale("sums") is None and records.remark.__wrapped__("sums") is None
        edit(project / name, old, new)
        assert why_stale("sums") == why, name
        words = f"measured at commit {read('sums')['label']['commit']}; the code has changed since"
        assert records.remark.__wrapped__("sums") == (words if why else None)
        edit(project / name, new, old)


def test_the_hashes_are_those_of_the_code_that_ran_and_what_was_edited_by_hand_is_stale(project):
    content = read("sums")
    for edited, why in ((content | {"numbers": {"found": 4}}, "changed after"), ({"numbers": {}}, "does not say")):
        (project / FAKE["sums"].path).write_text(json.dumps(edited))
        assert why in why_stale("sums")
    run = Run("sums")
    edit(project / "proofs/law.py", "x + 1", "x - 1")
    run.write({"numbers": {}, "label": {"browser": "none"}})
    assert why_stale("sums") == "proofs/law.py changed" and read("sums")["label"]["browser"] == "none"


def test_what_was_measured_with_other_options_is_not_kept(project, capsys):
    def run(*arguments):
        records.command("sums", "A run.", lambda **numbers: {"numbers": numbers}, [*arguments], rounds=9, only="")
        return read("sums")["numbers"]

    assert run("--rounds", "1") == run("--only", "a") == {"found": 3}
    assert capsys.readouterr().out.count("not kept") == 2
    run("--rounds", "1", "--output", str(project))
    assert json.loads((project / "sums.json").read_text())["numbers"] == {"rounds": 1, "only": ""}
    assert run() == {"rounds": 9, "only": ""}
    with pytest.raises(SystemExit, match="2"):
        run("--rounds", "0")


def test_only_what_is_stale_is_measured_and_what_was_written_before_an_interruption_stays(project, monkeypatch, capsys):
    made = []

    def run(command, **_):
        name = next(name for name, record in FAKE.items() if command[1:] == record.command.split())
        if made:  # the second is stopped
            raise KeyboardInterrupt
        made.append(name)
        Run(name).write({"numbers": {"found": 5}})
        return SimpleNamespace(returncode=0)

    def measured(*arguments, status=0):
        made.clear()
        assert evidence.main([*arguments]) == status
        return made, capsys.readouterr().out

    monkeypatch.setattr(records, "commit", lambda: "abc1234")
    monkeypatch.setattr(evidence.subprocess, "run", run)
    assert measured()[0] == []
    for path in ("verify/run.py", "verify/other.py"):
        edit(project / path, "print", "str")
    before = read("ones")
    assert "stale: verify/run.py changed: python -m verify.run" in measured("--list")[1]
    with monkeypatch.context() as patch:
        patch.setitem(FAKE, "sums", replace(FAKE["sums"], needs=("no_such_library",)))
        assert "it needs no_such_library, which is not installed" in measured("sums", status=1)[1]
    with monkeypatch.context() as patch:
        patch.setattr(evidence.subprocess, "run", lambda *_, **__: SimpleNamespace(returncode=3))
        assert "still stale: sums: its run ended with status 3" in measured("sums", status=1)[1]
    names, told = measured(status=1)
    assert names == ["sums"] and "still stale: ones: its run was stopped" in told
    assert why_stale("sums") is None and read("sums")["numbers"]["found"] == 5 and read("ones") == before
    with pytest.raises(SystemExit, match="2"):
        evidence.main(["nothing"])
