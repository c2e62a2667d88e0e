"""The simulator against axe-core: no serious or critical violation, in light, in dark and on a phone.

axe-core is an npm package and used here alone: `npm ci --prefix tests/axe` installs it. Without it these are skipped.
"""

from pathlib import Path

import pytest

from tests.test_browser import DESKTOP, PHONE

AXE = Path(__file__).parent / "axe" / "node_modules" / "axe-core" / "axe.min.js"

pytestmark = [
    pytest.mark.browser,
    pytest.mark.skipif(not AXE.is_file(), reason="axe-core is not installed: npm ci --prefix tests/axe"),
]
RUN = """async () => (await axe.run('#simulator', { resultTypes: ['violations'] })).violations
    .filter(v => ['serious', 'critical'].includes(v.impact))
    .map(v => `${v.id}: ${v.nodes.map(n => n.target.join(' ')).slice(0, 5).join(', ')}`)"""
MODES = {
    "light": {"viewport": DESKTOP, "color_scheme": "light"},
    "dark": {"viewport": DESKTOP, "color_scheme": "dark"},
    "phone": {"viewport": PHONE, "is_mobile": True, "has_touch": True},
}


@pytest.fixture(params=MODES)
def tab(request, browser, server):
    context = browser.new_context(**MODES[request.param])
    page = context.new_page()
    page.goto(f"{server}/s4.html")
    page.wait_for_function("window.Simulator && Simulator.running && Simulator.running.frames.length > 0")
    page.add_script_tag(path=AXE)
    yield page
    context.close()


def test_no_serious_violation(tab):
    assert tab.evaluate(RUN) == []
    tab.locator("#sim-eps ~ input").fill("nonsense")
    tab.locator("#sim-eps ~ input").press("Tab")
    assert tab.evaluate(RUN) == []


def test_a_violation_is_seen(tab):
    tab.evaluate("document.getElementById('simulator').insertAdjacentHTML('beforeend', '<button></button>')")
    assert any(entry.startswith("button-name") for entry in tab.evaluate(RUN))
