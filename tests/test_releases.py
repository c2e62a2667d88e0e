"""Releases: what moved is named, what must be named is, and two builds that differ are told apart."""

import copy
import re
import sys
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from matplotlib.figure import Figure
from PIL import Image

import book.__main__ as command_line
from book.assembly import report, stamps
from book.drawing import save
from book.drawing.registry import Drawing, Registered
from book.releases import archive, command, compare, notes as release_notes, record, same_bytes
from proofs.engine.theorem import all_theorems
from proofs.engine.vectors import real
from tests.processes import run

GRADES = {
    "unit_length": {"grade": "proved", "given": [], "statement": "$|N| = 1$"},
    "known_lemma": {"grade": "proved", "given": ["DLMF"], "statement": "$x < y$"},
    "sampled": {"grade": "measured", "given": [], "statement": "small"},
}
STEPS = np.array([1e-1, 1e-2, 1e-3, 1e-4, 1e-5])
PIXELS = np.arange(8 * 9 * 3, dtype=np.uint8).reshape(8, 9, 3)


def draw_into(folder, rms=0.0121, pixels=PIXELS, heights=STEPS**2):
    """Draw a plot, a render and a table of numbers."""

    def plot():
        """A curve."""
        fig = Figure(figsize=(3, 2))
        fig.subplots().plot(STEPS, heights, label="rms")
        numbers = {"rms_1e-3": rms, "rms_1e-3_at": 1e-3, "flips": 0, "date": "2026-01-01"}
        return Drawing(fig, numbers=numbers)

    def render():
        """Pixels."""
        return Drawing(pixels)

    for id, function in (("sweep", plot), ("hero", render)):
        save.save(Registered(id, function), folder, "book/figures/x.py", "key")


@pytest.fixture
def places(stamped, monkeypatch):
    """A project with drawn figures, three theorems (`grades`, which a test may change) and its first release."""
    modules = {"releases": archive, "generated": record, "changelog": release_notes, "out": command}
    paths = SimpleNamespace(**{name: stamped / name for name in modules}, grades=copy.deepcopy(GRADES))
    for name, module in modules.items():
        monkeypatch.setattr(module, name.upper(), stamped / name)
    other = "\n- unit_length, sweep.rms_1e-3\n\n"
    paths.changelog.write_text(f"## 0.1.0.1\n{other}## 0.1.0 (unreleased)\n\n- A line.\n\n## 0.0.1\n{other}")
    monkeypatch.setattr(record, "theorems", lambda: copy.deepcopy(paths.grades))
    monkeypatch.setattr(record, "version", lambda: "0.1.0")
    monkeypatch.setattr(report, "make", lambda: None)
    monkeypatch.setattr(command_line, "figures", lambda: None)
    monkeypatch.setattr(command_line.evidence, "stale", lambda: {})
    draw_into(paths.generated)
    assert command_line.main(["release"]) == 0
    return paths


@pytest.fixture
def notes(places):
    """A function: the status and the text of the notes as they are now."""
    return lambda: (command_line.main(["release-notes"]), (places.out / "notes.md").read_text())


def released(places):
    return {name: path.read_bytes() for name, path in same_bytes.files_of(places.releases).items()}


def test_what_moved_is_named_and_nothing_is_released_that_the_changelog_does_not_name(places, notes):
    """First nothing moves; then a theorem is weaker, a number moved by 1e-3, pictures changed; last looks alone."""
    before, heights, pixels = released(places), STEPS**2, PIXELS.copy()
    draw_into(places.generated)
    status, output = notes()
    assert status == 0 and "Nothing moved." in output
    assert command_line.main(["release"]) == 0 and released(places) == before
    places.grades["unit_length"]["grade"] = "measured"
    heights[1] *= 1.25
    pixels[2, 3, 1] += 40
    moved = {"rms": 0.0121 * (1 + 1e-3), "pixels": pixels, "heights": heights}
    draw_into(places.generated, **moved)
    status, output = notes()
    assert status == 1
    for words in (
        "Weakened: 1\n\n- `unit_length`: proved → measured",
        "Out of tolerance: 1\n\n- `sweep.rms_1e-3`: 0.0121 → 0.012112",
        "- `hero`: largest difference 40/255, RMS 4.71/255, 1 of 72 pixels",
        "- `sweep`: its pixels or plotted numbers; a build of the older version's tag has those before",
        "- `unit_length` (weakened)\n- `sweep.rms_1e-3` (out of tolerance)\n",
    ):
        assert words in output
    difference = np.asarray(Image.open(places.out / "hero.png"))
    assert np.argwhere(difference).tolist() == [[2, 3]] and difference.max() == 255
    for id, status in (("unit_length", 1), ("sweep.rms_1e-3", 0)):
        text = places.changelog.read_text()
        places.changelog.write_text(text.replace("- A line.\n", f"- A line.\n- `{id}` moved, for a reason.\n"))
        assert notes()[0] == command_line.main(["release"]) == status
        assert (released(places) == before) == bool(status)
    assert "Nothing moved." in notes()[1]


