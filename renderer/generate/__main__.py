"""Write the generated kernels:  python -m renderer.generate [--check]"""

import argparse
from pathlib import Path

from renderer.generate.source import kernels_source

KERNELS = Path(__file__).parents[1] / "kernels.py"


def main():
    """Write renderer/kernels.py, or with --check say whether it is up to date."""
    parser = argparse.ArgumentParser(prog="python -m renderer.generate", description=__doc__)
    parser.add_argument("--check", action="store_true", help="write nothing; exit with 1 if the file is out of date")
    source = kernels_source()
    if parser.parse_args().check:
        stale = KERNELS.read_text(encoding="utf-8") != source
        print(f"renderer/{KERNELS.name} is {'out of date' if stale else 'up to date'}")
        raise SystemExit(int(stale))
    KERNELS.write_text(source, encoding="utf-8")
    print(f"wrote renderer/{KERNELS.name}: {source.count(chr(10))} lines")


if __name__ == "__main__":
    main()
