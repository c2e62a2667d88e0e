"""The proofs' run in pytest: options, one table at the end, one report for the book."""

import json
import time

import pytest

from proofs.engine.project import PROJECT
from proofs.engine.theorem import all_theorems
from renderer.whole_files import write_whole
from verify.checkers import theorem_files
from verify.checkers.grades import NOT_RECHECKED, graded, summary
from verify.coq import formal
from verify.optional import lacking

EVIDENCE = []
TOOK = {}
AGREED = set()
"""In the process that controls the workers: the evidence that tests' reports carry, {theorem: how long it took}, and
who agreed in this run: Coq with its record, the second checker with the kernel"""


def pytest_addoption(parser):
    group = parser.getgroup("proofs")
    group.addoption("--theorem", metavar="ID", action="append", help="only this theorem and those that it uses")
    group.addoption(
        "--search", action="store_true", help="find every certificate anew instead of reading the stored ones"
    )
    if not any("--long" in option.names() for option in parser._anonymous.options):
        group.addoption("--long", action="store_true", help="also what takes minutes")


def pytest_configure(config):
    """Refuse files of theorems that are more than data, before any is imported: a program could change its judges."""
    if refused := theorem_files.refused():
        raise pytest.UsageError("a file of theorems is data: " + "; ".join(refused))


def pytest_ignore_collect(collection_path, config):
    """Ignore the other tests where --theorem is given: they are not even imported."""
    others = collection_path.name.startswith("test_") and collection_path.name != "test_theorems.py"
    return True if config.getoption("theorem") and others else None


class _Module(pytest.Module):
    """A file of tests that is skipped, by name, where a library that it needs is not installed."""

    def collect(self):
        try:
            return super().collect()
        except self.CollectError as error:
            if library := lacking(error):
                pytest.skip(f"needs {library}", allow_module_level=True)
            raise


def pytest_pycollect_makemodule(module_path, parent):
    return _Module.from_parent(parent, path=module_path)


def pytest_generate_tests(metafunc):
    """Test the theorems that --theorem names, and those that they use; without it, all."""
    if "theorem_id" in metafunc.fixturenames:
        theorems = all_theorems()
        wanted = {*(metafunc.config.getoption("theorem") or theorems)}
        if unknown := wanted - theorems.keys():
            raise pytest.UsageError(f"--theorem: there is no {', '.join(sorted(unknown))}")
        for theorem in reversed(theorems.values()):  # each stands after those that it uses
            wanted |= {*theorem.uses} if theorem.id in wanted else set()
        metafunc.parametrize("theorem_id", [id for id in theorems if id in wanted])


def pytest_collection_modifyitems(config, items):
    """Skip what is marked long without --long."""
    if not config.getoption("--long"):
        for item in items:
            if item.get_closest_marker("long"):
                item.add_marker(pytest.mark.skip(reason="takes minutes; run with --long"))


@pytest.fixture
def record_evidence(record_property):
    """Return a function that hands a theorem's evidence to the process that writes the report.

    took: how the time is told; by default that since the test began.
    """
    start = time.perf_counter()

    def record(entry, took=None):
        record_property("evidence", json.dumps(entry, ensure_ascii=False))
        record_property("took", took or f"{time.perf_counter() - start:.2f} s")

    return record


def pytest_runtest_logreport(report):
    properties = dict(report.user_properties)
    if report.passed and "agreed" in properties:
        AGREED.add(properties["agreed"])
    if report.when == "call" and "evidence" in properties:
        EVIDENCE.append(json.loads(properties["evidence"]))
        TOOK[EVIDENCE[-1]["id"]] = properties["took"]


def _results():
    """Return the entries of the report in order of the ids."""
    return graded(EVIDENCE, formal.proved(all_theorems().values()) if "Coq" in AGREED else ())


def _told(entry):
    """Return how a run names a grade: formal, where Coq agreed in this run; else with the day that the record has."""
    theorem = all_theorems()[entry["id"]]
    if entry["grade"] != "proved" or not formal.proved([theorem]):
        return entry["grade_line"]
    if "Coq" in AGREED:
        return "formal"
    return f"{'' if theorem.pinned or theorem.rounded else entry['grade_line'] + '; '}recorded on {formal.day()}"


def pytest_sessionfinish(session, exitstatus):
    """Fail a run in which a theorem misses its expected grade; write the report when every theorem was run."""
    config = session.config
    if hasattr(config, "workerinput") or not EVIDENCE:
        return
    entries = [entry for entry in _results() if entry["grade"] != NOT_RECHECKED]
    partial = config.getoption("keyword") or config.getoption("theorem")
    if any(e["grade"] != e["expected"] for e in entries) and not partial and session.exitstatus == 0:
        session.exitstatus = pytest.ExitCode.TESTS_FAILED
    if PROJECT.writable and {entry["id"] for entry in entries} == all_theorems().keys():
        asked = {"the second checker": "the second checker" in AGREED, "Coq": formal.accepted_here()}
        report = {"version": 1, "summary": summary(entries), "theorems": entries, "asked": asked}
        write_whole(PROJECT.report, (json.dumps(report, indent=1, ensure_ascii=False, sort_keys=True) + "\n").encode())


def pytest_terminal_summary(terminalreporter):
    _tell_what_was_left_out(terminalreporter)
    if not EVIDENCE:
        return
    terminalreporter.section("theorems")
    told: list[str] = []
    for entry in (results := _results()):
        good = entry["grade"] in (entry["expected"], NOT_RECHECKED)
        mark = "" if good else f"   expected {entry['expected']}  {entry.get('reason', '')}"
        told.append(_told(entry))
        line = f"{entry['id']:32} {told[-1]:9} {TOOK[entry['id']]:>8}   mutants {entry['killed']}{mark}"
        terminalreporter.write_line(line, red=bool(mark))
    counts = summary(results).items()
    formally = f"; formal: {told.count('formal')}" if "Coq" in AGREED else ""
    terminalreporter.write_line(", ".join(f"{n} {key.replace('_', ' ')}" for key, n in counts) + formally)


def _tell_what_was_left_out(terminalreporter):
    """List which evidence was not re-checked for want of a program or library: files of tests, theorems, a checker."""
    skipped = [(report.nodeid, str(report.longrepr[2])) for report in terminalreporter.stats.get("skipped", ())]
    lines = sorted({f"{where}: {why.removeprefix('Skipped: ')}" for where, why in skipped if "needs " in why})
    if lines:
        terminalreporter.section("not re-checked here")
        for line in lines:
            terminalreporter.write_line(line)
