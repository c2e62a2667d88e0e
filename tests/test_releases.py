"""Releases: what moved is named, what must be named is, and two builds that differ are told apart."""

import copy
import shutil
import subprocess
import sys
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
from book.releases import command, compare, kept, record, same_bytes, tolerances
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
    found = SimpleNamespace()
    for name, module, constant in (
        ("releases", kept, "RELEASES"),
        ("generated", record, "GENERATED"),
        ("changelog", release_notes, "CHANGELOG"),
        ("out", command, "OUT"),
    ):
        setattr(found, name, tmp_path / name)
        monkeypatch.setattr(module, constant, tmp_path / name)
    other = "\n- unit_length, sweep.rms_1e-3\n\n"
    found.changelog.write_text(f"## 0.1.0.1\n{other}## 0.1.0 (unreleased)\n\n- A line.\n\n## 0.0.1\n{other}")
    monkeypatch.setattr(record, "theorems", lambda: copy.deepcopy(grades))
    monkeypatch.setattr(record, "version", lambda: "0.1.0")
    draw_into(found.generated)
    assert command.release() == 0
    return found


def notes(places, capsys) -> tuple[int, str]:
    capsys.readouterr()
    status = command.release_notes()
    said = capsys.readouterr().out
    written = (places.out / "notes.md").read_text()
    assert said.strip() == written.strip()
    return status, written


def plant(places, grades) -> None:
    """Weaken a theorem, move a number by 1e-3, change a picture."""
    grades["unit_length"] |= {"grade": "measured"}
    pixels = PIXELS.copy()
    pixels[2, 3, 1] += 40
    draw_into(places.generated, rms=0.0121 * (1 + 1e-3), pixels=pixels)


def name_in_changelog(places, *ids) -> None:
    text = places.changelog.read_text()
    named = "".join(f"- `{id}` moved, for a reason.\n" for id in ids)
    places.changelog.write_text(text.replace("- A line.\n", f"- A line.\n{named}"))


def test_planted_changes_are_all_named_and_fail(places, grades, capsys):
    plant(places, grades)
    status, said = notes(places, capsys)
    assert status == 1
    assert "Weakened: 1\n\n- `unit_length`: proved → measured" in said
    assert "Out of tolerance: 1\n\n- `sweep.rms_1e-3`: 0.0121 → 0.012112" in said and "+0.1 %" in said
    assert "Changed: 1\n\n- `hero`: largest difference 40/255, RMS 4.71/255, 1 of 72 pixels" in said
    assert said.endswith("- `unit_length` (weakened)\n- `sweep.rms_1e-3` (out of tolerance)\n")
    difference = np.asarray(Image.open(places.out / "hero.png"))
    assert difference.shape == (8, 9) and difference[2, 3] == 255 and np.count_nonzero(difference) == 1


def test_planted_changes_that_the_changelog_names_pass_and_are_released(places, grades, capsys):
    before = (places.releases / "0.1.0.json").read_bytes()
    plant(places, grades)
    name_in_changelog(places, "unit_length")
    assert notes(places, capsys)[0] == 1 and command.release() == 1
    assert (places.releases / "0.1.0.json").read_bytes() == before
    name_in_changelog(places, "sweep.rms_1e-3")
    status, said = notes(places, capsys)
    assert status == 0
    assert all(id in said for id in ("`unit_length`", "`sweep.rms_1e-3`", "`hero`"))
    assert command.release() == 0
    assert (places.releases / "0.1.0.json").read_bytes() != before
    assert "Nothing moved." in notes(places, capsys)[1]


def test_the_same_state_gives_the_same_record_and_pictures(places, capsys):
    before = {name: path.read_bytes() for name, path in same_bytes.files_of(places.releases).items()}
    draw_into(places.generated)
    status, said = notes(places, capsys)
    assert status == 0 and "Nothing moved." in said
    assert command.release() == 0
    assert {name: path.read_bytes() for name, path in same_bytes.files_of(places.releases).items()} == before


def test_curves_are_compared_by_their_numbers_and_looks_apart(places, capsys):
    heights = STEPS**2
    heights[1] *= 1.25
    draw_into(places.generated, heights=heights)
    assert "`sweep`: largest difference 0.2 relative, RMS 0.0632, 1 of 10 plotted numbers" in notes(places, capsys)[1]
    draw_into(places.generated, width=3.5)
    status, said = notes(places, capsys)
    assert status == 0 and "`sweep`: the same numbers, other bytes: sweep.dark.svg, sweep.svg" in said
    path = places.releases / "0.1.0.json"
    path.write_text(path.read_text().replace(record._sha256((places.generated / "hero.png").read_bytes()), "0"))
    draw_into(places.generated)
    assert "`hero`: the same pixels, other bytes: hero.png" in notes(places, capsys)[1]
    draw_into(places.generated, pixels=PIXELS[:4])
    assert "`hero`: other arrays: picture_0 8×9×4 → picture_0 4×9×4" in notes(places, capsys)[1]


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
    assert tolerances.tolerance("eps_table.flips", 0) == 0
    assert tolerances.tolerance("u_curve.slope", 2.0) == 1e-9
    assert tolerances.tolerance("bench:frames.algebraic_256_2_ms", 2.5) == 0.25
    assert tolerances.tolerance("bench:frames.a_alone_central_to_algebraic_verdict", "met") == 0
    assert tolerances.tolerance("work_precision.date", "2026-11-21") == tolerances.ANY


