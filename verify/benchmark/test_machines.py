"""Both machines are timed, draw the same bytes, and a byte that is not the same is counted. No time is asserted."""

import json
from types import SimpleNamespace

from renderer.machines import native
from verify.benchmark import machines


def test_a_small_run_writes_every_machine_and_method(tmp_path):
    machines.main(["--rounds", "2", "--output", str(tmp_path)])
    numbers = json.loads((tmp_path / "machines.json").read_text(encoding="utf-8"))["numbers"]
    assert numbers["differing"] == 0
    for name in machines.MACHINES:
        for key in (*(f"{name}_{method}_ms" for method in machines.METHODS), f"{name}_central_to_exact"):
            assert 0 < numbers[f"{key}_low"] <= numbers[key] <= numbers[f"{key}_high"]


def test_a_machine_that_draws_other_bits_is_seen(monkeypatch):
    def drawer(want, job):
        draw = native.drawer(want, job)

        def wrong(rows):
            counted = draw(rows)
            job.planes["red"][:] *= 1 + 2**-50
            return counted

        return wrong

    other = SimpleNamespace(drawer=drawer, NAME="other")
    monkeypatch.setitem(machines.MACHINES, "numpy", other)
    assert machines.differing_bytes("exact") > 0


def test_the_kept_run_found_no_difference():
    result = json.loads((machines.RESULTS / "machines.json").read_text(encoding="utf-8"))
    assert result["numbers"]["differing"] == 0
    assert {"machine", "date", "commit"} <= result["label"].keys()
