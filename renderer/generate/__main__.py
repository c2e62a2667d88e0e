"""Write what is printed from the formulas:  python -m renderer.generate"""

import argparse
from collections.abc import Callable, Mapping
from pathlib import Path

from proofs import coq_files
from renderer.generate.float64 import float64_source
from renderer.generate.kernels import kernels_source
from renderer.whole_files import write_whole

ROOT = Path(__file__).resolve().parents[2]
FORMAL = ROOT / "proofs" / "formal"
PRINTED = {
    ROOT / "renderer" / "kernels.py": kernels_source,
    FORMAL / "Formulas.v": coq_files.formulas_source,
    FORMAL / "Float64.v": float64_source,
    FORMAL / "Statements.v": coq_files.statements_source,
}
"""{file: what returns its text}"""


def write_all(printed: Mapping[Path, Callable[[], str]]) -> None:
    """Write every text that changed, each whole, once all of them are made. Raises ValueError where one cannot be."""
    sources = {path: source_of() for path, source_of in printed.items()}
    for path, source in sources.items():
        same = path.exists() and path.read_bytes() == source.encode()
        if not same:
            write_whole(path, source.encode())
        print(f"{'unchanged' if same else 'wrote'} {path.name}: {source.count(chr(10))} lines")


if __name__ == "__main__":
    argparse.ArgumentParser("python -m renderer.generate", description=__doc__).parse_args()
    write_all(PRINTED)