@pytest.mark.parametrize(("good", "bad", "message"), [("so", " ", "needs a why"), ("0.5", "-1", "≥ 0")])
def test_every_rule_has_a_reason_and_a_tolerance(tmp_path, good, bad, message):
    path, rule = tmp_path / "rules.toml", 'floats = 1e-9\n[[rule]]\nnumbers = ["a.*"]\nwithin = 0.5\nwhy = "so"\n'
    path.write_text(rule.replace(good, bad))
    with pytest.raises(ValueError, match=message):
        tolerances.rules(path)


def test_every_rule_speaks_of_a_number_that_the_last_release_or_the_next_has(site):
    releases = (kept.read(kept.versions()[-1]), record.make())
    names = [name for release in releases for name in release["numbers"]]
    names += [name for release in releases for result in release["measured"].values() for name in result["numbers"]]
    for rule in tolerances.rules()["rule"]:
        for pattern in rule["numbers"]:
            assert any(tolerances.fnmatchcase(name, pattern) for name in names), pattern


@pytest.mark.parametrize(
    ("text", "named"),
    [("`u_curve.least` fell", True), ("u_curve.least.", True), ("u_curve.least_at", False), ("u_curve", False),
     ("bench:u_curve.least", False), ("u_curve.least-2", False), ("u_curve.least.x", False),
     ("`u_curve.*`", True), ("`u_curve.l*st`", True), ("u_curve.*", False), ("`pole.*`", False), ("`*`", False)],
)  # fmt: skip
def test_an_id_is_named_as_a_whole(text, named):
    assert release_notes.names("u_curve.least", text) is named


def test_versions_are_in_order_and_compared_with_the_one_before(tmp_path, monkeypatch):
    monkeypatch.setattr(kept, "RELEASES", tmp_path)
    for version in ("0.2.0", "0.10.0", "0.9.1"):
        (tmp_path / f"{version}.json").write_text("{}")
    assert kept.versions() == ["0.2.0", "0.9.1", "0.10.0"]
    assert kept.before("0.10.0") == "0.9.1"
    assert kept.before("0.9.2") == "0.9.1"
    assert kept.before("0.2.0") == "0.2.0"
    with pytest.raises(stamps.Refused, match=r"up to 0\.1\.0"):
        kept.before("0.1.0")


def test_only_the_two_newest_releases_keep_pictures(places, monkeypatch):
    for version in ("0.2.0", "0.3.0"):
        monkeypatch.setattr(record, "version", lambda version=version: version)
        places.changelog.write_text(f"## {version}\n")
        assert command.release() == 0
    assert kept.versions() == ["0.1.0", "0.2.0", "0.3.0"]
    assert sorted(path.name for path in places.releases.iterdir() if path.is_dir()) == ["0.2.0", "0.3.0"]


def test_the_command_line_gives_the_status_on(monkeypatch, places, grades, capsys):
    monkeypatch.setattr(report, "make", lambda: None)
    monkeypatch.setattr(command_line, "figures", lambda: None)
    monkeypatch.setattr(stamps, "STAMPS", places.releases.parent / "stamps")
    assert command_line.main(["release-notes"]) == 0
    plant(places, grades)
    assert command_line.main(["release-notes"]) == 1
    assert command_line.main(["release-notes", "--against", "9.9"]) == 2
    assert "there is no release 9.9; there are: 0.1.0" in capsys.readouterr().err
    places.changelog.write_text("## 0.0.1\n")
    assert command_line.main(["release"]) == 2
    assert "changelog has no heading ## 0.1.0" in capsys.readouterr().err


def test_the_committed_release_is_whole_and_small():
    version = kept.versions()[-1]
    then = kept.read(version)
    assert then["version"] == version
    assert all(entry["grade"] != "failed" for entry in then["theorems"].values()) and len(then["theorems"]) > 60
    assert all(entry["tolerance"] == "any" or entry["tolerance"] >= 0 for entry in then["numbers"].values())
    assert all(result["label"]["machine"] for result in then["measured"].values())
    folder = kept.RELEASES / version
    names = {picture["kept"] for picture in then["pictures"].values()}
    assert {path.name for path in folder.iterdir()} == names
    assert sum(path.stat().st_size for path in folder.iterdir()) < 5e6
    for picture in then["pictures"].values():
        assert kept.pictures.digest(kept.pictures.arrays_of(folder / picture["kept"])) == picture["content"]


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


