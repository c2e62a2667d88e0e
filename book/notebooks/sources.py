"""The project's sources that some code needs: the modules it imports, directly or not."""

import hashlib
import json
import tomllib
from functools import cache

from book.build import stamps


@cache
def version():
    """Return the project's version."""
    return tomllib.loads((stamps.ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["version"]


def closure(code):
    """Return {path from the root: text} of the modules that some code needs, the packages around them included."""
    paths = sorted(stamps.modules_for(code))
    return {path.relative_to(stamps.ROOT).as_posix(): path.read_text(encoding="utf-8") for path in paths}


def hashes(sources):
    """Return {path: SHA-256} of a closure."""
    return {path: hashlib.sha256(text.encode()).hexdigest() for path, text in sources.items()}


def digest(sources):
    """Return one SHA-256 for a closure: that of its hashes as JSON."""
    return hashlib.sha256(json.dumps(hashes(sources)).encode()).hexdigest()
