"""The simulator's numbers: every bit against the renderer, the hovered pixel against the line that is copied."""

import base64
import json
import math
import random
import re
from dataclasses import asdict, replace
from itertools import chain

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from playwright.sync_api import expect

from book.programs.simulator_module import BY
from renderer import Light, Scene, central, render
from renderer.kernels import FIELDS, LIGHT_MODELS
from renderer.picture.differences import distance_on_a
from renderer.picture.views import (
    derivative_view,
    difference_linear,
    difference_logarithmic,
    image_view,
    kink_view,
    slope_view,
)
from renderer.scene.methods import DIFFERENCES
from renderer.scene.scene import DEFAULT_LIGHTS
from tests.pictures import pixels
from tests.tabs import go, number, readout, says
from tests.test_machines import numpy_draws

OFTEN = {
    "field": [*FIELDS],
    "eps": [0.1, 1e-3, 1e-6, 1e-7, 2.5e-9, 1e-16, 1e-17, 1e-18],
    "beta": [0, 0.35, 1.7, 2],
    "ku": [8, 7, -4, 7.3],
    "kv": [4, 3, 0, -3.1],
    "model": [*LIGHT_MODELS],
    "method": [*DIFFERENCES],
    "against": ["exact", "exact", *DIFFERENCES],
    "against_eps": [0.01, 1e-5],
    "lamp": [[5, 5, 10], [5, 5, 10], [-4, 3, 2.5]],
    "size": [128, 256, 512],
    "zoom": [0, 0, 3, 10],
}
"""Values of random states: odd and fractional wave numbers among them."""
PARTS = "gradient", "normal", "rgb"
# For each of several states the line of Python, and what the page knows and shows of the pixel by both pipelines.
PIXELS = """wanted => wanted.map(given => {
    const { states, module, cursor } = Simulator.running, state = states.within({ ...states.start(), ...given });
    cursor.show(states.changed(state, {}));
    const methods = Object.values(module.methods_of(state));
    const rows = [...document.querySelectorAll('.sim-pixel tbody tr')].map(({ cells }) => [cells[1], cells[2]]);
    const shown = rows.map(pair => pair.map(cell => cell.textContent));
    return [states.python(state), methods.map(method => module.pixel(state, method, states.crop(state))), shown];
})"""


def random_state(rng):
    """Return a state of the page, cursor included; some off sphere A, zoomed."""
    state = {name: rng.choice(values) for name, values in OFTEN.items()}
    state |= {"ball": int(rng.random() < 0.8), "lights": [rng.random() < 0.8 for _ in DEFAULT_LIGHTS]}
    state |= {corner: rng.randrange(4000) for corner in ("left", "top")}
    return state | {place: rng.randrange(4000 if state["zoom"] else 128) for place in ("column", "row")}


def painted(tab, name):
    """Return the bytes of a canvas, (size, size, 3)."""
    script = "name => Simulator.running.pictures.canvas(name).toDataURL().split(',')[1]"
    return pixels(base64.b64decode(tab.evaluate(script, name)))


def paint(tab, wanted):
    """Wait until the pictures of an address are in the canvases."""
    go(tab, wanted)
    tab.wait_for_function(
        """wanted => { const r = Simulator.running.shown();
        return r && wanted.slice(5).split('&').every(part => r.slice(5).split('&').includes(part)) }""",
        arg=wanted,
    )


@pytest.mark.parametrize("size", [256, 512])
def test_the_page_and_its_workers_paint_the_renderers_pictures(tab, size):
    """By the page at 256², through workers, bands and canvases at 512²: the same bytes as the renderer's own views."""
    scene = Scene(field="sine", model="phong")
    symbolic = render(scene, size, size)
    numeric = render(scene, size, size, central(0.03))
    apart, ends = numeric.rgb - symbolic.rgb, distance_on_a(numeric, symbolic)
    wanted = f"#sim?field=sine&eps=0.03&scale=1e2&model=phong&size={size}"
    paint(tab, wanted)
    assert_array_equal(painted(tab, "numeric"), image_view(numeric))
    assert_array_equal(painted(tab, "symbolic"), image_view(symbolic))
    assert_array_equal(painted(tab, "difference"), difference_linear(apart, 100))
    assert [readout(tab, name) for name in ("max", "rms")] == pytest.approx([end.value for end in ends], rel=5e-3)
    paint(tab, wanted.replace("1e2", "log"))
    assert_array_equal(painted(tab, "difference"), difference_logarithmic(apart))
    for bump, against in (("surface", "surface"), ("chart", "exact")):  # each is drawn anew after the other
        paint(tab, f"{wanted}&against={against}")
        assert_array_equal(painted(tab, "symbolic"), image_view(render(replace(scene, bump=bump), size, size)))


