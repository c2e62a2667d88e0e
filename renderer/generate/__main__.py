"""Write what is printed from the formulas:  python -m renderer.generate"""

from pathlib import Path

from renderer.generate.coq import float64_source, formulas_source
from renderer.generate.kernels import kernels_source
from renderer.whole_files import write_whole

ROOT = Path(__file__).resolve().parents[2]
FORMAL = ROOT / "proofs" / "formal"
PRINTED = {
    ROOT / "renderer" / "kernels.py": kernels_source,
    FORMAL / "Formulas.v": formulas_source,
    FORMAL / "Float64.v": float64_source,
}
"""{file: what returns its text}"""

if __name__ == "__main__":
    sources = {path: source_of() for path, source_of in PRINTED.items()}  # all of them, before one is written
    for path, source in sources.items():
        write_whole(path, source.encode())
        print(f"wrote {path.name}: {source.count(chr(10))} lines")
