"""The simulator's numbers: every bit against the renderer, the hovered pixel against the line that is copied."""

import base64
import io
import json
import math
import random
from dataclasses import asdict

import numpy as np
import pytest
from numpy.testing import assert_array_equal
from PIL import Image, ImageColor

from book.simulator_module import TERM_COLOURS
from renderer import Light, Scene, central, render
from renderer.generate.step_terms import BOUNDS
from renderer.kernels import FIELDS, LIGHT_MODELS
from renderer.picture.differences import distance_on_a
from renderer.picture.views import difference_linear, difference_logarithmic, image_view, kink_view, slope_view
from renderer.scene.methods import DIFFERENCES, GradientMethod
from renderer.scene.scene import DEFAULT_LIGHTS
from tests.tabs import go, number, readout

EXACT = {"name": "exact"}
WHOLE = 256, (0, 0, 256, 256)  # a raster's side, and its part: left, top, width, height
BASE = {"ku": 8, "kv": 4, "beta": 0.35, "ball": True, "lights": [True, True], "model": "blinn", "field": "ridges"}
OFTEN = {
    "field": [*FIELDS],
    "eps": [0.1, 1e-3, 1e-6, 1e-7, 2.5e-9, 1e-16, 1e-17, 1e-18],
    "beta": [0, 0.35, 1.7, 2],
    "ku": [8, 7, -4, 7.3],
    "kv": [4, 3, 0, -3.1],
    "model": [*LIGHT_MODELS],
    "method": [*DIFFERENCES],
    "size": [128, 256, 512],
    "zoom": [0, 0, 3, 10],
}
"""What random states are made of: odd and fractional wave numbers among them."""
# The last one of some pictures, all on one stage.
RENDER = """async ([steps, [side, [left, top, wide, high]]]) => {
    const { module } = Simulator.running, raster = { width: side, height: side, left, top, wide, high };
    const stage = module.make_stage(steps[0][0], raster);
    let planes = [];
    for (const [state, method] of steps) planes = module.render(state, method, stage);
    const address = await new Promise(done => {
        const reader = new FileReader();
        reader.onload = () => done(reader.result);
        reader.readAsDataURL(new Blob([...planes, stage.codes]));
    });
    return address.slice(address.indexOf(',') + 1);
}"""
# For each of several states the line of Python, and what the page knows of the pixel by both pipelines.
PIXELS = """wanted => wanted.map(given => {
    const { states, module, cursor } = Simulator.running, state = states.within({ ...states.start(), ...given });
    cursor.show(states.changed(state, {}));
    const methods = Object.values(module.methods_of(state));
    return [states.python(state), methods.map(method => module.pixel(state, method, states.crop(state)))];
})"""


@pytest.fixture(scope="module")
def tab(visit_once):
    return visit_once("s4")


def drawn(tab, *steps, raster=WHOLE):
    """Return the bytes of a picture's colours and chambers as the page's pipeline draws them.

    steps: pairs of a state and a method, which are drawn one after another on one stage; the last one is the picture.
    """
    return base64.b64decode(tab.evaluate(RENDER, [steps, raster]))


def rendered(state, method, raster=WHOLE):
    """Return the same of the renderer."""
    side, crop = raster
    lights = tuple(a if on else Light(a.position, None) for a, on in zip(DEFAULT_LIGHTS, state["lights"], strict=True))
    given = {name: state[name] for name in ("field", "ku", "kv", "beta", "model")}
    scene = Scene(**given, ball=bool(state["ball"]), lights=lights)
    frame = render(scene, side, side, GradientMethod(**method), crop)
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
    state |= {corner: rng.randrange(4000) for corner in ("left", "top")}
    return state | {place: rng.randrange(4000 if state["zoom"] else 128) for place in ("column", "row")}


def random_crop(rng):
    """Return up to 24 x 24 pixels of a raster: of sphere A, sphere B, the floor, or of two of them."""
    side = rng.choice([128, 257, 4096])
    return side, (*(int(rng.uniform(0.15, 0.8) * side) for _ in "xy"), rng.randint(1, 24), rng.randint(1, 24))


