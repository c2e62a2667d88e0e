"""The simulator's numbers: every bit against the renderer, the hovered pixel against the line that is copied."""

import base64
import io
import math
import random

import numpy as np
import pytest
from PIL import Image

from book.simulator_module import TERM_COLOURS
from renderer import Light, Scene, central, central4, exact, forward, pixel, render
from renderer.generate.step_terms import BOUNDS
from renderer.kernels import FIELDS, LIGHT_MODELS
from renderer.picture.pixel_record import LightRecord, PixelRecord
from renderer.picture.views import difference_linear, difference_logarithmic, image_view, slope_view
from renderer.scene.scene import DEFAULT_LIGHTS
from tests.tabs import RUNNING, go

METHODS = {"central": central, "forward": forward, "central4": central4}
WHOLE = {"width": 256, "height": 256, "left": 0, "top": 0, "wide": 256, "high": 256}
BASE = {"ku": 8, "kv": 4, "beta": 0.35, "ball": True, "lights": [True, True], "model": "blinn", "field": "ridges"}
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


def drawn(tab, state, method, raster=WHOLE, before=()):
    """Return (colours (3, high, wide) as bit patterns, chambers) as the page's pipeline draws them.

    before: the (state, method) pairs that the stage was drawn with.
    """
    data = base64.b64decode(tab.evaluate(RENDER, [[*before, (state, method)], raster]))
    shape = raster["high"], raster["wide"]
    bits = np.frombuffer(data, np.int64, 3 * shape[0] * shape[1]).reshape(3, *shape)
    return bits, np.frombuffer(data, np.uint8, offset=bits.nbytes).reshape(shape)


def rendered(state, method, raster=WHOLE):
    """Return the same of the renderer."""
    gradient = METHODS[method["name"]](method["eps"]) if "eps" in method else exact()
    crop = tuple(raster[name] for name in ("left", "top", "wide", "high"))
    lights = tuple(a if on else Light(a.position, None) for a, on in zip(DEFAULT_LIGHTS, state["lights"], strict=True))
    scene = Scene(**{name: state[name] for name in ("field", "ku", "kv", "beta", "model", "ball")}, lights=lights)
    frame = render(scene, raster["width"], raster["height"], gradient, crop=crop)
    return np.ascontiguousarray(np.moveaxis(frame.rgb, -1, 0)).view(np.int64), frame.chambers


def assert_same_bits(tab, *what, **more):
    for ours, theirs in zip(drawn(tab, *what, **more), rendered(*what), strict=True):
        np.testing.assert_array_equal(ours, theirs)


@pytest.mark.parametrize("model", LIGHT_MODELS)
@pytest.mark.parametrize("field", FIELDS)
def test_pictures_are_the_renderers_to_the_last_bit(tab, field, model):
    state = BASE | {"field": field, "model": model}
    for eps in (None, 1e-1, 1e-3, 1e-6, 1e-12, 1e-16, 1e-17, 1e-18):
        assert_same_bits(tab, state, {"name": "central", "eps": eps} if eps else {"name": "exact"})


def random_crop(rng):
    """Return up to 24 x 24 pixels of a raster: of sphere A, sphere B, the floor, or of two of them."""
    side, wide, high = rng.choice([64, 257, 4096]), rng.randint(1, 24), rng.randint(1, 24)
    left, top = (min(int(rng.uniform(0.15, 0.85) * side), side - size) for size in (wide, high))
    return {"width": side, "height": side, "left": left, "top": top, "wide": wide, "high": high}


def test_two_hundred_random_states_are_the_renderers_to_the_last_bit(tab):
    """Every field, method, model of light and combination of lights, whole wave numbers and others, odd crops."""
    rng, surfaces = random.Random("states"), set()
    for _ in range(200):
        state = random_state(rng)
        method = rng.choice([{"name": "exact"}, {"name": state["method"], "eps": state["eps"]}])
        crop = random_crop(rng)
        assert_same_bits(tab, state, method, crop)
        surfaces |= set(np.unique(rendered(state, method, crop)[1] & 3))
    assert surfaces == {1, 2, 3}


