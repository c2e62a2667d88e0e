"""Compiled code, kept for other processes of the same user, in the user's cache or another folder.

SYMBOLIC_RENDERING_CODE names another folder, or is "off" (or empty) to keep nothing. Loading a file is running it, so
the folder has to be the user's own and closed to others' writing. A file begins with a digest of its name and content:
code is compiled anew where it is empty, cut or another's. If the folder cannot be written, nothing is kept, silently.
"""

import hashlib
import os
import stat
from contextlib import suppress
from pathlib import Path

from renderer.whole_files import write_whole

VARIABLE = "SYMBOLIC_RENDERING_CODE"
OFF = ("", "off")
LARGEST = 2**27  # bytes of all files: some thousand pictures' code; the least recently used goes
_DIGEST = hashlib.sha256().digest_size


def folder() -> Path | None:
    """Return the folder that code is kept in, None if it is not to be kept."""
    named = os.environ.get(VARIABLE)
    if named is not None:
        return None if named in OFF else Path(named)
    from platformdirs import user_cache_path

    cache = user_cache_path("symbolic-rendering", appauthor=False) / "compiled"
    return cache if cache.is_absolute() else None  # not, where the user has no home


def trusted(path: Path) -> bool:
    """Return whether a folder is there, is no link, is this user's, and is closed to others' writing."""
    try:
        status = os.lstat(path)
    except (OSError, ValueError):
        return False
    return stat.S_ISDIR(status.st_mode) and _is_own(status)


def _is_own(status):
    return not hasattr(os, "getuid") or (status.st_uid == os.getuid() and not status.st_mode & 0o022)


def load(key: str) -> bytes | None:
    """Return the code of a key (a file name), None where there is none, or a damaged one."""
    kept_in = folder()
    if kept_in is None or not trusted(kept_in):
        return None
    path, flags = kept_in / f"{key}.o", ("O_NOFOLLOW", "O_NONBLOCK", "O_BINARY")  # no link, no pipe that is waited for
    try:
        with open(os.open(path, sum(getattr(os, flag, 0) for flag in flags)), "rb") as file:
            status = os.fstat(file.fileno())
            content = file.read() if stat.S_ISREG(status.st_mode) and _is_own(status) else b""
    except OSError:
        return None
    if content[:_DIGEST] != _digest(key, content[_DIGEST:]):
        return None
    with suppress(OSError):
        os.utime(path)  # it was used
    return content[_DIGEST:]


def save(key: str, code: bytes) -> None:
    """Keep code under a key; where all is more than LARGEST, remove the least recently used."""
    kept_in = folder()
    if kept_in is None:
        return
    with suppress(OSError, ValueError):
        kept_in.parent.mkdir(parents=True, exist_ok=True)
        kept_in.mkdir(mode=0o700, exist_ok=True)
        if trusted(kept_in):
            write_whole(kept_in / f"{key}.o", _digest(key, code) + code, mode=0o600)
            _make_room(kept_in)


def _digest(key, code):
    return hashlib.sha256(key.encode() + code).digest()


def _make_room(kept_in):
    """Remove the files that were not used for longest; another process may do the same."""
    files = []
    for path in kept_in.glob("*.o"):
        with suppress(OSError):
            status = path.lstat()
            files.append((status.st_mtime, status.st_size, path))
    total = 0
    for _, size, path in sorted(files, reverse=True):
        total += size
        if total > LARGEST:
            with suppress(OSError):
                path.unlink()
