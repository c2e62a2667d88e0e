"""The pages' scripts: formatted and without known bad habits (Biome), and their types fit (TypeScript)."""

import shutil
import subprocess

import pytest

from verify.sources import ROOT

NPM = ROOT / "tests" / "npm"
WRONG = ("function  nothing() {}\n", "debugger;\n", "with_minus(1);\n")


@pytest.mark.skipif(not (NPM / "node_modules").is_dir(), reason="not installed: npm ci --prefix tests/npm")
def test_scripts_pass_biome_and_typescript(tmp_path):
    """As they stand; and not with a line of the wrong form, a bad habit, or a wrong type."""
    here = tmp_path / "tests" / "npm"
    here.mkdir(parents=True)
    shutil.copy(NPM / "package.json", here)
    (here / "node_modules").symlink_to(NPM / "node_modules")
    shutil.copytree(ROOT / "book", tmp_path / "book", ignore=shutil.ignore_patterns("_*", "*.py", "*.md"))
    script = tmp_path / "book" / "static" / "shared.js"
    text = script.read_text("utf-8")
    for line in ("", *WRONG):
        script.write_text(text + line, "utf-8")
        command = ["npm", "run", "--silent", "check", "--prefix", here]
        assert (subprocess.run(command, capture_output=True).returncode == 0) is (line == ""), line
