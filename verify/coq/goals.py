"""The goals that each step of a proof leaves, as Coq shows them: recorded, for the pages of the proofs."""

import json
import lzma
import re
import subprocess
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from hashlib import sha256
from pathlib import Path

from renderer.whole_files import write_whole
from verify.coq.recorded import FOLDER

RECORD = FOLDER / "goals.json.xz"
SENTENCE = re.compile(r"^Chars (\d+) - (\d+) \[.*\] \S+ secs \(.*\)$", re.MULTILINE)
MESSAGE = re.compile(r"<(infomsg|warning)>.*?</\1>\n?", re.DOTALL)
IDENTITY = re.compile(r" \(ID \d+\)")
WHOLE = "all files"
LONGEST = 3000  # characters of goals that are kept: some show data of thousands of numbers

Step = tuple[int, int, str]
"""Where a sentence begins and ends in its file, in bytes, and the goals that it leaves."""


def steps(printed: str) -> list[Step]:
    """Return each sentence of a file and its goals, from what coqtop printed with -emacs -time."""
    pieces = iter(SENTENCE.split(MESSAGE.sub("", printed))[1:])
    return [(int(start), int(end), _kept(goals)) for start, end, goals in zip(pieces, pieces, pieces, strict=True)]


def _kept(goals: str) -> str:
    text = IDENTITY.sub("", goals).strip()
    return text if len(text) <= LONGEST else f"{text[:LONGEST]} …"


def write(folder: Path, names: Iterable[str], options: tuple[str, ...], given: Iterable[str] = ()) -> None:
    """Record the goals of files, in a folder where they are compiled, unless the record is of these very texts.

    given: other files that they require.
    """
    names = sorted(names)
    whole = sha256(b"".join((folder / f"{name}.v").read_bytes() for name in (*names, *sorted(given)))).hexdigest()
    if record().get(WHOLE, {}).get("sha256") == whole:
        return

    def entry_of(name: str) -> dict:
        text = (folder / f"{name}.v").read_bytes()
        command = ("coqtop", "-quiet", "-emacs", "-time", *options)
        done = subprocess.run(command, cwd=folder, input=text, capture_output=True, check=True)
        return {"sha256": sha256(text).hexdigest(), "steps": steps(done.stdout.decode())}

    with ThreadPoolExecutor(2) as pool:
        table = dict(zip(names, pool.map(entry_of, names), strict=True)) | {WHOLE: {"sha256": whole, "steps": []}}
    write_whole(RECORD, lzma.compress(json.dumps(table).encode(), preset=9))


@cache
def record() -> dict[str, dict]:
    """Return what was recorded: {file: {"sha256": of its text, "steps": [Step, …]}}."""
    return json.loads(lzma.decompress(RECORD.read_bytes())) if RECORD.is_file() else {}


def steps_of(path: Path) -> list[Step]:
    """Return the steps of a file as it is, [] if none are recorded of this text."""
    entry = record().get(path.stem, {})
    return entry["steps"] if entry.get("sha256") == sha256(path.read_bytes()).hexdigest() else []
