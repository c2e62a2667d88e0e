"""The simulator's numbers: every bit against the renderer, the hovered pixel against the line that is copied."""

import base64
import io
import math
import random
from dataclasses import asdict

import numpy as np
import pytest
from PIL import Image, ImageColor

from book.simulator_module import TERM_COLOURS
from renderer import Light, Scene, central, central4, exact, forward, render
from renderer.generate.step_terms import BOUNDS
from renderer.kernels import FIELDS, LIGHT_MODELS
from renderer.picture.differences import distance_on_a
from renderer.picture.views import difference_linear, difference_logarithmic, image_view, slope_view
from renderer.scene.scene import DEFAULT_LIGHTS
from tests.tabs import RUNNING, go, readout

METHODS = {"central": central, "forward": forward, "central4": central4}
EXACT = {"name": "exact"}
WHOLE = {"width": 256, "height": 256, "left": 0, "top": 0, "wide": 256, "high": 256}
BASE = {"ku": 8, "kv": 4, "beta": 0.35, "ball": True, "lights": [True, True], "model": "blinn", "field": "ridges"}
OFTEN = {
    "field": [*FIELDS],
    "eps": [0.1, 1e-3, 1e-6, 1e-7, 2.5e-9, 1e-16, 1e-17, 1e-18],
    "beta": [0, 0.35, 1.7, 2],
    "ku": [8, 7, -4, 7.3],
    "kv": [4, 3, 0, -3.1],
    "model": [*LIGHT_MODELS],
    "method": [*METHODS],
    "size": [128, 256, 512],
    "zoom": [0, 0, 3, 10],
}
"""What random states are made of: odd and fractional wave numbers among them."""
# The last one of some pictures, all on one stage.
RENDER = """async ([steps, raster]) => {
    const { module } = Simulator.running, stage = module.make_stage(steps[0][0], raster);
    let planes = [];
    for (const [state, method] of steps) planes = module.render(state, method, stage);
    const address = await new Promise(done => {
        const reader = new FileReader();
        reader.onload = () => done(reader.result);
        reader.readAsDataURL(new Blob([...planes, stage.codes]));
    });
    return address.slice(address.indexOf(',') + 1);
}"""
# What the panel shows for each of several states: the text of every cell, and the line of Python.
SHOWN = """wanted => wanted.map(state => {
    const { states, cursor } = Simulator.running;
    cursor.show(states.changed(states.within({ ...states.start(), ...state }), {}));
    const text = e => e.textContent, root = document.getElementById('simulator');
    return {
        facts: Object.fromEntries([...root.querySelectorAll('.sim-facts div')].map(d => [...d.children].map(text))),
        table: Object.fromEntries([...root.querySelectorAll('.sim-pixel tbody tr')].map(r => {
            const [name, ...cells] = [...r.children].map(text);
            return [name, cells];
        })),
        line: text(root.querySelector('.sim-python code')),
    };
})"""


@pytest.fixture(scope="module")
def tab(visit_once):
    return visit_once("s4", until=RUNNING)


def drawn(tab, *steps, raster=WHOLE):
    """Return the bytes of a picture's colours and chambers as the page's pipeline draws them.

    steps: pairs of a state and a method, which are drawn one after another on one stage; the last one is the picture.
    """
    return base64.b64decode(tab.evaluate(RENDER, [steps, raster]))


def rendered(state, method, raster=WHOLE):
    """Return the same of the renderer."""
    gradient = METHODS[method["name"]](method["eps"]) if "eps" in method else exact()
    crop = tuple(raster[name] for name in ("left", "top", "wide", "high"))
    lights = tuple(a if on else Light(a.position, None) for a, on in zip(DEFAULT_LIGHTS, state["lights"], strict=True))
    scene = Scene(**{name: state[name] for name in ("field", "ku", "kv", "beta", "model", "ball")}, lights=lights)
    frame = render(scene, raster["width"], raster["height"], gradient, crop=crop)
    return np.moveaxis(frame.rgb, -1, 0).tobytes() + frame.chambers.tobytes()


def way(state):
    """Return a state with the method that it names."""
    return state, {"name": state["method"], "eps": state["eps"]}


