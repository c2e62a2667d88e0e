"""The simulator as a reader meets it: sliders, boxes, keys, addresses, experiments, phone, print, no script."""

import base64
import gzip
import random
import re
from pathlib import Path

import numpy as np
import pytest
from matplotlib import colormaps
from playwright.sync_api import expect

from proofs.formulas.step_bounds import TERMS
from renderer.kernels import FIELDS
from tests.processes import python
from tests.tabs import PHONE, RUNNING, go, settled, slide, state
from tests.test_contributing import copied

CLIPBOARD = ["clipboard-read", "clipboard-write"]
# k_u u + k_v v at the pixels of A over which a crease is drawn.
WHITE = """() => {
    const { module, states, act } = Simulator.running, state = act.state(), { size, ku, kv } = state;
    const stage = module.make_stage(state, states.crop(state)), [u, v] = module.chart(stage);
    const small = new OffscreenCanvas(size, size).getContext('2d');
    small.drawImage(document.querySelector('[data-picture=numeric] .over'), 0, 0, size, size);
    const { data } = small.getImageData(0, 0, size, size);
    return [...stage.at].flatMap((i, n) => (data[4 * i + 3] > 40 ? [ku * u[n] + kv * v[n]] : []));
}"""
# The curve's title is seen whole, and its lines' names have their colours.
UNCUT = """() => { const title = document.querySelector('[data-reading]').parentElement;
    const names = [...document.querySelectorAll('.sim-curve .name')].map(name => getComputedStyle(name).fill);
    return title.scrollWidth <= title.clientWidth && title.scrollHeight <= title.clientHeight + 2
        && names.length > 1 && new Set(names).size === names.length }"""
SIGNS = {"eps": "ε", "beta": "β"}
EDITS = ["", *"&=%-e1ε. #", "9" * 9, "NaN", "\0", "%zz", "__proto__"]


@pytest.fixture(scope="module")
def shared(visit_once):
    return visit_once("s4", until=RUNNING, reduced_motion="reduce", permissions=CLIPBOARD)


@pytest.fixture
def tab(shared):
    """The page in its first state."""
    shared.click("[data-reset]")
    return shared


def type_into(tab, name, text):
    """Type into a box; return what is said of it."""
    box = tab.locator(f"[data-parameter={name}] input[type=text]")
    box.fill(text)
    box.press("Tab")
    return tab.locator(f"#sim-{name}-error").inner_text()


def readout(tab, name):
    return float(tab.inner_text(f"[data-readout={name}]").replace("−", "-"))


def test_it_runs_and_asks_for_nothing_else(visit):
    tab = visit("s4", "file", until=RUNNING)
    for eps in (-2, -8, -14):
        slide(tab, "eps", eps)
    tab.wait_for_function("document.querySelector('[data-readout=flips]').textContent === '0'")


def test_sliders_boxes_and_menus_set_the_state(tab):
    slide(tab, "eps", -6)
    slide(tab, "beta", 1.25)
    assert type_into(tab, "ku", "7.5") == ""
    tab.select_option("#sim-method", "central4")
    tab.check("input[value=rings]")
    tab.uncheck("[data-parameter=ball] input")
    tab.uncheck("[data-index='1']")
    now = state(tab)
    assert (now["eps"], now["beta"], now["ku"], now["method"], now["field"]) == (1e-6, 1.25, 7.5, "central4", "rings")
    assert now["ball"] == 0 and now["lights"] == [True, False]
    assert tab.get_attribute("#sim-eps", "aria-valuetext") == "1e-6"


@pytest.mark.parametrize(
    "text", ["", "NaN", "0", "-1", "Infinity", "1e-19", "0.2", "0x1", "1e", "ε", "1/0", "1/2/3", "2^2^2", "10^"]
)
def test_a_box_says_what_it_refuses_and_changes_nothing(tab, text):
    before = state(tab)
    assert "ε = " in (said := type_into(tab, "eps", text))
    assert "is not allowed: a number from 1e-18 to 0.1" in said
    assert state(tab) == before
    assert tab.get_attribute("[data-parameter=eps] input[type=text]", "aria-invalid") == "true"
    assert type_into(tab, "eps", "1e-5") == ""
    assert state(tab)["eps"] == 1e-5


