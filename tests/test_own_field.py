"""Custom height fields: drawn, bounded, refused, written down and read again."""

import os
import re
from dataclasses import replace
from functools import partial
from random import Random

import mpmath
import numpy as np
import pytest
from sympy import Mod, Mul, Piecewise, Rational, Symbol, exp, frac, log, pi, sin, sqrt, tanh

from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.shading import LIGHT_MODELS
from proofs.printers.text import LONGEST
from renderer import (
    HeightField,
    Scene,
    central,
    central4,
    exact,
    fit,
    forward,
    gradient_at,
    height_at,
    k_u,
    k_v,
    render,
    sinpi,
    u,
    v,
)
from renderer.command_line.verbs import main
from renderer.files import record
from renderer.generate.custom_printer import CALLED, OwnPrinter
from renderer.generate.reader import expression_text, parse_expression
from renderer.machines import native
from renderer.scene.fields import field_kernels
from renderer.shader.gradients import algebraic_powers
from tests.pictures import shows
from tests.processes import python
from tests.refusals import rejection
from tests.test_machines import differing, drawn_by, held, numpy_draws
from verify.enclosed_pixels import wrong

DUNES = "exp(-8*(v-1/2)**2)*sinpi(k_u*u)"
NESTED = [  # of a random grammar, those that have most in one another
    "(2+cospi(k_v*v-1/3))^1.5-sinpi(k_v*v)/(3+cospi(2*k_u*u+k_v*v))/(3+cospi(2*k_u*u+k_v*v))",
    "exp(-2*(v-1/2)**2**2)+floor(3*sinpi(k_u*u))/2+max(sqrt(4+sinpi(k_v*v)), sinpi(k_u*u)-max(0,sinpi(k_v*v)))",
    "(exp(-2*-cospi(k_v*v-1/3)**2)*sinpi(k_v*v)) % 2",
    "sqrt(4+sinpi(k_u*u))/(3+sign(2+sinpi(k_u*u)))-max(atan(2*cospi(2*k_u*u+k_v*v)), 2.5e-1"
    "+floor(3*cospi(2*k_u*u+k_v*v))/2)",
    "-abs(log(4+cospi(k_v*v-1/3)))*abs(sqrt(4+sinpi(k_u*u)))",
    "max(-sinpi(k_u*u), cospi(2*k_u*u+k_v*v)/(3+cospi(k_v*v-1/3)), (2+cospi(k_v*v-1/3))^1.5"
    "+(abs(sinpi(k_u*u)*cospi(k_v*v))*cospi(k_v*v-1/3)) % 2)",
    "abs(exp(-2*atan(2*cospi(k_v*v-1/3))**2))*abs(sqrt(4+sign(2+sinpi(k_u*u))))",
    "abs(log(4+sinpi(k_u*u))*(2+sinpi(k_u*u))^1.5)*abs(log(4+sinpi(k_v*v)))",
    "exp(-2*(sqrt(4+cospi(2*k_u*u+k_v*v))-(min(0, sinpi(k_u*u+k_v*v))-pi/4))**2)",
    "((2.5e-1*sinpi(k_v*v)) % 2-sqrt(4+sinpi(k_v*v)))/(3+cospi(2*k_u*u+k_v*v))",
    "(atan(2*sinpi(k_u*u))+abs(v)*0.3)*cospi(k_v*v-1/3) % 2",
    "abs(0.3*cospi(2*k_u*u+k_v*v) % 2+floor(3*sinpi(k_v*v))/2)*abs((2+sinpi(k_u*u))^1.5)",
]
KU, KV = 6.0, 3.0
METHODS = (exact(), central(1e-3), forward(1e-2), central4(1e-2))


