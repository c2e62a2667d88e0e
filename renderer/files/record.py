"""The record in a picture's file by which it can be drawn again: JSON, in a PNG or an NPZ."""

import json
import struct
import zlib
from dataclasses import asdict
from os import SEEK_END
from pathlib import Path
from zipfile import ZIP_DEFLATED, ZIP_STORED, BadZipFile, ZipFile

from renderer.checks import check_kind
from renderer.files.pictures import KEYWORD, SIGNATURE
from renderer.machines import machine
from renderer.scene.methods import GradientMethod
from renderer.scene.raster import Raster
from renderer.scene.scene import Scene
from renderer.scene.text import LARGEST, distrusted, read_json
from renderer.shader.numbers import Shot

MEMBER = "record.json"  # of an NPZ, beside its arrays
NAMES = {"version", "machine", "width", "height", "crop", "gradient", "scene"}


def text_of(shot: Shot) -> str:
    """Return the record, ASCII; "" where a custom field has no text."""
    from renderer.version import __version__  # which takes a while where it is installed

    try:
        scene = shot.scene.as_record()
    except ValueError:
        return ""
    made_by = {"version": __version__, "machine": machine().NAME}
    samples = {"samples": shot.samples} if shot.samples > 1 else {}
    return json.dumps(made_by | asdict(shot.raster) | samples | {"gradient": asdict(shot.method), "scene": scene})


def read(path: str | Path) -> tuple[Shot, str, str]:
    """Return the Shot of a PNG or an NPZ, and the version and the machine that drew it. Nothing in it is run.

    Raises ValueError of one sentence unless the file carries one whole record.
    """
    with distrusted("again", path):
        if not Path(path).is_file():  # one that is opened for ever, say
            raise ValueError("there is no such file")
        if Path(path).suffix.lower() not in (".png", ".npz"):
            raise ValueError("it is no picture of this program: neither a .png nor a .npz")
        texts = _of_png(path) if Path(path).suffix.lower() == ".png" else _of_npz(path)
        if len(texts) != 1:
            raise ValueError(f"{len(texts)} records; a picture has one, a map of slopes or of a difference has none")
        (text,) = texts
        if len(text) > LARGEST:
            raise ValueError(f"a text of more than {LARGEST} bytes")
        record = read_json(text)
        if check_kind("record", record, dict).keys() - {"samples"} != NAMES:
            raise ValueError("other names than a record has")
        if check_kind("gradient", record["gradient"], dict).keys() != {"name", "eps", "form"}:
            raise ValueError("other names than a gradient has")
        made_by = [record[name] for name in ("version", "machine")]
        if not all(isinstance(name, str) and len(name) < 100 and name.isprintable() for name in made_by):
            raise ValueError("no version and machine")
        raster = Raster(record["width"], record["height"], record["crop"])
        scene, samples = Scene.from_record(record["scene"]), record.get("samples", 1)
        return Shot(scene, GradientMethod(**record["gradient"]), raster, samples), *made_by


def _of_png(path):
    """Return the texts under KEYWORD. Raises ValueError where the file is cut, or a text is damaged or too long."""
    texts, at, kind, begins = [], len(SIGNATURE), b"", b"tEXt" + KEYWORD + b"\0"
    with open(path, "rb") as file:
        size = file.seek(0, SEEK_END)
        file.seek(0)
        if file.read(at) != SIGNATURE:
            raise ValueError("it is no PNG")
        while kind != b"IEND":
            file.seek(at)
            length, kind = struct.unpack(">I4s", file.read(8).ljust(8))
            at += 12 + length
            if at > size:
                raise ValueError("the file is cut")
            chunk = kind + file.read(min(length, LARGEST + len(KEYWORD) + 2))
            if chunk.startswith(begins):
                if len(chunk) == 4 + length and zlib.crc32(chunk) != int.from_bytes(file.read(4)):
                    raise ValueError("a damaged text")
                texts.append(chunk.removeprefix(begins))
    return texts


def _of_npz(path):
    """Return the members that are a record. Raises ValueError where one is damaged."""
    try:
        with ZipFile(path) as zipped:
            members = [one for one in zipped.infolist() if one.filename == MEMBER]
            if any(one.compress_type not in (ZIP_STORED, ZIP_DEFLATED) for one in members):
                raise ValueError("compressed in a way that NumPy has not")
            return [zipped.open(one).read(LARGEST + 1) for one in members]
    except (BadZipFile, zlib.error, RuntimeError, EOFError) as error:  # RuntimeError: encrypted, or an unknown method
        raise ValueError(f"it is no whole .npz: {error}") from None
