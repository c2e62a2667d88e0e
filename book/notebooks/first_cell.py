"""The text of a notebook's first cell: it writes out the sources that the notebook uses, and checks them."""

import base64
import json
import zlib
from string import Template

from book.notebooks.sources import digest, hashes, version

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


def first_cell(sources):
    """Return the text of the first cell for a closure of `sources.closure`."""
    packed = base64.b64encode(zlib.compress(json.dumps(sources).encode(), 9)).decode()
    return TEXT.substitute(
        version=version(), digest=digest(sources), hashes=json.dumps(hashes(sources), indent=4), sources=packed
    )
