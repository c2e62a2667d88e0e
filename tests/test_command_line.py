"""The command line: what it writes and prints, and how it refuses."""

import os
import re
import shlex
import sys
import tomllib
from dataclasses import fields
from io import BytesIO
from unittest.mock import Mock

import numpy as np
import pytest
from PIL import Image

import renderer
from renderer import Light, Scene, central, render
from renderer.command_line import grid
from renderer.command_line.verbs import main
from renderer.files import record
from renderer.kernels import FIELDS
from renderer.picture import views
from renderer.picture.facts import facts
from renderer.picture.sweep import sweep, table
from tests.pictures import contents, shows
from tests.processes import python, started
from verify.evidence.sources import ROOT


def run(*arguments):
    """Run the command line in this process; return its exit status."""
    try:
        return main([str(argument) for argument in arguments])
    except SystemExit as end:  # argparse's way out
        return end.code


def other_scene():
    """Return a scene that differs in each field from the default, and its options."""
    numbers = {each.name: each.default for each in fields(Scene) if each.type in (float, tuple)}
    values = {name: 0.9 * np.array(value) for name, value in numbers.items() if name != "lights"}
    lights = Light((-6, 2, 8)), Light((5, 5, 10), (1, 0.5, 0))
    scene = Scene(**values, ball=False, floor=False, field="rings", model="phong", lights=lights)
    options = [f"--{name.replace('_', '-')} {','.join(map(str, value.ravel()))}" for name, value in values.items()]
    return scene, [*options, "--no-ball --no-floor --field rings --model phong --light -6,2,8 --light 5,5,10,1,0.5,0"]


@pytest.mark.parametrize("name", ["a.PNG", "a.npz", "a.Npy", "a.TIF"])
def test_image(name, tmp_path, capsys):
    """With every option of the scene; a picture that is drawn whole with its bounds."""
    target, (scene, options) = tmp_path / name, other_scene()
    samples = 1 + (name == "a.npz")
    options += [
        f"--samples {samples} --width 20 --height 10 --crop 5,2,10,6 --threads 1 --gradient central --eps 1e-2 --out",
        str(target),
    ]
    frame = render(scene, 20, 10, central(1e-2), (5, 2, 10, 6), bounds=True, samples=samples)
    told = f"wrote {target}: 10 x 6 pixels\n"
    is_whole = name in ("a.PNG", "a.npz")
    if is_whole:
        options += ["--bounds", str(tmp_path / "b.npz")]
        far = f"no colour is more than {frame.bounds.max():.2g} off, {frame.open.sum()} pixels are open"
        told += f"wrote {tmp_path / 'b.npz'}: {far}\n"
    assert run("image", *shlex.split(" ".join(options))) == 0
    assert capsys.readouterr() == (told, "")
    assert shows(target, frame)
    if is_whole:
        assert record.read(target)[0] == frame.shot
        arrays = np.load(tmp_path / "b.npz")
        assert (arrays["bounds"] == frame.bounds).all() and (arrays["open"] == frame.open).all()


@pytest.mark.parametrize("name", ["a.png", "a.tif", "-", "a.npy", "a.npz"])
def test_a_slope(name, tmp_path, capfdbinary):
    """A picture beside its scale, or the numbers."""
    target, slope = tmp_path / name, render(Scene(), 20, 20, derivatives=["beta"]).derivatives["beta"]
    assert run("image", "--by", "beta", "--size", 20, "--out", name if name == "-" else target) == 0
    shown = {"a.png": target, "a.tif": target, "-": BytesIO(capfdbinary.readouterr().out)}
    if name in shown:
        picture = np.asarray(Image.open(shown[name]))
        assert (picture[:20, :20] == views.derivative_view(slope, "beta")[:20, :20]).all()
    else:
        kept = np.load(target)
        assert ((kept if name == "a.npy" else kept["derivative_beta"]) == slope).all()


def test_views(tmp_path, capsys):
    folder = tmp_path / "new" / "views"
    assert run("views", "--size", 24, "--eps", "1e-2", "--out", folder) == 0
    names = "numeric.png, symbolic.png, slope.png, kink.png, difference_linear.png, difference_logarithmic.png"
    assert capsys.readouterr().out == f"wrote {folder}: {names}\n"
    one, other = render(Scene(), 24, 24, central(1e-2)), render(Scene(), 24, 24)
    assert shows(folder / "numeric.png", one) and shows(folder / "symbolic.png", other)
    linear = np.asarray(Image.open(folder / "difference_linear.png"))
    assert (linear == views.difference_linear(one.rgb - other.rgb)).all()


