"""The command line: what it writes and prints, and how it refuses."""

import dataclasses
import io
import os
import re
import shlex
import sys
import tomllib
from concurrent.futures import BrokenExecutor, ThreadPoolExecutor

import numpy as np
import pytest
from PIL import Image

import renderer
from renderer import Light, Scene, central, forward, render
from renderer.command_line import grid
from renderer.command_line.verbs import main
from renderer.kernels import FIELDS
from renderer.picture import views
from renderer.picture.sweep import sweep, table
from renderer.scene.scene import DEFAULT_LIGHTS
from tests.folders import contents
from tests.processes import python, started
from verify.sources import ROOT


def run(*arguments):
    """Run the command line in this process; return its exit status."""
    try:
        return main([str(argument) for argument in arguments])
    except SystemExit as end:  # argparse's way out
        return end.code


def picture(path):
    return np.asarray(Image.open(path))


def test_image_png(tmp_path, capsys):
    target = tmp_path / "a.png"
    assert run("image", "--size", 32, "--field", "sine", "--gradient", "central", "--out", target) == 0
    expected = views.image_view(render(Scene(field="sine"), 32, 32, central(1e-3)))
    np.testing.assert_array_equal(picture(target), expected)
    assert capsys.readouterr() == (f"wrote {target}: 32 x 32 pixels\n", "")


def test_image_npz_with_every_option_of_the_scene(tmp_path):
    """Its numbers have a test of their own."""
    target = tmp_path / "a.npz"
    options = "--no-ball --no-floor --field rings --model phong --ku -3 --beta -1e-1 --light -6,2,8"
    options += " --light 5,5,10,1,0.5,0 --width 20 --height 10 --crop 5,2,10,6 --threads 1"
    assert run("image", *options.split(), "--out", target) == 0
    lights = (Light((-6, 2, 8)), Light((5, 5, 10), (1, 0.5, 0)))
    scene = Scene(field="rings", model="phong", ku=-3.0, beta=-0.1, ball=False, floor=False, lights=lights)
    frame = render(scene, 20, 10, crop=(5, 2, 10, 6))
    stored, held = np.load(target), {"rgb": frame.rgb, "chambers": frame.chambers, **frame.surface_data}
    assert held.keys() == {"rgb", "chambers", "u", "v", "h", "h_u", "h_v", "slope", "kink"}
    assert {*stored.files} == {*held, "record.json"}
    for name, plane in held.items():
        np.testing.assert_array_equal(stored[name], plane)


def test_image_streamed(tmp_path, capsys):
    for name in ("a.Npy", "a.TIF"):
        target = tmp_path / name
        assert run("image", "--size", 40, "--crop", "3,5,20,30", "--gradient", "forward", "--out", target) == 0
        assert capsys.readouterr() == (f"wrote {target}: 20 x 30 pixels\n", "")
    frame = render(Scene(), 40, 40, forward(1e-3), crop=(3, 5, 20, 30))
    np.testing.assert_array_equal(np.load(tmp_path / "a.Npy"), frame.rgb)
    np.testing.assert_array_equal(picture(tmp_path / "a.TIF"), views.image_view(frame))


def test_views(tmp_path, capsys):
    folder = tmp_path / "new" / "views"
    assert run("views", "--size", 24, "--eps", "1e-2", "--out", folder) == 0
    names = ["numeric", "symbolic", "slope", "kink", "difference_linear", "difference_logarithmic"]
    assert sorted(path.stem for path in folder.iterdir()) == sorted(names)
    assert capsys.readouterr().out == f"wrote {folder}: {', '.join(f'{name}.png' for name in names)}\n"
    one, other = render(Scene(), 24, 24, central(1e-2)), render(Scene(), 24, 24)
    np.testing.assert_array_equal(picture(folder / "numeric.png"), views.image_view(one))
    np.testing.assert_array_equal(picture(folder / "symbolic.png"), views.image_view(other))
    np.testing.assert_array_equal(
        picture(folder / "difference_linear.png"), views.difference_linear(one.rgb - other.rgb)
    )


def test_sweep(tmp_path, capsys):
    target = tmp_path / "a.csv"
    steps = ["1e-2", "1e-3"]
    assert run("sweep", "--size", 32, "--eps", *steps, "--gradient", "forward", "--no-facts", "--csv", target) == 0
    out, err = capsys.readouterr()
    first, names, *rows, last = out.splitlines()
    expected = sweep(Scene(), 32, 32, (1e-2, 1e-3), "forward")
    assert first == "ridges, blinn, 32 x 32: forward difference against the exact gradient"
    assert names.split()[0] == "eps"
    assert [float(row.split()[2]) for row in rows] == pytest.approx([row.rms for row in expected], rel=1e-3)
    assert last == f"wrote {target}"
    assert len(target.read_text().splitlines()) == 3
    assert err == ""