def test_the_views_are_the_renderers(tab):
    """At a large step, so that a part of A straddles a crease."""
    frame = render(Scene(), 256, 256, central(0.01))
    expected = {"slope": slope_view(frame, math.pi * 8), "kink": kink_view(frame)}
    expected["straddle"] = np.where(frame.straddling[..., None], np.uint8(255), image_view(frame) // 3)
    for flags in (frame.kink, frame.straddling):
        assert 0 < flags.sum() < 20_000
    for view, picture in expected.items():
        paint(tab, f"#sim?field=ridges&eps=0.01&scale=log&model=blinn&size=256&view={view}")
        assert_array_equal(painted(tab, "numeric"), picture, view)


# The slopes of a picture by a difference and exactly, and what is copied and known of the cursor's pixel.
SLOPES = """given => {
    const { states, module } = Simulator.running, state = { ...states.start(), ...given }, crop = states.crop(state);
    const stage = module.make_stage(state, crop), methods = Object.values(module.methods_of(state));
    const slopes = methods.map(method => module.picture_slopes(state, stage, method).map(plane => [...plane]));
    return [...slopes, states.python(state), module.pixel(state, methods[1], crop).slope]; }"""


@pytest.mark.parametrize("view", BY)
@pytest.mark.parametrize("changes", [
    {"field": "sine", "ku": 7.3, "kv": -3.1, "model": "phong"},
    {"field": "ridges", "beta": 1.2, "ku": -4, "ball": False},
])  # fmt: skip
@numpy_draws()
def test_a_slope_of_the_picture_is_the_renderers(tab, view, changes):
    """Exactly, to the last bit; by a difference, that of whole pictures, whose shadows move with the lamp."""
    name, step, scene = BY[view], 1 / 8, Scene(**changes)
    given = changes | {"view": view, "size": 128, "method": "central", "eps": step}
    *slopes, line, of_cursor = tab.evaluate(SLOPES, given)
    apart, slope = (np.transpose(planes).reshape(128, 128, 3) for planes in slopes)
    assert_array_equal(slope, render(scene, 128, 128, derivatives=(name,)).derivatives[name])
    moved = (scene.with_numbers({name: scene.number(name) + side * step}) for side in (1, -1))
    above, below = (render(each, 128, 128).rgb for each in moved)
    assert_allclose(apart, (above - below) / (2 * step), atol=1e-12)
    assert printed(line)[1]["derivatives"] == {name: of_cursor}
    assert not np.allclose(apart, slope, atol=1e-4)


@pytest.mark.parametrize("size", [256, 512])
def test_slopes_are_painted_on_one_scale(tab, size):
    """By the page, and by workers in bands: as far as all but one pixel in 200 of the page's go."""
    name = BY["by_lamp"]
    coarse, slope = (render(Scene(), side, side, derivatives=(name,)).derivatives[name] for side in (256, size))
    end = np.sort(np.abs(coarse).max(axis=2), axis=None)[int(0.995 * 256**2)]
    paint(tab, f"#sim?field=ridges&eps=0.01&scale=log&model=blinn&size={size}&view=by_lamp")
    assert_array_equal(painted(tab, "symbolic"), derivative_view(np.clip(slope, -end, end)))
    says(tab, ".sim-legend", re.compile(f"≥ {end:.2e}".replace("e-0", "e−")))


def printed(line):
    """Return the records that a line of Python prints, as JSON has them."""
    records = []
    exec(line, {"print": lambda *arguments, sep: records.extend(map(asdict, arguments))})
    return json.loads(json.dumps(records))


def shared(records, others):
    """Return records without what others do not have."""
    return [{name: record[name] for name in other} for record, other in zip(records, others, strict=True)]


def test_the_copied_line_prints_the_numbers_shown(tab, by_numpy):
    rng, surfaces = random.Random("lines"), []
    for line, records, rows in tab.evaluate(PIXELS, [random_state(rng) for _ in range(200)]):
        assert shared(printed(line), records) == records, line
        pairs = (zip(*(record.get(part, []) for record in records), strict=True) for part in PARTS)
        assert [[*map(number, row)] for row in rows] == [[*pair] for pair in chain.from_iterable(pairs)], line
        surfaces.append(records[0]["surface"])
    assert surfaces.count("A") >= 40 and {"B", "floor"} <= {*surfaces}


# The lamp that is dragged: light and shadows wherever it stands; and what plays by itself

PICTURE = """([lamp, ball, size]) => {
    const { states, module } = Simulator.running;
    const state = states.changed(states.start(), { lamp, ball, size: 128 });
    const stage = module.make_stage(state, { width: size, height: size, left: 0, top: 0, wide: size, high: size });
    return [...stage.codes, ...module.render(state, module.methods_of(state).numeric, stage).map(plane => [...plane])];
}"""
SIDE = 64
LAMP = "Simulator.running.act.state().lamp"


@pytest.mark.parametrize("ball", [1, 0])
@pytest.mark.parametrize("lamp", [[5, 5, 10], [-4, 3, 2.5], [0, 0, 30], [3, -0.5, 0.1], [-2.1, 0.5, 0.5], [-2, 2, 3]])
def test_its_light_and_shadows_are_the_renderers(tab, lamp, ball):
    *codes, red, green, blue = tab.evaluate(PICTURE, [lamp, ball, SIDE])
    scene = Scene(lights=(Light(tuple(map(float, lamp)), DEFAULT_LIGHTS[0].color), DEFAULT_LIGHTS[1]), ball=bool(ball))
    frame = render(scene, SIDE, SIDE, central(1e-3))
    assert np.array_equal(np.reshape([red, green, blue], (3, SIDE, SIDE)), np.moveaxis(frame.rgb, -1, 0))
    assert np.array_equal(np.reshape(codes, (SIDE, SIDE)), frame.chambers)


def test_it_is_dragged_and_moved_by_keys(tab):
    """It keeps its distance, its handle follows, the link and the copied line have it."""
    go(tab, "#sim?field=ridges")
    handle, before = tab.locator("[data-picture=symbolic] .sim-lamp"), tab.evaluate(LAMP)
    box = handle.bounding_box()
    tab.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    tab.mouse.down()
    tab.mouse.move(box["x"] - 60, box["y"] + 40, steps=4)
    tab.mouse.up()
    x, y, z = tab.evaluate(LAMP)
    assert x < before[0] and y < before[1]
    assert np.hypot(np.hypot(x, y), z) == pytest.approx(np.linalg.norm(before), abs=0.02)
    moved = handle.bounding_box()
    assert abs(moved["x"] + moved["width"] / 2 - (box["x"] - 60)) < 3
    tab.wait_for_function("location.hash.includes('lamp=' + Simulator.running.act.state().lamp)")
    expect(tab.locator(".sim-python code")).to_contain_text(f"Light(({x}, {y}, {z})")
    handle.focus()
    handle.press("ArrowRight")
    assert tab.evaluate(LAMP)[0] > x
    expect(handle).to_have_attribute("aria-valuetext", re.compile(r"\d+° up, at "))
    tab.locator("#sim-lamp").evaluate("box => box.closest('details').open = true")
    tab.locator("#sim-lamp").fill("1, 2, -3")
    tab.locator("#sim-lamp").press("Enter")
    expect(tab.locator("#sim-lamp-error")).to_contain_text("outside both spheres")


def test_every_slider_plays(visit):
    """Beside each slider and the lamp a button lets it run; the same button stops it."""
    tab = visit("s4", reduced_motion="no-preference")
    go(tab, "#sim?field=sine")
    for name in ("eps", "beta", "ku", "kv", "lamp"):
        read, button = f"String(Simulator.running.act.state().{name})", tab.locator(f"[data-play={name}]")
        before = tab.evaluate(read)
        button.click()
        tab.wait_for_function(f"{read} !== '{before}'")
        button.click()
        stopped = tab.evaluate(read)
        tab.wait_for_timeout(200)
        assert tab.evaluate(read) == stopped != before, name
