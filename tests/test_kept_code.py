"""Kept code: where it is kept, and that whatever is not whole or not the user's own is compiled anew."""

import os
from unittest.mock import Mock

import pytest

from renderer.machines import kept_code
from renderer.machines.kept_code import load, save
from tests.pictures import contents

KEY, CODE = "a" * 64, b"machine code"
NAME = f"{KEY}.o"


def is_kept():
    """Save the code; return whether it is loaded."""
    save(KEY, CODE)
    return load(KEY) == CODE


@pytest.fixture
def place(tmp_path, monkeypatch):
    """The folder, which is there with one file in it, of a user whose files anybody may write to, unless told."""
    mask = os.umask(0)
    monkeypatch.setenv(kept_code.VARIABLE, str(tmp_path / "new" / "code"))
    assert load(KEY) is None
    assert is_kept()
    yield tmp_path / "new" / "code"
    os.umask(mask)


def test_a_file_that_is_not_whole_is_none(place):
    """Empty, cut, longer, without a digest, of another byte, of another name."""
    content = (place / NAME).read_bytes()
    of_another = kept_code._digest("b", CODE) + CODE
    for spoilt in (b"", content[:40], content[:-1], content + b"\0", CODE, content[:-1] + b"x", of_another):
        (place / NAME).write_bytes(spoilt)
        assert load(KEY) is None
    assert is_kept()


def a_link(path):
    path.symlink_to(path.rename(path.parents[1] / "elsewhere"))


def a_pipe(path):
    path.rename(path.parents[1] / "elsewhere")
    os.mkfifo(path)


def open_to_others(path):
    path.chmod(0o777)


def another_users(path):
    if os.geteuid():
        pytest.skip("only root may give a file to another user")
    os.chown(path, 65534, 65534)


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="this system has no owners of files")
@pytest.mark.parametrize("name", ["", NAME])
@pytest.mark.parametrize("become", [a_link, a_pipe, open_to_others, another_users])
def test_what_is_not_the_users_own_is_not_loaded(become, name, place):
    """Neither from another's folder, nor another's file."""
    become(place / name)
    assert load(KEY) is None


@pytest.mark.parametrize("name", ["file/code", "full", "a\0b"])
def test_where_nothing_can_be_kept_nothing_is(name, tmp_path, monkeypatch):
    """A folder that is a file or has no name, a disk that is full."""
    (tmp_path / "file").write_text("")
    monkeypatch.setattr(kept_code, "folder", lambda: tmp_path / name)
    if name == "full":
        monkeypatch.setattr(os, "replace", Mock(side_effect=OSError(28, "No space left on device")))
    save(KEY, CODE)
    assert load(KEY) is None
    assert [path.name for path in tmp_path.rglob("*") if path.is_file()] == ["file"]


def test_it_is_kept_in_the_users_cache_and_closed_to_others(tmp_path, monkeypatch):
    monkeypatch.delenv(kept_code.VARIABLE, raising=False)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setenv("HOME", str(tmp_path))  # where macOS has it
    assert is_kept()
    assert tmp_path in kept_code.folder().parents
    assert kept_code.folder().stat().st_mode & 0o777 == 0o700 or os.name == "nt"
    monkeypatch.setenv(kept_code.VARIABLE, "off")
    save(KEY, CODE)
    assert (kept_code.folder(), load(KEY)) == (None, None)


def test_what_was_not_used_for_longest_goes(place, monkeypatch):
    monkeypatch.setattr(kept_code, "LARGEST", 3 * (place / NAME).stat().st_size)
    save("b", CODE)
    save("c", CODE)
    for number, name in enumerate((NAME, "b.o", "c.o")):
        os.utime(place / name, (number, number))
    assert load(KEY) == CODE  # used now
    save("d", CODE)
    assert contents(place).keys() == {"c.o", "d.o", NAME}
