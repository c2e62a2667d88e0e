"""Results that survive the process: a file of JSON lines, one a result, that is only ever appended to."""

import json
import os
from dataclasses import asdict

from renderer.files import checked_target
from renderer.sweep import SweepRow

SUFFIXES = (".jsonl",)
_START = b'{"key": '


class Checkpoint:
    """The results kept in a .jsonl file: `rows`, by the key of their task.

    A line is {"key": …, "task": …, "row": …}. A last line without an end (its writer was killed) is dropped. Raises
    ValueError if the file cannot be written or holds anything but results. One sweep at a time may write to it.
    """

    def __init__(self, path):
        self.path = checked_target(path, SUFFIXES, "checkpoint")
        content = self.path.read_bytes() if self.path.exists() else b""
        *lines, torn = content.split(b"\n")
        self.rows = dict(self._read(number, line) for number, line in enumerate(lines, 1))
        if torn:
            self._drop(torn, len(lines) + 1, len(content) - len(torn))

    def _read(self, number, line):
        try:
            record = json.loads(line)
            return record["key"], SweepRow(**record["row"])
        except (ValueError, KeyError, TypeError):
            self._reject(number)

    def _drop(self, torn, number, size):
        if not (torn.startswith(_START) or _START.startswith(torn)):
            self._reject(number)
        os.truncate(self.path, size)

    def _reject(self, number):
        raise ValueError(
            f"checkpoint = {str(self.path)!r} is not allowed: a file of results, and its line {number} is none"
        )

    def append(self, tasks, rows):
        """Keep the row of every task; when this returns, they are on the disk."""
        results = list(zip(tasks, rows, strict=True))
        records = [{"key": task.key, "task": asdict(task), "row": asdict(row)} for task, row in results]
        with open(self.path, "ab") as file:
            file.write("".join(json.dumps(record) + "\n" for record in records).encode())
            file.flush()
            os.fsync(file.fileno())
        self.rows |= {task.key: row for task, row in results}