def by_mpmath(text):
    """The function of a text, by Python and mpmath alone."""
    exactly = re.sub(r"(?<!\w)[\d.]+(e-?\d+)?", r"mpf('\g<0>')", text.replace("^", "**").replace("np.", ""))
    chosen = {"min": min, "max": max, "Piecewise": lambda *cases: next(value for value, holds in cases if holds)}
    names = vars(mpmath) | chosen | {"E": mpmath.e, "mod": lambda x, y: x % y}
    names |= {"where": lambda test, one, other: one if test else other, "clip": lambda x, *ends: sorted([x, *ends])[1]}
    return eval(f"lambda u, v, k_u={KU}, k_v={KV}: {exactly}", names)


def apart(text, field, count=12, size=lambda true: 1 + abs(true)):
    """Return the distance of a field's heights and slopes from those of a text, over their size, off the creases."""
    scene, random = Scene(field=field, ku=KU, kv=KV), np.random.default_rng(28)
    here = random.uniform(0.01, 0.99, (2, count))
    here = here[:, field_kernels(field)["straddling"](*here, KU, KV, 1e-6) == np.zeros(count)]
    computed = [height_at(scene, *here), *gradient_at(scene, *here, exact())]
    with mpmath.workdps(60):
        true = [[mpmath.diff(by_mpmath(text), at, n) for at in here.T.tolist()] for n in ((0, 0), (1, 0), (0, 1))]
        return np.max(abs(np.array(computed) - true) / size(np.array(true)))


def assert_drawn(scene, method, monkeypatch):
    """Hold a picture of one's own field to the same bits by both machines, and to bounds that hold in balls."""
    with drawn_by(native.drawer):
        by_llvm = held(render(scene, 24, 16, method))
    assert differing(by_llvm, held(assert_bounded(scene, method, monkeypatch))) == []


def assert_bounded(scene, method, monkeypatch):
    """Hold a picture by NumPy to its bounds, and return it."""
    monkeypatch.setitem(HEIGHT_FIELDS, scene.field, scene.field)
    with numpy_draws():
        frame = render(scene, 24, 16, method, bounds=True)
    assert not any(wrong(frame, *place) for place in ((10, 6), (13, 9), (8, 8), (12, 4), (2, 14)))
    return frame


@pytest.mark.parametrize("text", NESTED)
def test_a_formula_is_drawn_by_both_machines_and_is_what_it_says(text, monkeypatch):
    """Bits, gradients against mpmath's at 60 digits, bounds against 256-bit balls."""
    field = HeightField("nested", text)
    assert parse_expression(expression_text(field.expression)) == field.expression
    assert apart(text, field) < 1e-12
    assert_drawn(Scene(field=field, ku=KU, kv=KV), METHODS[NESTED.index(text) % len(METHODS)], monkeypatch)