def test_sweep_prints_the_chapters_table(capsys):
    assert run("sweep", "--size", 64) == 0
    out = capsys.readouterr().out
    assert sum(line.split()[3:4] == ["0"] for line in out.splitlines()[2:8]) == 6
    assert "flips over 96 frames (fields, beta, eps, models) " in out
    assert "6.116e-05" in out


def test_sweep_of_a_grid(tmp_path, capsys):
    lists = ["--field", "sine,rings", "--beta", "-0.1,.35", "--kv", "3,4", "--size", "16,24"]
    lists += ["--eps", "1e-2,1e-3", ".1"]
    target = tmp_path / "a.csv"
    assert run("sweep", *lists, "--gradient", "forward,central", "--model", "phong", "--csv", target) == 0
    values = {"field": ["sine", "rings"], "kv": [3, 4], "beta": [-0.1, 0.35]}
    tasks = grid.grid(Scene(model="phong"), [(16, 16), (24, 24)], ["forward", "central"], (1e-2, 1e-3, 0.1), **values)
    with ThreadPoolExecutor(1) as executor:
        expected = table(grid.run(tasks, executor))
    assert capsys.readouterr() == (f"{expected}\nwrote {target}\n", "")
    names = "field,ku,kv,beta,gradient,width,height,eps,largest,rms,flips,straddling"
    names += ",largest_lower,largest_upper,rms_lower,rms_upper"
    assert target.read_text().splitlines()[0] == names
    assert len(target.read_text().splitlines()) == 1 + len(tasks)


def test_a_sweep_that_is_interrupted_says_what_is_kept(tmp_path, monkeypatch, capsys):
    kept, compare = tmp_path / "a.jsonl", grid.compare_batch

    def interrupted(batch, *arguments):
        if len(batch) < 16:
            raise KeyboardInterrupt
        return compare(batch, *arguments)

    monkeypatch.setattr(grid, "compare_batch", interrupted)
    betas = ",".join(map(str, range(1, 21)))
    command = ["sweep", "--size", "8", "--eps", "1e-3", "--beta", betas, "--workers", "1"]
    for options, told in (
        ([], "nothing is kept without --checkpoint"),
        (["--checkpoint", kept], f"16 of 20 frames are in {kept}, and the same command goes on from there"),
    ):
        assert run(*command, *options) == 130
        assert capsys.readouterr() == ("", f"symbolic-rendering sweep: interrupted: {told}\n")


def test_a_sweep_whose_workers_are_gone(tmp_path, monkeypatch, capsys):
    def die(*arguments):
        raise BrokenExecutor

    monkeypatch.setattr(grid, "compare_batch", die)
    assert run("sweep", "--size", "8", "--eps", "1e-3", "--beta", "1,2", "--checkpoint", tmp_path / "a.jsonl") == 2
    told = f"the workers are gone; 0 of 2 frames are in {tmp_path / 'a.jsonl'}, and the same command goes on from there"
    assert capsys.readouterr() == ("", f"symbolic-rendering sweep: error: {told}\n")


@pytest.mark.parametrize(
    ("module", "extra", "arguments"),
    [
        ("distributed", "dask", ["sweep", "--dask", "tcp://localhost:1"]),
        ("tifffile", "tiff", ["image", "--out", "a.tif"]),
        ("matplotlib", "plot", ["views", "--out", "new/views"]),
    ],
)
def test_what_needs_an_extra_that_is_not_installed_names_it(module, extra, arguments, monkeypatch, capsys, tmp_path):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setitem(sys.modules, module, None)
    assert run(*arguments, "--size", "8") == 2
    told = f"{module} is not installed: pip install 'symbolic-rendering[{extra}]'"
    assert capsys.readouterr().err.endswith(f"error: {told}\n")
    assert list(tmp_path.iterdir()) == []  # it is said before anything is drawn


