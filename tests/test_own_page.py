"""The reader's own field in the page: what its formulas mean, what is refused, and how it is typed."""

from urllib.parse import quote

import numpy as np
import pytest
from playwright.sync_api import expect

from renderer import HeightField, Scene, central, render
from tests.tabs import go
from tests.test_machines import numpy_draws
from tests.test_own_field import AS_WRITTEN, KU, KV
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
    catch (error) { return error.message; }
}"""
EXAMPLES = "[...document.querySelectorAll('#sim-example option')].map(o => o.value).filter(Boolean)"
SIDE = 48


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
    for text in (*tab.evaluate(EXAMPLES), *READ, *(text for text in AS_WRITTEN if " if " not in text)):
        numeric, symbolic = off(tab, text)
        assert symbolic <= 1e-12 and numeric <= 1e-9, (text, numeric, symbolic)


REFUSED = (
    *("sinh(u)", "u +", "(u", "u)", "u**v", "u**65", "u**99.5", "x", "1/0", "log(v-2)", "sqrt(u-1)", "u if v else u"),
    *("max(u)", "sinpi(u, v)", "Piecewise((u, v))", "u v", "a.b", "'u'", "", "sinpi", "(" * 50 + "u" + ")" * 50),
)
READ = ("u*(1-u)", "+v", "-v**2", "2**-1*v", "1e-3*v", "Piecewise((v, v < 1/2), (1 - v, True))", "Abs(v - 2)", "pi*v/4")


@pytest.mark.parametrize("text", REFUSED)
def test_both_sides_refuse(tab, text):
    with pytest.raises(ValueError):
        HeightField("own", text)
    assert "h(u, v)" in tab.evaluate(REFUSAL, text)


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
    text = "abs(sin(8*pi*u))*v"
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
