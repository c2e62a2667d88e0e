"""The text of a notebook's first cell: it writes out the sources that the notebook uses, and checks them."""

import base64
import hashlib
import json
import tomllib
import zlib
from functools import cache
from string import Template

from book.build import stamps

TEXT = Template('''\
# What this notebook uses of the project Symbolic Rendering, version $version, put in a folder beside it by this cell.
# The book's build took it from the project's own files; HASHES has the SHA-256 of each.
import base64
import hashlib
import json
import sys
import time
import zlib
from pathlib import Path

BEGAN = time.perf_counter()
VERSION, DIGEST = "$version", "$digest"
HASHES = $hashes
SOURCES = "$sources"


def write_sources():
    """Write the files, each checked against its hash, and return their folder."""
    folder = Path(f"symbolic-rendering-{VERSION}-{DIGEST[:8]}").resolve()
    if hashlib.sha256(json.dumps(HASHES).encode()).hexdigest() != DIGEST:
        raise ValueError("HASHES is not what the book's build wrote")
    for path, text in json.loads(zlib.decompress(base64.b64decode(SOURCES))).items():
        found, right = hashlib.sha256(text.encode()).hexdigest(), HASHES.get(path)
        if found != right:
            raise ValueError(f"{path} is not what the book's build wrote: its SHA-256 is {found}, not {right}")
        place = folder / path
        if not place.is_file() or place.read_bytes() != text.encode():
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_bytes(text.encode())
    return folder


FOLDER = write_sources()
sys.path.insert(0, str(FOLDER))
from renderer.machines import machine


def expect(what, found, as_expected):
    """Print what the chapter expects and what this run found."""
    print(f"{'as expected' if as_expected else 'NOT AS EXPECTED'}: {what}; here {found}")


files = len(list(FOLDER.rglob("*.py")))
print(f"version {VERSION}, sources {DIGEST[:8]}, drawn by {machine().NAME}: {files} files in {FOLDER.name}")
''')


@cache
def version():
    """Return the project's version."""
    return tomllib.loads((stamps.ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["version"]


def closure(code):
    """Return {path from the root: text} of the modules that some code imports, directly or not, and their packages."""
    paths = sorted(stamps.modules_for(code))
    return {path.relative_to(stamps.ROOT).as_posix(): path.read_text(encoding="utf-8") for path in paths}


def first_cell(sources):
    """Return the text of the first cell for a closure."""
    hashes = {path: hashlib.sha256(text.encode()).hexdigest() for path, text in sources.items()}
    return TEXT.substitute(
        version=version(),
        digest=hashlib.sha256(json.dumps(hashes).encode()).hexdigest(),
        hashes=json.dumps(hashes, indent=4),
        sources=base64.b64encode(zlib.compress(json.dumps(sources).encode(), 9)).decode(),
    )
