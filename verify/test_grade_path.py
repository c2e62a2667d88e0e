"""The command that counts what a grade passes through finds what decides one, and nothing that decides none."""

from verify import grade_path
from verify.sources import ROOT


def test_what_decides_a_grade_is_counted():
    found = grade_path.modules(ROOT)
    deciding = ("engine/kernel", "engine/statement", "engine/names", "engine/theorem")
    assert {f"proofs/{name}.py" for name in deciding} | {"verify/survey.py", grade_path.PRINTS_CLAIMS} <= found.keys()
    assert 150 < found["proofs/engine/kernel.py"] < 250  # prose is not counted
    assert not {"proofs/engine/search.py", "verify/checkers/measured.py", "renderer/kernels.py"} & found.keys()
    assert "renderer/generate/rules.py" in grade_path.modules(ROOT, grade_path.PRINTS_FLOAT64)
