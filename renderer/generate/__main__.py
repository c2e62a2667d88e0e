"""Write what is printed from the formulas:  python -m renderer.generate"""

from pathlib import Path

from renderer.generate.coq import formulas_source
from renderer.generate.kernels import kernels_source

ROOT = Path(__file__).resolve().parents[2]
PRINTED = {ROOT / "renderer" / "kernels.py": kernels_source, ROOT / "proofs" / "formal" / "Formulas.v": formulas_source}
"""{file: what returns its text}"""

if __name__ == "__main__":
    for path, source_of in PRINTED.items():
        source = source_of()
        path.write_text(source, encoding="utf-8")
        print(f"wrote {path.name}: {source.count(chr(10))} lines")