def repository(folder: Path, content: str) -> Path:
    """A project whose build writes what an expression gives: a stand-in for this one."""
    (folder / "book").mkdir(parents=True)
    program = "import os, pathlib\nfor part in ('html', '../_generated'):\n"
    program += "    out = pathlib.Path('book/_build') / part\n    out.mkdir(parents=True)\n"
    program += "    (out / 'index.html').write_text(eval(open('content.txt').read()))\n"
    (folder / "book" / "__main__.py").write_text(program)
    (folder / "content.txt").write_text(content)
    (folder / "requirements.lock").touch()
    (folder / "pyproject.toml").touch()
    for package in stamps.PACKAGES:
        (folder / package).mkdir(exist_ok=True)
        (folder / package / "__init__.py").touch()
    (folder / ".gitignore").write_text("_build\n_generated\n__pycache__\n")
    return folder


def build_twice(root: Path, monkeypatch) -> int:
    """Build a stand-in, and compare with a build from a clone of it."""
    subprocess.run([sys.executable, "-m", "book"], cwd=root, check=True)
    monkeypatch.setattr(stamps, "ROOT", root)
    return same_bytes.same_bytes()


@pytest.mark.parametrize(
    "place", ["os.getcwd()", "os.environ.get('TZ', '')", "str(hash('word'))", "os.environ['HOME']"]
)
def test_a_build_that_depends_on_its_place_is_found_out(tmp_path, monkeypatch, capfd, place):
    root = repository(tmp_path / "here", place)
    assert build_twice(root, monkeypatch) == 1
    said = capfd.readouterr().out
    assert "book/_build/html/index.html: differs" in said and "agree" not in said


def test_a_build_that_does_not_agrees_without_git(tmp_path, monkeypatch, capfd):
    root = repository(tmp_path / "here", "'the same'")
    (root / ".stamps").mkdir()
    assert build_twice(root, monkeypatch) == 0
    assert "2 files, built in two folders, agree in every byte" in capfd.readouterr().out


@pytest.mark.skipif(shutil.which("git") is None, reason="there is no git")
def test_a_clone_is_of_what_is_committed(tmp_path, monkeypatch, capfd):
    root = repository(tmp_path / "here", "'the same'")
    git = ["git", "-c", "user.name=a", "-c", "user.email=a@b"]
    for arguments in (["init", "-q"], ["add", "."], ["commit", "-qm", "x"]):
        subprocess.run([*git, *arguments], cwd=root, check=True)
    assert build_twice(root, monkeypatch) == 0
    (root / "book" / "new.py").touch()
    with pytest.raises(stamps.Refused, match=r"book/new\.py"):
        same_bytes.same_bytes()


WORKFLOW = stamps.ROOT / ".github" / "workflows" / "publish.yml"
CITATION = stamps.ROOT / "CITATION.cff"
TOOLS = Path(sys.executable).parent


def lint(*command) -> tuple[bool, str]:
    """Whether a linter is content, and what it says."""
    done = subprocess.run([TOOLS / command[0], *map(str, command[1:])], capture_output=True, text=True)
    return done.returncode == 0, done.stdout + done.stderr


def lint_workflow(path: Path) -> tuple[bool, str]:
    """By the schema of workflows, and by zizmor, which looks for unpinned actions, wide permissions and injections."""
    fits, why = lint("check-jsonschema", "--builtin-schema", "vendor.github-workflows", path)
    safe, risks = lint("zizmor", "--offline", "--no-config", "--persona", "pedantic", path)
    return fits and safe, why + risks


@pytest.mark.parametrize(
    ("name", "commands"),
    [("publish", (".ci/run", "make release-notes", "book/_build/html")), ("weekly", (".ci/run", ".ci/long"))],
)
def test_the_workflows_are_valid_pinned_and_without_secrets(name, commands):
    path = WORKFLOW.with_stem(name)
    good, said = lint_workflow(path)
    assert good, said
    text = path.read_text()
    assert "secrets" not in text.replace("no secret", "") and "GITHUB_TOKEN" not in text
    assert all(command in text for command in commands)


@pytest.mark.parametrize(
    ("said", "instead", "complaint"),
    [
        ("runs-on: ubuntu-24.04", "run-on: ubuntu-24.04", "run-on"),
        ("@11bd71901bbe5b1630ceea73d27597364c9af683", "@v4", "unpinned-uses"),
        ("permissions: {}", "permissions: write-all", "excessive-permissions"),
        ("persist-credentials: false", "fetch-depth: 1", "artipacked"),
        ('grep -qxF "version', 'echo ${{ github.event.head_commit.message }} "version', "template-injection"),
    ],
)
def test_a_workflow_that_is_wrong_is_refused(tmp_path, said, instead, complaint):
    text = WORKFLOW.read_text()
    assert said in text
    wrong = tmp_path / ".github" / "workflows" / "publish.yml"
    wrong.parent.mkdir(parents=True)
    wrong.write_text(text.replace(said, instead))
    good, why = lint_workflow(wrong)
    assert not good and complaint in why


def test_the_citation_is_valid_and_of_this_version(tmp_path):
    command = "check-jsonschema", "--builtin-schema", "vendor.citation-file-format"
    good, said = lint(*command, CITATION)
    assert good, said
    text = CITATION.read_text()
    assert f"\nversion: {record.version()}\n" in text
    wrong = tmp_path / "CITATION.cff"
    wrong.write_text(text.replace("authors:", "author:"))
    assert not lint(*command, wrong)[0]
