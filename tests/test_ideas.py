"""The small interactives: their numbers are the renderer's, hand and keys move them, the still pictures stay."""

import math
import random
import re

import numpy as np
import pytest

from book import idea_kernels
from renderer import Scene, exact, gradient_at, height_at
from renderer.machines.points_code import inputs_of
from tests.simulator_page import visited

pytestmark = pytest.mark.browser

SCENE = Scene()
PAGES = {"slope_is_texture": "s1"}
NUMBER = re.compile(r"[−-]?\d+(?:\.\d+)?")
STARTED = "document.querySelector('figure.idea') && !document.querySelector('figure.idea:not(.idea-live)')"


def numbers(text):
    """Return the numbers in a text, in their order."""
    return [float(found.replace("−", "-")) for found in NUMBER.findall(text)]


def unit(vector):
    return np.asarray(vector) / np.linalg.norm(vector)


@pytest.fixture(scope="module")
def visit(browser, server):
    """Return the function that opens an idea's page once, and gives the tab and the idea's figure."""
    opened = {}

    def open_page(name):
        page = PAGES[name]
        if page not in opened:
            manager = visited(browser, f"{server}/{page}.html", started=False)
            opened[page] = manager, manager.__enter__()
            opened[page][1].wait_for_function(STARTED)
        tab = opened[page][1]
        return tab, tab.locator(f"#fig-{name}")

    yield open_page
    for manager, _ in opened.values():
        manager.__exit__(None, None, None)


def next_frame(tab):
    tab.evaluate("() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")


def press(tab, part, *keys):
    for key in keys:
        part.press(key)
    next_frame(tab)


def said(figure):
    return numbers(figure.locator(".idea-says").first.inner_text())


def now(part):
    return float(part.get_attribute("aria-valuenow"))


@pytest.mark.parametrize("kernel", idea_kernels.IDEAS, ids=lambda kernel: kernel.__name__)
def test_the_compiled_kernels_are_python_s_to_the_last_bit(visit, kernel):
    tab, _ = visit("slope_is_texture")
    rng, count = random.Random(kernel.__name__), len(inputs_of(kernel))
    rows = [[rng.uniform(-1, 1) for _ in range(count)] for _ in range(50)]
    ask = "([name, rows]) => rows.map(row => [Ideas.module.kernel(name, ...row)].flat())"
    found = tab.evaluate(ask, [kernel.__name__, rows])
    with np.errstate(all="ignore"):
        expected = [[float(value) for value in np.atleast_1d(kernel(*map(np.float64, row)))] for row in rows]
    np.testing.assert_array_equal(np.array(found, float), np.array(expected))


@pytest.mark.parametrize("name", PAGES)
def test_the_still_picture_stands_where_no_script_runs_and_on_paper(browser, server, name):
    for script, medium in ((False, "screen"), (True, "print"), (True, "screen")):
        with visited(browser, f"{server}/{PAGES[name]}.html", started=False, java_script_enabled=script) as tab:
            if script:
                tab.wait_for_function(STARTED)
            tab.emulate_media(media=medium)
            figure, live = tab.locator(f"#fig-{name}"), script and medium == "screen"
            assert figure.locator(".pixels").is_visible() is not live
            assert (
                figure.locator(".idea-stage").count() == script and figure.locator(".idea-stage").is_visible() is live
            )


@pytest.mark.parametrize("name", PAGES)
def test_a_phone_has_it_whole_with_large_targets(browser, server, name):
    phone = {"viewport": {"width": 400, "height": 850}, "is_mobile": True, "has_touch": True}
    with visited(browser, f"{server}/{PAGES[name]}.html", started=False, **phone) as tab:
        tab.wait_for_function(STARTED)
        tab.locator(f"#fig-{name}").scroll_into_view_if_needed()
        next_frame(tab)
        script = """name => [...document.querySelectorAll(`#fig-${name} :is(.reach, input, button, select)`)]
            .map(e => e.getBoundingClientRect()).map(r => [r.width, r.height])"""
        sizes = tab.evaluate(script, name)
        assert sizes and all(min(size) >= 43.9 for size in sizes)
        assert tab.evaluate("document.documentElement.scrollWidth") == 400


def test_slope_is_texture_starts_near_the_top_of_the_chapter(visit):
    tab, figure = visit("slope_is_texture")
    assert tab.evaluate("e => e.getBoundingClientRect().top + scrollY", figure.element_handle()) < 2500


def expected_on_circle(u, beta):
    """Return slope, slope × β, tilt, and μ without the bump and with it, by formulas of this test's own."""
    slope, _ = gradient_at(SCENE, u, 0.125, exact())
    theta, phi = 2 * math.pi * u - math.pi, math.pi / 8
    normal = np.array([math.sin(phi) * math.cos(theta), math.sin(phi) * math.sin(theta), math.cos(phi)])
    bumped = unit(normal + beta * slope * np.array([-math.sin(theta), math.cos(theta), 0]))
    light = unit(np.array(SCENE.lights[0].position) - normal)
    tilt = math.degrees(math.acos(min(1.0, bumped @ normal)))
    return slope, slope * beta, tilt, max(0.0, normal @ light), max(0.0, bumped @ light)


def test_slope_is_texture_says_what_the_renderer_says(visit):
    tab, figure = visit("slope_is_texture")
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


def test_slope_is_texture_follows_the_pointer(visit):
    tab, figure = visit("slope_is_texture")
    figure.scroll_into_view_if_needed()
    point, sphere = figure.locator(".idea-handle").all()
    box, frame = point.bounding_box(), figure.locator("svg").first.bounding_box()
    start = now(point)
    tab.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    tab.mouse.down()
    tab.mouse.move(frame["x"] + frame["width"] / 2, frame["y"] + 50, steps=4)
    tab.mouse.up()
    next_frame(tab)
    assert start != now(point) == now(sphere) == 0.5
    assert abs(float(height_at(SCENE, 0.5, 0.125))) < 1e-12 and said(figure)[0] == 0.0
