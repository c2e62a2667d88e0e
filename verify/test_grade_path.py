"""The command that counts what a grade passes through finds what decides one, and nothing that decides none."""

from verify import grade_path
from verify.sources import ROOT


def test_what_decides_a_grade_is_counted(tmp_path):
    found = grade_path.modules(ROOT)
    deciding = ("engine/kernel", "engine/statement", "engine/names", "engine/theorem")
    assert {f"proofs/{name}.py" for name in deciding} | {"verify/survey.py", grade_path.PRINTS_CLAIMS} <= found.keys()
    assert not {"proofs/engine/search.py", "verify/checkers/measured.py"} & found.keys()
    assert found["proofs/engine/kernel.py"] > 150
    for name in grade_path.ENTRANCES:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text('"""Prose."""\n\n# A remark.\nnumber = 1\n')
    assert grade_path.modules(tmp_path) == dict.fromkeys(grade_path.ENTRANCES, 1)
    (tmp_path / "verify" / "formal.py").write_text("from verify import more\n\n\ndef f():\n    import proofs.check\n")
    (tmp_path / "verify" / "more.py").write_text("a = 1\nb = 2\n")
    assert grade_path.modules(tmp_path)["verify/more.py"] == 2
