"""The reader's own field in the page: what its formulas mean, what is refused, and how it is typed."""

from urllib.parse import quote

import numpy as np
import pytest
from playwright.sync_api import expect
from pytest import approx

from renderer import HeightField, Scene, central, render
from tests.refusals import rejection
from tests.tabs import go
from tests.test_machines import numpy_draws
from tests.test_own_field import AS_WRITTEN, HOSTILE, KU, KV, LONG
from tests.test_simulator_numbers import paint, painted

# Both pictures of a state with a formula, and whether it has a seam.
PICTURES = """([h, ku, kv, size]) => {
    const { states, module } = Simulator.running;
    const state = states.changed(states.start(), { field: "own", h: states.read("h", h), ku, kv, size: 128 });
    const raster = { ...states.crop(state), width: size, height: size, wide: size, high: size };
    const stage = module.make_stage(state, raster);
    const methods = Object.values(module.methods_of(state));
    return [methods.map(method => module.render(state, method, stage).map(plane => [...plane])),
        module.own_of(state).has_seam];
}"""
REFUSAL = """h => {
    const { states, module } = Simulator.running;
    try { module.own_of({ ...states.start(), field: "own", h: states.read("h", h) }); return null; }
    catch (error) { return [error.message, error.text.slice(error.at, error.at + error.length)]; }
}"""
EXAMPLES = "[...document.querySelectorAll('#sim-example option')].map(o => o.value).filter(Boolean)"
SIDE = 24


def off(tab, text):
    """Return by how much the page's pictures are off the renderer's, beyond the exact one's bound and off creases."""
    planes, has_seam = tab.evaluate(PICTURES, [text, KU, KV, SIDE])
    scene = Scene(field=HeightField("own", text, seam=has_seam), ku=KU, kv=KV)
    with numpy_draws():
        frames = render(scene, SIDE, SIDE, central(1e-3)), render(scene, SIDE, SIDE, bounds=True)
    certain = ~frames[1].open & ~frames[1].kink & ~frames[0].straddling
    assert certain.mean() > 0.5
    shown = (np.transpose(colours).reshape(SIDE, SIDE, 3) for colours in planes)
    beyond = [np.abs(picture - frame.rgb) for picture, frame in zip(shown, frames, strict=True)]
    beyond[1] -= frames[1].bounds
    return [part[certain].max() for part in beyond]


def test_a_typed_field_is_the_renderers(tab):
    """The page's examples and formulas as people write them: to 1e-12 beside the bound, by a difference to 1e-9."""
    for text in (*tab.evaluate(EXAMPLES), *READ, *AS_WRITTEN):
        numeric, symbolic = off(tab, text)
        assert symbolic <= 1e-12 and numeric <= 1e-9, (text, numeric, symbolic)


REFUSED = (
    *("asinh(u)", "u +", "(u", "u)", "u**v", "u**99.5", "x", "log(v-2)", "sqrt(u-1)", "u if v else u", "u if u < v"),
    *("max()", "sinpi(u, v)", "u v", "a.b", "'u'", "sinpi", "(u < v)*v", "(u < v) & v", "u < v & v < 1", "not u < v"),
    *(
        "1/cospi(u)",
        "sqrt((u - 0.51)^2 + (v - 0.503)^2)",
        "exp(999*u)",
        "0/0",
        "1e99*u",
        "(u**40)**2",
        "Piecewise((1, u < v))",
    ),
    *("sin(8*pi*u)^32 + sin(8*pi*v)^32", "abs(v - " * 6 + "u" + ")" * 6, "smoothstep(v, v, u)", "where(u, v, 1)"),
)
MARKED = {
    **{"2u": "u", "1 + |u|": "|", "sin^2(u)": "sin", "sin(u)cos(v)": "cos", "sin(uv)": "uv", "8(u)": "(", "u = v": "="},
    **{"1 + log(v - 2)": "log", "v + tan(pi*u)": "tan", "u < v ? 1 : 2": "u", "v + u^65": "^", "√v": "√", "1,5*u": ","},
}  # fmt: skip
"""{what is refused: the part of it that the page marks}"""
INSTEAD = {"v*|u|": "abs(u) for |u|", "|v|": "abs(u) for |u|", "4 sin(u)": "4*sin(u) for 4 sin(u)"}
"""{what is refused: what both sides say to write}"""
READ = (
    *("u*(1-u)", "+v", "-v**2", "2**-1*v", "1E-3*v", "Piecewise((v, v < 1/2), (1 - v, True))", "Abs(v - 2)", "π*v/4"),
    *("v if u < 1/2 and v < 1/2 or v > 0.8 else 1 - v", "where((u < 1/2) & (v <= 1/2) | (u > 0.7), v, 1 - v)", "v²·u"),
    *("fract(8*u)", "step(0.5, v)*u", "smoothstep(0.2, 0.8, v)", "clamp(3*v, 0.5, 1.5)", "mix(u, v, sin(8*pi*u))"),
    *("min(v, max(0.2, min(0.8, u)))", "pow(v, 2.5)", "ln(1+v)", "log(2+u, 2)", "sqrt((v - 1/2)^2)", "atan2pi(v,1+u)"),
    *("1/cos(pi*u/4)", "1 if u < 1/3 else v if u < 2/3 else v^2", "sqrt(2 - u*u)", "max(u, v, 1/2)", "sin(u,)^3"),
    *("sin(4π(u + v))", "cos(2 π u)/cosh(sinh(v))", "(v + 1/2)^2.3/(1 + v)^7.6 + (1 + v)^-3*(2 - v)^-0.5"),
    " + ".join(f"{n % 7 - 3}*sin(2*pi*({n}*u + {n}*v))" for n in range(1, 21)),
)  # fmt: skip


