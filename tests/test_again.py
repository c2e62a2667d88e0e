"""A picture that draws itself again, a scene in a file; and what is refused of such files, which nothing runs."""

import json
import struct
from zipfile import ZipFile

import numpy as np
import pytest
from hypothesis import given, settings
from sympy import exp

from renderer import HeightField, Scene, central, k_u, render, u, v
from renderer.files import pictures, record
from tests.refusals import rejection
from tests.strategies import scenes
from tests.test_command_line import run

HILL = HeightField("hill_drawn_again", exp(-2 * (2 * v - 1) ** 2) * (u * (1 - u)) ** 2 * k_u)
SCENE = Scene(field=HILL, ku=3.0, beta=0.1, lights=())
FRAME = render(SCENE, 30, 20, central(1e-3), (2, 3, 21, 15))
TOLD = json.loads(record.text_of(record.Drawing(FRAME.scene, FRAME.method, FRAME.raster)))


@pytest.mark.parametrize("name", ["a.png", "A.PNG", "a.npz"])
def test_a_picture_is_drawn_again(name, tmp_path, capsys):
    FRAME.save(tmp_path / name)
    for again in ("b.png", "b.npy"):
        assert run("image", "--again", tmp_path / name, "--out", tmp_path / again) == 0
    FRAME.save(tmp_path / "c.png")
    assert (tmp_path / "b.png").read_bytes() == (tmp_path / "c.png").read_bytes()
    assert np.load(tmp_path / "b.npy").tobytes() == FRAME.rgb.tobytes()
    assert capsys.readouterr().err == ""
    said = record.read(tmp_path / name)
    assert said[:3] == (SCENE, FRAME.method, FRAME.raster)
    for option, value in (("beta", 1), ("scene", "a.toml"), ("size", 8), ("crop", "0,0,1,1"), ("eps", 0.1)):
        assert run("image", "--again", tmp_path / name, f"--{option}", value, "--out", tmp_path / "d.png") == 2
        assert f"no --{option} beside it" in capsys.readouterr().err


def with_text(path, text, copies=1):
    """A picture that says a text, as a PNG or an NPZ."""
    if path.suffix == ".png":
        chunk = pictures._chunk(b"tEXt", pictures.KEYWORD + b"\0" + text)
        path.write_bytes(
            pictures.png_of(np.zeros((1, 1, 3), np.uint8)).replace(
                b"\0\0\0\x02IDAT", copies * chunk + b"\0\0\0\x02IDAT"
            )
        )
    else:
        with ZipFile(path, "w") as zipped:
            for _ in range(copies):
                zipped.writestr(record.MEMBER, text)


def test_it_says_what_drew_it(tmp_path, capsys):
    with_text(tmp_path / "a.png", json.dumps(TOLD | {"version": "0.1", "machine": "abacus"}).encode())
    assert run("image", "--again", tmp_path / "a.png", "--out", tmp_path / "b.png") == 0
    first, second = capsys.readouterr().err.splitlines()
    assert "was drawn by version 0.1; this is " in first and "was drawn by machine abacus; this is " in second
    assert (tmp_path / "b.png").read_bytes() == FRAME._repr_png_()


FIELD = TOLD["scene"]["field"]
DEEP = b"[" * 10**4 + b"]" * 10**4
WRONG = [
    *({name: wrong} for name in ("width", "height") for wrong in (0, -1, 1.5, "9", None, True, 2**40)),
    *({"crop": wrong} for wrong in ("abcd", 5, [0, 0, 99, 9], [0, 0], {"a": 1}, [0, 0, "9", "9"])),
    *({"gradient": wrong} for wrong in (None, "exact", {}, {"name": "exact"}, TOLD["gradient"] | {"eps": "1"})),
    *({"gradient": TOLD["gradient"] | {"name": wrong}} for wrong in (None, [], "__import__", {})),
    *(
        {"scene": wrong}
        for wrong in (None, 5, [], "Scene()", {"beta": "1"}, {"no": 1}, {"lights": [[]]}, {"field": {}})
    ),
    *(
        {"scene": {"field": TOLD["scene"]["field"] | {wrong: "__import__('os').system('true')"}}}
        for wrong in ("expression", "x")
    ),
    *({"version": wrong} for wrong in (None, 3, "\n", "x" * 10**3)),
    {"more": 1},
]
TEXTS = [
    *(json.dumps(TOLD | wrong).encode() for wrong in WRONG),
    json.dumps(TOLD).replace("0.1", "NaN").encode(),
    json.dumps(TOLD).replace("0.1", "1e999").encode(),
    json.dumps(TOLD).replace("{", '{"width": 30, ', 1).encode(),
    DEEP, b'{"a":' * 10**4, b"", b"null", b"{}", b"\xff", b"9" * 10**4, b" " * 10**5,
]  # fmt: skip