PRINTED = {"1.21e−2": 1.21e-2, "10⁻⁸": 1e-8, "3 · 10⁻⁴": 3e-4, "2^-20": 2**-20, "10^-18": 1e-18, "2⁻⁵³": 2**-53}
PRINTED |= {"1/16": 1 / 16, " 5 × 10^-3 ": 5e-3, "1/2^30": 2**-30}


@pytest.mark.parametrize("text, eps", PRINTED.items())
def test_what_the_page_prints_may_be_typed(tab, text, eps):
    assert type_into(tab, "eps", text) == ""
    assert state(tab)["eps"] == eps


def test_a_decimal_comma_is_refused_in_words(tab):
    assert "write the decimal comma as a point" in type_into(tab, "eps", "0,01")


def test_keys_move_the_cursor_and_zoom(tab):
    frame = tab.locator("[data-picture=symbolic]")
    frame.focus()
    before = state(tab)
    for key in ("ArrowRight", "Shift+ArrowDown", "ArrowUp"):
        frame.press(key)
    now = state(tab)
    assert (now["column"], now["row"]) == (before["column"] + 1, before["row"] + 9)
    frame.press("+")
    assert state(tab)["zoom"] == 1
    frame.press("-")
    assert state(tab)["zoom"] == 0
    slider = tab.locator("#sim-eps")
    slider.press("Home")
    assert state(tab)["eps"] == 1e-18
    slider.press("End")
    assert state(tab)["eps"] == 0.1
    slider.press("PageDown")
    assert state(tab)["eps"] < 0.1


def test_hover_shows_the_pixel_and_a_click_holds_it(tab):
    frame = tab.locator("[data-picture=numeric]")
    assert hovered(tab, frame, 60, 90)
    tab.wait_for_function("document.querySelector('.sim-facts dd').textContent === '60, 90'")
    frame.click(position=inside(frame, 60.5, 90.5))
    assert not hovered(tab, frame, 10, 11, tries=2)
    assert (state(tab)["column"], state(tab)["row"]) == (60, 90)
    frame.click(position=inside(frame, 61.5, 92.5), button="right")  # is none of the page's
    assert not hovered(tab, frame, 10, 11, tries=2)
    frame.click(position=inside(frame, 20.5, 30.5))  # lets go again
    assert hovered(tab, frame, 40, 50)


def inside(frame, column, row):
    """Return where a pixel of the raster is, in an element that shows 256 x 256 of them."""
    scale = frame.bounding_box()["width"] / 256
    return {"x": column * scale, "y": row * scale}


def hovered(tab, frame, column, row, tries=20):
    """Point at a pixel, again while the page still scrolls; return whether the cursor has followed."""
    for attempt in range(tries):
        frame.hover(position=inside(frame, column + (0.25 if attempt % 2 else 0.75), row + 0.5))
        tab.wait_for_timeout(50)
        if (state(tab)["column"], state(tab)["row"]) == (column, row):
            return True
    return False


def test_the_address_holds_the_whole_state(tab, server):
    slide(tab, "beta", 0.7)
    tab.check("input[value=sine]")
    tab.click("[data-zoom='1']")
    tab.wait_for_function("location.hash === Simulator.running.states.fragment(Simulator.running.act.state())")
    wanted, address = state(tab), tab.url
    tab.click("[data-reset]")
    tab.wait_for_function("address => location.href !== address", arg=address)
    tab.evaluate("address => { location.href = address }", address)
    tab.wait_for_function("beta => Simulator.running.act.state().beta === beta", arg=0.7)
    assert state(tab) == wanted


@pytest.mark.parametrize("wrong", ["eps=0", "eps=NaN", "ku=1e9", "field=cosine", "nothing=1", "beta", "beta=1&beta=1",
                                   "size=100", "lights=2", "left=1", "column=999"])  # fmt: skip
def test_a_malformed_address_is_refused_with_a_message(tab, wrong):
    before = state(tab)
    go(tab, f"#sim?{wrong}")
    tab.wait_for_selector(".sim-message:visible")
    name = wrong.split("=")[0]
    assert re.search(f"{name}|{SIGNS.get(name, name)}", tab.inner_text(".sim-message"))
    assert state(tab) == before


