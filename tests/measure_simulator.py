"""Measure the simulator in headless Chromium:  python -m tests.measure_simulator [--size 256 512 1024] [--against PAGE]

A step of ε: milliseconds from the slider's event to the last of its pictures in a canvas. A drag: ε moves for five
seconds, at every frame of the screen; what counts is the time between frames that show a new picture. With an older
build's page the two take turns, and the ratio of their steps is kept. Times belong to the machine that they were taken
on; no test asserts them. Writes verify/benchmark/results/simulator.json. Needs the built book.
"""

import argparse
import os
import shutil
from pathlib import Path
from statistics import median

from playwright.sync_api import sync_playwright

from book.editions.chromium import FLAGS
from verify.benchmark.label import ROOT, label, write

PAGE = ROOT / "book" / "_build" / "html" / "s4.html"
RESULT = Path("verify/benchmark/results/simulator.json")
ROUNDS = 3
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


def opened(browser, page, size):
    """Return a tab with the simulator at a raster, its idle work done."""
    tab = browser.new_page(viewport={"width": 1280, "height": 1000})
    tab.goto(f"{page}#sim?size={size}")
    tab.wait_for_function("window.Simulator && Simulator.running && Simulator.running.frames.length > 0")
    tab.wait_for_timeout(4000)
    return tab


def measured(browser, pages, size, steps, seconds):
    """Return the numbers of one raster. pages: {name: address}, of which "now" is dragged too."""
    taken, between = {name: [] for name in pages}, []
    for _ in range(ROUNDS):
        for name, page in pages.items():
            tab = opened(browser, page, size)
            taken[name] += tab.evaluate(STEPS, steps)
            if name == "now":
                between += tab.evaluate(DRAG, seconds)
            tab.close()
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
    parser.add_argument("--steps", type=int, default=40, help="steps of a round (default: 40)")
    parser.add_argument("--seconds", type=float, default=5, help="how long a drag is (default: 5)")
    parser.add_argument("--page", default=PAGE.as_uri(), help="address of the page (default: the built book's)")
    parser.add_argument("--against", help="address of an older build's page, to be compared with")
    parser.add_argument("--out", type=Path, default=ROOT / RESULT, help=f"the JSON (default: {RESULT})")
    options = parser.parse_args()
    pages = {"now": options.page} | ({"before": options.against} if options.against else {})
    numbers = {"load": os.getloadavg()[0], "cores": os.cpu_count()}
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=FLAGS)
        for size in options.size:
            found = measured(browser, pages, size, options.steps, options.seconds)
            print("\n".join(f"{name:24} {value:.3g}" for name, value in found.items()), flush=True)
            numbers |= found
        version = browser.version
        browser.close()
    write(options.out, {"label": label() | {"browser": f"Chromium {version}"}, "numbers": numbers})


if __name__ == "__main__":
    main()
