"""Measure the simulator in headless Chromium:

    python -m tests.measure_simulator                    (some minutes, on a machine that does nothing else)
    python -m tests.measure_simulator --size 256 512     only these rasters

A step of ε: milliseconds from the slider's event to the last of its pictures in a canvas. A drag: ε moves for five
seconds, at every frame of the screen; what counts is the time between frames that show a new picture, also of an own
field of five terms. Times belong to the machine that they were taken on; no test asserts them. Needs the built book, of
the code that is to be measured. Writes verify/benchmark/results/simulator.json: commit it.
"""

import os
from statistics import median
from urllib.parse import quote

from tqdm import tqdm

from book.assembly import stamps
from book.assembly.website import SITE
from tests.tabs import RUNNING, chromium, opened
from verify.benchmark.timing import load
from verify.evidence.records import code_of, command
from verify.evidence.sources import ROOT

ROUNDS = 3
VIEWPORT = {"width": 1280, "height": 1000}
TARGETS = {256: 25, 512: 42, 1024: 100}  # milliseconds between pictures, of a drag
FIVE_TERMS = "sin(16*pi*u)*v + " + " + ".join(
    f"sin(pi*({a}*u + {b}*v))/9" for a, b in ((6, 5), (8, 9), (12, 7), (14, 3))
)
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


def measured(browser, page, size):
    """Return the numbers of one raster."""
    steps, between = [], []
    for _ in tqdm(range(ROUNDS), desc=f"{size}²", unit="visit"):
        with opened(browser, f"{page}#sim?size={size}", until=RUNNING, viewport=VIEWPORT) as tab:
            tab.wait_for_timeout(4000)  # its idle work
            steps += tab.evaluate(STEPS, 40)
            between += tab.evaluate(DRAG, 5)
    return {
        f"step_{size}_ms": median(steps),
        f"drag_{size}_ms": median(between),
        f"drag_{size}_worst_ms": max(between),
        f"drag_{size}_within": sum(time <= TARGETS[size] for time in between) / len(between),
    }


def measure(size):
    """Return the numbers of all rasters; SystemExit unless the book was built from the code as it is."""
    built, code = stamps.read("site") or {}, stamps.hashes(ROOT / path for path in code_of("simulator"))
    if other := [path for path, hashed in code.items() if built.get(path) != hashed]:
        raise SystemExit(f"the built book is not of this code ({other[0]}): python -m book build")
    numbers, page = {"load": load(), "cores": os.cpu_count()}, (SITE / "s4.html").as_uri()
    with chromium() as browser:
        for side in size:
            numbers |= measured(browser, page, side)
        own = f"{page}#sim?size=512&field=own&h={quote(FIVE_TERMS)}"
        with opened(browser, own, until=RUNNING, viewport=VIEWPORT) as tab:
            tab.wait_for_timeout(4000)
            numbers["drag_own_512_ms"] = median(tab.evaluate(DRAG, 5))
        return {"label": {"browser": f"Chromium {browser.version}"}, "numbers": numbers}


if __name__ == "__main__":
    command("simulator", __doc__, measure, size=list(TARGETS))
