"""The loupe: its bits against `float.hex` and exact fractions, its lenses and bounds against the renderer."""

import random
import re
from fractions import Fraction

import numpy as np
import pytest
from mpmath import mpf, workdps

from proofs.formulas.height_fields import HEIGHT_FIELDS, height
from renderer import Scene, central, exact, pixel, render
from renderer.kernels import FIELDS
from renderer.picture.differences import certain_digits, distance_on_a
from renderer.shader.gradients import gradient_at
from tests.tabs import PHONE, RUNNING, go, state
from tests.test_browser import violations, with_axe
from tests.test_simulator_numbers import METHODS
from verify.evaluate import Reference

SIDE = 256
# The loupe's and the certifier's own parts, on the page's data.
READY = """async () => {
    const { states, act } = Simulator.running, compiled = await compiled_program(Simulator.program);
    const parts = await closer_parts(Simulator.data, compiled), module = await simulator_module(...parts);
    const loupe = simulator_loupe(document.getElementById('simulator'), states, parts[0], module, act);
    window.closer = { parts, module, loupe };
}"""
# What the ruler shows for a state: of each row its name, exponent, runs of bits, and what is said of it.
SHOWN = """wanted => wanted.map(state => {
    closer.loupe.show({ ...Simulator.running.states.start(), ...state });
    return [...document.querySelectorAll('.sim-bits tbody tr')].map(({ cells: [name, exponent, bits] }) => ({
        name: name.textContent, exponent: exponent.textContent, note: bits.querySelector('small').textContent,
        runs: [...bits.querySelectorAll('span')].map(run => [run.className, run.textContent]),
    }));
})"""
OPEN = 0xFF739E00  # the colour of a bound that is not known
CERTAIN = "#certified td:has-text('e')"
CERTIFIED = """async state => {
    let found;
    const { states } = Simulator.running, whole = { ...states.start(), ...state };
    const task = { key: '', parts: closer.parts, state: whole, raster: states.crop(whole) };
    await simulator_certifier(all => { found = all })(task);
    return { ...found, maps: found.maps.map(map => [...map]) };
}"""


@pytest.fixture(scope="module")
def tab(visit_once):
    page = visit_once("s4", until=RUNNING)
    page.evaluate(READY)
    return page