@pytest.mark.parametrize("model", LIGHT_MODELS)
@pytest.mark.parametrize("field", FIELDS)
def test_pictures_are_the_renderers_to_the_last_bit(tab, field, model):
    state = BASE | {"field": field, "model": model}
    steps = [{"name": "central", "eps": eps} for eps in (1e-1, 1e-3, 1e-6, 1e-12, 1e-16, 1e-17, 1e-18)]
    for method in (EXACT, *steps):
        assert drawn(tab, (state, method)) == rendered(state, method)


def test_the_comparison_sees_the_next_float(tab):
    state = BASE | {"method": "central"}
    step, next_step = (way(state | {"eps": eps}) for eps in (1e-3, math.nextafter(1e-3, 1)))
    assert drawn(tab, next_step) != rendered(*step)


def random_state(rng):
    """Return a state of the page, cursor included; some off sphere A, zoomed."""
    state = {name: rng.choice(values) for name, values in OFTEN.items()}
    state |= {"ball": int(rng.random() < 0.8), "lights": [rng.random() < 0.8 for _ in DEFAULT_LIGHTS]}
    zoomed = state["zoom"] > 0
    state |= {corner: zoomed * rng.randrange(4000) for corner in ("left", "top")}
    return state | {place: rng.randrange(4000 if zoomed else 128) for place in ("column", "row")}


def random_crop(rng):
    """Return up to 24 x 24 pixels of a raster: of sphere A, sphere B, the floor, or of two of them."""
    side, wide, high = rng.choice([64, 257, 4096]), rng.randint(1, 24), rng.randint(1, 24)
    left, top = (min(int(rng.uniform(0.15, 0.85) * side), side - size) for size in (wide, high))
    return {"width": side, "height": side, "left": left, "top": top, "wide": wide, "high": high}


def test_two_hundred_random_states_are_the_renderers_to_the_last_bit(tab):
    """Every field, method, model of light and combination of lights, whole wave numbers and others, odd crops.

    Some are followed by steps of ε and β, which read what was kept, and by what nothing may be kept for.
    """
    rng, surfaces = random.Random("states"), set()
    for number in range(200):
        state, other, crop = random_state(rng), random_state(rng), random_crop(rng)
        more = {name: other[name] for name in OFTEN if rng.random() < 0.3}
        steps = [rng.choice([(state, EXACT), way(state)])]
        if number % 5 == 0:
            changes = ({"eps": 1e-2}, {"eps": 1e-5}, {"eps": 1e-13, "beta": 1.5}, more)
            steps += [way(state | change) for change in changes]
        for count, step in enumerate(steps, start=1):
            wanted = rendered(*step, crop)
            assert drawn(tab, *steps[:count], raster=crop) == wanted
        surfaces |= {code & 3 for code in wanted[-crop["wide"] * crop["high"] :]}
    assert surfaces == {1, 2, 3}


def painted(tab, name):
    """Return the bytes of a canvas, (size, size, 3)."""
    script = "name => Simulator.running.pictures.canvas(name).toDataURL()"
    image = Image.open(io.BytesIO(base64.b64decode(tab.evaluate(script, name).split(",")[1])))
    return np.asarray(image.convert("RGB"))


def paint(tab, wanted):
    """Wait until the pictures of an address are in the canvases."""
    go(tab, wanted)
    tab.wait_for_function(
        """wanted => { const r = Simulator.running.shown();
        return r && wanted.slice(5).split('&').every(part => r.slice(5).split('&').includes(part)) }""",
        arg=wanted,
    )


@pytest.mark.parametrize("size", [256, 512, 128])
def test_the_page_and_its_workers_paint_the_renderers_pictures(tab, size):
    """By the page at 256², through workers, bands and canvases at 512²: the same bytes as the renderer's own views."""
    scene = Scene(field="sine", model="phong")
    symbolic = render(scene, size, size)
    for eps in (0.01, 0.03):
        numeric = render(scene, size, size, central(eps))
        apart, ends = numeric.rgb - symbolic.rgb, distance_on_a(numeric, symbolic)
        wanted = f"#sim?field=sine&eps={eps}&scale=1e2&model=phong&size={size}"
        paint(tab, wanted)
        np.testing.assert_array_equal(painted(tab, "numeric"), image_view(numeric))
        np.testing.assert_array_equal(painted(tab, "symbolic"), image_view(symbolic))
        np.testing.assert_array_equal(painted(tab, "difference"), difference_linear(apart, 100))
        assert [readout(tab, name) for name in ("max", "rms")] == pytest.approx([end.value for end in ends], rel=5e-3)
        paint(tab, wanted.replace("1e2", "log"))
        np.testing.assert_array_equal(painted(tab, "difference"), difference_logarithmic(apart))


