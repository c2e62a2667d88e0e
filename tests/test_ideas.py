"""The small interactives: their numbers are the renderer's, hand and keys move them, the still pictures stay."""

import base64
import functools
import io
import re
import time
import warnings

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import expect

from book import worked
from book.programs import idea_kernels
from renderer import Light, Scene, central, exact, gradient_at, pixel, render
from renderer.files.srgb import to_bytes
from renderer.picture.views import difference_logarithmic, image_view
from renderer.scene.raster import Raster
from tests.pictures import pixels
from tests.tabs import PHONE, RUNNING, next_frame, number, wait_for

SCENE = Scene()
LAMP = Light((4.09, 4.323, 0.762))  # of the three balls: 80° to the left, 0.75 rad up, seen from above the pole
AFAR = Scene(bump="surface", beta=0.12, ball=False, floor=False, ks=0.0, ka=0.4, eye=1e4, lights=[LAMP])
PAGES = {
    "s1": ["three_balls", "slope_is_texture"],
    "s2": ["scene_from_the_side", "pixel_worked"],
    "s3": ["two_slopes"],
    "s7": ["pitfall_seam"],
    "derivative": ["derivative_fit"],
}
# Brings into sight one figure after another that is still.
STARTED = """(() => {
    const still = document.querySelector('.idea:not(.idea-live)');
    still?.scrollIntoView({ behavior: 'instant' });
    return !still && document.querySelector('figure.idea') !== null;
})()"""
# True if all parts that are drawn by a background alone differ from the page's.
DIFFERS = """() => {
    const drawn = 'foreignObject div, .idea-swatch, [aria-pressed=true], .sim-dot, .sim-certified i, .fa-solid, .fas';
    const looks = [...document.querySelectorAll(drawn)].map(part => getComputedStyle(part));
    const paper = getComputedStyle(document.body).backgroundColor;
    return document.documentElement.matches('.drawn') && looks.length > 9
        && looks.every(look => look.backgroundImage !== 'none' || look.backgroundColor !== paper) }"""
# True if no line comes nearer to a drawing's first label than 2 pixels.
CLEAR = """svg => {
    const { x, y, width, height } = svg.querySelector('text').getBBox(), all = [...svg.querySelectorAll('path')];
    const away = (at, from, size) => Math.max(from - at, at - from - size) > 2;
    return all.every(line => [...Array(400).keys()].map(n => line.getPointAtLength(line.getTotalLength() * n / 399))
        .every(at => away(at.x, x, width) || away(at.y, y, height))) }"""
SIZES = "parts => parts.map(e => e.getBoundingClientRect()).map(({ width, height }) => Math.min(width, height))"


def numbers(text):
    """Return the numbers in a text, in their order."""
    return [*map(number, re.findall(r"[−-]?\d+(?:\.\d+)?", text))]


@pytest.fixture(scope="module")
def idea(visit_once):
    """Return the function that opens an idea's page once, and gives the tab and the idea's figure."""
    open_page = functools.cache(lambda page: visit_once(page, until=STARTED))

    def open_idea(name):
        tab = open_page(next(page for page, names in PAGES.items() if name in names))
        figure = tab.locator(f"#fig-{name}")
        figure.scroll_into_view_if_needed()
        return tab, figure, figure.locator(".idea-handle")

    return open_idea


def press(tab, part, *keys):
    for key in keys:
        part.press(key)
    next_frame(tab)


def shown_by(figure):
    return numbers(figure.locator(".idea-says").first.inner_text())


def now(part):
    return float(part.get_attribute("aria-valuenow"))


@pytest.mark.parametrize("page", PAGES)
def test_the_still_picture_stands_where_no_script_runs_and_on_paper_and_a_phone_has_large_targets(visit, page):
    for script in (False, True):
        tab = visit(page, until=STARTED, java_script_enabled=script)
        for medium in ("screen", "print"):
            tab.emulate_media(media=medium)
            live = script and medium == "screen"
            for name in PAGES[page]:
                assert tab.is_visible(f"#fig-{name} .pixels") is not live
                assert tab.is_visible(f"#fig-{name} .idea-stage") is live
    targets = visit(page, until=STARTED, **PHONE).locator(".idea :is(.reach, input, button, select)")
    assert min(targets.evaluate_all(SIZES)) >= 43.9


def test_an_idea_comes_alive_whose_own_script_comes_after_the_page_was_seen(browser, server):
    tab = browser.new_page()
    tab.route("**/slope_is_texture.js*", lambda route: (time.sleep(1), route.continue_()))
    tab.goto(f"{server}/s1.html")
    wait_for(tab, STARTED)


def expected_on_circle(u, beta):
    """Return slope, β, slope × β, tilt, and μ without the bump and with it."""
    at = u, 0.125, SCENE.ku, SCENE.kv
    light = SCENE.radius, *SCENE.lights[0].position
    (_, _, slope, tilt, lit), smooth = (idea_kernels.bump_at(*at, amount, *light) for amount in (beta, 0.0))
    return slope, beta, beta * slope, tilt, smooth[-1], lit


