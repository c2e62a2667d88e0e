"""The pages' scripts: formatted and without known bad habits (Biome), and their types fit (TypeScript)."""

import shutil
import subprocess

import pytest

from verify.sources import ROOT

NPM = ROOT / "tests" / "npm"
WRONG = {"form": "function  nothing() {}\n", "habit": "debugger;\n", "type": "with_minus(1);\n"}


@pytest.mark.skipif(not (NPM / "node_modules").is_dir(), reason="not installed: npm ci --prefix tests/npm")
@pytest.mark.parametrize("line", ["", *WRONG.values()], ids=["as they stand", *WRONG])
def test_scripts_pass_biome_and_typescript(tmp_path, line):
    """As they stand; and not with a line of the wrong form, a bad habit, or a wrong type."""
    here = tmp_path / "tests" / "npm"
    here.mkdir(parents=True)
    shutil.copy(NPM / "package.json", here)
    (here / "node_modules").symlink_to(NPM / "node_modules")
    shutil.copytree(ROOT / "book", tmp_path / "book", ignore=shutil.ignore_patterns("_*", "*.py", "*.md"))
    with open(tmp_path / "book" / "static" / "shared.js", "a", encoding="utf-8") as script:
        script.write(line)
    command = ["npm", "run", "--silent", "check", "--prefix", here]
    assert (subprocess.run(command, capture_output=True).returncode == 0) is (line == "")
