"""The check that a build from a clean clone in another folder gives the same bytes as the one here."""

import os
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from os.path import commonprefix  # of any text, byte by byte
from pathlib import Path

from book.assembly import stamps
from renderer.whole_files import write_whole
from verify.coq import formal

COMPARED = ("book/_build/html", "book/_generated")
AROUND = 20  # bytes shown on each side of the first that differs


def files_of(folder: Path) -> dict[str, Path]:
    return {path.relative_to(folder).as_posix(): path for path in sorted(folder.rglob("*")) if path.is_file()}


def differences(one: Path, other: Path) -> list[str]:
    """Return a line for each file that is in one folder alone or differs; ValueError where one has no files."""
    here, there = files_of(one), files_of(other)
    if not here or not there:
        raise ValueError(f"{one if not here else other} has no files: nothing was built there")
    lines = [f"{name}: only in {one if name in here else other}" for name in here.keys() ^ there.keys()]
    for name in here.keys() & there.keys():
        first, second = here[name].read_bytes(), there[name].read_bytes()
        if first != second:
            at = len(commonprefix([first, second]))  # noqa: RUF071
            window = slice(max(0, at - AROUND), at + AROUND)
            lines.append(f"{name}: differs from byte {at} on: {first[window]!r} and {second[window]!r}")
    return sorted(lines)


def clone(root: Path, target: Path) -> None:
    """Clone what is committed. Refused if what is here is not."""
    command = ["git", "status", "--porcelain", "--", *stamps.PACKAGES, "requirements.lock", "pyproject.toml"]
    changed = subprocess.run(command, cwd=root, check=True, capture_output=True, text=True).stdout.splitlines()
    if changed:
        more = f" and {len(changed) - 1} more" if len(changed) > 1 else ""
        raise stamps.Refused(f"not committed: {changed[0][3:]}{more}; a clone would be built from something else")
    subprocess.run(["git", "clone", "--quiet", str(root), str(target)], check=True)


def elsewhere(folder: Path) -> Mapping[str, str]:
    """Return an environment with another home, time zone, hash seed and caches, on which no build may depend."""
    home = folder / "another home"
    home.mkdir()
    unwanted = ("XDG_", "MPLCONFIGDIR", "PYTHONPATH", "IPYTHONDIR", "JUPYTER_")
    environment = {name: value for name, value in os.environ.items() if not name.startswith(unwanted)}
    return environment | {"HOME": str(home), "TZ": "Asia/Kathmandu", "PYTHONHASHSEED": "12345", "LC_ALL": "C.UTF-8"}


def same_bytes() -> int:
    """Clone, build there with no cache, compare with the build here; print what differs; the exit status."""
    with tempfile.TemporaryDirectory(prefix="a-clone-") as name:
        folder = Path(name)
        target = folder / "the book, elsewhere"
        clone(stamps.ROOT, target)
        if formal.accepted_here():  # on this machine, which is the clone's
            write_whole(target / formal.KEPT.relative_to(formal.ROOT), formal.KEPT.read_bytes())
        subprocess.run([sys.executable, "-m", "book"], cwd=target, env=elsewhere(folder), check=True)
        lines = [f"{part}/{line}" for part in COMPARED for line in differences(stamps.ROOT / part, target / part)]
        files = sum(len(files_of(stamps.ROOT / part)) for part in COMPARED)
    print("\n".join(lines) or f"{files} files, built in two folders, agree in every byte")
    return 1 if lines else 0
