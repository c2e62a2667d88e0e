"""The simulator as a reader meets it: sliders, boxes, keys, addresses, experiments, phone, print, no script."""

import re
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import expect

from proofs.formulas.step_bounds import TERMS
from renderer import Scene, central, exact, render
from renderer.files import record
from renderer.picture import views
from tests.pictures import pixels
from tests.tabs import PHONE, becomes, go, says, settled, slide, state
from tests.test_checker import FORBIDDEN

OPTIONS = {"reduced_motion": "reduce", "permissions": ["clipboard-read", "clipboard-write"]}
# The curve's title is seen whole; its lines' names have their colours, and lie on no curve and on no other name.
READABLE = """() => {
    const edges = selector => [...document.querySelectorAll(selector)].map(e => e.getBoundingClientRect());
    const title = document.querySelector('[data-reading]').parentElement, names = edges('.sim-curve .name');
    const fills = [...document.querySelectorAll('.sim-curve .name')].map(name => getComputedStyle(name).fill);
    const svg = document.querySelector('.sim-curve svg');
    const right = Math.max(...edges('.sim-curve path').map(e => e.right));
    const tops = names.map(e => e.top).sort((a, b) => a - b);
    return title.scrollWidth <= title.clientWidth && title.scrollHeight <= title.clientHeight + 2
        && names.length === 3 && new Set(fills).size === 3 && svg.viewBox.baseVal.width === svg.clientWidth
        && names.every(e => e.left >= right) && tops.slice(1).every((top, n) => top >= tops[n] + 12); }"""
# Which of the places are not seen as they are.
UNSEEN = """places => places.filter(place => {
    const { top, bottom, left, right } = document.querySelector(place).getBoundingClientRect();
    return top < 40 || bottom > innerHeight || left < 0 || right > innerWidth; })"""
# The choices that a menu cuts: the present ones, and the views of slopes.
CUT = """() => [...document.querySelectorAll('.sim-menus select')].flatMap(menu => {
    const copy = menu.cloneNode(true);
    copy.style.cssText = 'position: absolute; width: auto';
    menu.after(copy);
    const cut = [...menu.options].filter(o => o.selected || o.value.startsWith('by_')).filter(option => {
        copy.replaceChildren(option.cloneNode(true));
        return copy.offsetWidth > menu.offsetWidth; }).map(option => option.text);
    copy.remove();
    return cut; })"""
TYPED = {
    "1.21e−2": 1.21e-2, "10⁻⁸": 1e-8, "3 · 10⁻⁴": 3e-4, "2^-20": 2**-20, "1/16": 1 / 16, " 5 × 10^-3 ": 5e-3,
}  # fmt: skip
REFUSED = ["", "NaN", "0", "1e-19", "0.2", "0x1", "1/0", "2^2^2", "10^"]
MALFORMED = {
    "eps=0": "ε = 0 is", "field=cosine": "field = cosine is", "nothing=1": "nothing", "beta=1&beta=1": "beta twice",
    "lights=2": "lights = 2 is", "constructor=1": "constructor", "ku=%zz": "ku = %zz is",
}  # fmt: skip
"""{a fragment: what is said of it}"""


@pytest.fixture(scope="module")
def shared(visit_once):
    return visit_once("s4", **OPTIONS)


@pytest.fixture
def tab(shared):
    """The page in its first state, on a raster of 256²."""
    shared.click("[data-reset]")
    shared.select_option("#sim-size", "256")
    return shared


def addressed(tab):
    """Wait until the address is the state's."""
    tab.wait_for_function("location.hash === Simulator.running.states.fragment(Simulator.running.act.state())")


def type_into(tab, name, text):
    """Type into a box; return the page's remark on it."""
    box = tab.locator(f"[data-parameter={name}] input[type=text]")
    box.fill(text)
    box.press("Tab")
    return tab.text_content(f"#sim-{name}-error")


