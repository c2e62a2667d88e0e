"""Write what is printed from the formulas:  python -m renderer.generate [--check]"""

import argparse
from pathlib import Path

from renderer.generate.kernels import kernels_source

PRINTED = {Path(__file__).resolve().parents[1] / "kernels.py": kernels_source}
"""{path: the function that returns its text}"""


def main():
    """Write every printed file, or with --check say which are up to date."""
    parser = argparse.ArgumentParser(prog="python -m renderer.generate", description=__doc__)
    parser.add_argument("--check", action="store_true", help="write nothing; exit with 1 if a file is out of date")
    check, stale = parser.parse_args().check, 0
    for path, source_of in PRINTED.items():
        source = source_of()
        if check:
            differs = not path.is_file() or path.read_text(encoding="utf-8") != source
            stale += differs
            print(f"{path.name} is {'out of date' if differs else 'up to date'}")
        else:
            path.write_text(source, encoding="utf-8")
            print(f"wrote {path.name}: {source.count(chr(10))} lines")
    raise SystemExit(int(stale > 0))


if __name__ == "__main__":
    main()