def fuzz(rng, seeds):
    """Return a text made from one of the seeds by a few random edits."""
    text = list(rng.choice(seeds))
    for _ in range(rng.randrange(6)):
        at = rng.randrange(len(text) + 1)
        text[at : at + rng.randrange(3)] = rng.choice(EDITS)
    return "".join(text)


def test_fuzzed_addresses_and_boxes_leave_a_valid_state(tab):
    rng = random.Random("fuzz")
    seeds = ["#s4", "#sim?eps=1e-3", "#sim?zoom=8&left=100&top=100", "#sim?lights=10&ball=0", "#sim?constructor=1"]
    seeds.append(tab.evaluate("Simulator.running.states.fragment(Simulator.running.act.state())"))
    addresses = [fuzz(rng, seeds).replace("size=256", f"size={rng.choice([128, 256])}") for _ in range(1000)]
    numbers, boxes = ["0.001", "-1e-3", "8", "1e400", ""], ["eps", "beta", "ku", "kv"]
    texts = [(rng.choice(boxes), fuzz(rng, numbers)) for _ in range(1000)]
    script = """([addresses, texts]) => {
        const { act, states } = Simulator.running, found = [];
        const check = what => {
            try { states.changed(act.state(), {}) } catch (error) { found.push(`${what}: ${error}`) }
        };
        for (const address of addresses) {
            history.replaceState(null, '', '#' + encodeURI(address.slice(1)).replaceAll('%25', '%'));
            dispatchEvent(new HashChangeEvent('hashchange'));
            check(address);
        }
        for (const [name, text] of texts) {
            const box = document.querySelector(`[data-parameter=${name}] input[type=text]`);
            box.value = text;
            box.dispatchEvent(new Event('change'));
            check(name + ' ' + text);
        }
        return found;
    }"""
    assert tab.evaluate(script, [addresses, texts]) == []


def at_step(tab, field, eps, method="central"):
    """Return (max, rms) on A once the pictures of a state are there."""
    go(tab, f"#sim?field={field}&eps={eps:g}&method={method}")
    tab.wait_for_function(
        "([eps, field]) => { const s = Simulator.running.act.state(); return s.eps === eps && s.field === field }",
        arg=[eps, field],
    )
    settled(tab)
    return readout(tab, "max"), readout(tab, "rms")


def test_first_experiment_the_slope_the_floor_and_the_cliff(tab):
    """Sine: two decades a decade down to about 1e-6, then one decade a decade up."""
    rms = {n: at_step(tab, "sine", float(f"1e-{n}"))[1] for n in (2, 3, 4, 6, 8, 10, 12, 16)}
    assert 80 < rms[2] / rms[3] < 125 and 80 < rms[3] / rms[4] < 125
    assert rms[6] == min(rms.values())
    assert 3 < (rms[12] / rms[8]) ** 0.25 < 30
    assert rms[16] > 0.01


def test_second_experiment_the_creases_do_not_fade(tab):
    """Ridges: the largest difference hardly falls, the RMS like √ε, and both fall where no pixel straddles."""
    (most_2, rms_2), (most_4, rms_4) = at_step(tab, "ridges", 1e-2), at_step(tab, "ridges", 1e-4)
    assert most_4 > 0.5 * most_2 and most_4 > 0.3
    assert 5 < rms_2 / rms_4 < 20
    assert at_step(tab, "ridges", 1e-6)[0] < 1e-9


def test_third_experiment_leads_to_the_pole(tab):
    tab.click("#sim-pole")
    now = state(tab)
    assert (now["field"], now["zoom"]) == ("rings", 10)
    tab.wait_for_function(
        """[...document.querySelectorAll('.sim-facts div')].some(
            fact => fact.children[0].textContent === 'v' && Number(fact.children[1].textContent) < 1e-3)"""
    )


def test_fourth_experiment_makes_the_pictures_one(tab):
    tab.click("#sim-flat")
    settled(tab)
    assert state(tab)["beta"] == 0
    assert readout(tab, "max") == 0 and readout(tab, "rms") == 0


