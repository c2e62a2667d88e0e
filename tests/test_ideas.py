"""The small interactives: their numbers are the renderer's, hand and keys move them, the still pictures stay."""

import functools
import gzip
import io
import math
import random
import re

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import expect

from book import idea_kernels
from book.figures import bump_surface
from renderer import Scene, central, exact, gradient_at, height_at, pixel, render
from renderer.machines.points_code import inputs_of
from tests.tabs import PHONE, next_frame

SCENE = Scene()
PAGES = {
    "s1": ["slope_is_texture"],
    "s2": ["scene_from_the_side", "pixel_worked"],
    "s3": ["bump_surface", "two_slopes"],
}
NUMBER = re.compile(r"[−-]?\d+(?:\.\d+)?")
# Brings into sight one figure after another that is still.
STARTED = """(() => {
    const still = document.querySelector('figure.idea:not(.idea-live)');
    still?.scrollIntoView({ behavior: 'instant' });
    return !still && document.querySelector('figure.idea') !== null;
})()"""


def numbers(text):
    """Return the numbers in a text, in their order."""
    return [float(number.replace("−", "-")) for number in NUMBER.findall(text)]


@pytest.fixture(scope="module")
def idea(visit_once):
    """Return the function that opens an idea's page once, and gives the tab and the idea's figure."""
    open_page = functools.cache(lambda page: visit_once(page, until=STARTED))

    def open_idea(name):
        tab = open_page(next(page for page, names in PAGES.items() if name in names))
        return tab, tab.locator(f"#fig-{name}")

    return open_idea


def press(tab, part, *keys):
    for key in keys:
        part.press(key)
    next_frame(tab)


def said(figure):
    return numbers(figure.locator(".idea-says").first.inner_text())


def now(part):
    return float(part.get_attribute("aria-valuenow"))


@pytest.mark.parametrize("kernel", idea_kernels.IDEAS, ids=lambda kernel: kernel.__name__)
def test_the_compiled_kernels_are_python_s_to_the_last_bit(idea, kernel):
    tab, _ = idea("slope_is_texture")
    rng, count = random.Random(kernel.__name__), len(inputs_of(kernel))
    rows = [[rng.uniform(-1, 1) for _ in range(count)] for _ in range(50)]
    ask = """async ([name, rows]) => {
        const { own } = await Ideas.module;
        return rows.map(row => [own.kernel(name, ...row)].flat());
    }"""
    compiled = np.array(tab.evaluate(ask, [kernel.__name__, rows]), float)
    with np.errstate(all="ignore"):
        np.testing.assert_array_equal(compiled, [np.atleast_1d(kernel(*map(np.float64, row))) for row in rows])


@pytest.mark.parametrize("page", PAGES)
def test_the_still_picture_stands_where_no_script_runs_and_on_paper(visit, page):
    for script in (False, True):
        tab = visit(page, until=STARTED, java_script_enabled=script)
        for medium in ("screen", "print"):
            tab.emulate_media(media=medium)
            live = script and medium == "screen"
            for name in PAGES[page]:
                figure = tab.locator(f"#fig-{name}")
                assert figure.locator(".pixels").is_visible() is not live
                stage = figure.locator(".idea-stage")
                assert stage.count() == script and stage.is_visible() is live


@pytest.mark.parametrize("page", PAGES)
def test_a_phone_has_it_whole_with_large_targets(visit, page):
    tab = visit(page, until=STARTED, **PHONE)
    for name in PAGES[page]:
        tab.locator(f"#fig-{name}").scroll_into_view_if_needed()
        next_frame(tab)
        script = """name => [...document.querySelectorAll(`#fig-${name} :is(.reach, input, button, select)`)]
            .map(e => e.getBoundingClientRect()).map(r => [r.width, r.height])"""
        sizes = tab.evaluate(script, name)
        assert sizes and all(min(size) >= 43.9 for size in sizes)


def test_their_code_is_light(site):
    """What they load beside the simulator's module, compressed as a server would: at most 25 kB."""
    parts = [path.read_bytes() for path in sorted((site / "_static" / "ideas").iterdir())]
    assert len(parts) == 8 and len(gzip.compress(b"".join(parts))) <= 25_000


def test_slope_is_texture_starts_near_the_top_of_the_chapter(idea):
    tab, figure = idea("slope_is_texture")
    assert tab.evaluate("e => e.getBoundingClientRect().top + scrollY", figure.element_handle()) < 2500


def expected_on_circle(u, beta):
    """Return slope, slope × β, tilt, and μ without the bump and with it; the frame by formulas of this test's own."""
    slope, _ = gradient_at(SCENE, u, 0.125, exact())
    theta, phi, bump = 2 * math.pi * u - math.pi, math.pi / 8, beta * slope
    normal = np.array([math.sin(phi) * math.cos(theta), math.sin(phi) * math.sin(theta), math.cos(phi)])
    light = SCENE.lights[0].position - normal
    before, along = np.array([normal, [-math.sin(theta), math.cos(theta), 0]]) @ light / np.linalg.norm(light)
    after = (before + bump * along) / math.hypot(1, bump)
    return slope, bump, math.degrees(math.atan(abs(bump))), max(0.0, before), max(0.0, after)


