"""The command that counts what a grade passes through finds what decides one, and nothing that decides none."""

from verify import grade_path
from verify.sources import ROOT


def test_what_decides_a_grade_is_counted(tmp_path):
    found = grade_path.modules(ROOT)
    deciding = ("engine/kernel", "engine/statement", "engine/names", "engine/theorem")
    assert {f"proofs/{name}.py" for name in deciding} | {"verify/survey.py", grade_path.PRINTS_CLAIMS} <= found.keys()
    assert not {"proofs/engine/search.py", "verify/checkers/measured.py"} & found.keys()
    formal = tmp_path / "verify" / "formal.py"
    formal.parent.mkdir()
    formal.write_text('"""Prose."""\n\n# A remark.\nfrom verify import more\n\n\ndef f():\n    import proofs.check\n')
    (formal.parent / "more.py").write_text("a = 1\nb = 2\n")
    assert grade_path.modules(tmp_path) == {"verify/formal.py": 3, "verify/more.py": 2}