def test_an_experiment_moves_unless_motion_is_unwanted(visit):
    page = visit("s4", until=RUNNING, reduced_motion="no-preference")
    page.click("#sim-sweep")
    page.wait_for_function("Simulator.running.act.state().eps < 0.05")
    page.keyboard.press("Tab")
    slide(page, "beta", 0.5)  # the reader's hand ends it
    assert not page.evaluate("Simulator.running.presets.running()")


def test_flips_are_counted_and_the_bound_holds(tab):
    settled(tab)  # until then the read-outs are the last state's
    expect(tab.locator("[data-readout=flips]")).to_have_text("0")
    assert re.match(r"10,954 \(37 %\), 11,092 \(37 %\)", tab.inner_text("[data-readout=attached]"))


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


def test_the_curve_sets_the_step_by_click_drag_and_key(tab):
    curve = tab.locator(".sim-curve input")
    curve.scroll_into_view_if_needed()
    box = curve.bounding_box()
    tab.mouse.move(box["x"] + box["width"] / 2, box["y"] + 50)
    assert "ε = " in tab.inner_text("[data-reading]") and "gradient here" in tab.inner_text("[data-reading]")
    before = state(tab)["eps"]
    tab.mouse.down()
    middle = state(tab)["eps"]
    assert middle != before and 1e-10 < middle < 1e-9
    tab.mouse.move(box["x"] + box["width"] / 4, box["y"] + 50)
    tab.mouse.up()
    assert state(tab)["eps"] < 1e-3 * middle
    curve.press("End")
    assert state(tab)["eps"] == 0.1
    curve.press("ArrowLeft")
    assert state(tab)["eps"] == 0.075
    assert re.match("ε = 7.5e−2 · .*gradient here", curve.get_attribute("aria-valuetext"))


def test_no_name_lies_on_a_curve_or_on_another(tab):
    tab.wait_for_function("document.querySelectorAll('.sim-curve path:not(.least, .grid)').length === 3")
    script = """() => {
        const edges = selector => [...document.querySelectorAll(selector)].map(e => e.getBoundingClientRect());
        const names = edges('.sim-curve .name');
        const right = Math.max(...edges('.sim-curve path').map(e => e.right));
        const tops = names.map(e => e.top).sort((a, b) => a - b);
        return [names.length, names.every(e => e.left >= right), tops.slice(1).every((top, n) => top >= tops[n] + 12)];
    }"""
    assert tab.evaluate(script) == [3, True, True]


def test_a_field_or_a_method_without_a_theorem_has_no_bound(tab):
    tab.wait_for_selector(".sim-curve path.bound", state="attached")
    tab.select_option("#sim-method", "forward")
    tab.wait_for_selector(".sim-curve path.bound", state="detached")
    tab.select_option("#sim-view", "terms")
    tab.wait_for_function("document.querySelector('.sim-remark').textContent.startsWith('No theorem')")


def test_the_leading_term_is_named_and_shown(tab):
    """A large step is led by truncation, a small one by a rounded argument; on a crease by the crease."""
    leading = tab.locator(".sim-facts div", has_text="error led by").locator("dd")
    tab.select_option("#sim-view", "terms")
    for exponent, term in ((-3, TERMS[0]), (-9, TERMS[1]), (-1, TERMS[3])):
        slide(tab, "eps", exponent)
        expect(leading).to_have_text(term)
    assert tab.locator(".sim-legend").is_visible()


def test_far_numbers_are_not_counted_in_floats(tab):
    slide(tab, "eps", -14)
    tab.wait_for_function("document.querySelector('.sim-pixel tbody').textContent.includes('—')")
    assert tab.locator(".sim-far").is_visible()
    type_into(tab, "beta", "0")
    expect(tab.locator(".sim-pixel tbody tr:last-child td").last).to_have_text("0 ulp")


def test_the_scale_keeps_its_bar(tab):
    for scale, last in (("1e4", "10⁻⁴"), ("log", "1")):
        tab.select_option("#sim-scale", scale)
        tab.wait_for_function(f"document.querySelector('.sim-bar p').lastChild.textContent === '{last}'")
        assert tab.locator(".sim-bar").is_visible()