def test_sweep(tmp_path, monkeypatch, capsys):
    """Without tqdm, too."""
    monkeypatch.setitem(sys.modules, "tqdm", None)
    target = tmp_path / "a.csv"
    assert run("sweep", "--size", 32, "--eps", "1e-2", "1e-3", "--gradient", "forward", "--csv", target) == 0
    first, *expected = table(sweep(Scene(), 32, 32, (1e-2, 1e-3), "forward")).splitlines()
    told = [f"{name + ' ':.<60} {value}" for name, value in facts(Scene(), 32, 32)]
    head = "ridges, blinn, 32 x 32: forward difference against the exact gradient"
    lines = [head, first, *expected, f"wrote {target}", "", *told, ""]
    assert capsys.readouterr() == ("\n".join(lines), "")
    assert len(target.read_text().splitlines()) == 3


def test_a_sweep_that_ends_early_says_what_is_kept(tmp_path, monkeypatch, capsys):
    path, compare = tmp_path / "a.jsonl", grid.compare_batch

    def ended(batch, *arguments):
        if len(batch) < 8:
            raise KeyboardInterrupt
        return compare(batch, *arguments)

    monkeypatch.setattr(grid, "compare_batch", ended)
    betas = ",".join(map(str, range(1, 21)))
    command = ["sweep", "--size", "8", "--eps", "1e-3", "--beta", betas, "--workers", "1"]
    for options, rest in (
        ([], "nothing is kept without --checkpoint"),
        (["--checkpoint", path], f"16 of 20 frames are in {path}, and the same command goes on from there"),
    ):
        assert run(*command, *options) == 130
        assert capsys.readouterr() == ("", f"symbolic-rendering sweep: interrupted: {rest}\n")


