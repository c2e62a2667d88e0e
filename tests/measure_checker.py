"""Measure "Check all" in headless Chromium:  python -m tests.measure_checker [--times 7]

Prints the median and the worst of the milliseconds that the kernel takes for all certificates, and from the press of
the button to the summary. Times belong to the machine that they were taken on; no test asserts them. Needs the built
book.
"""

import argparse
import shutil
import statistics
from pathlib import Path

from playwright.sync_api import sync_playwright
from tqdm import tqdm

from book.editions.chromium import FLAGS

PAGE = Path(__file__).resolve().parent.parent / "book" / "_build" / "html" / "claims.html"
PRESS = """async () => {
    const place = document.querySelector('.checker[data-all]'), bar = place.querySelector('progress');
    const verdict = place.querySelector('.check-verdict'), begin = performance.now();
    place.querySelector('button').click();
    while (!verdict.innerText) await new Promise((done) => setTimeout(done, 1));
    if (!verdict.innerText.includes('Accepted')) throw new Error(verdict.innerText);
    return [Number(place.dataset.kernel), performance.now() - begin, bar.value];
}"""


def main():
    """Press the button a few times, each in a fresh page; print a table."""
    parser = argparse.ArgumentParser(prog="python -m tests.measure_checker", description=__doc__.split("\n\n")[0])
    parser.add_argument("--times", type=int, default=7, help="how often (default: 7)")
    parser.add_argument("--page", default=PAGE.as_uri(), help="address of the page (default: the built book's)")
    options = parser.parse_args()
    taken = []
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=FLAGS)
        for _ in tqdm(range(options.times), leave=False):
            tab = browser.new_page()
            tab.goto(options.page, wait_until="load")
            taken.append(tab.evaluate(PRESS))
            tab.close()
        browser.close()
    kernel, whole, count = zip(*taken, strict=True)
    print(f"{count[0]} certificates, {options.times} times, each in a fresh page, in milliseconds")
    for name, times in (("in the kernel", kernel), ("from the press to the summary", whole)):
        print(f"{name:30} median {statistics.median(times):7.0f}   worst {max(times):7.0f}")


if __name__ == "__main__":
    main()
