"""Stamps of the steps that were done, and of their sources: small JSON files in `.stamps/`.

A result is up to date when its stamp equals what `verify.evidence.sources` finds now.
"""

import json
import tomllib
from pathlib import Path

import yaml

from renderer.whole_files import write_whole
from verify.evidence.sources import HOME, PACKAGES, ROOT, file_hashes, files_in, hashes, key, reachable  # noqa: F401

STAMPS = ROOT / ".stamps"
LOCK_FILE = ROOT / "requirements.lock"


class Refused(ValueError):
    """A failure in one line; `status` is the command's exit status."""

    status = 2


def table_in(path: Path) -> dict:
    """Return the content of a JSON, a TOML or a YAML file."""
    loads = {".toml": tomllib.loads, ".yml": yaml.safe_load}.get(path.suffix, json.loads)
    return loads(path.read_text(encoding="utf-8"))


def read(name: str) -> dict | None:
    """Return a stamp's content, or None where there is no readable stamp."""
    try:
        return table_in(STAMPS / f"{name}.json")
    except (OSError, ValueError):
        return None


def write(name: str, content: dict) -> None:
    """Keep a stamp. Call it after the result is in place, never before."""
    write_whole(STAMPS / f"{name}.json", (json.dumps(content, indent=1) + "\n").encode())


def remove(name: str) -> None:
    """Forget a stamp. Call it before a result is touched."""
    (STAMPS / f"{name}.json").unlink(missing_ok=True)
