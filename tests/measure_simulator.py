"""Measure the simulator in headless Chromium:  python -m tests.measure_simulator [--size 256 512 1024] [--against PAGE]

A step of ε: milliseconds from the slider's event to the last of its pictures in a canvas. A drag: ε moves for five
seconds, at every frame of the screen; what counts is the time between frames that show a new picture. With an older
build's page the two take turns, and the ratio of their steps is kept. Times belong to the machine that they were taken
on; no test asserts them. Writes verify/benchmark/results/simulator.json. Needs the built book.
"""

import argparse
import os
from statistics import median

from playwright.sync_api import sync_playwright

from book.editions.chromium import FLAGS, installed
from tests.tabs import RUNNING, opened
from verify.benchmark.label import ROOT, label, write

PAGE = ROOT / "book" / "_build" / "html" / "s4.html"
RESULT = ROOT / "verify" / "benchmark" / "results" / "simulator.json"
ROUNDS = 3
VIEWPORT = {"width": 1280, "height": 1000}
TARGETS = {256: 25, 512: 42, 1024: 100}  # milliseconds between pictures, of a drag
# A slider moves, as by hand; two frames later the next step, so that each picture is seen.
STEPS = """async (count) => {
    const { frames } = Simulator.running, slider = document.querySelector('#sim-eps'), found = [];
    const frame = () => new Promise(requestAnimationFrame);
    for (let step = 0; step < count + 8; step++) {
        const before = frames.length;
        slider.value = -1 - 14 * Math.abs(1 - 2 * ((step * 0.031) % 1));
        slider.dispatchEvent(new Event('input', { bubbles: true }));
        for (let wait = 0; frames.length === before && wait < 120; wait++) await frame();
        if (frames.length > before && step >= 8) found.push(frames[frames.length - 1].ready);
        await frame();
    }
    return found;
}"""
DRAG = """async (seconds) => {
    const { frames } = Simulator.running, slider = document.querySelector('#sim-eps');
    const shown = [], begin = performance.now();
    let seen = frames.length;
    for (let now = begin; now < begin + 1000 * seconds; ) {
        now = await new Promise(requestAnimationFrame);
        if (frames.length > seen) shown.push(now);
        seen = frames.length;
        slider.value = -1 - 14 * Math.abs(1 - 2 * (((now - begin) / 2500) % 1));
        slider.dispatchEvent(new Event('input', { bubbles: true }));
    }
    return shown.slice(1).map((time, n) => time - shown[n]);
}"""


def measured(browser, pages, size):
    """Return the numbers of one raster. pages: {name: address}, of which "now" is dragged too."""
    taken, between = {name: [] for name in pages}, []
    for _ in range(ROUNDS):
        for name, page in pages.items():
            with opened(browser, f"{page}#sim?size={size}", until=RUNNING, viewport=VIEWPORT) as tab:
                tab.wait_for_timeout(4000)  # its idle work
                taken[name] += tab.evaluate(STEPS, 40)
                if name == "now":
                    between += tab.evaluate(DRAG, 5)
    now = taken["now"]
    numbers = {f"step_{size}_ms": median(now), f"step_{size}_worst_ms": max(now)}
    numbers |= {f"drag_{size}_ms": median(between), f"drag_{size}_worst_ms": max(between)}
    numbers[f"drag_{size}_within"] = sum(time <= TARGETS[size] for time in between) / len(between)
    if "before" in taken:
        numbers |= {
            f"before_{size}_ms": median(taken["before"]),
            f"ratio_{size}": median(taken["before"]) / median(now),
        }
    return numbers


def main():
    """Open the page, move the slider, print what was found and write it with its label."""
    parser = argparse.ArgumentParser(prog="python -m tests.measure_simulator", description=__doc__)
    parser.add_argument("--size", type=int, nargs="*", choices=TARGETS, default=list(TARGETS), help="rasters")
    parser.add_argument("--against", help="address of an older build's page, to be compared with")
    options = parser.parse_args()
    pages = {"now": PAGE.as_uri()} | ({"before": options.against} if options.against else {})
    numbers = {"load": os.getloadavg()[0], "cores": os.cpu_count()}
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=installed(), args=FLAGS)
        for size in options.size:
            found = measured(browser, pages, size)
            print("\n".join(f"{name:24} {value:.3g}" for name, value in found.items()), flush=True)
            numbers |= found
        version = browser.version
        browser.close()
    write(RESULT, {"label": label("llvmlite") | {"browser": f"Chromium {version}"}, "numbers": numbers})


if __name__ == "__main__":
    main()
