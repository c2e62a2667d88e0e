"""Measure, and write what was measured with a label:  python -m verify.benchmark

Runs the bench_*.py files of this folder under pytest-benchmark and writes results/frames.json and gradients.json:
{"label": {machine, cores, date, commit}, "numbers": {...}}, medians. The book prints from these files, so commit them.
"""

import argparse
import datetime
import json
import platform
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

from renderer.files import whole_file
from renderer.threads import available_cores
from verify.benchmark.bench_gradients import POINTS

HERE = Path(__file__).parent
RESULTS = HERE / "results"


def processor():
    """Return the processor's name, or the architecture where the system does not tell."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
        return next(line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or platform.machine()


def commit():
    """Return the short id of the commit that was measured, with + if the tree differs from it."""
    git = ["git", "-C", str(HERE)]
    head = subprocess.run([*git, "rev-parse", "--short", "HEAD"], capture_output=True, text=True, check=False)
    dirty = subprocess.run([*git, "status", "--porcelain", "-uno"], capture_output=True, text=True, check=False)
    return head.stdout.strip() + ("+" if dirty.stdout.strip() else "") if head.returncode == 0 else "unknown"


def label():
    """Return where and when: machine, cores, date, commit."""
    return {
        "machine": f"{processor()}, {available_cores()} cores, Python {platform.python_version()}",
        "date": datetime.date.today().isoformat(),
        "commit": commit(),
    }


def medians(file):
    """Run one bench file and return {parameters: median seconds}."""
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.json"
        options = ["-q", "-p", "no:cacheprovider", "-p", "no:xdist", "-o", "python_functions=bench_*"]
        status = pytest.main([str(HERE / file), f"--benchmark-json={report}", "--benchmark-min-rounds=15", *options])
        if status:
            raise SystemExit(f"{file}: pytest ended with status {int(status)}; nothing was written")
        found = json.loads(report.read_text(encoding="utf-8"))["benchmarks"]
    return {(b["name"].split("[")[0], *b["params"].values()): b["stats"]["median"] for b in found}


def frame_numbers(times):
    """Return the milliseconds of frames, and the ratio of the two pipelines."""
    numbers = {}
    for (name, *params), seconds in times.items():
        method = next(p for p in params if isinstance(p, str))
        size = next(p for p in params if isinstance(p, int))
        kind = "whole_" if name == "bench_whole_frame" else ""
        numbers[f"{kind}{method}_{size}_ms"] = 1e3 * seconds
    numbers["central_to_exact"] = numbers["central_1024_ms"] / numbers["exact_1024_ms"]
    numbers["general_to_exact"] = numbers["general_1024_ms"] / numbers["exact_1024_ms"]
    return numbers


def gradient_numbers(times):
    """Return the nanoseconds of one gradient by each method, and the ratio of central to exact."""
    numbers = {f"{method}_ns": 1e9 * seconds / POINTS for (_, method), seconds in times.items()}
    return numbers | {"central_to_exact": numbers["central_ns"] / numbers["exact_ns"]}


def main():
    """Measure both files and write the results."""
    argparse.ArgumentParser(prog="python -m verify.benchmark", description=__doc__).parse_args()
    RESULTS.mkdir(exist_ok=True)
    where = label()
    for name, numbers_of in (("frames", frame_numbers), ("gradients", gradient_numbers)):
        numbers = numbers_of(medians(f"bench_{name}.py"))
        with whole_file(RESULTS / f"{name}.json") as target:
            text = json.dumps({"label": where, "numbers": numbers}, indent=2, sort_keys=True)
            Path(target).write_text(text + "\n", encoding="utf-8")
        print(f"wrote verify/benchmark/results/{name}.json")
        for key, value in sorted(numbers.items()):
            print(f"  {key:24} {value:10.3f}")


if __name__ == "__main__":
    sys.exit(main())
