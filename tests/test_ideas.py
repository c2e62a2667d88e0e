"""The small interactives: their numbers are the renderer's, hand and keys move them, the still pictures stay."""

import functools
import io
import re
import time
from math import sqrt

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import expect

from book import idea_kernels
from book.extension import worked
from renderer import Scene, central, exact, gradient_at, height_at, pixel
from renderer.scene.raster import Raster
from tests.tabs import PHONE, RUNNING, next_frame, number, wait_for

SCENE = Scene()
PAGES = {
    "s1": ["slope_is_texture"],
    "s2": ["scene_from_the_side", "pixel_worked"],
    "s3": ["bump_surface", "two_slopes"],
}
# Brings into sight one figure after another that is still.
STARTED = """(() => {
    const still = document.querySelector('figure.idea:not(.idea-live)');
    still?.scrollIntoView({ behavior: 'instant' });
    return !still && document.querySelector('figure.idea') !== null;
})()"""
# Whether all that is drawn by a background alone differs from the page's own.
DIFFERS = """() => {
    const drawn = 'foreignObject div, .idea-swatch, [aria-pressed=true], .sim-dot, .sim-certified i, .fa-solid, .fas';
    const looks = [...document.querySelectorAll(drawn)].map(part => getComputedStyle(part));
    const paper = getComputedStyle(document.body).backgroundColor;
    return document.documentElement.matches('.drawn') && looks.length > 9
        && looks.every(look => look.backgroundImage !== 'none' || look.backgroundColor !== paper) }"""
SIZES = "parts => parts.map(e => e.getBoundingClientRect()).map(({ width, height }) => Math.min(width, height))"
CENTRES = "dots => dots.map(({ cx, cy }) => [cx.baseVal.value, cy.baseVal.value])"
SHADOW, FLOOR = (144, 141, 134), (232, 227, 217)


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


def said(figure):
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
    targets = visit(page, until=STARTED, **PHONE).locator("figure.idea :is(.reach, input, button, select)")
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
    (_, slope, _, tilt, lit), smooth = (idea_kernels.bump_at(*at, amount, *light) for amount in (beta, 0.0))
    return slope, beta, beta * slope, tilt, smooth[-1], lit


def test_slope_is_texture_says_what_the_renderer_says_and_follows_the_pointer(idea):
    tab, figure, handles = idea("slope_is_texture")
    point, sphere = handles.all()
    for keys in (["ArrowRight"], ["Shift+ArrowLeft", "ArrowDown"], ["Shift+ArrowRight"] * 9, ["Shift+ArrowDown"] * 6):
        before = said(figure)
        press(tab, point, *keys)
        slope, beta, *_ = found = said(figure)
        expected = expected_on_circle(now(point), beta)
        np.testing.assert_allclose(found, expected, atol=0.051)
        assert before != found and abs(slope - expected[0]) < 0.0051
        assert beta == float(figure.locator("input").input_value())
        assert numbers(point.get_attribute("aria-valuetext")) == [slope, found[3]]
    assert abs(expected[3] - expected_on_circle(now(point) + 1 / 256, beta)[3]) > 0.2  # a neighbour would be seen
    frame = figure.locator("svg").first
    point.drag_to(frame, target_position={"x": frame.bounding_box()["width"] / 2, "y": 50}, force=True)
    next_frame(tab)
    assert now(point) == now(sphere) == 0.5
    assert abs(height_at(SCENE, 0.5, 0.125)) < 1e-12 and said(figure)[0] == 0.0


def covered(figure, *colours):
    """Return of each colour which pixels of a figure's canvas have it, to a level."""
    with Image.open(io.BytesIO(figure.locator("canvas").screenshot())) as picture:
        seen = np.asarray(picture.convert("RGB"), float)
    return [(np.abs(seen - colour) < 2).all(axis=2) for colour in colours]


def test_bump_surface_turns_and_moves_rim_and_shadow_in_the_last_state_alone(idea, visit):
    """By hand and keys; and it stays still without a card."""
    tab, figure, _ = idea("bump_surface")
    seen = []
    for button, angle in zip(figure.locator(".idea-states button").all(), idea_kernels.angles(), strict=True):
        button.click()
        next_frame(tab)
        assert button.get_attribute("aria-pressed") == "true" and said(figure)[0] == pytest.approx(angle, abs=0.51)
        seen.append(covered(figure, SHADOW, FLOOR))
    assert figure.locator("[aria-pressed=true]").count() == 1 and all(map(np.any, seen[0]))
    for first, *others in zip(*seen, strict=True):
        assert [np.array_equal(first, other) for other in others] == [True, True, True, False]
    view = figure.locator("[role=slider]")
    start, places = now(view), [{"x": x, "y": 100} for x in (200, 320)]
    view.drag_to(view, source_position=places[0], target_position=places[1])
    expect(view).to_have_attribute("aria-valuenow", str(int(start + 57)))
    press(tab, view, *["Shift+ArrowDown"] * 9)
    assert "from 90° above" in view.get_attribute("aria-valuetext") and np.any(covered(figure, FLOOR))
    press(tab, view, *["Shift+ArrowUp"] * 9)
    assert not np.any(covered(figure, FLOOR))  # from below there is no floor
    none = "HTMLCanvasElement.prototype.getContext = () => null"
    without = visit("s3", until=STARTED.replace("'figure.idea:not", "'#fig-two_slopes:not"), prepare=none)
    assert without.is_visible("#fig-bump_surface .pixels")


