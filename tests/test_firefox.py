"""The site and the one file in Firefox, driven by WebDriver BiDi: every page, the search, the proofs, the simulator.

Firefox is not needed for the book and is asked once a week: `.ci/long` installs it. Without it these tests are skipped.
"""

import asyncio
import json
import re
import shutil
import subprocess
from threading import Thread

import pytest
from tornado.websocket import websocket_connect

from tests.tabs import RUNNING, slide, wait_for
from tests.test_browser import OVERFLOWS, SEEN, every_page
from tests.test_simulator_numbers import BASE, drawn, rendered

FIREFOX = shutil.which("firefox-esr") or shutil.which("firefox")
pytestmark = [pytest.mark.long, pytest.mark.skipif(not FIREFOX, reason="Firefox is not installed")]
CROP = 256, (90, 60, 96, 96)
PATIENCE = 120  # seconds for an answer
# What a page complains of, and what it was forbidden; that a layout follows a frame later is no complaint.
WATCH = """() => {
    window.complaints = [];
    const take = e => e.message?.startsWith('ResizeObserver') || complaints.push(`${e.type} ${e.message ?? e.reason}`);
    for (const type of ['error', 'unhandledrejection', 'securitypolicyviolation']) addEventListener(type, take, true);
}"""
# A function is called, and an expression is what it says; both may be promises.
GIVEN = "(async (script, arg) => JSON.stringify(typeof script === 'function' ? await script(arg) : await script))"


class Tab:
    """A tab of a running Firefox, which evaluates scripts as Playwright's does. address: of its BiDi."""

    def __init__(self, address):
        # A loop in a thread of its own: Playwright may hold this thread's.
        self.loop, self.count = asyncio.new_event_loop(), 0
        Thread(target=self.loop.run_forever, daemon=True).start()
        self.socket = self.answer(self.connect(f"{address}/session"))
        self.ask("session.new", capabilities={})
        self.context = self.ask("browsingContext.getTree")["contexts"][0]["context"]
        self.ask("script.addPreloadScript", functionDeclaration=WATCH)

    async def connect(self, address):
        return await websocket_connect(address, max_message_size=2**26)

    def answer(self, coroutine):
        return asyncio.run_coroutine_threadsafe(coroutine, self.loop).result(PATIENCE)

    def ask(self, method, **params):
        """Return the result of a command; AssertionError where Firefox says that it failed."""
        return self.answer(self.told(method, params))

    async def told(self, method, params):
        self.count += 1
        await self.socket.write_message(json.dumps({"id": self.count, "method": method, "params": params}))
        while (said := json.loads(await self.socket.read_message())).get("id") != self.count:
            pass  # what Firefox tells meanwhile
        assert said["type"] == "success", said
        return said["result"]

    def evaluate(self, script, arg=None):
        expression, target = f"{GIVEN}({script}, {json.dumps(arg)})", {"context": self.context}
        said = self.ask("script.evaluate", expression=expression, target=target, awaitPromise=True)
        assert said["type"] == "success", said
        text = said["result"].get("value")
        return text and json.loads(text)

    def wait_for_timeout(self, milliseconds):
        self.answer(asyncio.sleep(milliseconds / 1000))

    def resize(self, width):
        self.ask("browsingContext.setViewport", context=self.context, viewport={"width": width, "height": 900})

    def goto(self, address):
        self.ask("browsingContext.navigate", context=self.context, url=address, wait="complete")


@pytest.fixture(scope="module")
def firefox(tmp_path_factory):
    command = [FIREFOX, "--headless", "--no-remote", "--profile", tmp_path_factory.mktemp("profile")]
    with subprocess.Popen([*command, "--remote-debugging-port=0"], stderr=subprocess.PIPE, text=True) as running:
        address = next(found[0] for line in running.stderr if (found := re.search(r"ws://\S+", line)))
        Thread(target=running.stderr.read, daemon=True).start()
        yield Tab(address)
        running.terminate()


@pytest.fixture
def tab(firefox):
    """The tab, whose page has complained of nothing and has been forbidden nothing when the test is over."""
    yield firefox
    assert firefox.evaluate("complaints") == []


@every_page
def test_page_is_whole(tab, base, page):
    tab.goto(f"{base}/{page}.html")
    for width in (400, 1440):
        tab.resize(width)
        seen = tab.evaluate(SEEN)
        assert seen["unloaded"] == [] and seen["unset"] == 0 and seen["fonts"] and not tab.evaluate(OVERFLOWS, 15000)


def test_search_finds_words(tab, base):
    tab.goto(f"{base}/search.html?q=silhouette")
    wait_for(tab, "!!document.querySelector(\"#search-results li > a[href^='s2.html']\")")


def test_proofs_are_checked(tab, base):
    tab.goto(f"{base}/findings.html")
    wait_for(tab, "!!document.querySelector('.checker[data-all] button')")
    tab.evaluate("document.querySelector('.checker[data-all] button').click()")
    wait_for(tab, "document.querySelector('.checker[data-all] .check-verdict').textContent.startsWith('Accepted')")


def test_simulator_gives_the_renderers_bits(tab, base, single):
    """And moves by its slider; in the one file, too."""
    tab.resize(1440)
    for address in (f"{base}/s4.html", f"{single.as_uri()}#sim"):
        tab.goto(address)
        wait_for(tab, RUNNING)
        for eps in (1e-1, 1e-3, 1e-16, 1e-18):
            step = BASE, {"name": "central", "eps": eps}
            assert drawn(tab, step, raster=CROP) == rendered(*step, CROP)
        before = tab.evaluate("Simulator.running.frames.length")
        slide(tab, "eps", -5)
        wait_for(tab, f"Simulator.running.frames.length > {before}")
        assert tab.evaluate("complaints") == []


def test_what_is_wrong_is_seen(firefox, site):
    firefox.goto((site / "s1.html").as_uri())
    firefox.evaluate("fetch('https://example.org/').catch(() => setTimeout(() => undefined.name))")
    wait_for(firefox, "complaints.length > 1")
    assert {of.split()[0] for of in firefox.evaluate("complaints")} == {"securitypolicyviolation", "error"}
    firefox.evaluate("document.body.style.minWidth = '3000px'")
    assert firefox.evaluate(OVERFLOWS, 500)
