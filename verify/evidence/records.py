"""Records of long runs, in committed JSON that a build only reads; and whether the code has changed since.

A record holds a `label` (place, versions, day and commit of the run), the results, the hashes of all `code` that the
run could reach when it began, and a `seal`, the hash of all this. Where the code has changed, pages mark its numbers
with † and a release waits: `python -m verify.evidence --list` says why, `make evidence` measures anew. A record is an
entry of `[tool.symbolic-book.records]` and a command that calls `command`; only a `Run` writes one. The seal shows that
a record was edited or merged by hand. It keeps nobody from forging one: who wants to can compute it.
"""

import argparse
import datetime
import json
import platform
import re
import subprocess
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cache
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from proofs.engine.project import PROJECT
from renderer.threads import available_cores
from renderer.whole_files import write_whole
from verify.evidence import sources
from verify.evidence.sources import ROOT

RESULTS, BENCHMARKS = PROJECT.results, PROJECT.benchmarks
PROSE = {".md", ".bib"}


@dataclass(frozen=True)
class Record:
    """A record: NAME.json in `folder`, and the run that writes it.

    command: what Python is given to measure it. begins: patterns of the files whose imports are the run's code, and
    folders of which it may reach everything. packages: the libraries that it names. needs: those without which it
    would leave something out.
    """

    name: str
    folder: str
    command: str
    begins: Sequence[str]
    packages: Sequence[str] = ("numpy", "llvmlite")
    needs: Sequence[str] = ()

    @property
    def path(self) -> str:
        """Its path from the root."""
        return f"{self.folder}/{self.name}.json"


RECORDS = {name: Record(name, **fields) for name, fields in PROJECT.records.items()}


def processor() -> str:
    """Return the processor's name, or the architecture where the system does not tell."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
        return next(line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or platform.machine()


def commit() -> str:
    """Return the short id of the commit that is measured, with + if the tree differs from it, records aside."""
    head = _git("rev-parse", "--short", "HEAD")
    dirty = head and _git(
        "status", "--porcelain", "-uno", "--", ":/", f":(exclude){RESULTS}", f":(exclude){BENCHMARKS}"
    )
    return f"{head}+" if dirty else head or "unknown"


def _git(*arguments):
    """Return what git prints, nothing where it fails."""
    command = ["git", "-C", str(ROOT), *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout.strip()


def label(packages: Iterable[str]) -> dict[str, Any]:
    """Return where, with what and when a run is made, as text: machine, processor, python, date, commit."""
    python, versions = f"Python {platform.python_version()}", [f"{name} {version(name)}" for name in packages]
    return {
        "machine": ", ".join([processor(), f"{available_cores()} cores", python, *versions]),
        "processor": processor(),
        "python": python,
        "date": datetime.date.today().isoformat(),
        "commit": commit(),
    }


@cache
def code_of(name: str) -> dict[str, str]:
    """Return {file: its hash} of all code that a record's run can reach, and {library: version} of what the lock pins.

    Data files beside the code belong to it, and tests if the run is about them; prose, comments and records do not.
    """
    reached: set[Path] = set()
    for begin in (path for pattern in RECORDS[name].begins for path in ROOT.glob(pattern)):
        reached |= {*sources.files_in(begin)} if begin.is_dir() else sources.reachable(begin)
    records = {ROOT / folder for folder in (RESULTS, BENCHMARKS)}
    code = sources.code_hashes(path for path in reached if path.suffix not in PROSE and path.parent not in records)
    lock = (ROOT / "requirements.lock").read_text(encoding="utf-8")
    pins = [re.findall(rf"^{package}==([^\s;\\]+)", lock, re.MULTILINE) for package in RECORDS[name].packages]
    return code | {p: " ".join(versions) for p, versions in zip(RECORDS[name].packages, pins, strict=True) if versions}


def _seal(content):
    return sources.key({key: value for key, value in content.items() if key != "seal"})


class Run:
    """A run that measures a record: make it before anything is measured, and write what was found at the end."""

    def __init__(self, name: str):
        PROJECT.require_writable()
        self.record, self.code = RECORDS[name], code_of(name)
        self.label = label([*self.record.packages, *filter(find_spec, self.record.needs)])

    def write(self, measured: dict[str, Any], folder: Path | None = None) -> Path:
        """Write {"label": …} and what was measured, whole or not at all; return the path.

        measured: {"numbers": …} or what else a record holds; its "label" is added to the run's.
        """
        content = {"label": None} | measured | {"label": self.label | measured.get("label", {}), "code": self.code}
        path = (folder or ROOT / self.record.folder) / f"{self.record.name}.json"
        write_whole(path, (json.dumps(content | {"seal": _seal(content)}, indent=1) + "\n").encode())
        return path


def read(name: str) -> dict[str, Any]:
    """Return what a record holds."""
    return json.loads((ROOT / RECORDS[name].path).read_text(encoding="utf-8"))


def why_stale(name: str) -> str | None:
    """Return why a record's numbers are not those of the code as it is, in a few words; None if they are."""
    content = read(name)
    if not {"code", "seal"} <= content.keys():
        return "it does not say which code was measured"
    if content["seal"] != _seal(content):
        return "it was changed after it was written"
    return sources.difference(content["code"], code_of(name))


@cache
def remark(name: str) -> str | None:
    """Return the remark that a stale record's numbers need, None for a fresh one; found once a process."""
    if not why_stale(name):
        return None
    return f"measured at commit {read(name)['label']['commit']}; the code has changed since"


def command(
    name: str, doc: str, measure: Callable[..., dict[str, Any]], arguments: list[str] | None = None, **options: Any
) -> dict[str, Any]:
    """Run a record's command line and return what measure(**options) found; print its numbers, and write the record.

    options: {name: default}, a whole number above 0, a text, a list, or False for a flag. The record is written only of
    a run with the defaults, unless a folder is given.
    """
    formatter = argparse.RawDescriptionHelpFormatter
    parser = argparse.ArgumentParser(f"python {RECORDS[name].command}", description=doc, formatter_class=formatter)
    for option, default in options.items():
        if default is False:
            parser.add_argument(f"--{option}", action="store_true")
        else:
            several = isinstance(default, list)
            kind, many = type(default[0] if several else default), "*" if several else None
            parser.add_argument(f"--{option}", default=default, nargs=many, type=_above_0 if kind is int else kind,
                                help="default: %(default)s")  # fmt: skip
    parser.add_argument("--output", type=Path, metavar="FOLDER", help="write the record there, whatever was measured")
    chosen = vars(parser.parse_args(arguments))
    folder, run = chosen.pop("output"), Run(name)
    measured = measure(**chosen)
    for key, value in measured.get("numbers", {}).items():
        print(f"  {key:36} {value:12.4g}" if isinstance(value, float) else f"  {key:36} {value!s:>12}")
    if folder or chosen == options:
        print(f"wrote {run.write(measured, folder).name}")
    else:
        print("not kept: --output FOLDER keeps what was not measured with the defaults")
    return measured


def _above_0(text):
    if int(text) < 1:
        raise argparse.ArgumentTypeError(f"{text} is not allowed: at least 1")
    return int(text)
