"""Fixtures of the book's tests: the built site, a server for it, and a browser."""

import os
import re
import subprocess

import pytest
from filelock import FileLock
from playwright.sync_api import expect

from book.assembly import stamps, website
from book.editions import files
from book.editions.chromium import NoBrowser
from book.editions.pages import parsed
from tests.processes import python, started
from tests.tabs import chromium, visits


@pytest.fixture(scope="session")
def site():
    """The folder of the built site, which `make test` has built; else several workers may ask for it at once."""
    if "BOOK_BUILT" not in os.environ:
        python("-m", "book", "build")
    return website.SITE


@pytest.fixture(scope="session")
def html_of(site):
    """A function: a page's name → the built page."""
    return lambda name: (site / f"{name}.html").read_text("utf-8")


@pytest.fixture(scope="session")
def page_of(html_of):
    """A function: a page's name → the built page, parsed anew."""
    return lambda name: parsed(html_of(name))


@pytest.fixture
def stamped(monkeypatch, tmp_path):
    """Stamps in a folder of their own, which is given."""
    monkeypatch.setattr(stamps, "STAMPS", tmp_path / "stamps")
    return tmp_path


@pytest.fixture(scope="session")
def single(site):
    """The path of the one-file edition, which one worker makes."""
    with FileLock(stamps.STAMPS / "single.lock"):
        files.make("single", files.SINGLE, files.single_file)
    return files.SINGLE


@pytest.fixture(scope="session")
def server(site):
    """The site's address on this machine alone."""
    command = ("-u", "-m", "http.server", "0", "--bind", "127.0.0.1", "--directory", site)
    with started(*command, stderr=subprocess.DEVNULL) as running:
        yield re.search(r"http://[\d.:]+", running.stdout.readline())[0]
        running.terminate()


@pytest.fixture(scope="session")
def browser():
    """The installed Chromium. Without one the tests are skipped, unless REQUIRE_BROWSER=1 forbids it."""
    expect.set_options(timeout=30_000)  # as long as Playwright waits elsewhere
    try:
        with chromium() as running:
            yield running
    except NoBrowser as reason:
        if os.environ.get("REQUIRE_BROWSER") == "1":
            pytest.fail(f"{reason}, and REQUIRE_BROWSER=1")
        pytest.skip(str(reason))


@pytest.fixture(params=["http", "file"])
def scheme(request):
    """Open a page over http, or from the disk."""
    return request.param


@pytest.fixture
def base(scheme, site, server):
    """Return the start of the addresses of the site's pages."""
    return server if scheme == "http" else site.as_uri()


visit = pytest.fixture(visits)
visit_once = pytest.fixture(visits, scope="module")  # its pages stay open for all tests of a file


@pytest.fixture(scope="module")
def tab(visit_once):
    """The simulator's page, when it runs."""
    return visit_once("s4")
