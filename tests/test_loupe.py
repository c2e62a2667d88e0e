"""The loupe: its bits against `float.hex` and exact fractions, its lenses and bounds against the renderer."""

from fractions import Fraction
from functools import cache
from itertools import product
from math import copysign
from urllib.parse import urlencode

import numpy as np
import pytest

from book.programs.loupe_module import pairs_of, samples_of
from proofs.formulas.height_fields import HEIGHT_FIELDS
from renderer import Scene, central, exact, pixel, render
from renderer.intervals import certain_digits
from renderer.kernels import FIELDS
from renderer.picture.differences import distance_on_a
from renderer.scene.methods import DIFFERENCES, difference
from tests.tabs import CERTAIN, becomes, go, number, says

SIDE = 256
PIXELS = [(26, 109), (127, 108), (104, 72)]  # at the seam, by the pole, and another
# The loupe's and the certifier's own parts, on the page's data.
READY = """async () => {
    const { states, act } = Simulator.running, compiled = await compiled_program(Simulator.program);
    const parts = await closer_parts(Simulator.data, compiled), module = await simulator_module(...parts);
    const loupe = simulator_loupe(document.getElementById('simulator'), states, parts[0], module, act);
    window.closer = { parts, module, loupe };
}"""
# The ruler's rows for a state: name, exponent, runs of bits, and remark.
SHOWN = """state => {
    closer.loupe.show({ ...Simulator.running.states.start(), ...state });
    return [...document.querySelectorAll('.sim-bits tbody tr')].map(({ cells: [name, exponent, bits] }) => ({
        name: name.textContent, exponent: exponent.textContent, note: bits.querySelector('small').textContent,
        runs: [...bits.querySelectorAll('span')].map(run => [run.className, run.textContent]),
    }));
}"""
OPEN = 0xFF739E00  # the colour of a bound that is not known
CERTIFIED = """async state => {
    let found;
    const { states } = Simulator.running, whole = { ...states.start(), ...state };
    const task = { key: '', parts: closer.parts, state: whole, raster: states.crop(whole) };
    await simulator_certifier(all => { found = all })(task);
    return { ...found, maps: [] };
}"""


@pytest.fixture(scope="module")
def tab(tab):
    tab.evaluate(READY)
    return tab


def read(row):
    """Return the float that a row shows, and the exact number that it was before its lost bits were rounded away."""
    bits_left, lost = ("".join(text for look, text in row["runs"] if (look == "lost") is of) for of in (False, True))
    size, unrounded = (int(bits or "0", 2) * Fraction(2) ** (8 - len(bits)) for bits in (bits_left, bits_left + lost))
    if "rounded up" in row["note"]:
        unrounded -= Fraction(2) ** (8 - len(bits_left))
    return copysign(size, -1 if row["exponent"][0] == "−" else 1), unrounded


@cache
def printed_for(field, method, axis):
    """Return what the page has of a difference: the pairs of its samples, and what they are computed by."""
    return pairs_of(field, method, axis), samples_of(field, method)


def show(tab, column, row, **choices):
    return tab.evaluate(SHOWN, choices | {"column": column, "row": row})


def assert_rows(rows, place, field, method, axis, eps):
    """Hold what the ruler shows of a pixel to what the kernel computes, and to exact fractions."""
    n, (pairs, samples) = "uv".index(axis), printed_for(field, method, axis)
    with np.errstate(all="ignore"):
        outputs = samples(*map(np.float64, (*place, 8.0, 4.0, eps)))
    stepped = [sample for pair in pairs for sample in pair if sample["step"]]
    wanted = [place[n], eps, *(outputs[sample["at"]] for sample in stepped)]
    for one, other in pairs:
        wanted += [outputs[one["h"]], outputs[other["h"]], outputs[one["h"]] - outputs[other["h"]]]
    *shown, _ = map(read, rows)  # the last is the symbolic one
    assert [number.hex() for number, _ in shown] == [float(number).hex() for number in (*wanted, outputs[n - 6])]
    for sample, (_, exactly), row in zip(stepped, shown[2:], rows[2:], strict=False):
        moved = Fraction(place[n]) + sample["step"] * Fraction(eps)
        assert (exactly - moved) % 1 == 0 or (axis == "v" and not 0 <= moved <= 1 and "at the pole" in row["note"])