def test_slope_is_texture_says_what_the_renderer_says_and_follows_the_pointer(idea):
    tab, figure, handles = idea("slope_is_texture")
    (point,) = handles.all()
    press(tab, point, "ArrowRight", "Shift+ArrowDown")
    _, beta, *_ = numbers = shown_by(figure)
    np.testing.assert_allclose(numbers, expected_on_circle(now(point), beta), atol=0.051)
    before = figure.locator("foreignObject").evaluate_all("all => all.map(e => e.innerHTML)")
    figure.locator("input").last.fill("0.5")
    next_frame(tab)
    assert shown_by(figure) == numbers
    assert figure.locator("foreignObject").evaluate_all("all => all.map(e => e.innerHTML)") == before
    frame = figure.locator("svg").first
    point.drag_to(frame, target_position={"x": frame.bounding_box()["width"] / 2, "y": 50}, force=True)
    next_frame(tab)
    assert now(point) == 0.5


def test_the_slopes_tilt_is_that_of_the_renderers_surface_bump():
    record = pixel(AFAR, 256, 256, 104, 92)
    light = SCENE.radius, *AFAR.lights[0].position
    *_, tilt, lit = idea_kernels.bump_at(record.u, record.v, SCENE.ku, SCENE.kv, AFAR.beta, *light)
    assert lit == pytest.approx(record.lights[0].mu)
    assert np.cos(np.radians(tilt)) == pytest.approx(np.dot(record.normal, record.point))


