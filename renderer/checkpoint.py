"""Results that survive the process: a file of JSON lines, one a result, that is only ever appended to."""

import hashlib
import json
import os
import sys
from collections.abc import Iterable, Mapping
from dataclasses import asdict
from functools import cache
from pathlib import Path

import numpy as np

from renderer.checks import not_allowed
from renderer.files import checked_target
from renderer.machines import machine
from renderer.sweep import SweepRow, Task

_START = b'{"key": '


@cache
def version() -> str:
    """Return a hash of what computes a result: the renderer's sources, the machine that draws, NumPy, llvmlite."""
    drawing, folder = machine().NAME, Path(__file__).parent  # llvmlite is loaded then, if it draws
    llvmlite = getattr(sys.modules.get("llvmlite"), "__version__", None)
    digest = hashlib.sha256(f"{drawing} {np.__version__} {llvmlite}".encode())
    for path in sorted([*folder.glob("*.py"), *folder.glob("machines/*.py")]):
        digest.update(path.name.encode() + path.read_bytes())
    return digest.hexdigest()


def key_of(task: Task) -> str:
    """Return a hash of a Task and of what computes it: equal keys, equal results."""
    return hashlib.sha256(json.dumps([asdict(task), version()], sort_keys=True).encode()).hexdigest()


class Checkpoint:
    """The results kept in a .jsonl file: `rows`, by the key of their task.

    A line is {"key": …, "task": …, "row": …}. A last line without an end (its writer was killed) is dropped. Raises
    ValueError if the file cannot be written or holds anything but results. One sweep at a time may write to it.
    """

    def __init__(self, path: str | Path):
        self.path, self.rows = checked_target(path, (".jsonl",), "checkpoint"), {}
        content = self.path.read_bytes() if self.path.exists() else b""
        *lines, torn = content.split(b"\n")
        for number, line in enumerate(lines, 1):
            try:
                record = json.loads(line)
                self.rows[record["key"]] = SweepRow(**record["row"])
            except (ValueError, KeyError, TypeError):
                raise self._none(number) from None
        if torn[: len(_START)] != _START[: len(torn)]:
            raise self._none(len(lines) + 1)
        if torn:
            os.truncate(self.path, len(content) - len(torn))

    def _none(self, number):
        return not_allowed("checkpoint", str(self.path), f"a file of results, and its line {number} is none")

    def kept(self, tasks: Iterable[Task]) -> dict[Task, SweepRow]:
        """Return {task: row} of those of the tasks that are kept."""
        keys = {task: key_of(task) for task in tasks}
        return {task: self.rows[key] for task, key in keys.items() if key in self.rows}

    def append(self, results: Mapping[Task, SweepRow]) -> None:
        """Keep {task: row}; when this returns, they are on the disk."""
        keys = {task: key_of(task) for task in results}
        lines = [{"key": keys[task], "task": asdict(task), "row": asdict(row)} for task, row in results.items()]
        with open(self.path, "ab") as file:
            file.write("".join(json.dumps(line) + "\n" for line in lines).encode())
            file.flush()
            os.fsync(file.fileno())
        self.rows |= {keys[task]: row for task, row in results.items()}
