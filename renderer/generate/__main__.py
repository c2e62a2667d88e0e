"""Write what is printed from the formulas:  python -m renderer.generate"""

from pathlib import Path

from renderer.generate.coq import float64_source, formulas_source
from renderer.generate.kernels import kernels_source

ROOT = Path(__file__).resolve().parents[2]
FORMAL = ROOT / "proofs" / "formal"
PRINTED = {
    ROOT / "renderer" / "kernels.py": kernels_source,
    FORMAL / "Formulas.v": formulas_source,
    FORMAL / "Float64.v": float64_source,
}
"""{file: what returns its text}"""

if __name__ == "__main__":
    for path, source_of in PRINTED.items():
        source = source_of()
        path.write_text(source, encoding="utf-8")
        print(f"wrote {path.name}: {source.count(chr(10))} lines")