def test_controls_set_the_state_the_address_holds_it_and_a_step_is_undone(tab):
    slide(tab, "eps", -6)
    slide(tab, "beta", 1.25)
    assert type_into(tab, "ku", "7.5") == ""
    tab.select_option("#sim-method", "central4")
    tab.check("input[value=rings]")
    tab.uncheck("[data-parameter=ball] input")
    tab.uncheck("[data-index='1']")
    tab.click("[data-zoom='1']")
    wanted = {"eps": 1e-6, "beta": 1.25, "ku": 7.5, "method": "central4", "field": "rings", "ball": 0, "zoom": 1}
    before = state(tab)
    assert before | wanted | {"lights": [True, False]} == before
    assert tab.get_attribute("#sim-eps", "aria-valuetext") == "1e-6"
    addressed(tab)
    pages = tab.evaluate("history.length")
    tab.click("[data-reset]")
    addressed(tab)
    tab.click("[data-undo]")
    becomes(tab, **wanted)
    assert state(tab) == before
    tab.keyboard.press("Control+y")
    becomes(tab, field="ridges", eps=1e-3)
    tab.keyboard.press("Control+z")
    becomes(tab, **wanted)
    assert tab.evaluate("history.length") == pages  # so that the browser's Back leaves the page


def test_the_cursor_leaves_the_address_of_a_part(visit):
    tab = visit("s4", fragment="#four-experiments")
    tab.press("[data-picture=symbolic]", "ArrowDown")
    tab.wait_for_timeout(500)
    assert tab.url.endswith("#four-experiments")


def test_a_box_takes_what_the_page_prints_and_says_what_it_refuses(tab):
    for text, eps in TYPED.items():
        assert type_into(tab, "eps", text) == ""
        assert state(tab)["eps"] == eps
    before = state(tab)
    for text in REFUSED:
        assert f"ε = {text} is not allowed: a number from 1e-18 to 0.1" in type_into(tab, "eps", text)
        assert tab.get_attribute("[data-parameter=eps] input[type=text]", "aria-invalid") == "true"
    assert "write the decimal comma as a point" in type_into(tab, "eps", "0,01")
    for place in ("0,0,0", "5,5,-10", "1e9,0,0"):
        assert "outside both spheres" in type_into(tab, "lamp", place)
    assert state(tab) == before


def test_keys_move_the_cursor_the_zoom_and_the_step(tab):
    for place, key, name, value in (
        ("[data-picture=symbolic]", "ArrowRight", "column", 105),
        ("[data-picture=symbolic]", "Shift+ArrowDown", "row", 82),
        ("[data-picture=symbolic]", "ArrowUp", "row", 81),
        ("[data-picture=symbolic]", "+", "zoom", 1),
        ("[data-picture=symbolic]", "-", "zoom", 0),
        ("#sim-eps", "Home", "eps", 1e-18),
    ):
        tab.press(place, key)
        assert state(tab)[name] == value


def test_hover_shows_the_pixel_and_a_click_holds_it(tab):
    frame = "[data-picture=numeric]"
    scale = tab.locator(frame).bounding_box()["width"] / 256
    held = {"x": 60.5 * scale, "y": 90.5 * scale}
    tab.hover(frame, position=held)
    says(tab, ".sim-facts dd >> nth=0", "60, 90")
    tab.click(frame, position=held)
    tab.hover(frame, position={"x": 9, "y": 9})
    becomes(tab, column=60, row=90)


def test_a_malformed_address_is_refused_with_a_message(tab):
    before = state(tab)
    for wrong, words in MALFORMED.items():
        go(tab, f"#sim?{wrong}")
        says(tab, ".sim-message:visible", re.compile(words))
        assert state(tab) == before
        assert f"#sim?{wrong}" not in tab.url


def test_an_address_keeps_its_point_and_its_middle(tab):
    """A place is a share of the raster: the same point at any size, and the same middle at any zoom."""
    for fragment, wanted in {
        "size=512": {"size": 512, "column": 209, "row": 145},
        "zoom=16": {"zoom": 16, "left": 32640, "top": 32640},
        "size=128&column=0.25&row=0.75": {"size": 128, "column": 32, "row": 96},
    }.items():
        go(tab, f"#sim?{fragment}")
        becomes(tab, **wanted)


def test_experiments_lead_to_the_pole_and_to_one_picture(tab):
    tab.click("#sim-pole")
    becomes(tab, field="rings", zoom=10)
    says(tab, ".sim-facts div:has(dt:text-is('v')) dd", re.compile("^0.000"))
    tab.click("#sim-flat")
    becomes(tab, beta=0)
    says(tab, "[data-readout=max]", "0")
    says(tab, "[data-readout=rms]", "0")