AS_WRITTEN = [
    "sin(pi*k_u*u)", "0.3*sin(8*pi*u)*cos(4*pi*v)", "sin(8*pi*u)^2", "E*np.sin(2*np.pi*u)", "sin(pi/7)*sin(6*pi*u)",
    "abs(sin(8*pi*u))*abs(sin(4*pi*v))", "(1 - abs(sin(8*pi*u)))*(1 - abs(cos(5*pi*v)))", "abs(v - 1/2)",
    "max(0, sin(16*pi*u)*sin(8*pi*v) - 1/2)", "abs(sin(8*pi*u + pi*floor(8*v)/2))*abs(sin(8*pi*v))",
    "tanh(5*sin(8*pi*u))", "atan(3*sin(8*pi*u))", "mod(8*u, 1)", "floor(4*v)/8 + v", "(8*u % 1)*(1 - 8*u % 1)",
    "exp(-((u - 0.5)^2 + (v - 0.5)^2)/0.02)", "max(sin(8*pi*u), cos(6*pi*v))", "abs(sin(8*pi*u))^1.5",
    "min(abs(sin(8*pi*u)), abs(sin(8*pi*v)))", "sign(sin(8*pi*u)*sin(6*pi*v))*v", "max(0, min(1, 4*v - 1))",
    "Piecewise((1, v < 1/4), (0, v > 3/4), (2 - 4*v, True))", "log(2 + sin(8*pi*u)*sin(4*pi*v))", "v^2.5",
    "sin(20*pi*sqrt((u - 1/2)^2 + (v - 1/2)^2 + 1e-3))", "2^(-8*(v - 1/2)^2)", "1/(1 + 10*sin(4*pi*u)^2)",
    "sin(2*pi*(3*u + 2*v) + 0.7) + sin(2*pi*(5*u - 4*v) + 2.1)/2 + sin(2*pi*(9*u + 7*v) + 4.2)/3",
    "sin(4*pi*u) if v < 1/3 else where(v > 2/3, v, clip(3*v, 1/2, 3/2))", "sin(8*pi*(u + sin(4*pi*v)/10))",
    "abs(abs(sin(4*pi*u)) - 1/2)", "sinh(sin(4*pi*u))/cosh(2*v)",
    "max(0, 1 - 20*((4*u % 1 - 1/2)^2 + (4*v % 1 - 1/2)^2))",
]  # fmt: skip
NOT_DRAWN = {
    "sin(8*u)": "it is 0 at u = 0 and 0.989 at u = 1, .*: let u stand in sines and cosines of 2",
    "sqrt((u - 1/2)^2 + (v - 1/2)^2)": r"1/sqrt\(.*\) of h or a slope is not shown to be finite: keep .* 1e-4\)",
    "v + 2u": r"from '2u' on: write 2\*u for 2u, .* sin\(u\)\*\*2",
    "(u < v)*v": r"'u < v' is not of the kind that belongs there: write .* where\(u < v, 1, 2\)",
    "asin(sin(2*pi*u))": r"none of numbers .* arctan, .* Piecewise; write 2\*u",
}


@pytest.mark.parametrize("text", AS_WRITTEN)
def test_a_field_is_drawn_as_it_comes_to_mind(text, monkeypatch):
    """Off its creases as mpmath has it, and the picture as by a small step; bounds hold in balls."""
    field = HeightField("as_written", text)
    assert apart(text, field) < 1e-12
    scene = Scene(field=field, ku=KU, kv=KV)
    with numpy_draws():
        stepped = render(scene, 24, 16, central(1e-5))
        assert abs(stepped.rgb - render(scene, 24, 16).rgb)[~stepped.straddling].max() < 5e-6
    assert_bounded(scene, exact(), monkeypatch)
    assert Scene.from_record(scene.as_record()) == scene


@pytest.mark.parametrize("text", NOT_DRAWN)
def test_a_refusal_says_what_to_write(text):
    assert re.search(NOT_DRAWN[text], rejection(HeightField, "refused", text))


@pytest.mark.parametrize("how", [{"positive": True}, {"real": True}, {}], ids=str)
def test_sympy_says_it_as_a_text_does(how):
    x, y, k = (Symbol(name, **how) for name in ("u", "v", "ku"))
    written = sin(pi * k * x) + Mod(y, Rational(1, 4)) * tanh(0.1 * y) + 2 ** (k * y) + exp(1) * frac(2 * y + 1e-16)
    text = "sin(pi*k_u*u) + v % (1/4)*tanh(v/10) + 2**(k_u*v) + E*frac(2*v + 1e-16)"
    assert HeightField("sum", written) == HeightField("sum", text)
    assert HeightField("turn", "(1 + v)π*cos(2 πu)") == HeightField("turn", "(1 + v)*pi*cos(2*pi*u)")


HOSTILE = [
    "__import__('os')", "u" * 10**6, "(" * 500 + "u" + ")" * 500, "-" * (LONGEST - 1) + "u",
    "9**9**9", "((9**64)**64)**64", "u**65", "u**v", "1e999", "*".join("u" * 200), "I", "1/0", "log(-1)",
    "exp.__class__", "ｕ", "u<v<1", "u if v else 1", "(u,)", "u//v", "u\nv", "", "True", "0x10", "exp", "exp(u,v)",
    "max(*u)", "Piecewise((u,v))", "sinpi(exp(exp(20)))", "abs(v-" * 9 + "u" + ")" * 9,
    "max(" + ",".join("uv" * 20) + ")", "sqrt(u-2)", "cospi((k_u/2+k_v)*u)",
]  # fmt: skip
LONG = ["(((v/3)**64+v/3)**64+v/3)**64", "*".join(f"(v+{n})" for n in range(1, 199))]


