"""Releases: what moved is named, what must be named is, and two builds that differ are told apart."""

import copy
import shutil
import subprocess
import sys
from hashlib import sha256
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
from book.releases import archive, command, compare, record, same_bytes
from book.releases import notes as release_notes

GRADES = {
    "unit_length": {"grade": "proved", "given": [], "statement": "$|N| = 1$"},
    "known_lemma": {"grade": "proved", "given": ["DLMF"], "statement": "$x < y$"},
    "sampled": {"grade": "measured", "given": [], "statement": "small"},
}
STEPS = np.array([1e-1, 1e-2, 1e-3, 1e-4, 1e-5])
PIXELS = np.arange(8 * 9 * 3, dtype=np.uint8).reshape(8, 9, 3)


def draw_into(folder: Path, rms=0.0121, pixels=PIXELS, heights=STEPS**2, width=3.0) -> None:
    """Draw a plot, a render and a table of numbers."""

    def plot() -> Drawing:
        """A curve."""
        fig = Figure(figsize=(width, 2))
        fig.subplots().plot(STEPS, heights)
        numbers = {"rms_1e-3": rms, "rms_1e-3_at": 1e-3, "flips": 0, "date": "2026-01-01"}
        return Drawing(fig, numbers=numbers, data={"step": STEPS, "pixels": heights})

    def render() -> Drawing:
        """Pixels."""
        return Drawing(pixels)

    for id, function in (("sweep", plot), ("hero", render)):
        save.save(Registered(id, function), folder, "book/figures/x.py", "key")


@pytest.fixture
def grades():
    """The theorems as the run grades them; a test may change them."""
    return copy.deepcopy(GRADES)


@pytest.fixture
def places(tmp_path, monkeypatch, grades):
    """A project with drawn figures, three theorems and its first release."""
    modules = {"releases": archive, "generated": record, "changelog": release_notes, "out": command}
    paths = SimpleNamespace(**{name: tmp_path / name for name in modules})
    for name, module in modules.items():
        monkeypatch.setattr(module, name.upper(), tmp_path / name)
    other = "\n- unit_length, sweep.rms_1e-3\n\n"
    paths.changelog.write_text(f"## 0.1.0.1\n{other}## 0.1.0 (unreleased)\n\n- A line.\n\n## 0.0.1\n{other}")
    monkeypatch.setattr(record, "theorems", lambda: copy.deepcopy(grades))
    monkeypatch.setattr(record, "version", lambda: "0.1.0")
    draw_into(paths.generated)
    assert command.release() == 0
    return paths


@pytest.fixture
def notes(places, capsys):
    """A function: the status and the text of the notes as they are now."""

    def made():
        capsys.readouterr()
        status, written = command.release_notes(), (places.out / "notes.md").read_text()
        assert capsys.readouterr().out.strip() == written.strip()
        return status, written

    return made


@pytest.fixture
def planted(places, grades):
    """A theorem is weaker, a number moved by 1e-3, a picture changed."""
    grades["unit_length"] |= {"grade": "measured"}
    pixels = PIXELS.copy()
    pixels[2, 3, 1] += 40
    draw_into(places.generated, rms=0.0121 * (1 + 1e-3), pixels=pixels)


def name_in_changelog(places, id) -> None:
    text = places.changelog.read_text()
    places.changelog.write_text(text.replace("- A line.\n", f"- A line.\n- `{id}` moved, for a reason.\n"))


def test_planted_changes_are_all_named_and_fail(places, planted, notes):
    status, said = notes()
    assert status == 1
    assert "Weakened: 1\n\n- `unit_length`: proved → measured" in said
    assert "Out of tolerance: 1\n\n- `sweep.rms_1e-3`: 0.0121 → 0.012112" in said and "+0.1 %" in said
    assert "Changed: 1\n\n- `hero`: largest difference 40/255, RMS 4.71/255, 1 of 72 pixels" in said
    assert said.endswith("- `unit_length` (weakened)\n- `sweep.rms_1e-3` (out of tolerance)\n")
    difference = np.asarray(Image.open(places.out / "hero.png"))
    assert difference.shape == (8, 9) and difference[2, 3] == 255 and np.count_nonzero(difference) == 1


def released(places) -> dict[str, bytes]:
    return {name: path.read_bytes() for name, path in same_bytes.files_of(places.releases).items()}


