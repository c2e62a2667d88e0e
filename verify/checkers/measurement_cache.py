"""Evidence that is kept from run to run, of theorems that rest on measurements alone. It is never committed.

It is kept with a key: a hash of every source that the measurements can reach, of the checkers, of the theorem itself
and of the libraries' versions. What has another key, or was changed since it was written, is not read.
"""

import json
from dataclasses import asdict
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from proofs.engine.theorem import Theorem
from renderer.whole_files import write_whole
from verify import sources
from verify.checkers.grades import Examination
from verify.checkers.measured import sources_of
from verify.optional import LIBRARIES

FOLDER = sources.ROOT / ".stamps" / "theorems"
CHECKERS = Path(__file__).parent
ALSO = ("book/references.bib", "requirements.lock")


def key_of(theorem: Theorem) -> str:
    """Return the key of a theorem's evidence."""
    reached = set().union(*(sources.reachable(path) for path in sources_of(theorem.id)))
    reached |= {*CHECKERS.glob("*.py"), *(sources.ROOT / name for name in ALSO)}
    table = sources.hashes(reached) | {"theorem": repr(theorem)}
    return sources.key(table | {name: _version(name) for name in ("sympy", "numpy", "mpmath", *LIBRARIES.values())})


def _version(distribution):
    try:
        return version(distribution)
    except PackageNotFoundError:
        return None


def keep(evidence: Examination, key: str) -> None:
    """Write what a run found about a theorem, if nothing is missing."""
    if evidence.problems or not (sources.ROOT / "pyproject.toml").exists():  # an installed package keeps nothing
        return
    content = asdict(evidence)
    text = json.dumps({"key": key, "evidence": content, "hash": sources.key({key: content})}, indent=1)
    write_whole(FOLDER / f"{evidence.id}.json", (text + "\n").encode())


def read(theorem: Theorem, key: str) -> Examination | None:
    """Return the Examination that was kept with that key, or None: nothing kept, another key, or changed since."""
    try:
        kept = json.loads((FOLDER / f"{theorem.id}.json").read_text(encoding="utf-8"))
        if kept["key"] != key or kept["hash"] != sources.key({key: kept["evidence"]}):
            return None
        examination = Examination(**kept["evidence"])
    except (OSError, ValueError, KeyError, TypeError):
        return None
    examination.uses = tuple(examination.uses)
    return examination
