"""The book's pages in a browser: opened in one way, and all held to the same; and the simulator's controls."""

from contextlib import ExitStack, contextmanager
from functools import partial
from urllib.parse import urljoin

from playwright.sync_api import expect, sync_playwright

from book.editions.chromium import FLAGS, installed

DESKTOP = {"viewport": {"width": 1280, "height": 900}}
PHONE = {"viewport": {"width": 400, "height": 850}, "is_mobile": True, "has_touch": True}
RUNNING = "window.Simulator && Simulator.running && Simulator.running.frames.length > 0"
CERTAIN = "#certified td:has-text('e')"  # once the certified bounds are there

# Run before a page's own scripts, it counts in `seen` how far the layout shifts.
WATCH = """
    window.seen = { shift: 0 };
    new PerformanceObserver(list => list.getEntries().forEach(shift => {
        if (!shift.hadRecentInput) seen.shift += shift.value;
    })).observe({ type: 'layout-shift' });
"""


def wait_for(tab, condition, arg=None):
    """Ask until it is so. Playwright's own way evaluates a text in the page, which the pages' policy forbids."""
    for _ in range(1500):
        if tab.evaluate(condition, arg):
            return
        tab.wait_for_timeout(20)
    raise AssertionError(f"never came true: {condition}")


@contextmanager
def chromium():
    """Give the installed Chromium, with a fresh profile. Raises NoBrowser where there is none."""
    path = installed()
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=path, args=FLAGS)
        yield browser
        browser.close()


@contextmanager
def opened(browser, address, until=None, prepare="", home=None, **options):
    """Give the page in a context of its own. When it is closed it may have asked for nothing elsewhere, and have logged
    no error.

    until: what to wait for. prepare: a script to run before the page's own. home: what addresses begin with that it may
    ask for. options: as Playwright's new_context.
    """
    context, asked, complaints = browser.new_context(**DESKTOP | {"reduced_motion": "reduce"} | options), [], []
    context.add_init_script(prepare)
    tab = context.new_page()
    tab.wait_for_function = partial(wait_for, tab)
    tab.on("console", lambda message: complaints.append(message.text) if message.type == "error" else None)
    tab.on("pageerror", lambda error: complaints.append(str(error)))
    tab.on("request", lambda request: asked.append(request.url))
    tab.goto(address)
    if until and options.get("java_script_enabled", True):
        try:
            tab.wait_for_function(until)
        except AssertionError as error:
            error.add_note(f"the page complains of {complaints}")
            raise
    yield tab
    context.close()
    home = home or urljoin(address, "/")
    assert [url for url in asked if not url.startswith((home, "blob:", "data:"))] == []
    assert asked and not complaints, complaints


def visits(browser, site, server):
    """A function that opens a page of the site by its name, over http or from the disk; §4 when its simulator runs."""
    with ExitStack() as pages:

        def visit(page, scheme="http", fragment="", folded=False, **options):
            base = server if scheme == "http" else site.as_uri()
            until = {"until": RUNNING} if page == "s4" else {}
            tab = pages.enter_context(opened(browser, f"{base}/{page}.html{fragment}", **until | options))
            if not folded:
                tab.evaluate("document.querySelectorAll('.sim-fold').forEach(fold => { fold.open = true })")
            return tab

        yield visit


def says(tab, place, text):
    """Wait until a place of the page says this; text: all of it, or a pattern that it has."""
    expect(tab.locator(place)).to_have_text(text)


def number(text):
    """Return the number that a page prints."""
    return float(text.replace("−", "-"))


def readout(tab, name):
    """Return a number beside the simulator's pictures."""
    return number(tab.inner_text(f"[data-readout={name}]"))


def next_frame(tab):
    """Wait until the page has been laid out, and what watches its size has been told."""
    tab.evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")


def state(tab):
    """Return the simulator's state."""
    return tab.evaluate("Simulator.running.act.state()")


def becomes(tab, **wanted):
    """Wait until the simulator's state has these values."""
    script = "wanted => Object.entries(wanted).every(([name, is]) => Simulator.running.act.state()[name] === is)"
    tab.wait_for_function(script, arg=wanted)


def slide(tab, name, value):
    """Move a slider, as a hand does."""
    script = """([name, value]) => { const s = document.getElementById(`sim-${name}`); s.value = value;
        s.dispatchEvent(new Event('input', { bubbles: true })) }"""
    tab.evaluate(script, [name, value])


def go(tab, address):
    """Give the page a new fragment."""
    tab.evaluate("address => { location.hash = address }", address)


def settled(tab):
    """Wait until the pictures are those of the state."""
    tab.wait_for_function("""() => { const { states, act, shown } = Simulator.running, drawn = shown();
        return drawn && drawn.replace(/&column.*/, '') === states.fragment(act.state()).replace(/&column.*/, '') }""")