def test_an_experiment_moves_pauses_steps_and_stops(visit):
    page, play = visit("s4", reduced_motion="no-preference"), ".sim-play"
    begun = page.inner_text(".sim-says")
    page.wait_for_function("Simulator.running.act.state().eps < 0.09")  # it opens with a sweep,
    page.hover("[data-picture=numeric]")
    page.mouse.down()  # that ends at the first touch
    page.mouse.up()
    assert not page.evaluate("Simulator.running.presets.running()")

    def share():
        return float(page.input_value("#sim-share"))

    def begin():
        page.click("#sim-sweep")
        page.wait_for_function("document.querySelector('#sim-share').value > 0.01")

    begin()
    box = page.locator("[data-parameter=eps] input[type=text]")
    box.select_text()
    box.press_sequentially("1e-12", delay=50)  # and nothing writes over it
    box.press("Enter")
    assert state(page)["eps"] == 1e-12
    begin()
    slide(page, "beta", 0.5)  # the reader's hand ends it
    assert not page.is_visible(play)
    for key, stays in (("Escape", False), ("Space", True)):  # which pauses
        begin()
        page.keyboard.press(key)
        assert page.is_visible(play) is stays and not page.evaluate("Simulator.running.presets.running()")
    paused = share()
    page.click("[data-step='1']")
    assert share() == pytest.approx(paused + 0.05, abs=0.006)
    page.press(".sim-curve input", "Space")
    page.wait_for_function("paused => document.querySelector('#sim-share').value > paused + 0.06", arg=paused)
    slide(page, "share", 1)
    assert state(page)["eps"] == 1e-18
    page.click("[data-reset]")
    assert page.inner_text(".sim-says") == begun and not page.is_visible(play)


def test_no_error_at_a_pixel_exceeds_its_bound(tab):
    """200 random pixels and wave numbers, 121 steps each; and a bound of half the size fails somewhere."""
    script = """() => {
        const { curve, states } = Simulator.running;
        let seed = 1, worst = 0, points = 0;
        const random = n => (seed = (seed * 48271) % 2147483647) % n;
        for (let i = 0; i < 200; i++) {
            const state = { ...states.start(), field: ['sine', 'ridges', 'rings'][random(3)], ku: random(33) - 16,
                kv: random(17) - 8, column: 40 + random(170), row: 20 + random(170) };
            const { numeric = [], bound } = curve.at_pixel(state, states.crop(state));
            for (const [n, { size }] of numeric.entries()) worst = Math.max(worst, size && size / bound[n].size);
            points += numeric.length;
        }
        return [worst, points];
    }"""
    worst, points = tab.evaluate(script)
    assert points > 10_000
    assert 0.5 < worst <= 1


def test_the_curve_sets_the_step_by_click_and_key_and_reads_it(tab):
    curve = ".sim-curve input"
    tab.click(curve)
    assert 1e-10 < state(tab)["eps"] < 1e-9
    tab.press(curve, "End")
    tab.press(curve, "ArrowLeft")
    assert state(tab)["eps"] == 0.075
    assert re.match("ε = 7.5e−2 · .*gradient here", tab.get_attribute(curve, "aria-valuetext"))


def test_words_beside_the_pictures_follow_the_state(tab):
    """A large step is led by truncation, a small one by a rounded argument; on a crease by the crease."""
    tab.select_option("#sim-view", "terms")
    for exponent, term in ((-3, TERMS[0]), (-9, TERMS[1]), (-1, TERMS[3])):
        slide(tab, "eps", exponent)
        says(tab, ".sim-facts div:has-text('error led by') dd", term)
    assert tab.is_visible(".sim-legend") and tab.locator(".sim-curve path.bound").count() > 0
    tab.select_option("#sim-method", "forward")
    assert tab.locator(".sim-curve path.bound").count() > 0  # theorems cover the other differences, too
    slide(tab, "eps", -14)
    says(tab, ".sim-pixel tbody tr:first-child td >> nth=-1", re.compile("e−.$"))  # not in floats
    grey, ink = (f"e => getComputedStyle(e{part}).color" for part in ("", ".parentElement"))
    digits = tab.locator(".sim-pixel tbody .same").first  # in which the two numbers agree
    assert digits.evaluate(grey) != digits.evaluate(ink)
    tab.select_option("#sim-view", "by_lamp")
    says(tab, ".sim-pixel tbody tr:last-child th", "∂ blue")
    tab.uncheck("[data-parameter=lights] input >> nth=0")
    says(tab, ".sim-remark", re.compile("is off"))
    assert "derivatives" not in tab.inner_text(".sim-python code")
    tab.check("[data-parameter=lights] input >> nth=0")
    tab.select_option("#sim-view", "by_ku")
    tab.check("[data-parameter=field] [value=own]")
    says(tab, ".sim-remark", re.compile("no exact slope by k_u"))
    tab.check("[data-parameter=field] [value=ridges]")
    tab.select_option("#sim-view", "image")
    type_into(tab, "beta", "0")
    says(tab, ".sim-pixel tbody tr:last-child td >> nth=-1", "0.0e0 · 0 ulp")
    tab.select_option("#sim-scale", "1e4")
    says(tab, ".sim-bar span >> nth=-1", "10⁻⁴")