def test_two_slopes_says_what_the_renderer_says_and_shows_where_float64_puts_the_samples(idea):
    tab, figure, handles = idea("two_slopes")
    step, point = handles.all()
    unit, apart, met = figure.locator("svg").nth(1).bounding_box()["width"] / 4, [], []
    for exponent in (-2, -4, -6, -12, -15.9, -17):
        figure.locator("input").fill(str(exponent))
        press(tab, point, "ArrowRight")
        _, numeric, exactly, *_ = said(figure)
        eps, u = now(step), now(point)
        ours = [gradient_at(SCENE, u, 0.125, method)[0] for method in (central(eps), exact())]
        apart.append(abs(ours[0] - ours[1]))
        np.testing.assert_allclose((numeric, exactly), ours, rtol=0, atol=0.0051 if apart[-1] >= 0.01 else 5.1e-9)
        _, (below, _), _, (above, _) = figure.locator("svg >> nth=1 >> circle.end").evaluate_all(CENTRES)
        taken = [unit * (2 + (moved - u) / eps) for moved in (u - eps, u + eps)]
        np.testing.assert_allclose((below, above), taken, atol=0.6)
        is_lost = "float64 takes no step" in figure.locator(".idea-says").inner_text()
        assert is_lost is (u + eps == u)
        met += figure.locator("circle.met").evaluate_all(CENTRES)
    x, y = np.transpose(met)
    assert is_lost and numeric == 0.0 and apart[0] > apart[1] < apart[3]  # the U
    assert (np.diff(x) < 0).all() and np.array_equal(np.argsort(-y), np.argsort(apart))  # y is measured downwards
    point.drag_to(figure.locator("svg").first, target_position={"x": 200, "y": 50})  # though both are in one place
    assert now(point) > u
    press(tab, step, "ArrowUp")
    assert now(step) > eps


def test_scene_from_the_side_meets_what_the_renderer_meets(idea):
    tab, figure, point = idea("scene_from_the_side")
    image = Raster(2001, 2001).image_points(SCENE)
    for surface, way, times in (("sphere A", "Right", 0), ("sphere B", "Right", 4), ("the floor", "Left", 22)):
        press(tab, point, *[f"Shift+Arrow{way}"] * times)
        at = now(point) / sqrt(2)  # B's centre is on the diagonal
        record = pixel(SCENE, 2001, 2001, *(int(np.abs(part - at).argmin()) for part in image))
        text = figure.locator(".idea-says").inner_text()
        assert surface.split()[1] == record.surface and f"shows {surface}" in text
        for light, name in zip(record.lights, ("first", "second"), strict=True):
            assert f"{name} light {'is hidden' if light.occluded else 'reaches it'}" in text


def test_pixel_worked_is_the_renderers_pixel(idea):
    tab, figure, point = idea("pixel_worked")
    x, y = Raster(256, 256).image_points(SCENE)
    surfaces = set()
    for place in ((104, 92), (90, 140), (170, 70), (250, 20), (30, 200)):
        point.drag_to(figure.locator("svg"), target_position=dict(zip("xy", place, strict=True)), force=True)
        next_frame(tab)
        column, row = map(int, numbers(point.get_attribute("aria-valuetext")))
        at = {"x": x[column], "y": y[row]}
        record, lines = pixel(SCENE, 256, 256, column, row), at | idea_kernels.lines_at(SCENE, **at)
        surfaces.add(record.surface)
        assert [lines[f"rgb_{name}"] for name in ("red", "green", "blue")] == pytest.approx(record.rgb)
        assert (figure.locator("[data-line=h_u]").inner_text() == "—") is (record.surface != "A")
        for shown in figure.locator("[data-line]").all():
            wanted = worked.said(lines[shown.get_attribute("data-line")])
            assert shown.inner_text() in (wanted, "—" if record.surface != "A" else wanted)
    assert surfaces == {"A", "B", "floor"}


@pytest.mark.parametrize("page", [*PAGES, "s4"])
def test_in_forced_colours_sliders_and_backgrounds_are_seen_and_keys_lead_to_the_ends(visit, page):
    tab = visit(page, until=f"{RUNNING} || {STARTED}", forced_colors="active")
    tab.wait_for_function(DIFFERS)
    for slider in tab.locator("input[type=range]:visible").all():
        assert len(Image.open(io.BytesIO(slider.screenshot())).getcolors(10**6)) > 2
    for slider in tab.locator("[role=slider]").all():
        first, more, last, less = (
            press(tab, slider, key) or now(slider) for key in ("Home", "PageUp", "End", "PageDown")
        )
        assert [first, last] == [float(slider.get_attribute(f"aria-value{end}")) for end in ("min", "max")]
        assert first < more and less < last