PHONES = {False: {}, True: {"device_scale_factor": 2, "has_touch": True}}


@pytest.mark.parametrize("width, height, side", [(1440, 900, 512), (1024, 768, 256), (400, 850, 360)])
def test_pictures_step_curve_and_pixel_are_seen_together(visit, width, height, side):
    """In one screen; on a phone a picture and the step, also while an experiment runs and the page is scrolled."""
    seen = ["[data-picture=difference]", "#sim-eps"]
    if width > 1000:
        seen += ["[data-picture=numeric]", ".sim-curve", "#sim-beta", ".sim-presets", "[data-parameter=field]"]
        seen += [".sim-strip", ".sim-bar", ".sim-pixel tbody tr:last-child"]
    script = """seen => seen.map(selector => {
        const { top, bottom, left, right } = document.querySelector(selector).getBoundingClientRect();
        return [top, bottom, left, right]; })"""
    page = visit("s4", until=RUNNING, viewport={"width": width, "height": height}, **PHONES[width < 1000])
    page.evaluate("document.getElementById('simulator').scrollIntoView()")
    settled(page)
    page.wait_for_selector(".sim-curve path.numeric", state="attached")

    def all_seen():
        edges = page.evaluate(script, seen)
        return all(
            top >= 40 and bottom <= height and left >= 0 and right <= width for top, bottom, left, right in edges
        )

    assert all_seen(), page.evaluate(script, seen)
    assert page.evaluate("document.querySelector('[data-picture=numeric]').clientWidth") >= side
    if width > 1000:
        assert page.evaluate(UNCUT)
        go(page, "#sim?view=bounds")
        page.wait_for_selector("#certified td:has-text('e')")
        seen += ["#certified", "[data-readout=max]"]
        assert all_seen(), page.evaluate(script, seen)
        page.click("[data-apart]")
        page.evaluate("document.getElementById('simulator').scrollIntoView()")
        assert all_seen(), page.evaluate(script, seen)
        assert page.evaluate(UNCUT)
    if width < 1000:
        page.click("#sim-sweep")
        before = page.evaluate("scrollY")
        page.mouse.wheel(0, 300)
        page.wait_for_function("before => scrollY > before", arg=before)
        assert all_seen(), page.evaluate(script, seen)


def test_the_wiper_is_dragged_and_moved_by_keys(tab):
    tab.evaluate("document.getElementById('simulator').scrollIntoView()")
    knob, pair = tab.locator(".sim-pair .wiper-knob"), tab.locator(".sim-pair").bounding_box()
    tab.mouse.move(pair["x"] + pair["width"] / 2, knob.bounding_box()["y"] + knob.bounding_box()["height"] - 30)
    tab.mouse.down()
    tab.mouse.move(pair["x"] + pair["width"] / 4, 5)  # captured, wherever the pointer is
    tab.mouse.up()
    assert knob.get_attribute("aria-valuenow") == "25"
    for key, now in (("ArrowRight", "26"), ("Shift+ArrowLeft", "16"), ("Home", "0"), ("End", "100")):
        knob.press(key)
        assert knob.get_attribute("aria-valuenow") == now
    cut = "getComputedStyle(document.querySelector('[data-picture=symbolic]')).clipPath"
    assert tab.evaluate(cut) == "inset(0px 0px 0px 100%)"
    tab.click("[data-apart]")
    assert tab.evaluate(cut) == "none" and tab.get_attribute("[data-apart]", "aria-pressed") == "true"
    tab.click("[data-apart]")