@pytest.mark.parametrize("suffix", [".png", ".npz"])
@pytest.mark.parametrize("text", TEXTS, ids=range(len(TEXTS)))
def test_a_hostile_text_is_refused_in_a_sentence(text, suffix, tmp_path, capsys):
    path = tmp_path / f"a{suffix}"
    with_text(path, text)
    assert len(rejection(record.read, path)) < 600
    assert run("image", "--again", path, "--out", tmp_path / "b.png") == 2
    assert capsys.readouterr().err.count("\n") == 1
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.filterwarnings("ignore:Duplicate name")
def test_a_damaged_file_is_refused(tmp_path):
    for name in ("a.png", "a.npz"):
        path = tmp_path / name
        with_text(path, json.dumps(TOLD).encode())
        assert record.read(path).scene == SCENE
        whole = path.read_bytes()
        for cut in range(0, len(whole), 7):
            path.write_bytes(whole[:cut])
            rejection(record.read, path)
        with_text(path, json.dumps(TOLD).encode(), copies=2)
        rejection(record.read, path)
        with_text(path, json.dumps(TOLD).encode(), copies=0)
        rejection(record.read, path)
    FRAME.save(tmp_path / "a.png")
    whole = (tmp_path / "a.png").read_bytes()
    at = whole.index(b"tEXt")
    for place, lie in ((at + 40, b"!"), (at - 4, b"\xff\xff\xff\xff"), (at - 4, struct.pack(">I", 20)), (0, b"GIF")):
        (tmp_path / "a.png").write_bytes(whole[:place] + lie + whole[place + len(lie) :])
        rejection(record.read, tmp_path / "a.png")


@settings(max_examples=50)
@given(scenes())
def test_a_scene_goes_through_its_file(tmp_path_factory, scene):
    path = tmp_path_factory.mktemp("scene") / "scene.TOML"
    scene.to_file(path)
    assert Scene.from_file(path) == scene


def test_the_command_line_draws_the_scene_of_a_file(tmp_path):
    SCENE.to_file(tmp_path / "hill.toml")
    options = ["--scene", tmp_path / "hill.toml", "--beta", 0.2, "--size", 16]
    assert run("image", *options, "--out", tmp_path / "a.npy") == 0
    expected = render(Scene(field=HILL, ku=3.0, beta=0.2, lights=()), 16, 16)
    np.testing.assert_array_equal(np.load(tmp_path / "a.npy"), expected.rgb)


@pytest.mark.parametrize(
    "text",
    ["beta = 'a'", "beta = nan", "bet = 1", "beta = 1\nbeta = 2", "lights = 3", "lights = [3]", "ball = 1", "field = 3",
     "field = {name = 'x'}", "lights = [{position = [5, 5], color = 'off'}]", "radius = [[1]]", "a = " + "[" * 10**4,
     "beta =", "\0", "#" * 10**5, "[scene]\nbeta = 1"],
)  # fmt: skip
def test_a_wrong_scene_is_refused(text, tmp_path):
    path = tmp_path / "scene.toml"
    path.write_text(text)
    assert rejection(Scene.from_file, path).startswith(f"scene = {str(path)!r} is not allowed: ")