@pytest.mark.parametrize("text", HOSTILE + LONG, ids=range(len(HOSTILE + LONG)))
def test_a_hostile_formula_is_refused_in_a_sentence(text):
    """One that would take long is refused at once."""
    error = rejection(Scene.from_record, {"field": {"name": "hostile", "expression": text}})
    assert error.startswith("field = 'hostile' is not allowed: at most" if text in LONG else "expression = ")
    assert len(error) < 400


def test_a_formula_that_no_text_says_is_drawn_and_not_written(tmp_path):
    scene = Scene(field=HeightField("unevaluated", Mul(2, v + Rational(1, 3), evaluate=False)))
    assert "as SymPy evaluates it" in rejection(scene.as_record)
    with numpy_draws():
        render(scene, 4, 4).save(tmp_path / "a.npz")
    assert "(0 records;" in rejection(record.read, tmp_path / "a.npz")


NO_FIELDS = {
    "expression = None is not allowed: an expression of SymPy, or its text": lambda: HeightField("none", None),
    "expression = array([[0.],        [0.]]) is not allowed": lambda: HeightField("image", np.zeros((2, 1))),
    "field = 'deep' is not allowed: a formula that is": lambda: HeightField("deep", "tanh(" * 29 + "v" + ")" * 29),
    "name = 'rings' is not allowed: a name that no other": lambda: Scene(field=HeightField("rings", v)),
    "is not allowed: one of 'sine'": lambda: Scene(field=LIGHT_MODELS["phong"]),
    "'rings', or HeightField(name, formula)": lambda: Scene(field="sin(2*pi*u)"),
    "'a' is none of numbers (named a=1), ": lambda: HeightField("x", "a*v"),
    "(ku, kv) = (1000.0, 4.0)": lambda: Scene(field=HeightField("steep", exp(k_u * v)), ku=1000),
    "(ku, kv) = (8.0, 100.0)": lambda: Scene(field=HeightField("torn", v / (k_v - 100)), kv=100),
    "beta = 1e+100": lambda: Scene(field=HeightField("high", v * 10**9), beta=1e100),
    "derivatives = 'a' is not allowed: a parameter outside abs, max and": lambda: render(
        Scene(field=HeightField("moving", "max(0, sin(8*pi*u) - a)", a=0.5)), 8, 8, derivatives=["a"]
    ),
    "parameter = 'u' is not allowed: a name of small letters": lambda: HeightField("x", "v", u=1),
    "parameter = 'b' is not allowed: one that the formula has: a": lambda: HeightField("x", "a*v", a=1, b=1),
    "a = 'b' is not allowed: a finite number": lambda: HeightField("x", "a*v", a="b"),
    "field = 'beta' is not allowed: parameters by names": lambda: Scene(field=HeightField("x", "beta*v", beta=1)),
}
"""{how it is said: what is made}, beside the files of tests/test_again.py."""


@pytest.mark.parametrize("text", NO_FIELDS)
def test_what_is_no_field_is_refused(text):
    assert text in rejection(NO_FIELDS[text])


def test_a_profile_is_plotted_from_end_to_end():
    scene, along = Scene(field=HeightField("slope", "u^2*v", seam=True)), np.linspace(0, 1, 5)
    assert (height_at(scene, along, 1) == along**2).all()
    assert (gradient_at(scene, along, 1, exact())[0] == 2 * along).all()


