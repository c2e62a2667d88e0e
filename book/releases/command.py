"""`python -m book release-notes` and `python -m book release`."""

import shutil
from dataclasses import dataclass
from pathlib import Path

from PIL import Image

from book.build import stamps
from book.releases import compare, kept, notes, record

OUT = stamps.ROOT / "book" / "_build" / "release"


@dataclass(frozen=True)
class Places:
    """Where releases, drawn figures and the changelog are, and where notes and difference images go."""

    releases: Path = kept.RELEASES
    generated: Path = record.GENERATED
    changelog: Path = notes.CHANGELOG
    out: Path = OUT


def release_notes(now: dict | None = None, against: str | None = None, places: Places | None = None) -> int:
    """Print and write what moved since the last release; 1 if the changelog has to name something that it does not."""
    places = places or Places()
    now = now or record.make(places.generated)
    version = against or kept.before(now["version"], places.releases)
    then = kept.read(version, places.releases)
    mathematics = compare.theorems(then["theorems"], now["theorems"])
    numbers = compare.numbers(_all_numbers(then), _all_numbers(now))
    pictures = compare.pictures(then["pictures"], now["pictures"], places.releases / version, places.generated)
    missing = notes.unnamed([*mathematics, *numbers], notes.section(now["version"], places.changelog))
    shutil.rmtree(places.out, ignore_errors=True)
    places.out.mkdir(parents=True)
    for change in pictures:
        if change.difference is not None:
            Image.fromarray(change.difference).save(places.out / f"{change.id}.png")
    title = f"{now['version']}: since {'its own record' if version == now['version'] else version}"
    text = notes.written(title, mathematics, numbers, pictures, missing)
    stamps.write_whole(places.out / "notes.md", text.encode())
    print(f"\n{text}")
    return 1 if missing else 0


def release(places: Places | None = None) -> int:
    """Write the record and the pictures of this version, unless something has to be named first; the exit status."""
    places = places or Places()
    now = record.make(places.generated)
    if kept.versions(places.releases) and release_notes(now, places=places):
        print(f"Not written: name these in CHANGELOG.md under {now['version']} and say why.")
        return 1
    path = kept.write(now, places.generated, places.releases)
    print(f"Wrote {path.parent.name}/{path.name}: {len(now['theorems'])} theorems, {len(_all_numbers(now))} numbers, "
          f"{len(now['pictures'])} pictures")  # fmt: skip
    return 0


def _all_numbers(of: dict) -> dict[str, dict]:
    measured = (numbers for result in of["measured"].values() for numbers in result["numbers"].items())
    return of["numbers"] | dict(measured)
