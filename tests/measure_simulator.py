"""Measure the simulator in headless Chromium, beside the one that it once was:

    python -m tests.measure_simulator                    (some minutes, on a machine that does nothing else)
    python -m tests.measure_simulator --size 256 512     only these rasters

A step of ε: milliseconds from the slider's event to the last of its pictures in a canvas. A drag: ε moves for five
seconds, at every frame of the screen; what counts is the time between frames that show a new picture, also of an own
field of five terms. The simulator of
`--against`, a commit whose scripts are all committed, takes turns with today's, and the ratio of their steps is kept.
Times belong to the machine that they were taken on; no test asserts them. Needs the built book, of the code that is to
be measured. Writes verify/benchmark/results/simulator.json: commit it.
"""

import io
import os
import subprocess
import tarfile
import tempfile
from pathlib import Path
from statistics import median
from urllib.parse import quote

from tqdm import tqdm

from book.assembly import stamps
from book.assembly.website import SITE
from tests.tabs import RUNNING, chromium, opened
from verify.benchmark.timing import load
from verify.evidence.records import code_of, command
from verify.evidence.sources import ROOT

PRINTED_IN_JAVASCRIPT = "2be60f7"  # a commit whose simulator was printed in JavaScript, and not compiled
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


def simulator_of(commit, folder):
    """Write a page of a commit's simulator alone into a folder; return its address."""
    git = ["git", "archive", commit, "book/static"]
    archive = subprocess.run(git, cwd=ROOT, capture_output=True, check=True).stdout
    with tarfile.open(fileobj=io.BytesIO(archive)) as files:
        files.extractall(folder, filter="data")
    static = Path(folder, "book", "static").rename(Path(folder, "_static"))
    part = (static / "simulator" / "simulator.html").read_text(encoding="utf-8")
    style = '<link rel="stylesheet" href="_static/palette.css"><link rel="stylesheet" href="_static/book.css">'
    page, head = Path(folder, "page.html"), f'<!doctype html><html data-theme="light"><meta charset="utf-8">{style}'
    page.write_text(f"{head}<body>{part}", encoding="utf-8")
    return page.as_uri()


def measured(browser, pages, size):
    """Return the numbers of one raster. pages: {name: address}, of which "now" is dragged too."""
    taken, between = {name: [] for name in pages}, []
    for name in tqdm([*pages] * ROUNDS, desc=f"{size}²", unit="visit"):
        with opened(browser, f"{pages[name]}#sim?size={size}", until=RUNNING, viewport=VIEWPORT) as tab:
            tab.wait_for_timeout(4000)  # its idle work
            taken[name] += tab.evaluate(STEPS, 40)
            if name == "now":
                between += tab.evaluate(DRAG, 5)
    now, before = median(taken["now"]), median(taken["before"])
    return {
        f"step_{size}_ms": now,
        f"drag_{size}_ms": median(between),
        f"drag_{size}_worst_ms": max(between),
        f"drag_{size}_within": sum(time <= TARGETS[size] for time in between) / len(between),
        f"ratio_{size}": before / now,
    }


def measure(size, against):
    """Return the numbers of all rasters; SystemExit unless the book was built from the code as it is."""
    built, code = stamps.read("site") or {}, stamps.hashes(ROOT / path for path in code_of("simulator"))
    if other := [path for path, hashed in code.items() if built.get(path) != hashed]:
        raise SystemExit(f"the built book is not of this code ({other[0]}): python -m book build")
    numbers = {"load": load(), "cores": os.cpu_count()}
    with tempfile.TemporaryDirectory() as folder, chromium() as browser:
        pages = {"now": (SITE / "s4.html").as_uri(), "before": simulator_of(against, folder)}
        label = {"browser": f"Chromium {browser.version}", "before": against}
        for side in size:
            numbers |= measured(browser, pages, side)
        with opened(
            browser, f"{pages['now']}#sim?size=512&field=own&h={quote(FIVE_TERMS)}", until=RUNNING, viewport=VIEWPORT
        ) as tab:
            tab.wait_for_timeout(4000)
            numbers["drag_own_512_ms"] = median(tab.evaluate(DRAG, 5))
    return {"label": label, "numbers": numbers}


if __name__ == "__main__":
    command("simulator", __doc__, measure, size=list(TARGETS), against=PRINTED_IN_JAVASCRIPT)