# A worker draws, and is told to stop after the first tile; then draws, as if it had not been: whose replies come, and
# whether the picture is one that is drawn at once.
STOPPED = """async () => {
    const { states, module } = Simulator.running, state = { ...states.start(), size: 512 }, replies = [];
    const band = states.crop(state), take = simulator_worker(reply => replies.push(reply)), part = {};
    await take({ kind: 'begin', data: Simulator.data, compiled: await compiled_program(Simulator.program) });
    for (const [id, kind] of ['draw', 'stop', 'draw'].entries()) await take({ kind, id, state, band, part });
    while (!replies.length) await new Promise(done => setTimeout(done, 20));
    const stage = module.make_stage(state, band), { top, bytes } = replies[0].images.numeric;
    module.render(state, { name: state.method, eps: state.eps }, stage);
    module.paint('paint_colors', stage, 'picture', { whole: true });
    const whole = module.bytes(stage, 'picture', [0, state.size]);
    return [replies.map(({ id }) => id), top, bytes.length, whole.every((byte, n) => byte === bytes[n])]; }"""


def test_a_worker_stops_after_a_tile_and_draws_as_if_at_once(tab):
    assert tab.evaluate(STOPPED) == [[2], 0, 4 * 512**2, True]


SCREENS = [(1440, 900, 512), (1280, 720, 360), (1024, 768, 380), (820, 1180, 380), (1180, 820, 400), (1920, 1080, 700)]
SCREENS += [(2560, 1300, 640)]
TOGETHER = ["[data-picture=numeric]", "[data-picture=symbolic]", "[data-picture=difference]", "#sim-eps", "#sim-ku"]
TOGETHER += ["#sim-beta", "#sim-kv", "[data-parameter=field]", "#sim-view", "#sim-method", "#sim-scale", "#sim-size"]
TOGETHER += [".sim-zoom", ".sim-curve", ".sim-strip", ".sim-headline", ".sim-bar", ".sim-presets"]


@pytest.mark.parametrize("width, height, side", SCREENS)
def test_all_that_is_used_together_is_seen_together(visit, width, height, side):
    """On the first screen; with the certified bounds, too, where the window is not low."""
    page = visit("s4", folded=True, viewport={"width": width, "height": height})
    settled(page)
    assert page.evaluate(UNSEEN, TOGETHER) == [] == page.evaluate(CUT)
    page.wait_for_function(READABLE)
    assert page.evaluate("document.querySelector('[data-picture=numeric]').clientWidth") >= side
    says(page, ".sim-headline", re.compile(r"^max .* RMS .* flips 0 \(Theorem \d+\)$"))
    if height > 800:
        page.select_option("#sim-view", "bounds")
        page.wait_for_selector("#certified td:has-text('e')")
        assert page.evaluate(UNSEEN, [*TOGETHER, "#certified"]) == []
    page.set_viewport_size({"width": width, "height": 600})  # however low the window is, there are pictures
    page.wait_for_function("innerHeight === 600")
    assert page.evaluate("document.querySelector('[data-picture=difference]').clientWidth") >= 128


def test_a_phone_keeps_picture_and_step_in_sight_and_fingers_move_the_part_that_is_shown(visit):
    """Also while an experiment runs and the page is scrolled; and all that a finger needs is large."""
    page, parts = visit("s4", device_scale_factor=2, **PHONE), ["[data-picture=numeric]", "#sim-eps", ".sim-headline"]
    settled(page)
    assert page.evaluate(UNSEEN, parts) == []
    assert page.evaluate("document.querySelector('[data-picture=numeric]').clientWidth") >= 360
    for name in ("symbolic", "difference", "numeric"):  # one frame, with three positions
        page.check(f"[name=sim-shown][value={name}]")
        shown = page.locator("[data-picture]:visible")
        assert [box.get_attribute("data-picture") for box in shown.all()] == [name]
    page.tap("#sim-sweep")  # its bar, too
    parts.pop()
    for far, places in ((-100, parts[1:]), (400, parts)):
        page.evaluate("top => scrollBy({ top, behavior: 'instant' })", far)
        assert page.evaluate(UNSEEN, places) == []
    small = page.evaluate(
        """[...document.querySelectorAll('#simulator :is(button, select, input:is([type=range], [type=text]))')]
        .filter(e => e.checkVisibility() && e.offsetHeight < 44).map(e => e.outerHTML)"""
    )
    assert small == []
    box = page.locator("[data-picture=numeric]").bounding_box()
    middle = {axis: box[axis] + box[side] / 2 for axis, side in (("x", "width"), ("y", "height"))}
    send = page.context.new_cdp_session(page).send
    send("Input.synthesizePinchGesture", middle | {"scaleFactor": 4, "gestureSourceType": "touch"})
    assert state(page)["zoom"] in (4, 5)
    left = state(page)["left"]
    send("Input.synthesizeScrollGesture", middle | {"xDistance": 100, "gestureSourceType": "touch"})
    assert state(page)["left"] < left - 30


