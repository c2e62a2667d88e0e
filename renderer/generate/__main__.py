"""Write what is printed from the formulas:  python -m renderer.generate"""

import argparse
from collections.abc import Callable, Mapping
from pathlib import Path
from pkgutil import resolve_name

from proofs.engine.project import PROJECT
from renderer.whole_files import write_whole

PRINTED = {PROJECT.root / path: resolve_name(source) for path, source in PROJECT.printed.items()}
"""{file: the function that returns its text}"""


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
    PROJECT.require_writable()
    write_all(PRINTED)
