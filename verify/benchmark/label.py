"""Where, with what and when something was measured: the label of every committed result that a build does not make."""

import datetime
import importlib.metadata
import json
import platform
import subprocess
from pathlib import Path

from renderer.files import write_whole
from renderer.threads import available_cores

ROOT = Path(__file__).resolve().parents[2]


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


def write(path: Path, content: object) -> None:
    """Write a result with its label as JSON, whole or not at all."""
    write_whole(path, (json.dumps(content, indent=1) + "\n").encode())
