"""The simulator's page in a browser: opening it, moving its controls, waiting for its pictures."""

from contextlib import contextmanager

RUNNING = "window.Simulator && Simulator.running && Simulator.running.frames.length > 0"


@contextmanager
def visited(browser, address, started=True, prepare="", compiled=None, asked=None, **options):
    """Give the page in a context of its own; no error may have been logged when it is closed.

    started: wait for the first picture. prepare: a script to run before the page's own. compiled: what to give for
    compiled.js. asked: a list that takes the address of every request. options: as Playwright's new_context.
    """
    context, complaints = browser.new_context(**{"viewport": {"width": 1280, "height": 900}} | options), []
    context.add_init_script(prepare)
    if compiled:
        context.route("**/compiled.js", lambda route: route.fulfill(body=compiled, content_type="text/javascript"))
    page = context.new_page()
    page.on("console", lambda message: complaints.append(message.text) if message.type == "error" else None)
    page.on("pageerror", lambda error: complaints.append(str(error)))
    if asked is not None:
        page.on("request", lambda request: asked.append(request.url))
    page.goto(address)
    if started:
        page.wait_for_function(RUNNING)
    yield page
    context.close()
    assert complaints == []


def state(tab):
    """Return the page's state."""
    return tab.evaluate("Simulator.running.act.state()")


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
