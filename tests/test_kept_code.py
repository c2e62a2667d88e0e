"""Kept code: where it is kept, and that whatever is not whole or not the user's own is compiled anew."""

import os
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from renderer.machines import kept_code
from renderer.whole_files import whole_file
from tests.processes import python, started

KEY, CODE = "a" * 64, b"machine code"


@pytest.fixture
def place(tmp_path, monkeypatch):
    """The folder, which is there with one file in it."""
    monkeypatch.setenv(kept_code.VARIABLE, str(tmp_path / "new" / "code"))
    assert kept_code.load(KEY) is None
    kept_code.save(KEY, CODE)
    assert kept_code.load(KEY) == CODE
    return tmp_path / "new" / "code"


def test_a_file_that_is_not_whole_is_none(place):
    """Empty, cut, longer, without a digest, of another byte, of another name."""
    file = place / f"{KEY}.o"
    whole = file.read_bytes()
    of_another = kept_code._digest("b", CODE) + CODE
    for spoilt in (b"", whole[:40], whole[:-1], whole + b"\0", CODE, whole[:-1] + b"x", of_another):
        file.write_bytes(spoilt)
        assert kept_code.load(KEY) is None
    kept_code.save(KEY, CODE)
    assert kept_code.load(KEY) == CODE


def linked(place):
    os.rename(place, place.with_name("elsewhere"))
    place.symlink_to("elsewhere")


def linked_file(place):
    os.rename(place / f"{KEY}.o", place.parent / "elsewhere")
    (place / f"{KEY}.o").symlink_to(place.parent / "elsewhere")


def a_pipe(place):
    (place / f"{KEY}.o").unlink()
    os.mkfifo(place / f"{KEY}.o")


OTHERS = {
    "a link": linked,
    "open to others": lambda place: place.chmod(0o777),
    "a file": lambda place: [(place / f"{KEY}.o").unlink(), place.rmdir(), place.write_bytes(b"")],
    "a linked file": linked_file,
    "a file open to others": lambda place: (place / f"{KEY}.o").chmod(0o666),
    "a pipe": a_pipe,
}
if hasattr(os, "geteuid") and os.geteuid() == 0:
    OTHERS["another user's"] = lambda place: os.chown(place, 65534, 65534)
    OTHERS["another user's file"] = lambda place: os.chown(place / f"{KEY}.o", 65534, 65534)


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="this system has no owners of files")
@pytest.mark.parametrize("other", OTHERS)
def test_what_is_not_the_users_own_is_not_loaded(other, place):
    OTHERS[other](place)
    assert kept_code.load(KEY) is None


@pytest.mark.parametrize("why", ["a folder that is a file", "a disk that is full", "a name that is none"])
def test_where_nothing_can_be_kept_nothing_is(why, tmp_path, monkeypatch):
    def full(*arguments, **options):
        raise OSError(28, "No space left on device")

    (tmp_path / "file").write_text("")
    names = {"a folder that is a file": "file/code", "a disk that is full": "code", "a name that is none": "a\0b"}
    monkeypatch.setattr(kept_code, "folder", lambda: tmp_path / names[why])
    if why == "a disk that is full":
        monkeypatch.setattr(Path, "write_bytes", full)
    kept_code.save(KEY, CODE)
    assert kept_code.load(KEY) is None
    assert not [path for path in tmp_path.rglob("*") if path.is_file() and path.name != "file"]


def test_it_is_kept_in_the_users_cache_and_closed_to_others(tmp_path, monkeypatch):
    monkeypatch.delenv(kept_code.VARIABLE)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setenv("HOME", str(tmp_path))  # where macOS has it
    kept_code.save(KEY, CODE)
    assert tmp_path in kept_code.folder().parents
    assert kept_code.folder().stat().st_mode & 0o777 == 0o700 or os.name == "nt"
    assert kept_code.load(KEY) == CODE
    for off in kept_code.OFF:
        monkeypatch.setenv(kept_code.VARIABLE, off)
        assert (kept_code.folder(), kept_code.load(KEY)) == (None, None)
        kept_code.save(KEY, CODE)


def test_what_was_not_used_for_longest_goes(place, monkeypatch):
    size = (place / f"{KEY}.o").stat().st_size
    monkeypatch.setattr(kept_code, "LARGEST", 3 * size)
    for number, name in enumerate("bcd"):
        os.utime(place / f"{KEY}.o", (number, number))
        kept_code.save(name, CODE)
        os.utime(place / f"{name}.o", (10 + number, 10 + number))
        if name == "b":
            assert kept_code.load(KEY) == CODE  # used now
            os.utime(place / "b.o", (1, 1))
    assert sorted(path.stem for path in place.iterdir()) == sorted(["c", "d", KEY])


def test_written_by_two_at_once(place):
    with ThreadPoolExecutor(4) as several:
        list(several.map(lambda _: kept_code.save(KEY, CODE), range(40)))
    with whole_file(place / f"{KEY}.o"):  # another one that is half-way
        assert kept_code.load(KEY) == CODE
    assert kept_code.load(KEY) is None  # it kept nothing


def test_commands_that_start_at_once_and_files_that_are_emptied(tmp_path):
    """The picture is the same, whatever the files hold; nothing else is left in the folder."""
    command = ["-m", "renderer", "image", "--size", "16", "--out"]
    settings = os.environ | {kept_code.VARIABLE: str(tmp_path / "code")}
    together = [started(*command, tmp_path / f"{number}.png", env=settings) for number in range(3)]
    assert [one.wait(60) for one in together] == [0, 0, 0]
    kept = list((tmp_path / "code").iterdir())
    assert [path.suffix for path in kept] == [".o"]
    kept[0].write_bytes(b"")
    python(*command, tmp_path / "3.png", env=settings)
    assert kept[0].stat().st_size > 0
    assert len({(tmp_path / f"{number}.png").read_bytes() for number in range(4)}) == 1