def number_of(row):
    """Return the float that a row shows: its sign, its exponent and the 53 bits that are not lost."""
    if row["exponent"] in ("+0", "−0"):
        return float(row["exponent"].replace("−", "-"))
    sign, raised = re.fullmatch(r"([+−])2([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)", row["exponent"]).groups()
    exponent = int(raised.translate(str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")))
    bits = "".join(text for look, text in row["runs"] if look not in ("blank", "lost"))
    lost = [text for look, text in row["runs"] if look == "lost"]
    assert bits[0] == "1" and (len(bits) == 53 or lost or not bits[53:].strip("0"))
    return (-1 if sign == "−" else 1) * float(Fraction(int(bits, 2), 2 ** (len(bits) - 1)) * Fraction(2) ** exponent)


def lost_of(row):
    """Return (the fraction that a row strikes out, the place above it)."""
    runs = dict(row["runs"])
    end = 7 - sum(len(text) for look, text in row["runs"] if look != "lost") + 1
    return Fraction(int(runs["lost"], 2), 2 ** len(runs["lost"])) * Fraction(2) ** end, Fraction(2) ** end


def some_pixels(field):
    """Return pixels of A: those nearest to the seam and to a pole, from either side, and others."""
    frame = render(Scene(field=field), SIDE, SIDE)
    rows, columns = np.nonzero(frame.stage.on_a)
    u, v = (frame.surface_data[name][rows, columns] for name in "uv")
    chosen = [u.argmin(), u.argmax(), v.argmin(), v.argmax(), *np.random.default_rng(3).integers(0, len(u), 4)]
    return [(int(columns[n]), int(rows[n]), float(u[n]), float(v[n])) for n in chosen]


def stepped(at, step, eps, axis):
    """Return the argument that a difference takes, and the exact one, or None where it is clamped."""
    moved, whole = at + step * eps, Fraction(at) + step * Fraction(eps)
    if axis == "u":
        return moved - np.floor(moved), whole % 1
    return min(max(moved, 0.0), 1.0), whole if 0 <= moved <= 1 else None


STEPS = {"central": [(1, -1)], "forward": [(1, 0)], "central4": [(2, -2), (1, -1)]}


def assert_rows(rows, case, eps, counts):
    """Hold what the ruler shows of a pixel to what the kernel computes of it, and to exact fractions."""
    field, method, axis, (_, _, *here) = case
    n, at, pairs = "uv".index(axis), here["uv".index(axis)], STEPS[method]
    shown = iter(rows)
    assert [number_of(next(shown)).hex() for _ in range(2)] == [at.hex(), eps.hex()]
    arguments = {0: at}
    for step in (step for pair in pairs for step in pair if step):
        row = next(shown)
        arguments[step], whole = stepped(at, step, eps, axis)
        assert number_of(row).hex() == arguments[step].hex(), row
        if whole is None:
            assert row["note"].startswith("at the pole")
        elif whole == Fraction(arguments[step]):
            assert row["note"].startswith(("exact", "back to")) and "lost" not in dict(row["runs"])
        else:
            lost, place = lost_of(row)
            assert lost == whole % place, row
            is_up = (Fraction(arguments[step]) - whole) % 1 < Fraction(1, 2)
            assert f"rounded {'up' if is_up else 'down'}" in row["note"]
        assert ("back to" in row["note"]) == (arguments[step] == at)
        counts.update(word for word in ("pole", "seam", "back to") if word in row["note"])
    with np.errstate(all="ignore"):
        heights = {
            step: float(
                FIELDS[field]["height"](
                    *(np.float64(to) if i == n else np.float64(here[i]) for i in range(2)), 8.0, 4.0
                )
            )
            for step, to in arguments.items()
        }
    for pair in pairs:
        ends = [heights[step] for step in pair]
        both = [next(shown), next(shown)]
        assert [number_of(row).hex() for row in both] == [end.hex() for end in ends]
        assert number_of(next(shown)).hex() == (ends[0] - ends[1]).hex()
    slopes = [gradient_at(Scene(field=field), *here, way)[n].item() for way in (METHODS[method](eps), exact())]
    numeric, symbolic = next(shown), next(shown)
    assert number_of(numeric).hex() == slopes[0].hex()
    assert number_of(symbolic) == pytest.approx(slopes[1], rel=1e-13)  # of another form, without functions
    assert next(shown, None) is None


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("field", FIELDS)
def test_the_bits_are_the_kernels(tab, field, method):
    """From the largest step to where nothing of it is left, at the seam and where v is clamped."""
    counts = set()
    for place in some_pixels(field):
        for axis in "uv" if HEIGHT_FIELDS[field].depends_on_u else "v":
            steps = [0.1, 1e-3, 1.1e-8, 1e-12, 1e-16, 1e-17, 1e-18]
            if method == "forward" and axis == "v" and place[3] > 0.89:
                steps.remove(0.1)  # backward there, which is shown and not compared
            states = [{"field": field, "method": method, "eps": eps, "axis": axis} for eps in steps]
            states = [one | {"column": place[0], "row": place[1]} for one in states]
            for one, rows in zip(states, tab.evaluate(SHOWN, states), strict=True):
                assert_rows(rows, (field, method, axis, place), one["eps"], counts)
    assert counts >= {"back to"} | ({"seam"} if HEIGHT_FIELDS[field].depends_on_u else set())


def test_a_wrong_bit_would_be_seen(tab):
    """The next step, the next pixel, the other axis: none passes for what is shown."""
    (column, row, u, v), *_ = some_pixels("sine")
    (rows,) = tab.evaluate(SHOWN, [{"field": "sine", "column": column, "row": row}])
    for step, axis, here in ((np.nextafter(1e-3, 1), "u", u), (1e-3, "v", u), (1e-3, "u", np.nextafter(u, 1))):
        with pytest.raises(AssertionError):
            assert_rows(rows, ("sine", "central", axis, (column, row, float(here), v)), float(step), set())
    assert_rows(rows, ("sine", "central", "u", (column, row, u, v)), 1e-3, set())


@pytest.mark.parametrize("field", ["sine", "ridges"])
def test_noise_is_what_rounding_made(tab, field):
    """The exact heights of the exact arguments are apart by what is shown, up to the bits that are called noise."""

    def exactly(at, step, eps):
        with workdps(60):
            return mpf(at) + step * mpf(eps)

    reference, rng, shares = Reference(height(HEIGHT_FIELDS[field])), random.Random(field), []
    for column, row, u, v in some_pixels(field)[4:]:
        for eps in (1e-2, 1e-5, 1e-9, rng.uniform(1, 9) * 1e-13):
            (rows,) = tab.evaluate(SHOWN, [{"field": field, "eps": eps, "column": column, "row": row}])
            (shown,) = (one for one in rows if one["name"] == "difference")
            ends = (reference({"u": exactly(u, step, eps), "v": v, "k_u": 8.0, "k_v": 4.0})["h"] for step in (1, -1))
            off = abs(mpf(number_of(shown)) - next(ends) + next(ends))
            above = 7 - sum(len(text) for look, text in shown["runs"] if look in ("blank", "kept")) + 1
            assert "noise" in dict(shown["runs"]) and off < mpf(2) ** above
            shares.append(off / mpf(2) ** above)
    assert max(shares) > 2**-8  # no more is called noise than that


def test_the_lenses_show_the_renderers_pixels_and_move_the_cursor(visit):
    tab = visit("s4", "file", "#sim?field=sine&eps=0.01&column=100&row=90&axis=v", until=RUNNING)
    tab.locator("#loupe").scroll_into_view_if_needed()
    tab.wait_for_function("document.querySelector('[data-told]').textContent === '100, 90'")
    frame = tab.locator(".sim-lenses")
    box = frame.bounding_box()
    frame.hover(position={"x": box["width"] * 3.5 / 50, "y": box["height"] * 12.5 / 16})
    assert tab.inner_text("[data-told]") == "95, 94"
    told = [tab.locator(".sim-values output").nth(n).inner_text().split() for n in range(3)]
    colours = [pixel(Scene(field="sine"), SIDE, SIDE, 95, 94, *way).rgb for way in ([central(0.01)], [])]
    assert told[:2] == [[f"{value:.10f}" for value in rgb] for rgb in colours]
    apart = [abs(one - other) for one, other in zip(*colours, strict=True)]
    assert [float(text.replace("−", "-")) for text in told[2]] == pytest.approx(apart, rel=1e-2)
    frame.click(position={"x": box["width"] * 20.5 / 50, "y": box["height"] * 0.5 / 16})
    assert (state(tab)["column"], state(tab)["row"]) == (95, 82)
    frame.press("ArrowDown")
    assert state(tab)["row"] == 83
    tab.check("[name=sim-axis][value=u]")
    tab.wait_for_function("location.hash.includes('axis=u')")


@pytest.mark.parametrize("given", [("sine", 1e-3, "central"), ("rings", 1e-9, "central"), ("ridges", 1e-5, "central4")])
def test_what_is_certified_is_the_renderers(tab, given):
    """Hardly more: that a side which is a power of two moves no bit is lost on the page."""
    field, eps, method = given
    found = tab.evaluate(CERTIFIED, {"field": field, "eps": eps, "method": method, "size": 128})
    frames = [render(Scene(field=field), 128, 128, way, bounds=True) for way in (METHODS[method](eps), exact())]
    for frame, extremes in zip(frames, found["extremes"], strict=True):
        of_a = np.sort(frame.bounds.max(axis=2)[frame.stage.on_a])
        for ours, theirs in zip(extremes, (of_a[-1], of_a[len(of_a) // 2]), strict=True):
            assert theirs <= ours <= 1.15 * theirs
    for ours, theirs in zip((found["largest"], found["rms"]), distance_on_a(*frames), strict=True):
        assert ours[0] <= theirs.lower <= theirs.value <= theirs.upper <= ours[1]
        assert ours[1] - ours[0] <= 1.15 * (theirs.upper - theirs.lower) + 1e-9 * theirs.upper
    assert found["open"] == np.any([frame.open for frame in frames], axis=0).sum()


PRINTED = ["rms", "max"]


def test_bounds_stand_in_the_pictures_and_beside_certain_digits(tab):
    """All digits that are certain; the pictures' bounds; and none of an earlier state."""
    wanted = {"field": "sine", "eps": 0.01, "size": 128}
    go(tab, "#sim?view=bounds&" + "&".join(f"{name}={value}" for name, value in wanted.items()))
    tab.locator("#certified").scroll_into_view_if_needed()  # then it is fetched
    tab.wait_for_selector(CERTAIN)
    found = tab.evaluate(CERTIFIED, wanted)
    for name, ends in zip(PRINTED, (found["rms"], found["largest"]), strict=True):
        text = tab.inner_text(f"[data-readout={name}]").replace("−", "-")
        assert text.count("e") == 1 and float(text) == float(certain_digits(*ends, 15))
    shown = [float(text.replace("−", "-")) for text in tab.locator("#certified td").all_inner_texts() if text]
    assert shown == [float(f"{bound:.1e}") for pair in found["extremes"] for bound in pair] + [found["open"]]
    maps = """() => [...document.querySelectorAll('.sim-bounds')].map(canvas =>
        [...new Uint32Array(canvas.getContext('2d').getImageData(0, 0, 128, 128).data.buffer)])"""
    colours = [*tab.evaluate("Simulator.data.tables.inferno")[:255], OPEN]
    assert tab.evaluate(maps) == [[colours[level] for level in levels] for levels in found["maps"]]
    go(tab, "#sim?field=sine&eps=1e-14&size=128&view=bounds")
    tab.wait_for_selector(".sim-bounds", state="hidden")
    tab.wait_for_function("document.querySelector('[data-readout=rms]').textContent.startsWith('at most')")
    go(tab, "#sim?field=sine&view=image")
    for gone in ("#certified", ".sim-bounds"):
        tab.wait_for_selector(gone, state="hidden")


def test_a_single_open_pixel_is_seen_where_the_picture_is_shown_smaller(tab):
    """Bounds are reduced to the screen's pixels by their largest, as the difference is."""
    go(tab, "#sim?size=1024")
    tab.wait_for_function("Simulator.running.shown()?.includes('size=1024')")
    seen = """level => { const levels = new Uint8Array(1024 * 1024);
        levels[1024 * 333 + 501] = level;
        Simulator.running.pictures.show_bounds([levels, levels]);
        return [...document.querySelectorAll('.sim-bounds')].map(canvas => [canvas.width, ...new Uint32Array(
            canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.width).data.buffer)]); }"""
    for level, count in ((255, 1), (254, 0)):
        for side, *words in tab.evaluate(seen, level):
            assert 0 < side < 1024 and words.count(OPEN) == count
    tab.evaluate("Simulator.running.pictures.show_bounds([])")


@with_axe
@pytest.mark.parametrize("mode, options", [("light", {}), ("dark", {"color_scheme": "dark"}), ("phone", PHONE)])
def test_the_loupe_is_accessible_and_keeps_to_its_width(visit, mode, options):
    page = visit("s4", fragment="#sim?eps=1e-12&view=bounds", until=RUNNING, **options)
    page.locator("#loupe").scroll_into_view_if_needed()
    page.wait_for_selector(".sim-bits tbody tr")
    page.wait_for_selector(CERTAIN)
    assert violations(page, mode, place="#simulator") == []
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")  # the ruler scrolls in its own box