REFUSED = {
    "image": {
        "--out a.jpg": "out = 'a.jpg' is not allowed: a file name that ends in .png or .npz or .npy or .tif or",
        "--out ''": "out = '' is not allowed: a file name that ends in",
        "--out nowhere/a.png": "out = 'nowhere/a.png' is not allowed: a file in a folder that exists",
        "--bounds a.png": "bounds = 'a.png' is not allowed: a file name that ends in .npz",
        "--bounds nowhere/a.npz": "bounds = 'nowhere/a.npz' is not allowed: a file in a folder that exists",
        "--out a.npy --bounds a.npz": "bounds = 'a.npz' is not allowed: no --out that is drawn in bands",
        "--gradient foo": "gradient = 'foo' is not allowed: one of 'exact', 'forward', 'central', 'central4'",
        "--field SINE": f"field = 'SINE' is not allowed: one of {', '.join(map(repr, FIELDS))}",
        "--eps -1e-3": "eps = -0.001 is not allowed: a finite number from 1e-40 to 0.5",
        "--beta -inf": "beta = -inf is not allowed: a finite number from -1e+100 to 1e+100",
        "--crop 0,0,9,9": "crop = (0, 0, 9, 9) is not allowed: (left, top, width, height), whole numbers",
        "--width 0": "width = 0 is not allowed: a whole number from 1 to 16777216",
        "--size 20000": "width * height = 400000000 is not allowed: at most 268435456 drawn pixels",
        "--threads 0": "threads = 0 is not allowed: a whole number from 1 to 256",
        "--light 1,2": "argument --light: '1,2' is not allowed: X,Y,Z or X,Y,Z,R,G,B",
        "--ball-center 0,0": "argument --ball-center: '0,0' is not allowed: X,Y,Z",
        "--crop a,b,c,d": "argument --crop: 'a,b,c,d' is not allowed: LEFT,TOP,WIDTH,HEIGHT",
        "--ku abc": "argument --ku: 'abc' is not allowed: a number",
        "--size 1e3": "argument --size: '1e3' is not allowed: a whole number",
        "--beta": "argument --beta: expected one argument",
        "--bet 1": "unrecognized arguments: --bet 1",
        "--no-ball 1": "unrecognized arguments: 1",
        "--light 5,5,10 " * 6: "lights = 6 lights is not allowed: a sequence of at most 5 Light",
        "--size ''": "argument --size: '' is not allowed: a whole number",
        "--nonsense 1": "unrecognized arguments: --nonsense 1",
        "a.png": "unrecognized arguments: a.png",
        "--out file/a.png": "out = 'file/a.png' is not allowed: a file in a folder that exists",
        "--out a.png.gz": "out = 'a.png.gz' is not allowed: a file name that ends in",
        "--size 16777217": "width = 16777217 is not allowed: a whole number from 1 to 16777216",
        "--height -3": "height = -3 is not allowed: a whole number from 1 to 16777216",
        "--threads two": "argument --threads: 'two' is not allowed: a whole number",
        "--eps nan": "eps = nan is not allowed: a finite number from 1e-40 to 0.5",
        "--model gouraud": "model = 'gouraud' is not allowed: one of 'blinn', 'phong'",
        "--kv 1e7": "kv = 10000000.0 is not allowed: a finite number from -1.04858e+06 to 1.04858e+06",
        "--radius 4": "eye = 4.0 is not allowed: radius/eye from 1e-6 to 1 - 1e-9, and radius = 4",
        "--ball-center 0,0,4": "ball_center = (0.0, 0.0, 4.0) is not allowed: B clear of the eye",
        "--light 0,0,0": "lights[0].position = (0.0, 0.0, 0.0) is not allowed: outside sphere A",
        "--albedo-a 0,0,2": "albedo_a[2] = 2.0 is not allowed: a finite number from 0 to 1",
    },
    "views": {
        "--gradient exact": "gradient = 'exact' is not allowed: one of 'forward', 'central', 'central4'",
        "--gain -1": "gain = -1.0 is not allowed: a finite number from 0 to 1e+300",
        "--out file": "out = 'file' is not allowed: File exists",
        "--out file/views": "out = 'file/views' is not allowed: Not a directory",
        "--out 'new/a\0b'": "out = 'new/a\\x00b' is not allowed: a name without the character 0",
        "--size 20000": "width * height = 400000000 is not allowed: at most 268435456 drawn pixels",
        "--crop 0,0,1,1": "unrecognized arguments: --crop 0,0,1,1",
    },
    "doctor": {"--size 8": "unrecognized arguments: --size 8"},
    "sweep": {
        "--eps 1e-3 -1": "eps = -1.0 is not allowed: a finite number from 1e-40 to 0.5",
        "--csv a.txt": "csv = 'a.txt' is not allowed: a file name that ends in .csv",
        "--csv nowhere/a.csv": "csv = 'nowhere/a.csv' is not allowed: a file in a folder that exists",
        "--field sine,foo": f"field = 'foo' is not allowed: one of {', '.join(map(repr, FIELDS))}",
        "--size 8,0": "width = 0 is not allowed: a whole number from 1 to 16777216",
        "--gradient central,foo": "gradient = 'foo' is not allowed: one of 'forward', 'central', 'central4'",
        "--gradient exact": "gradient = 'exact' is not allowed: one of 'forward', 'central', 'central4'",
        "--beta 0.1,": "argument --beta: '' is not allowed: a number",
        "--checkpoint a.txt": "checkpoint = 'a.txt' is not allowed: a file name that ends in .jsonl",
        "--workers 0": "workers = 0 is not allowed: a whole number from 1 to 256",
        "--dask foo --workers 2": "dask = 'foo' is not allowed: no --workers beside it",
        "--dask foo": "dask = 'foo' is not allowed: the address of a scheduler that answers (missing port",
        "--checkpoint a.jsonl --dask foo": "dask = 'foo' is not allowed: the address of a scheduler",
        "--eps": "argument --eps: expected at least one argument",
    },
}
"""{verb: {options: what is said of them}}: values have tests of their own, here are a few of each kind of option."""
TARGETS = {"image": "--size 8 --out a.png ", "views": "--size 8 --out views ", "sweep": "--size 8 ", "doctor": ""}


