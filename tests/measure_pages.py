"""Measure the built book's pages in headless Chromium, beside another built site, its processor four times as slow:

    python -m tests.measure_pages OTHER/book/_build/html            (some minutes, on a machine that does nothing else)
    python -m tests.measure_pages OTHER/book/_build/html s3 lemmas  only these pages

Of each page: for how many milliseconds scripts and layout block it, which is what tasks take beyond 50 ms until it has
been idle for two seconds; the layout's shift; the simulator's first picture, in milliseconds, where there is one; and
the kilobytes of the page, its scripts, style sheets and fonts, before compression. The sites take turns, and medians
are printed. Times belong to the machine; no test asserts them.
"""

import argparse
from pathlib import Path
from statistics import median

from playwright.sync_api import sync_playwright
from tqdm import tqdm

from book.assembly.contents import page_files
from book.assembly.website import BOOK, SITE
from book.editions.chromium import FLAGS, installed

ROUNDS, SLOWER, IDLE = 3, 4, 2000
PLACES = {"blocked": 0, "shift": 2, "picture": 0, "kB": 0}  # what is printed, with so many digits after the point
KINDS = ("document", "script", "stylesheet", "font")
WATCH = """
    window.seen = { blocked: 0, shift: 0, last: 0, picture: 0 };
    const watch = (type, take) => new PerformanceObserver(list => list.getEntries().forEach(take)).observe({ type });
    watch('longtask', task => { seen.blocked += task.duration - 50; seen.last = task.startTime + task.duration; });
    watch('layout-shift', shift => { if (!shift.hadRecentInput) seen.shift += shift.value; });
    (function look() {
        if (window.Simulator?.running?.frames.length) seen.picture = performance.now();
        else if (performance.now() < 60000) setTimeout(look, 20);
    })();
"""
RESTED = f"performance.now() - Math.max(seen.last, {IDLE}) > {IDLE}"


def measured(browser, address):
    """Return what one visit to a page finds: blocked, shift, picture and bytes."""
    context, heavy = browser.new_context(viewport={"width": 1280, "height": 900}, bypass_csp=True), {}
    context.add_init_script(WATCH)
    tab = context.new_page()
    context.new_cdp_session(tab).send("Emulation.setCPUThrottlingRate", {"rate": SLOWER})

    def weigh(request):
        if request.resource_type in KINDS:
            heavy[request.url] = len(request.response().body())

    tab.on("requestfinished", weigh)
    tab.goto(address)
    tab.wait_for_function(RESTED, timeout=120_000)
    seen = tab.evaluate("seen")
    context.close()
    return {name: seen[name] for name in ("blocked", "shift", "picture")} | {"kB": sum(heavy.values()) / 1000}


def main():
    """Print a line a page: this site's numbers, and the other's after a stroke."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("other", type=Path, help="the folder of another built site")
    parser.add_argument("pages", nargs="*", default=list(page_files(BOOK)), metavar="PAGE")
    options = parser.parse_args()
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=installed(), args=FLAGS)
        for page in tqdm(options.pages):
            sites = [site.resolve() for site in (SITE, options.other) if (site / f"{page}.html").is_file()]
            visits = [(site, measured(browser, f"{site.as_uri()}/{page}.html")) for site in sites * ROUNDS]
            found = [
                {name: median(seen[name] for place, seen in visits if place == site) for name in visits[0][1]}
                for site in sites
            ]
            words = [f"{name} {' / '.join(f'{seen[name]:.{PLACES[name]}f}' for seen in found)}" for name in PLACES]
            tqdm.write(f"{page:16} {'   '.join(words)}")
        browser.close()


if __name__ == "__main__":
    main()
