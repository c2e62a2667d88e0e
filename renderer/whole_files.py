"""Files that appear whole or not at all: written beside their place under another name, then renamed.

The other name is `.STEM-????????-unfinished.SUFFIX`, of a file that its writer keeps locked. One that nobody has locked
was left by a writer that was killed, and whoever writes into that folder next removes it.
"""

import errno
import os
import secrets
import stat
import warnings
from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from functools import partial
from pathlib import Path
from typing import Any, BinaryIO

from renderer.checks import not_allowed

try:
    import fcntl
except ImportError:  # Windows, which removes no file that is open: as good as a lock
    fcntl = None  # type: ignore[assignment]
    import msvcrt

BEYOND = 2**30  # a byte that no checkpoint reaches


def named(name: str, path: str | Path) -> Path:
    """Return `path` as a Path, or raise ValueError, which calls it `name`, where no file can have such a name."""
    if not isinstance(path, str | os.PathLike) or "\0" in str(path):
        raise not_allowed(name, path, "a file's name, without the character 0, and no file object")
    return Path(path)


def checked_target(path: str | Path, suffixes: Collection[str], name: str = "out") -> Path:
    """Return `path` as a Path, or raise ValueError unless it ends in one of `suffixes`, in small letters or capitals,
    and can be written.

    name: the argument's, in the message.
    """
    path, shown = named(name, path), str(path)
    folder = os.path.dirname(os.path.realpath(path))
    if path.suffix.lower() not in suffixes:
        raise not_allowed(name, shown, f"a file name that ends in {' or '.join(suffixes)}")
    if os.path.isdir(path) or not os.path.isdir(folder):  # unlike Path's, False for a name that is too long
        raise not_allowed(name, shown, "a file in a folder that exists")
    try:
        with _unfinished(_place(path)[0]):
            return path
    except OSError as error:
        raise not_allowed(name, shown, f"a file that can be written ({error.strerror})") from None


def _place(path):
    """Return the file that a path leads to, links followed, and its mode: None where there is none yet.

    Renaming asks for the folder's permission alone. Raises OSError on anything but a regular file that may be written.
    """
    place = Path(os.path.realpath(path))
    if not os.path.lexists(place):
        return place, None
    status = os.stat(place)
    mode = status.st_mode
    if not stat.S_ISREG(mode) or not mode & 0o222 or not os.access(place, os.W_OK):  # root may write read-only files
        raise OSError(errno.EACCES, "it is read-only, or no regular file", path)
    if status.st_nlink > 1:
        warnings.warn(f"{path} has other names (hard links), which keep what is there now", stacklevel=2)
    return place, stat.S_IMODE(mode)


@contextmanager
def _unfinished(path, mode=0o666):
    """Make a file beside `path` and yield it, open and locked; remove it at the end if it still has its name."""
    linked = False
    while not linked:  # another process may remove the file before it is locked
        name = path.with_name(f".{path.stem}-{secrets.token_hex(4)}-unfinished{path.suffix}")
        file = open(name, "xb", opener=partial(os.open, mode=mode))  # noqa: SIM115
        with suppress(OSError):  # where a file system has no locks, nobody can lock it to remove it either
            if fcntl:
                fcntl.flock(file, fcntl.LOCK_EX)
        linked = os.fstat(file.fileno()).st_nlink
    try:
        yield file
    finally:
        file.close()
        Path(file.name).unlink(missing_ok=True)


def sole_writer(path: str | Path) -> BinaryIO:
    """Open a file that is added to, and that nobody else opens so until it is closed; it is made if there is none.

    Raises BlockingIOError where somebody else has it open so. A file system without locks keeps nobody out.
    """
    while True:
        file = open(path, "ab")  # noqa: SIM115
        try:
            if fcntl:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            else:
                _lock_a_byte(file)
        except BlockingIOError:
            file.close()
            raise
        except OSError:
            pass
        if os.fstat(file.fileno()).st_nlink:  # else it was removed before it was locked
            return file
        file.close()


def _lock_a_byte(file):
    """Lock a byte beyond the end, as Windows locks until a file is closed; BlockingIOError where somebody else has."""
    file.seek(BEYOND)
    try:
        msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)  # type: ignore[attr-defined]
    except PermissionError as error:
        raise BlockingIOError(*error.args) from None
    file.seek(0, os.SEEK_END)


def remove_abandoned(folder: str | Path) -> None:
    """Remove the unfinished files in a folder that no living process writes."""
    for path in Path(folder).glob(".*-????????-unfinished.*"):
        with suppress(OSError), open(path, "r+b") as file:
            if fcntl:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            else:
                file.close()
            path.unlink()


@contextmanager
def whole_file(path: str | Path, mode: int | None = None) -> Iterator[str]:
    """Yield a temporary file name beside `path`; rename it to `path` at the end, or remove it on an error.

    A link is followed, and stays. Other names of the same file (hard links) keep the old content, with a warning.
    mode: who may read and write it, as the user's mask lets them; by default those who may already, or everybody.
    Raises OSError where `path` is neither absent nor a file that may be written.
    """
    place, old_mode = _place(path)
    remove_abandoned(place.parent)
    with _unfinished(place, mode or old_mode or 0o666) as file:
        if old_mode and not mode:
            os.chmod(file.name, old_mode)
        yield str(file.name)
        if not fcntl:
            file.close()
        os.replace(file.name, place)


def write_whole(path: Path, *parts: bytes, mode: int | None = None) -> None:
    """Write a file so that nobody ever sees half of it; its folder is made if there is none. mode: see `whole_file`."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with whole_file(path, mode) as name, open(name, "wb") as file:
        file.writelines(parts)


def write_csv(path: str | Path, records: Sequence[Mapping[str, Any]]) -> None:
    """Write dicts of the same keys as a table with its column names."""
    import csv  # which a picture does not need

    with whole_file(path) as name, open(name, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, [name for record in records[:1] for name in record])
        writer.writeheader()
        writer.writerows(records)