@pytest.mark.parametrize(("verb", "options"), [(verb, options) for verb in REFUSED for options in REFUSED[verb]])
def test_what_is_refused_is_said_in_one_line(verb, options, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "file").write_text("old")
    assert run(verb, *shlex.split(TARGETS[verb] + options)) == 2
    message, (out, err) = REFUSED[verb][options], capsys.readouterr()
    assert (out, err.count("\n"), err[-1]) == ("", 1, "\n")
    assert err.startswith((f"symbolic-rendering {verb}: error: {message}", f"symbolic-rendering: error: {message}"))
    assert contents(tmp_path) == {"file": b"old"}


def test_bounds_are_written(tmp_path, capsys):
    assert run("image", "--size", "9", "--out", tmp_path / "a.png", "--bounds", tmp_path / "b.npz") == 0
    frame, kept = render(Scene(), 9, 9, bounds=True), np.load(tmp_path / "b.npz")
    np.testing.assert_array_equal(kept["bounds"], frame.bounds)
    np.testing.assert_array_equal(kept["open"], frame.open)
    told = f"no colour is more than {frame.bounds.max():.2g} off, {frame.open.sum()} pixels are open"
    assert capsys.readouterr().out.splitlines()[1] == f"wrote {tmp_path / 'b.npz'}: {told}"


def test_too_little_memory_is_one_line(tmp_path, monkeypatch, capsys):
    def no_memory(*arguments, **options):
        raise MemoryError("Unable to allocate 6.00 GiB")

    monkeypatch.setattr("renderer.command_line.verbs.render", no_memory)
    assert run("image", "--out", tmp_path / "a.png") == 2
    assert capsys.readouterr().err == "symbolic-rendering image: error: Unable to allocate 6.00 GiB\n"


@pytest.mark.parametrize("arguments", [(), ("draw",), ("image",), ("views",)])
def test_a_missing_or_unknown_verb_or_target(arguments, capsys):
    assert run(*arguments) == 2
    assert capsys.readouterr().err.count("\n") == 1


@pytest.mark.parametrize("verb", [(), ("image",), ("views",), ("sweep",), ("doctor",)])
@pytest.mark.parametrize("encoding", ["ascii", "cp1252", "utf-8"])
def test_help(encoding, verb, monkeypatch):
    printed = io.TextIOWrapper(io.BytesIO(), encoding)
    monkeypatch.setattr("sys.stdout", printed)
    assert run(*verb, "--help") == 0
    monkeypatch.undo()
    printed.flush()
    of_verb = () if "doctor" in verb else ("--field", "--ku", "--light", "--size", "--eps")
    out = printed.buffer.getvalue().decode(encoding)
    assert out.startswith(" ".join(["usage: symbolic-rendering", *verb])) and "\\" not in out
    assert all(word in out for word in (of_verb if verb else ("image", "views", "sweep", "doctor", "--version")))


def test_a_letter_that_the_terminal_lacks_is_no_error(tmp_path):
    settings = os.environ | {"PYTHONIOENCODING": "ascii"}
    told, _ = python("-m", "renderer", "image", "--size", "8", "--out", tmp_path / "é.png", env=settings)
    assert told == f"wrote {tmp_path}/\\xe9.png: 8 x 8 pixels\n"


