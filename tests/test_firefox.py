"""The site in Firefox, driven by puppeteer-core: the simulator draws the renderer's picture, the proofs are checked.

It is asked once a week: `.ci/long` installs Firefox. Without it, or without puppeteer-core, these tests are skipped.
"""

import json
import shutil

import pytest

from renderer import Scene, central, render
from renderer.picture.differences import distance_on_a
from tests.processes import ROOT, run
from verify.checkers.second_checker import stored

FIREFOX = shutil.which("firefox-esr") or shutil.which("firefox")
NPM = ROOT / "tests" / "npm"
missing = not FIREFOX or not (NPM / "node_modules" / "puppeteer-core").exists()
pytestmark = [pytest.mark.long, pytest.mark.skipif(missing, reason="Firefox or puppeteer-core is not installed")]
# Opens an address, runs a script there, waits until another is true, and prints the text of an element.
READ = """(async ([executablePath, address, script, until, element]) => {
    const browser = await require("puppeteer-core").launch({ browser: "firefox", executablePath });
    const page = await browser.newPage();
    await page.goto(address);
    await page.evaluate(script);
    await page.waitForFunction(until);
    console.log(await page.$eval(element, e => e.textContent));
    await browser.close();
})(JSON.parse(process.argv[1]))"""


def read(address, script, until, element):
    return run("node", "-e", READ, json.dumps([FIREFOX, address, script, until, element]), cwd=NPM)[0].strip()


def test_simulator_reads_the_renderers_difference(server):
    shown = "[data-readout=rms]"
    until = f"document.querySelector('{shown}')?.textContent.includes('e')"
    rms = distance_on_a(render(Scene(), 256, 256, central(1e-3)), render(Scene(), 256, 256, bounds=True))[1]
    told = read(f"{server}/s4.html", "0", until, shown).replace("−", "-")
    assert float(told) == pytest.approx(rms.value, rel=5e-3)


def test_proofs_are_checked(server):
    verdict = ".checker[data-all] .check-verdict"
    until = f"document.querySelector('{verdict}')?.textContent.startsWith('Accepted')"
    click = "document.querySelector('.checker[data-all] button').click()"
    assert f"{len(stored())} in all" in read(f"{server}/findings.html", click, until, verdict)