def test_a_field_is_kept_by_its_formula():
    """A name is a label, whatever was drawn by it or refused; one of the chapter's is the chapter's."""
    assert "number that no float64" in rejection(HeightField, "label", v / 10**400)
    labels = ("label", 2), ("label", 4), ("label", 2), ("another", 4)
    scenes = [Scene(field=HeightField(name, exp(v) * sinpi(rate * u))) for name, rate in labels]
    first, edited, again, renamed = (render(scene, 8, 8).rgb.tobytes() for scene in scenes)
    assert first == again != edited == renamed
    assert scenes[0] == scenes[2] != scenes[1] != scenes[3]
    assert Scene(field=replace(HEIGHT_FIELDS["rings"])) == Scene(field="rings")


@pytest.mark.parametrize("method", METHODS[:2], ids=str)
@pytest.mark.parametrize("text, number, name, instead", [
    ("a*sin(8*pi*u)*sin(4*pi*v)", 0.3, "beta", "0.3"),
    ("sin(a*pi*u)*sin(k_v*pi*v)", 8.0, "ku", "k_u"),
    ("abs(sin(6*pi*u))*a + abs(sin(4*pi*v))*a", -2.0, "beta", "(-2)"),
])  # fmt: skip
def test_a_slope_by_a_parameter_is_that_by_a_number_of_the_scene(text, number, name, instead, method):
    """a ∂I/∂a = β ∂I/∂β and its like, within the bounds of both; the picture is that of the number in the formula."""
    fields = HeightField("moved", text, True, a=number), HeightField("moved", re.sub(r"\ba\b", instead, text), True)
    scene, twin = (Scene(field=field) for field in fields)
    with numpy_draws():
        frames = [render(s, 24, 16, method, bounds=True, derivatives=[n]) for s, n in ((scene, "a"), (twin, name))]
        plain = render(scene, 24, 16, method)
    slope, of_twin, bound, of_both = (
        values for kind in ("derivatives", "derivative_bounds") for f in frames for values in getattr(f, kind).values()
    )
    share = number / scene.number(name)
    assert (abs(slope * share - of_twin) <= (of_both + bound * abs(share)) * (1 + 1e-15) + 1e-15 * abs(of_twin)).all()
    assert np.isfinite(bound).all() and abs(slope).max() > 0.1
    assert (frames[0].rgb == plain.rgb).all() and not frames[0].moves_boundaries
    assert frames[0].work["slopes"]["a"] == plain.work["pixels_a"]


def test_a_parameter_is_drawn_by_llvm_kept_in_a_file_and_found_again(tmp_path):
    """Beside other slopes: a flat bump has one by what makes it none."""
    scene = Scene(field=HeightField("hills", "a*sin(8*pi*u) + sin(6*pi*v + b)", a=0.5, b=0.1))
    start = scene.with_numbers({"a": 0.45, "b": 0.12})
    draw = partial(render, scene, 40, 30, derivatives=["ku", "a", "beta", "b"], bounds=True)
    by_llvm = draw()
    with numpy_draws():
        assert differing(held(by_llvm), held(draw())) == []
        flat = replace(scene, field=HeightField("flat", "a*sin(8*pi*u)", a=0))
        assert abs(render(flat, 8, 8, derivatives=["a"]).derivatives["a"]).max() > 0.1
        found = fit(start, render(scene, 32, 32), ["a", "b"])
    assert [found.scene.number(name) for name in "ab"] == pytest.approx([0.5, 0.1], rel=1e-9)
    by_llvm.save(tmp_path / "a.npz")
    scene.to_file(tmp_path / "a.toml")
    assert record.read(tmp_path / "a.npz")[0].scene == Scene.from_file(tmp_path / "a.toml") == scene
    assert (np.load(tmp_path / "a.npz")["derivative_a"] == by_llvm.derivatives["a"]).all()


def test_no_constant_is_further_off_than_it_says():
    """π from its 151st digit on; decimals as floats are printed; quotients of any size, from the least float64 on."""
    random, numbers = Random(47), [pi * 10**150 - int(pi.n(160) * 10**150), sqrt(2), pi**2 / 6, log(3) / log(2)]
    for bits in range(2000):
        p, q = (random.getrandbits(bits % 200) | 1 for _ in "pq")
        numbers += Rational(repr(random.random())), Rational(-p, q) * Rational(2) ** random.randint(-1070, 820)
    for number, constant in zip(numbers, eval(OwnPrinter().doprint(numbers), CALLED), strict=True):
        assert abs(number - Rational(constant)) <= Rational(getattr(constant, "error", 0))