def test_the_version(capsys):
    assert run("--version") == 0
    version = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["version"]
    assert capsys.readouterr() == (f"symbolic-rendering {version}\n", "")
    assert renderer.__version__ == version


def test_doctor(tmp_path, monkeypatch, capsys):
    for kept, told in (("off", "not kept"), (str(tmp_path / "new"), "not there yet"), (str(tmp_path), "0 files")):
        monkeypatch.setenv("SYMBOLIC_RENDERING_CODE", kept)
        assert run("doctor") == 0
        found = dict(re.split(r" \.+ ", line, maxsplit=1) for line in capsys.readouterr().out.splitlines())
        assert {"symbolic-rendering", "Python", "NumPy", "llvmlite", "machine", "threads"} < found.keys()
        assert told in found["compiled code"]


def test_a_picture_in_a_pipe(tmp_path):
    """Read to its end, or by somebody who has soon had enough; a terminal is refused."""
    command = ["-m", "renderer", "image", "--size", "300", "--out", "-"]
    done = started(*command, encoding=None)
    out, err = done.communicate()
    np.testing.assert_array_equal(picture(io.BytesIO(out)), views.image_view(render(Scene(), 300, 300)))
    assert (done.returncode, err) == (0, b"wrote -: 300 x 300 pixels\n")
    with started(*command) as child:
        child.stdout.close()
        assert (child.stderr.read(), child.wait()) == ("", 141)


def test_a_picture_is_not_written_to_a_terminal(monkeypatch, capsys):
    monkeypatch.setattr("sys.stdout.isatty", lambda: True)
    assert run("image", "--size", 8, "--out", "-") == 2
    told = "out = '-' is not allowed: a file, or standard output that is no terminal"
    assert capsys.readouterr() == ("", f"symbolic-rendering image: error: {told}\n")


@pytest.mark.parametrize("lights", [(), DEFAULT_LIGHTS])
def test_the_defaults_are_the_chapters_and_its_lights_can_be_given(lights, tmp_path):
    options = [text for light in lights for text in ("--light", ",".join(map(str, light.position + light.color)))]
    assert run("image", "--size", "8", *options, "--out", tmp_path / "a.npz") == 0
    np.testing.assert_array_equal(np.load(tmp_path / "a.npz")["rgb"], render(Scene(), 8, 8).rgb)


WITHOUT = ["sys.modules['llvmlite'] = None", "import llvmlite.binding; del llvmlite.binding.create_pass_builder"]


@pytest.mark.parametrize("without", WITHOUT)
def test_numpy_draws_the_same_where_llvmlite_is_missing_or_old_and_says_so(without, tmp_path):
    code = f"import sys; {without}; from renderer.command_line.verbs import main; sys.exit(main())"
    _, told = python("-W", "error", "-c", code, "image", "--size", "33", "--out", tmp_path / "a.npz")
    expected = "NumPy draws, the same but slowly, since llvmlite is not installed (or too old)"
    assert told == f"symbolic-rendering image: {expected}\n"
    frame = render(Scene(), 33, 33)
    assert frame.work["machine"] == "llvm"
    np.testing.assert_array_equal(np.load(tmp_path / "a.npz")["rgb"], frame.rgb)


OF_NUMBERS = [field for field in dataclasses.fields(Scene) if field.type in (float, tuple) and field.name != "lights"]


@pytest.mark.parametrize("field", OF_NUMBERS, ids=lambda field: field.name)
def test_every_number_and_colour_of_the_scene_is_an_option(field, tmp_path):
    value = 0.9 * np.array(field.default)
    text = ",".join(map(str, np.ravel(value)))
    assert run("image", "--size", "8", "--" + field.name.replace("_", "-"), text, "--out", tmp_path / "a.npz") == 0
    scene = Scene(**{field.name: field.type(value)})
    np.testing.assert_array_equal(np.load(tmp_path / "a.npz")["rgb"], render(scene, 8, 8).rgb)


def test_drawing_needs_neither_sympy_nor_the_proofs(tmp_path):
    code = f"""
import sys
from renderer.command_line.verbs import main
assert main(["views", "--size", "8", "--out", {str(tmp_path)!r}]) == 0
assert main(["sweep", "--size", "8"]) == 0
loaded = {{name.split(".")[0] for name in sys.modules}}
assert not loaded & {{"sympy", "proofs", "verify", "book"}}, loaded
"""
    python("-c", code)
