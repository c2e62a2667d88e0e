"""`python -m book.figures` is `python -m book figures`."""

import sys

from book.__main__ import main

if __name__ == "__main__":
    sys.exit(main(["figures", *sys.argv[1:]]))
