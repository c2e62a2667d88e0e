"""Measure the simulator in headless Chromium:  python -m tests.measure_simulator [--size 256] [--steps 60]

Prints milliseconds from a slider's step to the pictures in the canvases ("ready") and to the end of the frame that
shows them ("painted", which waits for the screen's next 60th of a second), and the main thread's long tasks. Times
belong to the machine that they were taken on; no test asserts them. Needs the built book.
"""

import argparse
import shutil
from pathlib import Path

from playwright.sync_api import sync_playwright
from tqdm import tqdm

from book.editions.chromium import FLAGS

PAGE = Path(__file__).resolve().parent.parent / "book" / "_build" / "html" / "s4.html"
WATCH = """window.longTasks = [];
new PerformanceObserver(list => longTasks.push(...list.getEntries().map(e => Math.round(e.duration))))
    .observe({ type: 'longtask', buffered: true });"""
# A slider moves, as by hand; two frames later the next step, so that each picture is seen.
STEP = """async ([name, value]) => {
    const { frames } = Simulator.running, before = frames.length;
    const slider = document.querySelector(`#sim-${name}`);
    slider.value = value;
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    for (let wait = 0; frames.length === before && wait < 120; wait++) await new Promise(requestAnimationFrame);
    return frames.length === before ? null : frames[frames.length - 1]; // null: the step changed nothing
}"""
SLIDERS = {"eps": (-1, -15), "beta": (0.1, 1.9), "ku": (2, 14)}


def percentile(times, share):
    """Return the time that `share` of the times do not exceed."""
    ordered = sorted(times)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))]


def measure(tab, name, steps):
    """Return the milliseconds of each step of a slider to and fro, the first few left out."""
    low, high = SLIDERS[name]
    shares = [abs(1 - 2 * ((n * 0.031) % 1)) for n in range(steps + 8)]
    values = [round(low + (high - low) * share, 0 if name == "ku" else 2) for share in shares]
    times = [tab.evaluate(STEP, [name, value]) for value in tqdm(values, desc=name, leave=False)][8:]
    return [time for time in times if time is not None]


def main():
    """Open the page, move the sliders, print a table."""
    parser = argparse.ArgumentParser(prog="python -m tests.measure_simulator", description=__doc__)
    parser.add_argument("--size", type=int, nargs="*", default=[256, 512], help="rasters (default: 256 512)")
    parser.add_argument("--steps", type=int, default=60, help="steps of each slider (default: 60)")
    parser.add_argument("--page", default=PAGE.as_uri(), help="address of the page (default: the built book's)")
    options = parser.parse_args()
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=FLAGS)
        tab = browser.new_page(viewport={"width": 1280, "height": 1000})
        tab.add_init_script(WATCH)
        for size in options.size:
            tab.goto("about:blank")
            tab.goto(f"{options.page}#sim?size={size}")
            tab.wait_for_function("Simulator.running && Simulator.running.frames.length > 0")
            tab.wait_for_timeout(4000)
            loading = tab.evaluate("longTasks.splice(0)")
            for name in SLIDERS:
                times = measure(tab, name, options.steps)
                for what in ("ready", "painted"):
                    taken = [time[what] for time in times]
                    median, high = percentile(taken, 0.5), percentile(taken, 0.95)
                    print(f"{size}² {name:4} {what:7} median {median:6.1f} ms   95 % {high:6.1f} ms")
            print(f"{size}² long tasks (ms): while loading {loading}, while moving {tab.evaluate('longTasks')}")
            print(f"{size}² pipelines: {tab.inner_text('.sim-readouts')!r}")
        browser.close()


if __name__ == "__main__":
    main()