def test_the_newest_version_keeps_pictures_and_what_cannot_be_released_is_refused(places, monkeypatch, capsys):
    for version in ("0.2.0", "0.10.0"):
        monkeypatch.setattr(record, "version", lambda version=version: version)
        places.changelog.write_text(f"## {version}\n")
        assert command_line.main(["release"]) == 0
    assert [archive.before(version) for version in ("0.10.0", "0.9.2", "0.1.0")] == ["0.2.0", "0.2.0", "0.1.0"]
    assert sorted(path.parent.name for path in places.releases.glob("*/*.*")) == ["0.10.0"]
    places.changelog.write_text("## 0.1.0\n")
    for arguments, stale, error in (
        (["release-notes", "--against", "9.9"], {}, "there is no release 9.9; there are: 0.1.0, 0.2.0, 0.10.0"),
        (["release"], {}, "changelog has no heading ## 0.10.0"),
        (["release"], {"frames": "a.py changed"}, "frames: a.py changed: python -m verify.benchmark\n"),
    ):
        monkeypatch.setattr(command_line.evidence, "stale", lambda stale=stale: stale)
        assert command_line.main(arguments) == 2
        assert error in capsys.readouterr().err


def test_a_hypothesis_that_is_added_shows_whatever_the_words_are():
    theorem = all_theorems()["unit_length"]
    stricter = [claim.but(given=(claim.given, real("x") > 0)) for claim in theorem.claims]
    both = theorem, replace(theorem, claims=stricter, hypotheses="more")
    old, new = ({"a": GRADES["unit_length"] | {"says": record.says(each)}} for each in both)
    assert compare.theorems(old, old) == []
    (change,) = compare.theorems(old, new)
    assert change.words == "said by other hypotheses, unit_length__g_is_tangent, unit_length__length"


def test_tolerances_are_exact_for_counts_narrow_for_floats_and_wide_for_times(tmp_path):
    assert record.tolerance("eps_table.flips", 0) == 0
    assert record.tolerance("u_curve.slope", 2.0) == 1e-9
    assert record.tolerance("bench:frames.algebraic_256_2_ms", 2.5) == 0.25
    assert record.tolerance("work_precision.date", "2026-11-21") == record.ANY
    (tmp_path / "a.toml").write_text('[[rule]]\nnumbers = ["a.*"]\nwithin = 0.5\nwhy = " "\n')
    with pytest.raises(ValueError, match="needs a why"):
        record.rules(tmp_path / "a.toml")


def test_an_id_is_named_as_a_whole():
    id = "u_curve.least"
    for text in ("`u_curve.least` fell", "u_curve.least.", "`u_curve.*`", "`u_curve.l*st`"):
        assert release_notes.names(id, text), text
    for text in ("u_curve.least_at", "u_curve", "bench:u_curve.least", "u_curve.*", "`pole.*`", "`*`"):
        assert not release_notes.names(id, text), text


def test_two_builds_that_differ_are_told_apart(tmp_path):
    builds = [tmp_path / name for name in ("here", "there")]
    for build in builds:
        build.mkdir()
        (build / "same").write_text("same")
        (build / "folder").write_text(str(build))
        (build / build.name).touch()
    differs, *alone = same_bytes.differences(*builds)
    assert differs.startswith("folder: differs from byte") and len(alone) == 2
    with pytest.raises(ValueError, match="nothing was built there"):
        same_bytes.differences(tmp_path, tmp_path / "none")


def test_the_workflows_are_valid_pinned_and_without_secrets_and_the_citation_is_of_this_version():
    folder, citation = stamps.ROOT / ".github" / "workflows", stamps.ROOT / "CITATION.cff"
    schema = ["check-jsonschema", "--builtin-schema"]
    for program, *arguments in (
        [*schema, "vendor.github-workflows", *folder.iterdir()],
        [*schema, "vendor.citation-file-format", citation],
        ["zizmor", "--offline", "--no-config", "--persona", "pedantic", folder],  # pins, permissions, injections
    ):
        run(Path(sys.executable).with_name(program), *arguments)
    assert not any(re.search("secrets|GITHUB_TOKEN", path.read_text()) for path in folder.iterdir())
    assert f"\nversion: {record.version()}\n" in citation.read_text()
