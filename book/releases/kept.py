"""The releases that are kept in releases/: VERSION.json, and beside the two newest their pictures in VERSION/."""

import json
import re
import shutil
from pathlib import Path

from book.build import stamps
from book.releases import pictures
from book.releases.record import FORMAT

RELEASES = stamps.ROOT / "releases"
PICTURES_KEPT = 2  # the release that is made, and the one that it is compared with


class NoRelease(stamps.Refused):
    """There is no release to compare with, or it is not one that this program reads."""


def order(version: str) -> tuple[int, ...]:
    """The key that puts versions like 0.10.2 in order; ValueError for other names."""
    if not re.fullmatch(r"\d+(\.\d+)*", version):
        raise ValueError(f"version = {version!r} is not allowed: numbers between dots, such as 0.1.0")
    return tuple(map(int, version.split(".")))


def versions(folder: Path = RELEASES) -> list[str]:
    """The versions that have a record, the oldest first."""
    return sorted((path.stem for path in folder.glob("*.json")), key=order)


def before(version: str, folder: Path = RELEASES) -> str:
    """The release to compare with: the newest older one, or the version's own first record. NoRelease if none is."""
    known = versions(folder)
    older = [other for other in known if order(other) < order(version)]
    if not older and version not in known:
        raise NoRelease(f"releases/ has no release up to {version}: make release writes the first")
    return older[-1] if older else version


def read(version: str, folder: Path = RELEASES) -> dict:
    """A release's record. NoRelease if it is missing or of another format."""
    path = folder / f"{version}.json"
    if not path.is_file():
        raise NoRelease(f"there is no release {version}; there are: {', '.join(versions(folder)) or 'none'}")
    content = json.loads(path.read_text(encoding="utf-8"))
    if content["format"] != FORMAT:
        raise NoRelease(f"{path.name} has format {content['format']}, and this program reads format {FORMAT}")
    return content


def write(record: dict, generated: Path, folder: Path = RELEASES) -> Path:
    """Write a release's pictures, then its record; remove the pictures of releases that nothing is compared with."""
    version = record["version"]
    order(version)
    work = folder / f".{version}"
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    for picture in record["pictures"].values():
        pictures.keep(generated / next(name for name in picture["files"] if name.endswith((".csv", ".npz"))), work)
    shutil.rmtree(folder / version, ignore_errors=True)
    work.rename(folder / version)
    text = json.dumps(record, indent=1, sort_keys=True, ensure_ascii=False, allow_nan=False) + "\n"
    stamps.write_whole(folder / f"{version}.json", text.encode())
    for old in versions(folder)[:-PICTURES_KEPT]:
        shutil.rmtree(folder / old, ignore_errors=True)
    return folder / f"{version}.json"