def test_planted_changes_that_the_changelog_names_pass_and_are_released(places, planted, notes):
    before = released(places)
    name_in_changelog(places, "unit_length")
    assert notes()[0] == command.release() == 1
    assert released(places) == before
    name_in_changelog(places, "sweep.rms_1e-3")
    status, said = notes()
    assert status == 0
    assert all(id in said for id in ("`unit_length`", "`sweep.rms_1e-3`", "`hero`"))
    assert command.release() == 0
    assert released(places) != before
    assert "Nothing moved." in notes()[1]


def test_the_same_state_gives_the_same_record_and_pictures(places, notes):
    before = released(places)
    draw_into(places.generated)
    status, said = notes()
    assert status == 0 and "Nothing moved." in said
    assert command.release() == 0
    assert released(places) == before


def test_curves_are_compared_by_their_numbers_and_looks_apart(places, notes):
    heights = STEPS**2
    heights[1] *= 1.25
    draw_into(places.generated, heights=heights)
    assert "`sweep`: largest difference 0.2 relative, RMS 0.0632, 1 of 10 plotted numbers" in notes()[1]
    draw_into(places.generated, width=3.5)
    status, said = notes()
    assert status == 0 and "`sweep`: the same numbers, other bytes: sweep.dark.svg, sweep.svg" in said
    path, hero = places.releases / "0.1.0.json", (places.generated / "hero.png").read_bytes()
    path.write_text(path.read_text().replace(sha256(hero).hexdigest(), "0"))
    draw_into(places.generated)
    assert "`hero`: the same pixels, other bytes: hero.png" in notes()[1]
    draw_into(places.generated, pixels=PIXELS[:4])
    assert "`hero`: other arrays: picture_0 8×9×4 u → picture_0 4×9×4 u" in notes()[1]


def changes(before, after):
    return [(change.kind, change.id, change.must_be_named) for change in compare.theorems(before, after)]


def test_theorems_added_removed_strengthened_weakened_and_restated():
    after = copy.deepcopy(GRADES)
    after["known_lemma"]["given"] = []
    after["sampled"]["statement"] = "smaller"
    after["news"] = after.pop("unit_length")
    expected = [("added", "news", False), ("removed", "unit_length", True), ("restated", "sampled", False)]
    assert changes(GRADES, after) == [*expected, ("strengthened", "known_lemma", False)]
    assert changes(after, GRADES)[-1] == ("weakened", "known_lemma", True)
    failed = copy.deepcopy(GRADES)
    failed["sampled"]["grade"] = "failed"
    assert changes(GRADES, failed) == [("weakened", "sampled", True)]
    assert changes(GRADES, GRADES) == []


@pytest.mark.parametrize(
    ("old", "new", "tolerance", "kind", "how"),
    [
        (1.0, 1.0 + 2**-51, 1e-9, "moved", "+4.44e-14 %"),
        (1.0, 1.0 + 2**-52, 0, "out of tolerance", "+2.22e-14 %"),
        (1.0, 1.001, 1e-9, "out of tolerance", "+0.1 %"),
        (2.0, 1.9, 0.25, "moved", "-5 %"),
        (0.0, 1e-300, 1e-9, "out of tolerance", "from zero"),
        (-1e-9, 1e-9, 1e-9, "out of tolerance", "+200 %"),
        (3, 4, 0, "out of tolerance", "+33.3 %"),
        (3, 3.0, 1e-9, "moved", "another kind"),
        ("met", "not met", 0, "out of tolerance", "another value"),
        ("Tuesday", "Friday", "any", "moved", "another value"),
        (True, False, 0, "out of tolerance", "another value"),
    ],
)
def test_numbers_that_moved(old, new, tolerance, kind, how):
    before, after = ({"a.b": {"value": value, "tolerance": tolerance}} for value in (old, new))
    (change,) = compare.numbers(before, after | {"a.b": after["a.b"] | {"tolerance": 1.0}})
    assert change.kind == kind and how in change.words
    assert list(compare.numbers(before, before)) == []


def test_tolerances_are_exact_for_counts_narrow_for_floats_and_wide_for_times():
    assert record.tolerance("eps_table.flips", 0) == 0
    assert record.tolerance("u_curve.slope", 2.0) == 1e-9
    assert record.tolerance("bench:frames.algebraic_256_2_ms", 2.5) == 0.25
    assert record.tolerance("bench:frames.a_alone_central_to_algebraic_verdict", "met") == 0
    assert record.tolerance("work_precision.date", "2026-11-21") == record.ANY


