"""Where, with what and when something was measured: the label of every committed result that a build does not make."""

import argparse
import datetime
import importlib.metadata
import json
import os
import platform
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

from renderer.picture.threads import available_cores
from renderer.whole_files import write_whole
from verify.sources import ROOT

RESULTS = Path(__file__).parent / "results"
BUSY = 0.5  # a load of more than this spoils a measurement


def processor() -> str:
    """Return the processor's name, or the architecture where the system does not tell."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
        return next(line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or platform.machine()


def commit() -> str:
    """Return the short id of the commit that was measured, with + if the tree differs from it, results aside."""
    git = ["git", "-C", str(ROOT)]
    head = subprocess.run([*git, "rev-parse", "--short", "HEAD"], capture_output=True, text=True, check=False)
    if head.returncode:
        return "unknown"
    status = [*git, "status", "--porcelain", "-uno", "--", ":/", ":(exclude,glob)verify/**/results/*"]
    dirty = subprocess.run(status, capture_output=True, text=True, check=False)
    return head.stdout.strip() + ("+" if dirty.stdout.strip() else "")


def label(*packages: str) -> dict[str, str]:
    """Return where, with what and when, as text: machine (all of it), processor, python, versions, date, commit."""
    versions = ", ".join(f"{name} {importlib.metadata.version(name)}" for name in packages)
    python = f"Python {platform.python_version()}"
    return {
        "machine": f"{processor()}, {available_cores()} cores, {python}, {versions}",
        "processor": processor(),
        "python": python,
        "versions": versions,
        "date": datetime.date.today().isoformat(),
        "commit": commit(),
    }


def load() -> float:
    """Return how many processes wanted a core during the last minute, and say so if the machine is busy."""
    busy = os.getloadavg()[0] if hasattr(os, "getloadavg") else 0.0
    if busy > BUSY:
        print(f"this machine is busy (load {busy:.1f}): its times will be too long", file=sys.stderr)
    return busy


def write(path: Path, content: object) -> None:
    """Write a result with its label as JSON, whole or not at all."""
    write_whole(path, (json.dumps(content, indent=1) + "\n").encode())


def command(
    name: str, doc: str, measure: Callable[[int], dict[str, float]], rounds: int, arguments: list[str] | None
) -> None:
    """Run `python -m verify.benchmark.NAME`: measure(rounds), print the numbers, write them as NAME.json."""
    parser = argparse.ArgumentParser(f"python -m verify.benchmark.{name}", description=doc.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=rounds, help="timed rounds (default: %(default)s)")
    parser.add_argument("--output", type=Path, default=RESULTS, metavar="FOLDER", help="where the result is written")
    options = parser.parse_args(arguments)
    numbers = {"load": load(), "rounds": options.rounds} | measure(options.rounds)
    print("\n".join(f"  {name:32} {value:8.3g}" for name, value in numbers.items()))
    write(options.output / f"{name}.json", {"label": label("numpy", "llvmlite"), "numbers": numbers})