@pytest.mark.parametrize("method", DIFFERENCES)
@pytest.mark.parametrize("field", FIELDS)
def test_the_bits_are_the_kernels(tab, field, method):
    """From the largest step to where nothing of it is left, at the seam and where v is clamped."""
    for at in PIXELS:
        record = pixel(Scene(), SIDE, SIDE, *at)
        place = record.u, record.v
        for axis, eps in product("uv" if HEIGHT_FIELDS[field].depends_on_u else "v", [0.1, 1.1e-8, 1e-16, 1e-18]):
            choices = {"field": field, "method": method, "axis": axis, "eps": eps}
            assert_rows(show(tab, *at, **choices), place, **choices)


def test_the_lenses_show_the_renderers_pixels_and_move_the_cursor(visit):
    tab = visit("s4", "file", "#sim?field=sine&eps=0.01&column=100&row=90&axis=v")
    tab.locator("#loupe").scroll_into_view_if_needed()
    says(tab, "[data-told]", "100, 90")
    frame, box = ".sim-lenses", tab.locator(".sim-lenses").bounding_box()

    def at(column, row):
        return {"x": box["width"] * (column + 0.5) / 50, "y": box["height"] * (row + 0.5) / 16}

    tab.hover(frame, position=at(3, 12))
    says(tab, "[data-told]", "95, 94")
    *told, _ = ([*map(number, text.split())] for text in tab.locator(".sim-values output").all_inner_texts())
    colours = [pixel(Scene(field="sine"), SIDE, SIDE, 95, 94, way).rgb for way in (central(0.01), exact())]
    np.testing.assert_allclose(told, colours, rtol=0, atol=5.1e-11)
    tab.click(frame, position=at(20, 0))
    becomes(tab, column=95, row=82)


@pytest.mark.parametrize("field, eps, method", [("sine", 0.01, "central"), ("ridges", 1e-5, "central4")])
def test_what_is_certified_is_the_renderers_and_stands_beside_the_pictures(tab, field, eps, method):
    """With all certain digits."""
    wanted = {"field": field, "eps": eps, "method": method, "size": 128}
    certified = tab.evaluate(CERTIFIED, wanted)
    frames = [render(Scene(field=field), 128, 128, way, bounds=True) for way in (difference(method, eps), exact())]
    assert certified["open"] == np.any([frame.open for frame in frames], axis=0).sum()
    go(tab, f"#sim?view=bounds&{urlencode(wanted)}")
    tab.locator("#certified").scroll_into_view_if_needed()  # then it is fetched
    tab.wait_for_selector(CERTAIN)
    for (name, shown), of in zip({"largest": "max", "rms": "rms"}.items(), distance_on_a(*frames), strict=True):
        low, high = certified[name]
        assert low <= of.lower <= of.value <= of.upper <= high
        digits = certain_digits(low, high, 15)
        assert not digits or number(tab.inner_text(f"[data-readout={shown}]")) == float(digits)
    shown = [number(text) for text in tab.locator("#certified td").all_inner_texts() if text]
    assert shown == [float(f"{bound:.1e}") for pair in certified["extremes"] for bound in pair] + [certified["open"]]


def test_a_single_pixel_is_seen_where_the_picture_is_shown_smaller(tab):
    """A difference and bounds are reduced to the screen's pixels by their largest."""
    go(tab, "#sim?size=1024")
    tab.wait_for_function("Simulator.running.shown()?.includes('size=1024')")
    script = """([level, open, bright]) => {
        const { pictures, act } = Simulator.running, levels = new Uint8Array(1024 * 1024), band = { wide: 1024 };
        const bytes = new Uint8Array(4 * 1024 * 1024), place = 1024 * 333 + 501;
        levels[place] = level;
        bytes.set([level, 1], 4 * place);
        pictures.show_bounds([levels, levels]);
        pictures.paint({ images: { difference: { top: 0, bytes } }, band, part: { begin: 0 } }, true);
        pictures.show(act.state(), true);
        const counts = [['.sim-bounds', open], ['[data-picture=difference] .pixels', bright]].map(([of, colour]) =>
            [...document.querySelectorAll(of)].map(canvas => [canvas.width, new Uint32Array(canvas.getContext('2d')
                .getImageData(0, 0, canvas.width, canvas.width).data.buffer).filter(is => is === colour).length]));
        pictures.show_bounds([]);
        return counts.flat(); }"""
    bright = tab.evaluate("Simulator.data.tables.inferno")[255] % 2**32
    for level, count in ((255, 1), (254, 0)):
        for side, bright_pixels in tab.evaluate(script, [level, OPEN, bright]):
            assert 0 < side < 1024 and bright_pixels == count
