"""The releases that are kept in releases/: VERSION.json, and beside the newest its pictures in VERSION/."""

import json
import shutil
from pathlib import Path

from packaging.version import Version

from book.assembly import stamps
from book.releases import pictures, record

RELEASES = stamps.ROOT / "releases"


def versions() -> list[str]:
    """Return the versions that have a record, the oldest first."""
    return sorted((path.stem for path in RELEASES.glob("*.json")), key=Version)


def before(version: str) -> str:
    """Return the release to compare with: the newest older one, or the version's own first record. Raises Refused."""
    recorded = versions()
    older = [other for other in recorded if Version(other) < Version(version)]
    if not older and version not in recorded:
        raise stamps.Refused(f"releases/ has no release up to {version}: make release writes the first")
    return older[-1] if older else version


def read(version: str) -> dict:
    """Return a release's record. Refused if it is missing."""
    path = RELEASES / f"{version}.json"
    if not path.is_file():
        raise stamps.Refused(f"there is no release {version}; there are: {', '.join(versions()) or 'none'}")
    return stamps.table_in(path)


def write(now: dict) -> Path:
    """Write a release's pictures, then its record; remove the pictures of older releases."""
    path = RELEASES / f"{now['version']}.json"
    folder = path.with_suffix("")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for id, picture in now["pictures"].items():
        pictures.archive(record.GENERATED / picture["data"], pictures.archived(folder, id))
    text = json.dumps(now, indent=1, sort_keys=True, ensure_ascii=False, allow_nan=False) + "\n"
    stamps.write_whole(path, text.encode())
    for old in versions()[:-1]:
        shutil.rmtree(RELEASES / old, ignore_errors=True)
    return path
