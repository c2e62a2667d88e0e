"""Writer of all files that are printed from the formulas:  python -m renderer.generate"""

import argparse
import subprocess
import sys
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from pkgutil import resolve_name

from proofs.engine.project import PROJECT
from renderer.whole_files import write_whole


def _text(source):
    return resolve_name(source)()


PRINTED = {PROJECT.root / path: partial(_text, source) for path, source in PROJECT.printed.items()}
"""{file: the function that returns its text}"""
RECORDED = {PROJECT.root / path for path, source in PROJECT.printed.items() if source.startswith("verify")}
"""Files for which kernels run, so that these are printed before."""


def write_all(printed: Mapping[Path, Callable[[], str]]) -> None:
    """Write every text that changed, each whole, once all of them are made. Raises ValueError where one cannot be."""
    sources = {path: source_of() for path, source_of in printed.items()}
    for path, source in sources.items():
        same = path.exists() and path.read_bytes() == source.encode()
        if not same:
            write_whole(path, source.encode())
        print(f"{'unchanged' if same else 'wrote'} {path.name}: {source.count(chr(10))} lines", flush=True)


if __name__ == "__main__":
    parser = argparse.ArgumentParser("python -m renderer.generate", description=__doc__)
    parser.add_argument("--recorded", action="store_true", help="only what kernels are run for, as they stand there")
    recorded = parser.parse_args().recorded
    PROJECT.require_writable()
    write_all({path: source_of for path, source_of in PRINTED.items() if (path in RECORDED) == recorded})
    if RECORDED and not recorded:  # by a process that has the new kernels
        sys.exit(subprocess.run([sys.executable, "-m", "renderer.generate", "--recorded"]).returncode)