def test_three_balls_have_the_renderers_colours_one_dented_rim_and_paint_that_does_not_answer(idea):
    """From above the pole, where the second is the renderer's picture; the view's right is −y, its up is x."""
    tab, figure, handles = idea("three_balls")
    (lamp,) = handles.all()

    def balls():
        shown = pixels(figure.locator("canvas").screenshot()).astype(int)
        shown = np.stack(np.split(shown[:, : shown.shape[1] // 3 * 3], 3, axis=1))
        return shown, np.mean(np.abs(shown[1] - shown[2]).max(axis=2) > 20)

    assert balls()[1] < 0.08
    press(tab, lamp, "Home", "ArrowUp")
    assert now(lamp) == -80 and "43° up" in lamp.get_attribute("aria-valuetext")
    press(tab, figure.locator(".idea-ground"), "End", *["Shift+ArrowDown"] * 4)
    shown, answers = balls()
    assert answers > 0.08

    _, bumped, _ = shown
    high, wide, _ = bumped.shape
    size = min(wide / 2.5, high / 2.4)
    x, y = np.meshgrid(*Raster(512, 512).image_points(AFAR))
    points = (np.hypot(x, y) < 0.9) & (np.arange(512) % 7 == 3)
    seen = bumped[(high / 2 - size * x[points]).astype(int), (wide / 2 - size * y[points]).astype(int)]
    assert np.quantile(np.abs(seen - to_bytes(render(AFAR, 512, 512).rgb[points])), 0.9) <= 4
    down, across = np.indices((high, wide))
    away = np.hypot(across + 0.5 - wide / 2, down + 0.5 - high / 2) / size
    off = ((shown != bumped[9, 9]).any(axis=3) != (away < 1))[:, away < 1.1].mean(axis=1)
    assert off[0] > 0.03 > 0.01 > max(off[1:])


def test_three_balls_turn_by_hand_and_stay_still_without_a_card(idea, visit):
    tab, figure, _ = idea("three_balls")
    view = figure.locator(".idea-ground")
    press(tab, view, "Home")
    start, places = now(view), [{"x": x, "y": 300} for x in (200, 320)]
    view.drag_to(view, source_position=places[0], target_position=places[1])
    expect(view).to_have_attribute("aria-valuenow", str(int(start + 57)))
    none = "HTMLCanvasElement.prototype.getContext = () => null"
    without = visit("s1", until=STARTED.replace("'.idea:not", "'#fig-slope_is_texture:not"), prepare=none)
    assert without.is_visible("#fig-three_balls .pixels")


def test_two_slopes_says_what_the_renderer_says_and_where_float64_takes_no_step(idea):
    tab, figure, handles = idea("two_slopes")
    step, point = handles.all()
    for exponent in (-2, -6, -17):
        figure.locator("input").fill(str(exponent))
        press(tab, point, "ArrowRight")
        _, numeric, exactly, *_ = shown_by(figure)
        eps, u = now(step), now(point)
        ours = [gradient_at(SCENE, u, 0.125, method)[0] for method in (central(eps), exact())]
        digits = 2 if abs(ours[0] - ours[1]) >= 0.01 else 8
        np.testing.assert_allclose((numeric, exactly), ours, rtol=0, atol=0.51 * 10**-digits)
        assert figure.locator("svg").first.evaluate(CLEAR)
        assert ("float64 takes no step" in figure.locator(".idea-says").inner_text()) is (u + eps == u)
    point.drag_to(figure.locator("svg").first, target_position={"x": 200, "y": 50})  # though both are in one place
    assert now(point) > u


def test_pixel_worked_shows_the_lines_of_the_renderers_pixel(idea):
    tab, figure, point = idea("pixel_worked")
    x, y = Raster(256, 256).image_points(SCENE)
    for place, surface in (((104, 92), "A"), ((250, 20), "floor")):
        point.drag_to(figure.locator("svg"), target_position=dict(zip("xy", place, strict=True)), force=True)
        next_frame(tab)
        column, row = map(int, numbers(point.get_attribute("aria-valuetext")))
        at = {"x": x[column], "y": y[row]}
        record, lines = pixel(SCENE, 256, 256, column, row), at | idea_kernels.lines_at(SCENE, **at)
        assert record.surface == surface
        assert [lines[f"rgb_{name}"] for name in ("red", "green", "blue")] == pytest.approx(record.rgb)
        for shown in figure.locator("[data-line]").all():
            wanted = worked.number_text(lines[shown.get_attribute("data-line")])
            assert shown.inner_text() in (wanted, "—" if surface != "A" else wanted)


# A pitfall's three canvases, each as a PNG.
CANVASES = "figure => [...figure.querySelectorAll('canvas')].map(canvas => canvas.toDataURL().split(',')[1])"


@pytest.mark.parametrize("name, value, width, corner, ku, eps, words", [
    ("pitfall_seam", 7, 1024, (202, 371), 7, 0.01, "Odd.* crease"),
    ("pitfall_seam", 6.5, 1024, (202, 371), 6.5, 0.01, "jumps"),
    ("step_taken", -16, 128, (0, 0), 8, 1e-16, "lie {2} apart"),
    ("around_pole", 8, 2048, (960, 806), 8, 1e-6, "from {} to {}"),
])  # fmt: skip
def test_a_pitfall_shows_the_renderers_pictures_and_says_its_numbers(idea, name, value, width, corner, ku, eps, words):
    tab, *_ = idea("pitfall_seam")
    figure, scene = tab.locator(f"#fig-{name}"), Scene(field="sine", ku=ku)
    figure.scroll_into_view_if_needed()
    figure.locator("input").fill(str(value))
    next_frame(tab)
    crop = *corner, 128, 128
    with warnings.catch_warnings(action="ignore"):  # of a step that is lost
        numeric, symbolic = frames = [render(scene, width, width, method, crop) for method in (central(eps), exact())]
    expected = [*map(image_view, frames), difference_logarithmic(numeric.rgb - symbolic.rgb)]
    for png, picture in zip(figure.evaluate(CANVASES), expected, strict=True):
        np.testing.assert_array_equal(pixels(base64.b64decode(png)), picture)
    ends = [f"{end(symbolic.planes_on_a[5]):.2f}" for end in (np.min, np.max)]
    ends.append(f"{(0.3 + eps) - (0.3 - eps):.3e}")
    expected = words.format(*(end.replace("-", "−") for end in ends))
    assert re.search(expected, figure.locator(".idea-says").inner_text())


def test_the_sphere_finds_a_target_and_says_so_when_it_does_not(idea):
    """Of the first line, the RMS is the renderer's."""
    _, figure, _ = idea("derivative_fit")
    scenes = Scene(field="sine"), Scene(field="sine", beta=0.2, ku=8.2)
    start, target = (render(scene, 128, 128).rgb for scene in scenes)
    says, lines = figure.locator(".idea-says"), figure.locator("li")
    figure.locator("button").first.click()
    expect(says).to_have_text("Found.")
    first, *_, last = map(numbers, lines.all_inner_texts())
    assert first[2] == pytest.approx(100 * np.sqrt(np.mean((target - start) ** 2)), abs=0.05)
    assert last[:2] == pytest.approx([0.2, 8.2], rel=1e-7)
    figure.get_by_label("target k").fill("9.5")
    while not says.inner_text():
        figure.locator("button").last.click()
    assert "did not converge" in says.inner_text()


@pytest.mark.parametrize("page", [*PAGES, "s4"])
def test_in_forced_colours_sliders_and_backgrounds_are_seen_and_keys_lead_to_the_ends(visit, page):
    tab = visit(page, until=f"{RUNNING} || {STARTED}", forced_colors="active")
    tab.wait_for_function(DIFFERS)
    for slider in tab.locator("input[type=range]:visible").all():
        assert len(Image.open(io.BytesIO(slider.screenshot())).getcolors(10**6)) > 2
    for slider in tab.locator("[role=slider]").all():
        for key, end in (("Home", "min"), ("End", "max")):
            press(tab, slider, key)
            assert now(slider) == float(slider.get_attribute(f"aria-value{end}"))