@pytest.mark.parametrize(
    "module, extra, arguments",
    [
        ("distributed", "dask", ["sweep", "--dask", "tcp://localhost:1"]),
        ("tifffile", "tiff", ["image", "--out", "a.tif"]),
        ("matplotlib", "plot", ["views", "--out", "new/views"]),
    ],
)
def test_what_needs_an_extra_that_is_not_installed_names_it(module, extra, arguments, monkeypatch, capsys, tmp_path):
    """Before anything is drawn."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setitem(sys.modules, module, None)
    assert run(*arguments, "--size", "8") == 2
    told = f"{module} is not installed: pip install 'symbolic-rendering[{extra}]'"
    assert capsys.readouterr().err.endswith(f"error: {told}\n")
    assert contents(tmp_path) == {}


LONG = "a" * 300 + ".png"
REFUSED = {
    "image": {
        "--out a.jpg": "out = 'a.jpg' is not allowed: a file name that ends in .png or .tif or .tiff or",
        "--out nowhere/a.png": "out = 'nowhere/a.png' is not allowed: a file in a folder that exists",
        "--out a.npz --bounds ./a.npz": "bounds = './a.npz' is not allowed: another file than --out",
        "--out a.npy --bounds a.npz": "bounds = 'a.npz' is not allowed: no --out that is drawn in bands",
        "--bounds ''": "bounds = '' is not allowed: a file name that ends in .npz",
        f"--out {LONG}": f"out = '{LONG}' is not allowed: a file that can be written (File name too long)",
        "--out a.npy --linear float32": "linear = 'float32' is not allowed: given with a .tif",
        "--linear float16": "linear = 'float16' is not allowed: one of 'float32', 'float64'",
        "--by beta,ku": "by = 'beta,ku' is not allowed: several numbers for a .npz, one for",
        "--samples 17": "samples = 17 is not allowed: a whole number from 1 to 16",
        "--again a.png --samples 2": "again = 'a.png' is not allowed: no --samples beside it",
        "--by lights[7].color[0]": "by = 'lights[7].color[0]' is not allowed: names of the scene's numbers",
        "--by ball_radius --no-ball": "by = 'ball_radius' is not allowed: no number of a body or a light",
        "--scene no.toml": "scene = 'no.toml' is not allowed: a file with a whole record of a scene (No such file",
        "--again file --size 256": "again = 'file' is not allowed: a file with a whole record of a scene (it is no",
        "--again ''": "again = '' is not allowed: no --size beside it",
        "--again a.png --scene a.toml": "again = 'a.png' is not allowed: no --scene beside it",
        "--field SINE": f"field = 'SINE' is not allowed: one of {', '.join(map(repr, FIELDS))}",
        "--eps 1e-2": "eps = 0.01 is not allowed: none beside the exact gradient",
        "--gradient central --eps -1e-3": "eps = -0.001 is not allowed: a finite number from 1e-40 to 0.5",
        "--beta -inf": "beta = -inf is not allowed: a finite number from -1e+100 to 1e+100",
        "--crop 0,0,9,9": "crop = (0, 0, 9, 9) is not allowed: (left, top, width, height), whole numbers",
        "--size 20000": "width * height = 400000000 is not allowed: at most 268435456 drawn pixels",
        "--threads 0": "threads = 0 is not allowed: a whole number from 1 to 256",
        "--light 1,2": "argument --light: '1,2' is not allowed: X,Y,Z or X,Y,Z,R,G,B",
        "--light 1,2,3,-1,1,1": "light.color[0] = -1.0 is not allowed: a finite number from 0 to 1e+06",
        "--ball-center 0,0": "argument --ball-center: '0,0' is not allowed: X,Y,Z",
        "--crop a,b,c,d": "argument --crop: 'a,b,c,d' is not allowed: LEFT,TOP,WIDTH,HEIGHT",
        "--ku abc": "argument --ku: 'abc' is not allowed: a number",
        "--size 1e3": "argument --size: '1e3' is not allowed: a whole number",
        "--beta": "argument --beta: expected one argument",
        "--bet 1": "unrecognized arguments: --bet 1",
        "--field-expression 'sin(u'": "field-expression = 'sin(u' is not allowed: it is no formula",
        "--field-expression '(((v/3)^64 + v/3)^64 + v/3)^64'": "field-expression is not allowed: at most",
        "--field-expression -u*v": "field-expression = -u*v is not allowed: it is 0 at u = 0 and -0.143 at u = 1, "
        "{v: 1/7, k_u: 2, k_v: 1}, without --field-seam",
        "--field-seam": "field-seam = True is not allowed: given with --field-expression",
        "--field-parameter a=1": "field-parameter = [('a', 1.0)] is not allowed: given with --field-expression",
        "--field-parameter a=b": "argument --field-parameter: 'a=b' is not allowed: NAME=NUMBER",
        "--field-expression a --field-parameter a=1 --field-parameter a=2": "field-parameter = "
        "[('a', 1.0), ('a', 2.0)] is not allowed: each name once",
        "--field-expression v --field-parameter name=1": "field-parameter = {'name': 1.0} is not allowed: others than",
        "--field-expression v --field-parameter b=1": "field-parameter = 'b' is not allowed: one that the formula",
        "--field-expression v --field-parameter v=1": "field-parameter = 'v' is not allowed: a name of small letters",
        "--field-expression v --field-parameter self=inf": "self = inf is not allowed: a finite number",
        "--again a.png --field-parameter a=1": "again = 'a.png' is not allowed: no --field-parameter beside it",
    },
    "views": {
        "--gradient exact": "gradient = 'exact' is not allowed: one of 'forward', 'central', 'central4'",
        "--out file": "out = 'file' is not allowed: File exists",
        "--out 'new/a\0b'": "out = 'new/a\\x00b' is not allowed: a file's name, without the character 0",
        "--crop 0,0,1,1": "unrecognized arguments: --crop 0,0,1,1",
    },
    "": {"": "", "draw": "", "image": "the following arguments are required: --out"},
    "sweep": {
        "--by beta": "unrecognized arguments: --by beta",
        "--csv ''": "csv = '' is not allowed: a file name that ends in .csv",
        "--checkpoint ''": "checkpoint = '' is not allowed: a file name that ends in .jsonl",
        "--size 8,0": "width = 0 is not allowed: a whole number from 1 to 16777216",
        "--beta 0.1,": "argument --beta: '' is not allowed: a number",
        "--workers 0": "workers = 0 is not allowed: a whole number from 1 to 256",
        "--dask foo --workers 2": "dask = 'foo' is not allowed: no --workers beside it",
        "--dask foo": "dask = 'foo' is not allowed: the address of a scheduler that answers (missing port",
    },
}
"""{verb: {options: what is said of them}}: values have tests of their own, here is one of each kind of option."""
TARGETS = {"image": "--size 8 --out a.png", "views": "--size 8 --out views", "sweep": "--size 8"}


@pytest.mark.parametrize("verb, options", [(verb, options) for verb in REFUSED for options in REFUSED[verb]])
def test_what_is_refused_is_said_in_one_line(verb, options, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "file").write_text("old")
    assert run(*shlex.split(f"{verb} {TARGETS.get(verb, '')} {options}")) == 2
    out, err = capsys.readouterr()
    assert (out, err.count("\n"), err[-1]) == ("", 1, "\n")
    assert re.match(f"symbolic-rendering( {verb or '.*'})?: error: {re.escape(REFUSED[verb][options])}", err)
    assert contents(tmp_path) == {"file": b"old"}


@pytest.mark.parametrize("verb", TARGETS)
def test_the_examples_of_help_run(verb, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert run(verb, "--help") == 0
    examples = re.findall(f"^  symbolic-rendering ({verb} --.*)", capsys.readouterr().out, re.M)
    assert examples and all(run(*shlex.split(example)) == 0 for example in examples)


def test_too_little_memory_is_one_line(tmp_path, monkeypatch, capsys):
    error = MemoryError("Unable to allocate 6.00 GiB")
    monkeypatch.setattr("renderer.command_line.verbs.render", Mock(side_effect=error))
    assert run("image", "--out", tmp_path / "a.png") == 2
    assert capsys.readouterr().err == f"symbolic-rendering image: error: {error}\n"


def test_a_letter_that_the_terminal_lacks_is_no_error(tmp_path):
    settings = os.environ | {"PYTHONIOENCODING": "ascii"}
    told, _ = python("-m", "renderer", "image", "--size", "8", "--out", tmp_path / "é.png", env=settings)
    assert told == f"wrote {tmp_path}/\\xe9.png: 8 x 8 pixels\n"


def test_the_version(capsys):
    assert run("--version") == 0
    version = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]["version"]
    assert capsys.readouterr() == (f"symbolic-rendering {version}\n", "")
    assert renderer.__version__ == version


def test_doctor(tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("SYMBOLIC_RENDERING_CODE", str(tmp_path))
    assert run("doctor") == 0
    out = capsys.readouterr().out
    assert all(f"{told} ." in out for told in ("symbolic-rendering", "NumPy", "llvmlite")) and "0 files" in out


def test_a_picture_in_a_pipe(monkeypatch, capsys):
    """Read to its end, or by somebody who has soon had enough; a terminal is refused."""
    command = ["-m", "renderer", "image", "--size", "300", "--out", "-"]
    with started(*command, encoding=None) as done:
        out, err = done.communicate()
    assert out == render(Scene(), 300, 300)._repr_png_()
    assert (done.returncode, err) == (0, b"wrote -: 300 x 300 pixels\n")
    with started(*command) as child:
        child.stdout.close()
        assert (child.stderr.read(), child.wait()) == ("", 141)
    told = "out = '-' is not allowed: a file, or standard output that is no terminal"
    monkeypatch.setattr("sys.stdout.isatty", lambda: True)
    assert run(*command[2:]) == 2
    assert capsys.readouterr() == ("", f"symbolic-rendering image: error: {told}\n")


WITHOUT = ["sys.modules['llvmlite'] = None", "import llvmlite.binding; del llvmlite.binding.create_pass_builder"]


@pytest.mark.parametrize("without", WITHOUT)
def test_numpy_draws_the_same_where_llvmlite_is_missing_or_old_and_says_so(without, tmp_path):
    code = f"import sys; {without}; from renderer.command_line.verbs import main; sys.exit(main())"
    _, told = python("-W", "error", "-c", code, "image", "--size", "33", "--out", tmp_path / "a.npz")
    expected = "NumPy draws, the same but slowly, since llvmlite is not installed (or too old)"
    assert told == f"symbolic-rendering image: {expected}\n"
    frame = render(Scene(), 33, 33)
    assert frame.work["machine"] == "llvm"
    assert shows(tmp_path / "a.npz", frame)


def test_drawing_needs_neither_sympy_nor_the_proofs(tmp_path):
    code = f"""
import sys
from renderer.command_line.verbs import main
from renderer import *
assert main(["views", "--size", "8", "--out", {str(tmp_path)!r}]) == 0
assert main(["sweep", "--size", "8"]) == 0
render(Scene.from_record(Scene(field="rings").as_record()), 8, 8, bounds=True)
loaded = {{name.split(".")[0] for name in sys.modules}}
assert not loaded & {{"sympy", "mpmath", "proofs", "verify", "book"}}, loaded
"""
    python("-c", code)