def step(state, eps, **changes):
    return state | changes, {"name": state["method"], "eps": eps}


def test_a_step_that_reads_what_was_kept_is_the_renderers_to_the_last_bit(tab):
    """Steps of ε and β, one after another; then of what nothing may be kept for: field, model, waves, method."""
    rng = random.Random("steps")
    for _ in range(40):
        state, crop = random_state(rng), random_crop(rng)
        more = {
            name: value
            for name, value in random_state(rng).items()
            if rng.random() < 0.3 and name not in ("lights", "ball")
        }
        steps = [step(state, 1e-2), step(state, 1e-5), step(state, 1e-13, beta=1.5), step(state | more, state["eps"])]
        for number in range(1, len(steps)):
            assert_same_bits(tab, *steps[number], crop, before=steps[:number])


def test_the_comparison_sees_the_next_float(tab):
    step, next_step = ({"name": "central", "eps": eps} for eps in (1e-3, float(np.nextafter(1e-3, 1))))
    assert not np.array_equal(drawn(tab, BASE, next_step)[0], rendered(BASE, step)[0])


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
        wanted = f"#sim?field=sine&eps={eps}&scale=1e2&model=phong&size={size}"
        paint(tab, wanted)
        np.testing.assert_array_equal(painted(tab, "numeric"), image_view(numeric))
        np.testing.assert_array_equal(painted(tab, "symbolic"), image_view(symbolic))
        np.testing.assert_array_equal(painted(tab, "difference"), difference_linear(numeric.rgb - symbolic.rgb, 100))
        paint(tab, wanted.replace("1e2", "log"))
        np.testing.assert_array_equal(painted(tab, "difference"), difference_logarithmic(numeric.rgb - symbolic.rgb))