def test_slope_is_texture_says_what_the_renderer_says(idea):
    tab, figure = idea("slope_is_texture")
    point, beta = figure.locator(".idea-handle").first, figure.locator("input")
    seen = set()
    for keys in (["ArrowRight"], ["Shift+ArrowLeft", "ArrowDown"], ["Shift+ArrowRight"] * 9, ["Shift+ArrowDown"] * 6):
        press(tab, point, *keys)
        slope, amount, product, tilt, before, after = said(figure)
        u = now(point)
        assert amount == float(beta.input_value())
        expected = expected_on_circle(u, amount)
        np.testing.assert_allclose((slope, product, tilt, before, after), expected, atol=0.051)
        assert abs(slope - expected[0]) < 0.0051 and numbers(point.get_attribute("aria-valuetext")) == [slope, tilt]
        seen.add((u, amount))
    assert len(seen) == 4
    assert abs(expected[2] - expected_on_circle(u + 1 / 256, amount)[2]) > 0.2  # a neighbour would be seen


def test_slope_is_texture_follows_the_pointer(idea):
    tab, figure = idea("slope_is_texture")
    figure.scroll_into_view_if_needed()
    point, sphere = figure.locator(".idea-handle").all()
    start, frame = now(point), figure.locator("svg").first
    point.drag_to(frame, target_position={"x": frame.bounding_box()["width"] / 2, "y": 50}, force=True)
    next_frame(tab)
    assert start != now(point) == now(sphere) == 0.5
    assert abs(height_at(SCENE, 0.5, 0.125)) < 1e-12 and said(figure)[0] == 0.0


def covered(figure, colour):
    """Return which pixels of a figure's canvas have a colour, to a level."""
    with Image.open(io.BytesIO(figure.locator("canvas").screenshot())) as picture:
        return (np.abs(np.asarray(picture.convert("RGB"), float) - colour) < 2).all(axis=2)


def test_bump_surface_moves_rim_and_shadow_in_the_last_state_alone(idea):
    tab, figure = idea("bump_surface")
    figure.scroll_into_view_if_needed()
    shadow, floor, seen = (144, 141, 134), (232, 227, 217), []
    for button, angle in zip(figure.locator(".idea-states button").all(), idea_kernels.angles(), strict=True):
        button.click()
        next_frame(tab)
        assert button.get_attribute("aria-pressed") == "true" and said(figure)[0] == pytest.approx(angle, abs=0.51)
        seen.append([covered(figure, colour) for colour in (shadow, floor)])
    assert figure.locator("[aria-pressed=true]").count() == 1 and all(map(np.any, seen[0]))
    for part, first in enumerate(seen[0]):
        same = [np.array_equal(first, later[part]) for later in seen[1:]]
        assert same == [True, True, True, False]


def test_bump_surface_turns_by_hand_and_keys_and_stays_still_without_a_card(idea, visit):
    tab, figure = idea("bump_surface")
    figure.scroll_into_view_if_needed()
    view = figure.locator("[role=slider]")
    start, places = now(view), [{"x": x, "y": 100} for x in (200, 320)]
    view.drag_to(view, source_position=places[0], target_position=places[1])
    expect(view).to_have_attribute("aria-valuenow", str(int(start - 57)))
    press(tab, view, *["Shift+ArrowDown"] * 9)
    assert "from 90° above" in view.get_attribute("aria-valuetext") and covered(figure, (232, 227, 217)).any()
    press(tab, view, *["Shift+ArrowUp"] * 9)
    assert not covered(figure, (232, 227, 217)).any()  # from below there is no floor
    none = "HTMLCanvasElement.prototype.getContext = () => null"
    without = visit("s3", until=STARTED.replace("'figure.idea:not", "'#fig-two_slopes:not"), prepare=none)
    assert without.locator("#fig-bump_surface .pixels").is_visible()


def test_the_stills_of_the_surface_are_the_sphere_s_but_for_the_last():
    outlines = [still[..., 3] > 0 for still in bump_surface._stills()]
    assert [np.array_equal(outlines[0], other) for other in outlines[1:]] == [True, True, True, False]


def test_two_slopes_says_what_the_renderer_says(idea):
    tab, figure = idea("two_slopes")
    point, step = figure.locator(".idea-handle").all()
    slider, apart = figure.locator("input"), []
    for exponent in (-2, -4, -12):
        slider.fill(str(exponent))
        press(tab, point, "ArrowRight")
        _, numeric, exactly, *_ = said(figure)
        eps, u = now(step), now(point)
        ours = [gradient_at(SCENE, u, 0.125, method)[0] for method in (central(eps), exact())]
        digits = 0.0051 if abs(ours[0] - ours[1]) >= 0.01 else 5.1e-9
        np.testing.assert_allclose((numeric, exactly), ours, rtol=0, atol=digits)
        apart.append(abs(ours[0] - ours[1]))
    assert apart[0] > apart[1] < apart[2]  # the U
    press(tab, step, "ArrowUp")
    assert now(step) > eps


