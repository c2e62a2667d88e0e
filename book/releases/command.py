"""The commands `python -m book release-notes` and `python -m book release`.

The notes compare the built book with the last release in `releases/`: theorems, numbers (in ulps or per cent), pictures
(with difference images; of a plot, that its numbers moved). They fail where a grade was weakened, or a number left the
tolerance that it stated, and `CHANGELOG.md` does not name the id under the version's heading. Tolerances and their
reasons are in `releases/tolerances.toml`. To cut a release, give the version in `pyproject.toml`, `CITATION.cff` and a
heading of the changelog; `make release-notes`; `make release`, and commit `releases/`; `make same-bytes`; tag it
vVERSION, and the workflow publishes.
"""

import shutil

from book.assembly import stamps
from book.assembly.website import BOOK
from book.releases import archive, compare, notes, record
from renderer.files.pictures import write_png

OUT = BOOK / "_build" / "release"


def release_notes(now: dict | None = None, against: str | None = None) -> int:
    """Print and write what moved since the last release; return 1 if the changelog lacks an id that moved."""
    now = now or record.make()
    version = against or archive.before(now["version"])
    then = archive.read(version)
    mathematics = compare.theorems(then["theorems"], now["theorems"])
    numbers = compare.numbers(all_numbers(then), all_numbers(now))
    pictures = compare.pictures(then["pictures"], now["pictures"], archive.RELEASES / version, record.GENERATED)
    missing = notes.unnamed([*mathematics, *numbers], notes.section(now["version"]))
    shutil.rmtree(OUT, ignore_errors=True)
    OUT.mkdir(parents=True)
    for change in pictures:
        if change.difference is not None:
            write_png(OUT / f"{change.id}.png", change.difference[..., None])
    title = f"{now['version']}: since {'its own record' if version == now['version'] else version}"
    text = notes.written(title, mathematics, numbers, pictures, missing)
    stamps.write_whole(OUT / "notes.md", text.encode())
    print(f"\n{text}")
    return 1 if missing else 0


def release() -> int:
    """Write the record and the pictures of this version, unless something has to be named first; the exit status."""
    now = record.make()
    if archive.versions() and release_notes(now):
        print(f"Not written: name these in CHANGELOG.md under {now['version']} and say why.")
        return 1
    path = archive.write(now)
    print(f"Wrote {path.parent.name}/{path.name}: {len(now['theorems'])} theorems, {len(all_numbers(now))} numbers, "
          f"{len(now['pictures'])} pictures")  # fmt: skip
    return 0


def all_numbers(of: dict) -> dict[str, dict]:
    """Return the numbers of a record's figures and of its measurements, by their names."""
    measured = (numbers for result in of["measured"].values() for numbers in result["numbers"].items())
    return of["numbers"] | dict(measured)