def test_an_experiment_pauses_steps_and_stops(visit):
    page = visit("s4", until=RUNNING, reduced_motion="no-preference")
    begun, share = page.inner_text(".sim-says"), "Number(document.querySelector('#sim-share').value)"
    page.click("#sim-sweep")
    page.wait_for_function(f"{share} > 0.01")
    page.keyboard.press("Escape")
    assert not page.locator(".sim-play").is_visible()
    page.click("#sim-sweep")
    page.locator(".sim-curve input").focus()
    page.keyboard.press("Space")
    paused = page.evaluate(share)
    page.wait_for_timeout(200)
    assert page.evaluate(share) == paused and page.locator(".sim-play").is_visible()
    page.click("[data-step='1']")
    assert page.evaluate(share) == pytest.approx(paused + 0.05, abs=0.006)
    page.evaluate("""() => { const bar = document.querySelector('#sim-share'); bar.value = 1;
        bar.dispatchEvent(new Event('input', { bubbles: true })) }""")
    assert state(page)["eps"] == 1e-18
    page.click("[data-reset]")
    assert page.inner_text(".sim-says") == begun and not page.locator(".sim-play").is_visible()


def test_back_undoes_a_step(tab):
    for exponent in (-5, -7):
        slide(tab, "eps", exponent)
        tab.wait_for_function(f"location.hash.includes('eps=' + 1e{exponent})")
    tab.go_back()
    tab.wait_for_function("Simulator.running.act.state().eps === 1e-5")


def test_an_address_keeps_its_point_and_its_middle(tab):
    """A place is a share of the raster: the same point at any size, and the same middle at any zoom."""
    share = "(() => { const { act, states } = Simulator.running, s = act.state(), side = states.side(s);"
    point = f"{share} return [(s.column + 0.5) / side, (s.row + 0.5) / side] }})()"
    middle = f"{share} return [(s.left + s.size / 2) / side, (s.top + s.size / 2) / side] }})()"
    before = tab.evaluate(point)
    go(tab, "#sim?size=512")
    tab.wait_for_function("Simulator.running.act.state().size === 512")
    assert tab.evaluate(point) == pytest.approx(before, abs=1 / 256)
    go(tab, "#sim?zoom=16")
    tab.wait_for_function("Simulator.running.act.state().zoom === 16")
    assert tab.evaluate(middle) == pytest.approx([0.5, 0.5], abs=1e-5)
    go(tab, "#sim?size=128&column=0.25&row=0.75")
    tab.wait_for_function("Simulator.running.act.state().size === 128")
    assert (state(tab)["column"], state(tab)["row"]) == (32, 96)


