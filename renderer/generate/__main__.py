"""Write what is printed from the formulas:  python -m renderer.generate"""

from collections.abc import Callable, Mapping
from pathlib import Path

from renderer.generate.coq import formulas_source
from renderer.generate.float64 import float64_source
from renderer.generate.kernels import kernels_source
from renderer.generate.statements import statements_source
from renderer.whole_files import write_whole

ROOT = Path(__file__).resolve().parents[2]
FORMAL = ROOT / "proofs" / "formal"
PRINTED = {
    ROOT / "renderer" / "kernels.py": kernels_source,
    FORMAL / "Formulas.v": formulas_source,
    FORMAL / "Float64.v": float64_source,
    FORMAL / "Statements.v": statements_source,
}
"""{file: what returns its text}"""


def write_all(printed: Mapping[Path, Callable[[], str]]) -> None:
    """Write every text, each whole, once all of them are made. Raises ValueError where one cannot be."""
    sources = {path: source_of() for path, source_of in printed.items()}
    for path, source in sources.items():
        write_whole(path, source.encode())
        print(f"wrote {path.name}: {source.count(chr(10))} lines")


if __name__ == "__main__":
    write_all(PRINTED)
