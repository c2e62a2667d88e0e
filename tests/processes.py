"""Python in a process of its own."""

import subprocess
import sys

from verify.sources import ROOT


def python(*arguments, status=0, cwd=ROOT, **options):
    """Run this Python, which has to end with the status; return what it printed, and what it complained of."""
    command = [sys.executable, *map(str, arguments)]
    done = subprocess.run(command, cwd=cwd, capture_output=True, encoding="utf-8", **options)
    assert done.returncode == status, done.stdout + done.stderr
    return done.stdout, done.stderr
