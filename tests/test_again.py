"""A picture that draws itself again, a scene in a file; and what is refused of such files, which nothing runs."""

import json
import os
from zipfile import ZipFile

import numpy as np
import pytest
from hypothesis import given, settings
from sympy import exp

from renderer import HeightField, Scene, central, k_u, render, u, v
from renderer.files import pictures, record
from tests.pictures import shows
from tests.refusals import rejection
from tests.strategies import scenes
from tests.test_command_line import run

HILL = HeightField("hill_drawn_again", exp(-2 * (2 * v - 1) ** 2) * (u * (1 - u)) ** 2 * k_u)
SCENE = Scene(field=HILL, ku=3.0, beta=0.1, lights=())
FRAME = render(SCENE, 30, 20, central(1e-3), (2, 3, 21, 15))
TOLD = json.loads(record.text_of(FRAME.shot))
TEXT = json.dumps(TOLD)


@pytest.mark.parametrize("name", ["A.PNG", "a.npz"])
def test_a_picture_is_drawn_again(name, tmp_path, capsys):
    FRAME.save(tmp_path / name)
    assert record.read(tmp_path / name)[0] == FRAME.shot
    assert run("image", "--again", tmp_path / name, "--out", tmp_path / "b.npy") == 0
    assert shows(tmp_path / "b.npy", FRAME)
    assert capsys.readouterr().err == ""


def with_text(path, text, copies=1):
    """Make a picture that says a text, as a PNG or an NPZ."""
    told = text.encode("latin-1")
    if path.suffix == ".png":
        chunk = pictures._chunk(b"tEXt", pictures.KEYWORD + b"\0" + told)
        head, data, rest = pictures.png_of(np.zeros((1, 1, 3), np.uint8)).partition(b"\0\0\0\x02IDAT")
        path.write_bytes(head + copies * chunk + data + rest)
    else:
        with ZipFile(path, "w") as zipped:
            for _ in range(copies):
                zipped.writestr(record.MEMBER, told)


def test_it_says_what_drew_it(tmp_path, capsys):
    with_text(tmp_path / "a.png", json.dumps(TOLD | {"version": "0.1", "machine": "abacus"}))
    assert run("image", "--again", tmp_path / "a.png", "--out", tmp_path / "b.png") == 0
    first, second = capsys.readouterr().err.splitlines()
    assert "was drawn by version 0.1; this is " in first and "was drawn by machine abacus; this is " in second


FIELD = {"name": "x", "expression": "__import__('os').system('true')"}
WRONG = {
    "width": (1.5,),
    "crop": ([0, 0, 99, 9],),
    "gradient": (None, {}, TOLD["gradient"] | {"name": []}),
    "scene": (None, {"lights": [[]]}, {"field": FIELD}),
    "version": (None, "x" * 10**3),
}
"""{name: wrong values}"""
TEXTS = [json.dumps(TOLD | {name: wrong}) for name, values in WRONG.items() for wrong in values]
TEXTS += [TEXT.replace("0.1", "NaN"), TEXT.replace("0.1", "1e999"), TEXT.replace("{", '{"width": 30, ', 1)]
TEXTS += ["[" * 10**4 + "]" * 10**4, "", "null", "{}", "\xff", "9" * 10**4, " " * 10**5]


@pytest.mark.parametrize("name", ["a.png", "a.npz"])
@pytest.mark.parametrize("text", TEXTS, ids=range(len(TEXTS)))
def test_a_hostile_text_is_refused_in_a_sentence(text, name, tmp_path):
    with_text(tmp_path / name, text)
    assert len(rejection(record.read, tmp_path / name)) < 600


@pytest.mark.filterwarnings("ignore:Duplicate name")
@pytest.mark.parametrize("name", ["a.png", "a.npz"])
def test_a_damaged_file_is_refused(name, tmp_path):
    """Cut anywhere, doubled, without a text, damaged, of another length than it says."""
    path = tmp_path / name
    with_text(path, TEXT)
    assert record.read(path)[0].scene == SCENE
    content = path.read_bytes()
    for cut in range(0, len(content), 7):
        path.write_bytes(content[:cut])
        rejection(record.read, path)
    for copies in (0, 2):
        with_text(path, TEXT, copies)
        rejection(record.read, path)
    os.mkfifo(tmp_path / f"pipe-{name}")
    rejection(record.read, tmp_path / f"pipe-{name}")
    lies = [(0, b"GIF"), (content.index(b"0.1"), b"9")]
    if name == "a.png":
        lies += [(content.index(b"tEXt") - 4, length) for length in (b"\xff\xff\xff\xff", b"\0\0\0\x14")]
    for place, lie in lies:
        path.write_bytes(content[:place] + lie + content[place + len(lie) :])
        rejection(record.read, path)


@settings(max_examples=50)
@given(scenes())
def test_a_scene_goes_through_its_record_and_its_file(tmp_path_factory, scene):
    assert Scene.from_record(json.loads(json.dumps(scene.as_record()))) == scene
    path = tmp_path_factory.mktemp("scene") / "scene.TOML"
    scene.to_file(path)
    assert Scene.from_file(path) == scene


WRONG_SCENES = {
    "beta = 'a'": "beta = 'a' is not allowed: a finite number",
    "bet = 1": "scene = 'bet' is not allowed: one of 'radius'",
    "ball = 1": "ball = 1 is not allowed: True or False",
    "lights = [3]": "lights[0] = 3 is not allowed: a record with a position",
    "\ufefflights = ''": "lights = '' is not allowed: a list",
    "lights = [{color = 'off'}]": "lights[0] = {'color': None} is not allowed: a record with a position",
    "field = {name = 'x'}": "field = {'name': 'x'} is not allowed: one with its expression",
    "field = {name = 'x', expression = 'v', more = 1}": "field = 'more' is not allowed: the parts name, expression",
    "field = {name = 'x', expression = 'v', seam = 'no'}": "field.seam = 'no' is not allowed: a bool",
    "field = {name = 'x', expression = 'a*v', parameters = [1]}": "field.parameters = [1] is not allowed: a dict",
    "field = {name = 'x', expression = 'v', parameters = {name = 1}}": "field.parameters = {'name': 1} is not allowed",
    "field = {name = 'x', expression = 'v', parameters = {__class__ = 1}}": "parameter = '__class__' is not allowed",
    "field = {name = 'sine', expression = 'v'}": "name = 'sine' is not allowed: a name that no other formula has",
    "a = " + "[" * 10**4: "",
    "beta =": "",
    "#" * 10**5: "more than 65536 bytes",
}
"""{what a file says: what is said of it}"""


@pytest.mark.parametrize("text", WRONG_SCENES, ids=range(len(WRONG_SCENES)))
def test_a_wrong_scene_is_refused(text, tmp_path):
    path = tmp_path / "scene.toml"
    path.write_text(text)
    error = rejection(Scene.from_file, path)
    assert error.startswith(f"scene = {str(path)!r} is not allowed: ") and WRONG_SCENES[text] in error
