"""Python in a process of its own."""

import subprocess
import sys
import time

from verify.sources import ROOT


def python(*arguments, status=0, cwd=ROOT, **options):
    """Run this Python, which has to end with the status; return what it printed, and what it complained of."""
    command = [sys.executable, *map(str, arguments)]
    done = subprocess.run(command, cwd=cwd, capture_output=True, encoding="utf-8", **options)
    assert done.returncode == status, done.stdout + done.stderr
    return done.stdout, done.stderr


def started(*arguments, **options):
    """Start this Python; what it prints, and what it complains of, can be read as text."""
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "encoding": "utf-8"}
    return subprocess.Popen([sys.executable, *map(str, arguments)], cwd=ROOT, **pipes | options)


def wait_until(condition, child):
    """Wait until a condition holds while a process runs, two minutes at most."""
    deadline = time.monotonic() + 120
    while not condition():
        assert child.poll() is None, child.stderr.read()
        assert time.monotonic() < deadline
        time.sleep(0.001)