@pytest.mark.parametrize("view", ["slope", "kink", "straddle"])
def test_the_views_are_the_renderers(tab, view):
    paint(tab, f"#sim?field=ridges&eps=0.01&scale=log&model=blinn&size=256&view={view}")
    frame = render(Scene(), 256, 256, central(0.01))
    white = {"kink": frame.kink, "straddle": frame.straddling}.get(view)
    if view == "slope":
        expected = slope_view(frame, math.pi * 8)
    else:
        expected = np.where(white[..., None], np.uint8(255), image_view(frame) // 3)
        assert 0 < white.sum() < 20_000
    np.testing.assert_array_equal(painted(tab, "numeric"), expected)


def test_the_leading_terms_are_shown_in_their_colours(tab):
    """Over A, at a large step: truncation, or a crease within ε; nothing else, and black off A."""
    paint(tab, "#sim?field=ridges&eps=0.01&scale=log&model=blinn&size=256&view=terms")
    frame, shown = render(Scene(), 256, 256, central(0.01)), painted(tab, "numeric")
    u, v = (frame.surface_data[name][frame.stage.on_a] for name in ("u", "v"))
    leading = BOUNDS["ridges"](u, v, 8.0, 4.0, 0.01)[1].astype(int)
    colours = np.array([[int(c[n : n + 2], 16) for n in (1, 3, 5)] for c in TERM_COLOURS], np.uint8)
    np.testing.assert_array_equal(shown[frame.stage.on_a], colours[leading])
    assert not shown[~frame.stage.on_a].any() and set(leading) == {1, 4}


def test_the_linear_scale_is_black_where_the_page_says():
    scene = Scene(field="sine")
    symbolic = render(scene, 256, 256)

    def lit(eps):
        return difference_linear(render(scene, 256, 256, central(eps)).rgb - symbolic.rgb, 100).any()

    assert lit(1e-3) and lit(1e-12)
    assert not any(lit(eps) for eps in (3e-4, 1e-5, 1e-6, 1e-8, 1e-10, 1e-11))


def random_state(rng):
    """Return a state of the page, cursor included; some off sphere A, zoomed, with odd and fractional wave numbers."""
    zoom = rng.choice([0, 0, 3, 10])
    return {
        "field": rng.choice(list(FIELDS)),
        "eps": rng.choice([0.1, 1e-3, 1e-6, 1e-7, 2.5e-9, 1e-16, 1e-17, 1e-18]),
        "beta": rng.choice([0, 0.35, 1.7, 2]),
        "ku": rng.choice([8, 7, -4, 7.3]),
        "kv": rng.choice([4, 3, 0, -3.1]),
        "model": rng.choice(list(LIGHT_MODELS)),
        "method": rng.choice(list(METHODS)),
        "ball": int(rng.random() < 0.8),
        "lights": [rng.random() < 0.8, rng.random() < 0.8],
        "size": rng.choice([128, 256, 512]),
        "zoom": zoom,
        "left": rng.randrange(4000) if zoom else 0,
        "top": rng.randrange(4000) if zoom else 0,
        "column": rng.randrange(4000) if zoom else rng.randrange(128),
        "row": rng.randrange(4000) if zoom else rng.randrange(128),
    }


def expected_texts(numeric, symbolic):
    """Return ({fact: number}, {row: (numeric, symbolic)}) that the panel has to show for two records."""
    facts = dict(zip(("Px", "Py", "Pz"), numeric.point or (), strict=False))
    table = {}
    if numeric.u is not None:
        facts |= {"u": numeric.u, "v": numeric.v, "h": numeric.h, "θ": numeric.theta, "φ": numeric.phi}
        table |= {f"h{c}": (numeric.gradient[n], symbolic.gradient[n]) for n, c in enumerate("uv")}
    if numeric.normal:
        table |= {f"N′{axis}": (numeric.normal[n], symbolic.normal[n]) for n, axis in enumerate("xyz")}
    table |= {name: (numeric.rgb[n], symbolic.rgb[n]) for n, name in enumerate(("red", "green", "blue"))}
    return facts, table


def bounded_texts(state, record):
    """Return {fact: number} of the bounds that the panel has to show of a difference's two slopes."""
    if state["method"] != "central":
        return {}
    with np.errstate(all="ignore"):
        of_slopes = BOUNDS[state["field"]](record.u, record.v, *(np.float64(state[n]) for n in ("ku", "kv", "eps")))[2:]
    return {f"|Δh{axis}| ≤": float(f"{bound:.2e}") for axis, bound in zip("uv", of_slopes, strict=True)}


def test_the_copied_line_prints_the_numbers_shown(tab, capsys):
    rng, on_a = random.Random("lines"), 0
    names = {"PixelRecord": PixelRecord, "LightRecord": LightRecord}
    states = [random_state(rng) for _ in range(50)]
    for state, shown in zip(states, tab.evaluate(SHOWN, states), strict=True):
        exec(shown["line"], {})
        numeric, symbolic = (eval(text, names) for text in capsys.readouterr().out.splitlines())
        facts, table = expected_texts(numeric, symbolic)
        assert shown["facts"]["pixel"] == f"{numeric.column}, {numeric.row}"
        assert shown["facts"]["surface"] == numeric.surface
        assert {name: float(shown["facts"][name]) for name in facts} == facts, shown["line"]
        assert shown["table"].keys() == table.keys()
        assert {name: tuple(map(float, cells[:2])) for name, cells in shown["table"].items()} == table, shown["line"]
        if numeric.u is not None:
            on_a += 1
            assert shown["facts"]["kink flag"] == ("yes" if numeric.kink else "no")
            assert shown["facts"]["straddles a crease"] == ("yes" if numeric.straddling else "no")
            assert {n: float(shown["facts"][n]) for n in bounded_texts(state, numeric)} == bounded_texts(state, numeric)
    assert on_a >= 10


def test_the_wrong_pixel_would_be_seen(tab):
    (shown,) = tab.evaluate(SHOWN, [BASE | {"ball": 1, "column": 100, "row": 80}])
    there = pixel(Scene(), 256, 256, 101, 80).rgb
    assert [float(shown["table"][name][1]) for name in ("red", "green", "blue")] != list(there)