def test_the_views_are_the_renderers(tab):
    """At a large step: the leading term is truncation, or a crease within ε; nothing else, and black off A."""
    frame = render(Scene(), 256, 256, central(0.01))
    u, v = (frame.surface_data[name][frame.stage.on_a] for name in ("u", "v"))
    leading = BOUNDS["ridges"](u, v, 8.0, 4.0, 0.01)[1].astype(int)
    colours, terms = np.array([*map(ImageColor.getrgb, TERM_COLOURS)], np.uint8), np.zeros((256, 256, 3), np.uint8)
    terms[frame.stage.on_a] = colours[leading]
    expected = {"slope": slope_view(frame, math.pi * 8), "terms": terms}
    for view, flags in (("kink", frame.kink), ("straddle", frame.straddling)):
        expected[view] = np.where(flags[..., None], np.uint8(255), image_view(frame) // 3)
        assert 0 < flags.sum() < 20_000
    for view, picture in expected.items():
        paint(tab, f"#sim?field=ridges&eps=0.01&scale=log&model=blinn&size=256&view={view}")
        np.testing.assert_array_equal(painted(tab, "numeric"), picture, view)
    assert set(leading) == {1, 4}


PARTS = {"gradient": ("hu", "hv"), "normal": ("N′x", "N′y", "N′z"), "rgb": ("red", "green", "blue")}


def said_of(line, state):
    """Return {fact: text}, {fact: number} and {row: (numeric, symbolic)} that the panel has to show, by its Python."""
    records = []
    exec(line, {"print": lambda *printed, sep: records.extend(map(asdict, printed))})
    one = records[0]
    words = {"pixel": f"{one['column']}, {one['row']}", "surface": one["surface"]}
    facts = dict(zip(("Px", "Py", "Pz"), one["point"] or (), strict=False))
    if one["u"] is not None:
        facts |= {name: one[name] for name in "uvh"} | {"θ": one["theta"], "φ": one["phi"]}
        flags = {"kink flag": one["kink"], "straddles a crease": one["straddling"]}
        words |= {name: "yes" if flag else "no" for name, flag in flags.items()}
        if state["method"] == "central":
            at = (np.float64((one | state)[name]) for name in ("u", "v", "ku", "kv", "eps"))
            _, _, *bounds = BOUNDS[state["field"]](*at)
            facts |= {f"|Δh{axis}| ≤": float(f"{bound:.2e}") for axis, bound in zip("uv", bounds, strict=True)}
    rows = {}
    for part, names in PARTS.items():
        if one[part]:
            rows |= zip(names, map(list, zip(*(record[part] for record in records), strict=True)), strict=True)
    return words, facts, rows


@np.errstate(all="ignore")
def test_the_copied_line_prints_the_numbers_shown(tab):
    rng, on_a = random.Random("lines"), 0
    states = [random_state(rng) for _ in range(50)]
    for state, shown in zip(states, tab.evaluate(SHOWN, states), strict=True):
        words, facts, rows = said_of(shown["line"], state)
        on_a += "u" in facts
        assert shown["facts"] | words == shown["facts"], shown["line"]
        assert {name: float(shown["facts"][name]) for name in facts} == facts, shown["line"]
        assert {name: [*map(float, cells[:2])] for name, cells in shown["table"].items()} == rows, shown["line"]
    assert on_a >= 10


def test_the_wrong_pixel_would_be_seen(tab):
    state = BASE | {"ball": 1, "method": "central", "eps": 1e-3, "column": 100, "row": 80}
    (shown,) = tab.evaluate(SHOWN, [state])
    *_, rows = said_of(shown["line"].replace("100, 80", "101, 80"), state)
    assert float(shown["table"]["red"][0]) != rows["red"][0]