def dots(figure, panel):
    """Return the places of the marked samples in a panel of two_slopes, x and y in pixels."""
    marked = figure.locator("svg").nth(panel).locator("circle.end").all()
    return np.array([[float(dot.get_attribute(name)) for name in ("cx", "cy")] for dot in marked])


def test_the_microscope_shows_where_float64_puts_the_samples(idea):
    tab, figure = idea("two_slopes")
    slider, point = figure.locator("input"), figure.locator(".idea-handle").first
    unit, met, u = figure.locator("svg").nth(1).bounding_box()["width"] / 4, [], now(point)
    for exponent in (-3, -6, -15.9, -17):
        slider.fill(str(exponent))
        next_frame(tab)
        eps = 10 ** float(slider.input_value())
        samples = dots(figure, 1)
        asked, taken = samples[[0, 2], 0], samples[[1, 3], 0]
        np.testing.assert_allclose(asked, [unit, 3 * unit], atol=0.6)
        np.testing.assert_allclose(taken, [unit * (2 + ((u + s * eps) - u) / eps) for s in (-1, 1)], atol=0.6)
        is_lost = "float64 takes no step" in figure.locator(".idea-says").inner_text()
        assert is_lost is (u + eps == u) is bool(taken[0] == taken[1])
        met.append([float(figure.locator("circle.met").get_attribute(name)) for name in ("cx", "cy")])
    assert is_lost and said(figure)[1] == 0.0
    (_, far), (_, best), (_, near), (_, lost) = met
    assert best > far and best > near > lost  # down one arm of the U and up the other; y is measured downwards
    assert [x for x, _ in met] == sorted((x for x, _ in met), reverse=True)


@pytest.mark.parametrize(
    "keys, surface", [([], "A"), (["Shift+ArrowRight"] * 4, "B"), (["Shift+ArrowLeft"] * 18, "floor")]
)
def test_scene_from_the_side_meets_what_the_renderer_meets(idea, keys, surface):
    tab, figure = idea("scene_from_the_side")
    point = figure.locator(".idea-handle")
    press(tab, point, *["Shift+ArrowLeft"] * 40, *["Shift+ArrowRight"] * 27, *keys)
    at = now(point) / math.sqrt(2)  # B's centre is on the diagonal
    frame = render(SCENE, 2001, 2001, exact(), crop=(0, 0, 1, 1))
    half = float(-frame.raster.image_points(SCENE)[0][0]) * 2001 / 2000
    column = round((at / half * 2001 + 2001 - 1) / 2)
    row = round((2001 - 1 - (at / half + 3 / 20) * 2001) / 2)
    record = pixel(SCENE, 2001, 2001, column, row)
    text = figure.locator(".idea-says").inner_text()
    assert record.surface == surface and f"shows {'the floor' if surface == 'floor' else f'sphere {surface}'}" in text
    for light, name in zip(record.lights, ("first", "second"), strict=True):
        assert f"{name} light {'is hidden' if light.occluded else 'reaches it'}" in text


@pytest.mark.parametrize("column, row", [(104, 92), (90, 140), (170, 70), (250, 20), (30, 200)])
def test_pixel_worked_is_the_renderers_pixel(idea, column, row):
    tab, figure = idea("pixel_worked")
    point = figure.locator(".idea-handle")
    at = int(now(point))
    for way, forth, back in ((column - at % 256, "ArrowRight", "ArrowLeft"), (row - at // 256, "ArrowDown", "ArrowUp")):
        key, (tens, ones) = forth if way > 0 else back, divmod(abs(way), 10)
        press(tab, point, *[f"Shift+{key}"] * tens, *[key] * ones)
    assert int(now(point)) == row * 256 + column
    shown = {e.get_attribute("data-line"): e.inner_text() for e in figure.locator("[data-line]").all()}
    record = pixel(SCENE, 256, 256, column, row)
    expected = dict(zip(("rgb_red", "rgb_green", "rgb_blue"), record.rgb, strict=True))
    expected |= {f"occluded_{light.number}": float(light.occluded) for light in record.lights}
    expected |= {f"mu_{light.number}": light.mu for light in record.lights if light.mu is not None}
    if record.surface == "A":
        expected |= {"u_closed": record.u, "v": record.v, "h_u": record.gradient[0], "h_v": record.gradient[1]}
        expected |= {f"bumped_{axis}_on_a": n for axis, n in zip("xyz", record.normal, strict=True)}
    else:
        assert shown["h_u"] == shown["m_length_on_a"] == "—"
    assert {name: numbers(shown[name])[0] for name in expected} == pytest.approx(expected, abs=5.1e-5)