def test_the_wiper_is_moved_by_keys(tab):
    tab.press(".sim-pair .wiper-knob", "End")
    expect(tab.locator("[data-picture=symbolic]")).to_have_css("clip-path", "inset(0px 0px 0px 100%)")
    tab.click("[data-apart]")
    expect(tab.locator("[data-picture=symbolic]")).to_have_css("clip-path", "none")
    tab.click("[data-apart]")


def test_pictures_and_curve_are_saved_and_the_line_copied(tab, tmp_path):
    def saved(button):
        with tab.expect_download() as download:
            tab.click(button)
        return Path(download.value.path()).read_bytes()

    def copied_is(text):
        tab.wait_for_function("text => navigator.clipboard.readText().then(copied => copied === text)", arg=text)

    for name, method in (("numeric", central(1e-3)), ("symbolic", exact())):
        (path := tmp_path / "saved.png").write_bytes(png := saved(f"[data-save={name}]"))
        frame = render(Scene(), 256, 256, method)
        assert record.read(path)[0] == frame.shot
        assert np.array_equal(pixels(png), views.image_view(frame))
    assert saved("[data-save=difference]").startswith(b"\x89PNG\r\n\x1a\n")
    assert b'xmlns="http://www.w3.org/2000/svg"' in saved("[data-svg]")
    tab.click("[data-copy]")
    copied_is(tab.inner_text(".sim-python code"))
    tab.click("[data-link]")
    copied_is(tab.url)


def test_another_page_shows_the_simulator_alone(visit):
    page = visit("s4", fragment="?embed")
    shown = "nodes => nodes.filter(node => node.checkVisibility()).map(node => node.id || node.className)"
    parts = ".bd-article > section > *, .bd-sidebar, .bd-header-article, footer"
    assert page.locator(parts).evaluate_all(shown) == ["simulator"]


@pytest.mark.parametrize("ratio", [1, 1.5])
def test_every_size_shows_whole_pixels(visit, ratio):
    """A pixel of the raster is a whole number of the screen's, or the other way round, unless a fifth stayed empty."""
    tab = visit("s4", device_scale_factor=ratio)
    for size in (128, 256, 512):
        tab.select_option("#sim-size", str(size))
        settled(tab)
        width = tab.locator("[data-picture=numeric] .pixels").bounding_box()["width"]
        width = ratio * width  # in the screen's pixels
        divides = max(round(width), size) % min(round(width), size) == 0
        assert width == pytest.approx(round(width), abs=0.1)
        assert divides or (ratio == 1.5 and size < 0.8 * width < 2 * size)


@pytest.mark.parametrize("medium, script", [("screen", False), ("print", True)])
def test_paper_and_scriptless_readers_get_the_figures(visit, medium, script):
    page = visit("s4", java_script_enabled=script)
    page.emulate_media(media=medium)
    assert page.is_visible(".sim-absent") is not script and not page.is_visible("#simulator")
    assert page.locator("img[src*=sweep_of_sine]").first.is_visible()


def test_a_browser_without_vectors_is_told(visit):
    page = visit("s4", prepare="WebAssembly.validate = () => false", until=None)
    says(page, ".sim-message:visible", re.compile("no WebAssembly with vectors"))
    assert not page.is_visible(".sim-pictures")


def test_a_page_whose_workers_do_not_start_says_so_and_draws_alone(visit):
    page = visit("s4", prepare=FORBIDDEN)
    says(page, ".sim-message:visible", re.compile("forbidden"))
    page.select_option("#sim-size", "512")
    settled(page)
    says(page, "[data-readout=flips]", "0")