@pytest.mark.parametrize("text", (*REFUSED, *MARKED, *HOSTILE[:-1], *LONG, *INSTEAD), ids=lambda text: text[:30])
def test_both_sides_refuse(tab, text):
    refused = rejection(HeightField, "own", text, seam=True)
    told, marked = tab.evaluate(REFUSAL, text)
    assert "h(u, v)" in told and marked == MARKED.get(text, marked)
    assert INSTEAD.get(text, "") in refused and INSTEAD.get(text, "") in told


def test_it_is_typed_and_an_error_loses_nothing(tab):
    """Drawn while it is typed; what cannot be read is said and marked, and the last good picture stays."""
    go(tab, "#sim?field=own")
    box = tab.locator("#sim-h")
    box.fill("sinpi(6*u)*v")
    tab.wait_for_function("Simulator.running.shown().includes('h=sinpi(6*u)*v&')")
    box.fill("sinpi(6*w)*v")
    box.press("Enter")
    expect(tab.locator("#sim-h-error")).to_contain_text("from w on")
    assert box.evaluate("box => [box.selectionStart, box.selectionEnd]") == [8, 9]
    assert tab.evaluate("Simulator.running.act.state().h") == "sinpi(6*u)*v"
    box.fill("sinpi(6·u)·v²")
    box.press("Enter")
    expect(tab.locator("#sim-h-error")).to_be_empty()
    assert tab.evaluate("Simulator.running.act.state().h") == "sinpi(6*u)*v**2"
    expect(tab.locator(".sim-python code")).to_contain_text("sinpi(6*u)*v**2")


def test_its_straddled_pixels_are_the_renderers(tab):
    text = "abs(sin(8*pi*u))*v + 0*abs(sin(6*pi*v))"
    frame = render(Scene(field=HeightField("own", text)), 256, 256, central(0.01))
    paint(tab, f"#sim?field=own&h={quote(text, safe='()*')}&eps=0.01&size=256&view=straddle")
    assert ((painted(tab, "numeric") == 255).all(axis=2) == frame.straddling).all() and frame.straddling.any()


def test_a_saved_picture_tells_of_field_lamp_and_method(tab):
    go(tab, "#sim?field=own&h=u*v&lamp=3,4,9&against=forward&against_eps=0.01&size=128")
    numeric, symbolic = tab.evaluate(
        "[true, false].map(is => Simulator.running.states.record(Simulator.running.act.state(), is))"
    )
    assert [(each["gradient"]["name"], each["gradient"]["eps"]) for each in (numeric, symbolic)] == [
        ("central", 1e-3),
        ("forward", 0.01),
    ]
    scene = Scene.from_record(symbolic["scene"])
    assert scene.field == HeightField("own", "u*v", seam=True) and scene.lights[0].position == (3.0, 4.0, 9.0)
    expect(tab.locator(".sim-python code")).to_contain_text("seam=True")


@pytest.mark.parametrize("field", ["own", "sine"])
def test_the_second_picture_wears_the_surfaces_bump(tab, field):
    """The picture, its slope by β and its pixel's record are the renderer's."""
    go(tab, f"#sim?field={field}&against=surface&size=128&view=by_beta")
    colours, slopes, record, pixel = tab.evaluate("""() => {
        const { act, states, module } = Simulator.running, state = act.state();
        const method = module.methods_of(state).symbolic, raster = states.crop(state);
        const stage = module.make_stage(state, raster);
        return [module.render(state, method, stage), module.picture_slopes(state, stage, method)]
            .map(planes => planes.map(plane => [...plane]))
            .concat([states.record(state, false).scene, module.pixel(state, method, raster)]);
    }""")
    scene = Scene.from_record(record)
    with numpy_draws():
        frame = render(scene, 128, 128, derivatives=["beta"])
    assert scene.bump == "surface" and pixel["normal"] == approx(list(frame.normal[pixel["row"], pixel["column"]]))
    for planes, true in ((colours, frame.rgb), (slopes, frame.derivatives["beta"])):
        assert np.transpose(planes).reshape(true.shape) == approx(true, abs=1e-11 * abs(true).max())