def test_two_hundred_random_states_are_the_renderers_to_the_last_bit(tab):
    """Every field, method, model of light and combination of lights, whole wave numbers and others, odd crops.

    Some are followed by steps of ε and β, which read what was kept, and by what nothing may be kept for.
    """
    rng, surfaces = random.Random("states"), set()
    for turn in range(200):
        state, other, crop = random_state(rng), random_state(rng), random_crop(rng)
        more = {name: other[name] for name in OFTEN if rng.random() < 0.3}
        steps = [rng.choice([(state, EXACT), way(state)])]
        if turn % 5 == 0:
            steps += [way(state | change) for change in ({"eps": 1e-5}, {"eps": 1e-13, "beta": 1.5}, more)]
        for count, step in enumerate(steps, start=1):
            wanted = rendered(*step, crop)
            assert drawn(tab, *steps[:count], raster=crop) == wanted
        surfaces |= {code & 3 for code in wanted[-crop[1][2] * crop[1][3] :]}
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
        assert_array_equal(painted(tab, "numeric"), image_view(numeric))
        assert_array_equal(painted(tab, "symbolic"), image_view(symbolic))
        assert_array_equal(painted(tab, "difference"), difference_linear(apart, 100))
        assert [readout(tab, name) for name in ("max", "rms")] == pytest.approx([end.value for end in ends], rel=5e-3)
        paint(tab, wanted.replace("1e2", "log"))
        assert_array_equal(painted(tab, "difference"), difference_logarithmic(apart))


def test_the_views_are_the_renderers(tab):
    """At a large step: the leading term is truncation, or a crease within ε; nothing else, and black off A."""
    frame = render(Scene(), 256, 256, central(0.01))
    u, v = (frame.data_on_a[name] for name in ("u", "v"))
    leading = BOUNDS["ridges"](u, v, 8.0, 4.0, 0.01)[1].astype(int)
    colours, terms = np.array([*map(ImageColor.getrgb, TERM_COLOURS)], np.uint8), np.zeros((256, 256, 3), np.uint8)
    terms[frame.stage.on_a] = colours[leading]
    expected = {"slope": slope_view(frame, math.pi * 8), "terms": terms, "kink": kink_view(frame)}
    expected["straddle"] = np.where(frame.straddling[..., None], np.uint8(255), image_view(frame) // 3)
    for flags in (frame.kink, frame.straddling):
        assert 0 < flags.sum() < 20_000
    for view, picture in expected.items():
        paint(tab, f"#sim?field=ridges&eps=0.01&scale=log&model=blinn&size=256&view={view}")
        assert_array_equal(painted(tab, "numeric"), picture, view)
    assert set(leading) == {1, 4}


def printed(line):
    """Return the records that a line of Python prints, as JSON has them."""
    records = []
    exec(line, {"print": lambda *said, sep: records.extend(map(asdict, said))})
    return json.loads(json.dumps(records))


def shared(records, others):
    """Return records without what others do not have."""
    return [{name: record[name] for name in other} for record, other in zip(records, others, strict=True)]


def test_the_copied_line_prints_the_numbers_shown(tab):
    """And the wrong pixel would be seen."""
    rng, surfaces = random.Random("lines"), []
    for line, found in tab.evaluate(PIXELS, [random_state(rng) for _ in range(50)]):
        assert shared(printed(line), found) == found, line
        surfaces.append(found[0]["surface"])
    assert surfaces.count("A") >= 10
    state = BASE | {"ball": 1, "method": "central", "eps": 1e-3, "column": 100, "row": 80}
    ((line, found),) = tab.evaluate(PIXELS, [state])
    assert shared(printed(line.replace("100, 80", "101, 80")), found) != found
    one, other = printed(line)
    rows = [[*map(number, row.split()[1:3])] for row in tab.locator(".sim-pixel tbody tr").all_inner_texts()]
    assert rows == [
        [*pair] for part in ("gradient", "normal", "rgb") for pair in zip(one[part], other[part], strict=True)
    ]