@pytest.mark.parametrize(("good", "bad", "message"), [("so", " ", "needs a why"), ("0.5", "-1", "≥ 0")])
def test_every_rule_has_a_reason_and_a_tolerance(tmp_path, good, bad, message):
    path, rule = tmp_path / "rules.toml", 'floats = 1e-9\n[[rule]]\nnumbers = ["a.*"]\nwithin = 0.5\nwhy = "so"\n'
    path.write_text(rule.replace(good, bad))
    with pytest.raises(ValueError, match=message):
        record.rules(path)


def test_every_rule_speaks_of_a_number_that_the_last_release_or_the_next_has(site):
    releases = (archive.read(archive.versions()[-1]), record.make())
    names = [name for release in releases for name in command.all_numbers(release)]
    for rule in record.rules()["rule"]:
        for pattern in rule["numbers"]:
            assert any(record.fnmatchcase(name, pattern) for name in names), pattern


@pytest.mark.parametrize(
    ("text", "named"),
    [("`u_curve.least` fell", True), ("u_curve.least.", True), ("u_curve.least_at", False), ("u_curve", False),
     ("bench:u_curve.least", False), ("u_curve.least-2", False), ("u_curve.least.x", False),
     ("`u_curve.*`", True), ("`u_curve.l*st`", True), ("u_curve.*", False), ("`pole.*`", False), ("`*`", False)],
)  # fmt: skip
def test_an_id_is_named_as_a_whole(text, named):
    assert release_notes.names("u_curve.least", text) is named


def test_versions_are_in_order_and_compared_with_the_one_before(tmp_path, monkeypatch):
    monkeypatch.setattr(archive, "RELEASES", tmp_path)
    for version in ("0.2.0", "0.10.0", "0.9.1"):
        (tmp_path / f"{version}.json").write_text("{}")
    assert archive.versions() == ["0.2.0", "0.9.1", "0.10.0"]
    assert [archive.before(version) for version in ("0.10.0", "0.9.2", "0.2.0")] == ["0.9.1", "0.9.1", "0.2.0"]
    with pytest.raises(stamps.Refused, match=r"up to 0\.1\.0"):
        archive.before("0.1.0")


def test_only_the_two_newest_releases_keep_pictures(places, monkeypatch):
    for version in ("0.2.0", "0.3.0"):
        monkeypatch.setattr(record, "version", lambda version=version: version)
        places.changelog.write_text(f"## {version}\n")
        assert command.release() == 0
    assert archive.versions() == ["0.1.0", "0.2.0", "0.3.0"]
    assert sorted(path.name for path in places.releases.iterdir() if path.is_dir()) == ["0.2.0", "0.3.0"]


def test_the_command_line_gives_the_status_on(monkeypatch, stamped, places, planted, capsys):
    monkeypatch.setattr(report, "make", lambda: None)
    monkeypatch.setattr(command_line, "figures", lambda: None)
    assert command_line.main(["release-notes"]) == 1
    assert command_line.main(["release-notes", "--against", "9.9"]) == 2
    assert "there is no release 9.9; there are: 0.1.0" in capsys.readouterr().err
    places.changelog.write_text("## 0.0.1\n")
    old = {}
    monkeypatch.setattr(command_line.evidence, "stale", lambda: old)
    assert command_line.main(["release"]) == 2
    assert "changelog has no heading ## 0.1.0" in capsys.readouterr().err
    old["frames"] = "renderer/kernels.py changed"
    assert command_line.main(["release"]) == 2
    said = capsys.readouterr().err
    assert "make evidence" in said and "frames: renderer/kernels.py changed: python -m verify.benchmark\n" in said


def test_the_committed_release_is_whole_and_small():
    version = archive.versions()[-1]
    then = archive.read(version)
    assert then["version"] == version
    assert all(entry["grade"] != "failed" for entry in then["theorems"].values()) and len(then["theorems"]) > 60
    assert all(entry["tolerance"] == "any" or entry["tolerance"] >= 0 for entry in then["numbers"].values())
    assert all(result["label"]["machine"] for result in then["measured"].values())
    folder = archive.RELEASES / version
    names = {picture["kept"] for picture in then["pictures"].values()}
    assert {path.name for path in folder.iterdir()} == names
    assert sum(path.stat().st_size for path in folder.iterdir()) < 5e6
    for picture in then["pictures"].values():
        assert archive.pictures.digest(archive.pictures.arrays_of(folder / picture["kept"])) == picture["content"]