def test_a_crease_is_as_bright_in_fewer_pixels_and_shown_by_a_key(tab):
    """Where the screen has fewer pixels than the raster, each is the brightest of those that it stands for."""
    tab.select_option("#sim-size", "1024")
    slide(tab, "eps", -6)
    settled(tab)
    script = """() => { const { pictures } = Simulator.running;
        const seen = document.querySelector('[data-picture=difference] .pixels'), rows = canvas => {
            const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
            return [canvas.width, ...[...data].filter((_, n) => n % 4 < 3)] };
        return [pictures.canvas('difference'), seen].map(rows) }"""
    inferno = colormaps["inferno"](range(256), bytes=True)[:, :3].tolist()
    level = {(0, 0, 0): 0} | {tuple(colour): n for n, colour in enumerate(inferno, start=1)}  # black is 0 itself
    whole, seen = (
        np.array([level[colour] for colour in zip(rest[::3], rest[1::3], rest[2::3], strict=True)]).reshape(wide, wide)
        for wide, *rest in tab.evaluate(script)
    )
    assert len(seen) < len(whole) == 1024
    cells = np.arange(1024) * len(seen) // 1024
    largest = np.zeros_like(seen)
    np.maximum.at(largest, (cells[:, None], cells[None, :]), whole)
    np.testing.assert_array_equal(seen, largest)
    assert (largest != whole[:: 1024 // len(seen), :: 1024 // len(seen)][: len(seen), : len(seen)]).any()
    tab.keyboard.down("c")
    assert len(tab.evaluate(WHITE)) > 500
    tab.keyboard.up("c")
    assert not tab.locator("[data-picture=numeric] .over").is_visible()


def test_two_fingers_magnify_and_one_moves_the_part_that_is_shown(visit):
    page = visit("s4", until=RUNNING, **PHONE)
    frame = page.locator("[data-picture=difference]")
    frame.scroll_into_view_if_needed()
    box = frame.bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    send = page.context.new_cdp_session(page).send

    def touch(kind, *points):
        send(
            "Input.dispatchTouchEvent",
            {"type": kind, "touchPoints": [{"x": x + dx, "y": y + dy, "id": n} for n, (dx, dy) in enumerate(points)]},
        )

    touch("touchStart", (-20, 0), (20, 0))
    for apart in (30, 50, 80):
        touch("touchMove", (-apart, 0), (apart, 0))
    touch("touchEnd")
    page.wait_for_function("Simulator.running.act.state().zoom === 4")
    left = state(page)["left"]
    touch("touchStart", (0, 0))
    for dx in (20, 60, 100):
        touch("touchMove", (dx, 0))
    touch("touchEnd")
    page.wait_for_function("left => Simulator.running.act.state().left < left - 30", arg=left)


def test_pictures_and_curve_are_saved_and_the_line_copied(tab):
    for name in ("numeric", "symbolic", "difference"):
        with tab.expect_download() as download:
            tab.click(f"[data-save={name}]")
        assert Path(download.value.path()).read_bytes()[:8] == b"\x89PNG\r\n\x1a\n"
    with tab.expect_download() as download:
        tab.click("[data-csv]")
    lines = Path(download.value.path()).read_text().splitlines()
    assert lines[0] == "step,gradient_error_at_cursor,bound,rms_on_a,max_on_a" and len(lines) > 100
    for button, wanted in (("[data-copy]", tab.inner_text(".sim-python code")), ("[data-link]", None)):
        tab.evaluate("document.querySelector('.sim-copied').textContent = ''")
        tab.click(button)
        tab.wait_for_function("document.querySelector('.sim-copied').textContent === 'copied'")
        assert tab.evaluate("navigator.clipboard.readText()") == (wanted or tab.url)
    assert "#sim?field=ridges" in tab.url


@pytest.mark.parametrize("ratio", [1, 1.5, 2])
def test_every_size_shows_whole_pixels(visit, ratio):
    """A pixel of the raster is a whole number of the screen's, or the other way round, unless a third stayed empty."""
    tab = visit("s4", until=RUNNING, device_scale_factor=ratio)
    for size in (128, 256, 512):
        tab.select_option("#sim-size", str(size))
        settled(tab)
        width = tab.evaluate("document.querySelector('[data-picture=numeric] .pixels').getBoundingClientRect().width")
        width = round(ratio * width, 3)  # in the screen's pixels
        whole = max(width, size) % min(width, size) == 0
        assert width == int(width) and (whole or (ratio == 1.5 and size < 2 / 3 * width < 2 * size))


def test_phone_has_large_targets(visit):
    page = visit("s4", until=RUNNING, device_scale_factor=2, **PHONE)
    page.tap("#sim-sweep")  # its bar, too
    small = page.evaluate(
        """[...document.querySelectorAll('#simulator :is(button, select, input:is([type=range], [type=text]))')]
        .filter(e => e.offsetHeight < 44).map(e => e.outerHTML)"""
    )
    assert small == []
    page.locator("[data-picture=difference]").tap()


@pytest.mark.parametrize("medium, script", [("screen", False), ("print", True)])
def test_paper_and_scriptless_readers_get_the_figures(visit, medium, script):
    page = visit("s4", until=RUNNING, java_script_enabled=script)
    page.emulate_media(media=medium)
    assert page.locator(".sim-absent").is_visible() is not script
    assert not page.locator("#simulator").is_visible()
    assert page.locator("img[src*=contact_sheet]").first.is_visible()


@pytest.mark.parametrize(
    "missing, words",
    [
        ("window.Worker = function () { throw new Error('no workers here') }", "no workers here"),
        ("WebAssembly.validate = () => false", "no WebAssembly with vectors"),
    ],
)
def test_a_browser_without_workers_or_vectors_is_told(visit, missing, words):
    page = visit("s4", prepare=missing)
    page.wait_for_selector(".sim-message:visible")
    assert words in page.inner_text(".sim-message")
    assert not page.locator(".sim-pictures").is_visible()


def test_a_hidden_page_has_no_worker(tab):
    """What visibilitychange does: the workers end when the page is hidden and come back with it."""
    hide = """hidden => { Object.defineProperty(document, 'hidden', { value: hidden, configurable: true });
        document.dispatchEvent(new Event('visibilitychange')) }"""
    settled(tab)
    tab.evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")  # then it is counted
    tab.evaluate(hide, True)
    before = tab.evaluate("Simulator.running.frames.length")
    slide(tab, "beta", 1.9)
    tab.wait_for_timeout(300)
    assert tab.evaluate("Simulator.running.frames.length") == before
    tab.evaluate(hide, False)
    settled(tab)
    tab.wait_for_function("before => Simulator.running.frames.length > before", arg=before)
    assert len(tab.context.pages[0].workers) >= 1


@pytest.fixture(scope="module")
def with_two_fields(tmp_path_factory):
    """The compiled scripts with two more HEIGHT_FIELDS: no theorem covers them, and one has slanted creases."""
    folder = tmp_path_factory.mktemp("fields")
    copied(folder)
    entries = """
    HeightField("doubled", 2 * sinpi(k_u * u)),
    HeightField("slanted", Abs(sinpi(k_u * u + k_v * v))),
))  # fmt: skip
"""
    place = folder / "proofs" / "formulas" / "height_fields.py"
    place.write_text(place.read_text(encoding="utf-8").replace("\n))  # fmt: skip\n", entries, 1), encoding="utf-8")
    python("-m", "renderer.generate", cwd=folder)
    scripts = {"compiled.js": "simulator_module", "compiled_closer.js": "loupe_module"}
    printing = "from book.{} import source; print(source())"
    return {f"**/{script}": python("-c", printing.format(name), cwd=folder)[0] for script, name in scripts.items()}


@pytest.mark.parametrize("field, creases", [("doubled", []), ("slanted", [(8, 4, level) for level in range(13)])])
def test_an_added_field_has_no_false_bound_and_its_own_creases(visit, with_two_fields, field, creases):
    """No bound is printed, drawn or attributed; white lines lie where the crease factor is zero, and nowhere else."""
    fragment = f"#sim?field={field}&view=loci&column=120&row=100"
    page = visit("s4", fragment=fragment, until=RUNNING, given=with_two_fields)
    settled(page)
    page.wait_for_selector(".sim-curve path.numeric", state="attached")
    offered = page.evaluate("[...document.querySelectorAll('[name=sim-field]')].map(button => button.value)")
    assert sorted(offered) == sorted([*FIELDS, "doubled", "slanted"])
    assert page.locator(f"[name=sim-field][value={field}]").is_checked()
    assert page.locator(".sim-curve path.bound").count() == 0
    assert "no theorem covers this" in page.inner_text(".sim-facts")
    page.locator("#loupe").scroll_into_view_if_needed()
    expect(page.locator(".sim-bits tbody")).to_contain_text("no theorem covers this")  # once its scripts are there
    assert ("has no creases" in page.inner_text(".sim-remark")) is (not creases)
    lines = page.evaluate("Simulator.running.module.crease_lines(Simulator.running.act.state())")
    assert [(line["a"], line["b"], line["level"]) for line in lines] == creases
    white = page.evaluate(WHITE)
    assert (len(white) > 500) is bool(creases)
    assert sum(abs(w - round(w)) < 0.1 for w in white) >= 0.95 * len(white)  # by the pole a pixel is wider than that


def test_the_code_is_light(site):
    """What the page loads for the simulator, compressed as a server would: at most 75 kB, the module at most 80 kB.

    What it loads for the loupe, when that is in sight: at most 45 kB, the module at most 160 kB.
    """
    parts = {path.name: path.read_bytes() for path in sorted((site / "_static" / "simulator").iterdir())}
    later = [parts.pop(name) for name in ("compiled_closer.js", "loupe.js", "certified.js")]
    assert len(gzip.compress(b"".join(parts.values()))) <= 75_000 and len(gzip.compress(b"".join(later))) <= 45_000
    for script, most in ((parts["compiled.js"], 80_000), (later[0], 160_000)):
        program = re.search(rb'program = "(.*)"', script)[1]
        assert 10_000 < len(gzip.decompress(base64.b64decode(program))) <= most
