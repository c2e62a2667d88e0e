"""Print the formulas of `proofs/` into the laboratory's cells:  python -m book.notebooks"""

import argparse

from book.notebooks.laboratory import PAGE
from book.notebooks.printed import refreshed

if __name__ == "__main__":
    argparse.ArgumentParser("python -m book.notebooks", description=__doc__).parse_args()
    PAGE.write_text(refreshed(PAGE.read_text(encoding="utf-8")), encoding="utf-8")
    print(f"wrote {PAGE.name}")