def test_a_file_that_differs_or_is_missing_is_reported_by_name(tmp_path):
    one, other = tmp_path / "one", tmp_path / "other"
    for folder, text in ((one, "<p>0.0121</p>"), (other, "<p>0.0122</p>")):
        folder.mkdir()
        (folder / "index.html").write_text(text)
    (one / "extra.json").touch()
    extra, index = same_bytes.differences(one, other)
    assert index == "index.html: differs from byte 8 on: b'<p>0.0121</p>' and b'<p>0.0122</p>'"
    assert extra == f"extra.json: only in {one}"
    shutil.rmtree(other)
    with pytest.raises(ValueError, match="nothing was built there"):
        same_bytes.differences(one, other)


PROGRAM = """
import os, pathlib
for part in ('html', '../_generated'):
    out = pathlib.Path('book/_build') / part
    out.mkdir(parents=True)
    (out / 'index.html').write_text({content})
"""


@pytest.fixture
def repository(tmp_path, monkeypatch):
    """A function: a project whose build writes what an expression gives, a stand-in for this one; it is built."""

    def built(content):
        root = tmp_path / "here"
        for package in stamps.PACKAGES:
            (root / package).mkdir(parents=True)
            (root / package / "__init__.py").touch()
        (root / "book" / "__main__.py").write_text(PROGRAM.format(content=content))
        for name, text in {"requirements.lock": "", "pyproject.toml": "", ".gitignore": "_*\n!__*.py\n"}.items():
            (root / name).write_text(text)
        subprocess.run([sys.executable, "-m", "book"], cwd=root, check=True)
        git = ["git", "-c", "user.name=a", "-c", "user.email=a@b"]
        for arguments in (["init", "-q"], ["add", "."], ["commit", "-qm", "x"]):
            subprocess.run([*git, *arguments], cwd=root, check=True)
        monkeypatch.setattr(stamps, "ROOT", root)
        return root

    return built


@pytest.mark.parametrize(
    "place", ["os.getcwd()", "os.environ.get('TZ', '')", "str(hash('word'))", "os.environ['HOME']"]
)
def test_a_build_that_depends_on_its_place_is_found_out(repository, capfd, place):
    repository(place)
    assert same_bytes.same_bytes() == 1
    said = capfd.readouterr().out
    assert "book/_build/html/index.html: differs" in said and "agree" not in said


def test_a_build_that_does_not_agrees_in_a_clone_of_what_is_committed(repository, capfd):
    root = repository("'the same'")
    (root / ".stamps").mkdir()
    assert same_bytes.same_bytes() == 0
    assert "2 files, built in two folders, agree in every byte" in capfd.readouterr().out
    (root / "book" / "new.py").touch()
    with pytest.raises(stamps.Refused, match=r"book/new\.py"):
        same_bytes.same_bytes()


def lint(program: str, *arguments) -> None:
    """Fail with what a linter says if it is not content."""
    done = subprocess.run([Path(sys.executable).with_name(program), *arguments], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize(
    ("name", "commands"),
    [
        ("publish", (".ci/run", "make release-notes", "book/_build/html")),
        ("weekly", (".ci/run", ".ci/long")),
        ("checks", (".ci/run", "3.14", "macos", "windows", "pytest -q verify", "tests/test_wheel.py")),
    ],
)
def test_the_workflows_are_valid_pinned_and_without_secrets(name, commands):
    path = stamps.ROOT / ".github" / "workflows" / f"{name}.yml"
    lint("check-jsonschema", "--builtin-schema", "vendor.github-workflows", path)
    lint("zizmor", "--offline", "--no-config", "--persona", "pedantic", path)  # pinned, few permissions, no injections
    text = path.read_text()
    assert "secrets" not in text.replace("no secret", "") and "GITHUB_TOKEN" not in text
    assert all(command in text for command in commands)


def test_the_citation_is_valid_and_of_this_version():
    citation = stamps.ROOT / "CITATION.cff"
    lint("check-jsonschema", "--builtin-schema", "vendor.citation-file-format", citation)
    assert f"\nversion: {record.version()}\n" in citation.read_text()
