"""Python, and other programs, in a process of their own."""

import os
import subprocess
import sys

from verify.evidence.sources import ROOT


def run(*command, status=0, cwd=ROOT, **options):
    """Run a command, which has to end with the status; return what it printed, and what it complained of."""
    done = subprocess.run([*map(str, command)], cwd=cwd, capture_output=True, encoding="utf-8", **options)
    assert done.returncode == status, done.stdout + done.stderr
    return done.stdout, done.stderr


def python(*arguments, **options):
    """Run this Python, as `run` does."""
    return run(sys.executable, *arguments, **options)


def settings_without(beginning):
    """Return the environment but for the variables whose names begin so."""
    return {name: value for name, value in os.environ.items() if not name.startswith(beginning)}


def started(*arguments, **options):
    """Start this Python; what it prints, and what it complains of, can be read as text."""
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "encoding": "utf-8"}
    return subprocess.Popen([sys.executable, *map(str, arguments)], cwd=ROOT, **pipes | options)
