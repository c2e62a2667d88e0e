"""The lamp that is dragged: the page's pictures are the renderer's wherever it stands; and what plays by itself."""

import re

import numpy as np
import pytest
from playwright.sync_api import expect

from renderer import Light, Scene, central, render
from renderer.scene.scene import DEFAULT_LIGHTS
from tests.tabs import go

PICTURE = """([lamp, ball, size]) => {
    const { states, module } = Simulator.running;
    const state = states.changed(states.start(), { lamp, ball, size: 128 });
    const stage = module.make_stage(state, { width: size, height: size, left: 0, top: 0, wide: size, high: size });
    return [...stage.codes, ...module.render(state, module.methods_of(state).numeric, stage).map(plane => [...plane])];
}"""
SIDE = 64
LAMP = "Simulator.running.act.state().lamp"


@pytest.mark.parametrize("ball", [1, 0])
@pytest.mark.parametrize("lamp", [[5, 5, 10], [-4, 3, 2.5], [0, 0, 30], [3, -0.5, 0.1], [-2.1, 0.5, 0.5], [-2, 2, 3]])
def test_its_light_and_shadows_are_the_renderers(tab, lamp, ball):
    *codes, red, green, blue = tab.evaluate(PICTURE, [lamp, ball, SIDE])
    scene = Scene(lights=(Light(tuple(map(float, lamp)), DEFAULT_LIGHTS[0].color), DEFAULT_LIGHTS[1]), ball=bool(ball))
    frame = render(scene, SIDE, SIDE, central(1e-3))
    assert np.array_equal(np.reshape([red, green, blue], (3, SIDE, SIDE)), np.moveaxis(frame.rgb, -1, 0))
    assert np.array_equal(np.reshape(codes, (SIDE, SIDE)), frame.chambers)


def test_it_is_dragged_and_moved_by_keys(tab):
    """It keeps its distance, its handle follows, the link and the copied line have it."""
    go(tab, "#sim?field=ridges")
    handle, before = tab.locator("[data-picture=symbolic] .sim-lamp"), tab.evaluate(LAMP)
    box = handle.bounding_box()
    tab.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    tab.mouse.down()
    tab.mouse.move(box["x"] - 60, box["y"] + 40, steps=4)
    tab.mouse.up()
    x, y, z = tab.evaluate(LAMP)
    assert x < before[0] and y < before[1]
    assert np.hypot(np.hypot(x, y), z) == pytest.approx(np.linalg.norm(before), abs=0.02)
    moved = handle.bounding_box()
    assert abs(moved["x"] + moved["width"] / 2 - (box["x"] - 60)) < 3
    tab.wait_for_function("location.hash.includes('lamp=' + Simulator.running.act.state().lamp)")
    expect(tab.locator(".sim-python code")).to_contain_text(f"Light(({x}, {y}, {z})")
    handle.focus()
    handle.press("ArrowRight")
    assert tab.evaluate(LAMP)[0] > x
    expect(handle).to_have_attribute("aria-valuetext", re.compile(r"\d+° up, at "))
    tab.locator("#sim-lamp").evaluate("box => box.closest('details').open = true")
    tab.locator("#sim-lamp").fill("1, 2, -3")
    tab.locator("#sim-lamp").press("Enter")
    expect(tab.locator("#sim-lamp-error")).to_contain_text("outside both spheres")


def test_every_slider_plays(visit):
    """Beside each slider and the lamp a button lets it run; the same button stops it."""
    tab = visit("s4", reduced_motion="no-preference")
    go(tab, "#sim?field=sine")
    for name in ("eps", "beta", "ku", "kv", "lamp"):
        read, button = f"String(Simulator.running.act.state().{name})", tab.locator(f"[data-play={name}]")
        before = tab.evaluate(read)
        button.click()
        tab.wait_for_function(f"{read} !== '{before}'")
        button.click()
        stopped = tab.evaluate(read)
        tab.wait_for_timeout(200)
        assert tab.evaluate(read) == stopped != before, name
