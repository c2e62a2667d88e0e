"""Measure every page of a built site in headless Chromium, its processor four times as slow, beside another site:

    python -m tests.measure_pages                                        (minutes, on a machine that does nothing else)
    python -m tests.measure_pages --against OTHER/book/_build/html       beside the same pages of another built site
    python -m tests.measure_pages --page s3 lemmas --rounds 1            only these pages, visited once

Of each page: for how many milliseconds scripts and layout block it, which is what tasks take beyond 50 ms until it has
rested for a second; how far the layout shifts; the simulator's first picture, in milliseconds, where there is one.
Sites take turns, and medians are kept. Times belong to the machine that they were taken on; no test asserts them.
Writes verify/benchmark/results/pages.json: commit it. What was measured beside another site is kept with --output.
"""

import os
from statistics import median

from tqdm import tqdm

from book.assembly.contents import page_files
from tests.tabs import DESKTOP, WATCH, chromium
from verify.benchmark.timing import load
from verify.records import command
from verify.sources import ROOT

SLOWER, RESTS = 4, 1000
RESTED = f"""(!document.querySelector('#simulator') || seen.picture)
    && performance.now() - Math.max(seen.last, {RESTS}) > {RESTS}"""
# Asked of the browser itself: Playwright's own way has the page read scripts of its own, which block it for 60 ms.
ASKED = {"expression": f"{RESTED} ? seen : null", "returnByValue": True}


def visited(browser, address):
    """Return what one visit to a page finds, by its name. address: of a file."""
    context = browser.new_context(bypass_csp=True, **DESKTOP)
    context.add_init_script(WATCH)
    tab = context.new_page()
    protocol = context.new_cdp_session(tab)
    protocol.send("Emulation.setCPUThrottlingRate", {"rate": SLOWER})
    tab.goto(address)
    for _ in range(500):
        tab.wait_for_timeout(RESTS / 4)
        if seen := protocol.send("Runtime.evaluate", ASKED)["result"]["value"]:
            context.close()
            return {name: seen[name] for name in ("blocked", "shift", "picture")}
    raise TimeoutError(f"{address} never rests")


def measured(browser, sites, page, rounds):
    """Return {"now": …} of a page, and of the other site "before" where it has the page too. sites: {name: folder}."""
    files = {name: path for name, folder in sites.items() if (path := folder / f"{page}.html").is_file()}
    visits = [(name, visited(browser, files[name].as_uri())) for name in [*files] * rounds]
    found = {}
    for name in files:
        seen = [numbers for of, numbers in visits if of == name]
        found[name] = {what: median(numbers[what] for numbers in seen) for what in seen[0]}
        tqdm.write(f"{page:16} {name:6}" + "".join(f"  {what} {value:.4g}" for what, value in found[name].items()))
    return found


def measure(site, against, page, rounds):
    """Return the numbers of all pages; SystemExit where a folder has none of them."""
    sites = {"now": ROOT / site} | ({"before": ROOT / against} if against else {})
    for folder in sites.values():
        if not (folder / "index.html").is_file():
            raise SystemExit(f"{folder} is no built site: python -m book build makes one")
    with chromium() as browser:
        label = {"browser": f"Chromium {browser.version}", "slower": SLOWER, "rounds": rounds}
        pages = {name: measured(browser, sites, name, rounds) for name in tqdm(page, unit="page")}
    now = [seen["now"] for seen in pages.values()]
    worst = {f"worst_{what}": max(numbers[what] for numbers in now) for what in now[0]}
    return {"label": label, "numbers": {"load": load(), "cores": os.cpu_count()} | worst, "pages": pages}


if __name__ == "__main__":
    everything = list(page_files(ROOT / "book"))
    command("pages", __doc__, measure, site="book/_build/html", against="", page=everything, rounds=3)