@pytest.mark.parametrize("text", ["9329113965543663/9340691059763681", "0.9643500889615229", "(2**64 + 1)/3e-50"])
def test_a_constant_that_cancels_has_a_bound(text, monkeypatch):
    number = parse_expression(text)
    step = Piecewise((Rational(float(number)), sinpi(v / 2) >= 0), (2, True))
    field = HeightField(f"cancels_{len(text)}", (number - step) * u, seam=True)
    assert_drawn(Scene(field=field, beta=1e14), exact(), monkeypatch)


LINEAR = [
    "sinpi(2*u)*sinpi(63*v)",
    "cospi(1000003*u)*cospi(511*v - 1/4)",
    "sinpi(1000000*v + 2*u)",
    "cospi(1048576*u - 1048573*v/2 + 1/3)",
    "sinpi(u - v)",
    "cospi(1e15*k_u*u)*sinpi(k_v*v)",
]


@pytest.mark.parametrize("text", LINEAR)
def test_the_last_digits_are_kept_at_any_wave_number(text, monkeypatch):
    """Of 400 heights and slopes, to three roundings of the largest; bits and bounds are as of any field."""
    field = HeightField(f"linear_{LINEAR.index(text)}", parse_expression(text), seam=True)
    assert apart(text, field, 400, lambda true: abs(true).max(1, keepdims=True)) <= 3 * 2.0**-53
    assert_drawn(Scene(field=field, ku=KU, kv=KV), exact(), monkeypatch)


def test_a_wave_number_that_is_rounded_to_a_whole_one_is_none():
    third = HeightField("third", sinpi(3 * k_u * u))
    powers, of_rounded = (algebraic_powers(Scene(field=third, ku=ku), exact()) for ku in (4.0, 64 / 3))
    assert powers and not of_rounded


def test_the_next_process_compiles_nothing(tmp_path):
    code = f"""if True:
        import sys
        from renderer import Scene, render
        from renderer.machines import native
        if sys.argv[1] == "2":
            native.optimized = None
        record = {{"name": "kept", "expression": {DUNES!r}}}
        print(render(Scene.from_record({{"field": record}}), 8, 8).rgb.tobytes().hex())"""
    environment = os.environ | {"SYMBOLIC_RENDERING_CODE": str(tmp_path)}
    drawn = [python("-c", code, seed, env=environment | {"PYTHONHASHSEED": seed}) for seed in "12"]
    assert drawn[0] == drawn[1]


def test_the_command_line_takes_a_formula(tmp_path, capsys):
    target = tmp_path / "own.npy"
    assert main(["image", "--field-expression", "u*v", "--field-seam", "--size", "8", "--out", str(target)]) == 0
    assert shows(target, render(Scene(field=HeightField("torn_at_u_0", u * v, seam=True)), 8, 8))
    assert main(["sweep", "--field-expression", DUNES, "--size", "24", "--no-facts", "--eps", "1e-3"]) == 0
    assert re.search(r"own_\w{6}, blinn, 24 x 24", capsys.readouterr().out)
    target, again = tmp_path / "a.png", tmp_path / "again.npz"
    hills = ["--field-expression", "a*self*sin(8*pi*u)", "--field-parameter", "a=0.3", "--field-parameter", "self=2"]
    assert main(["image", "--size", "8", *hills, "--out", str(target)]) == 0
    assert main(["image", "--again", str(target), "--by", "a", "--out", str(again)]) == 0
    field = HeightField("hills", hills[1], **{"a": 0.3, "self": 2})
    slope = render(Scene(field=field), 8, 8, derivatives=("a",)).derivatives["a"]
    assert (np.load(again)["derivative_a"] == slope).all() and slope.any()
