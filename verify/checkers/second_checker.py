"""The second checker of certificates: the kernel of the reader's page, in JavaScript, run by Node."""

import json
import shutil
import subprocess
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path

from proofs.engine.project import PROJECT

SCRIPT = Path(__file__).parents[2] / "book" / "static" / "checker" / "kernel.js"
if not SCRIPT.is_file():
    SCRIPT = Path(__file__).with_name("kernel.js")  # where the wheel has it
ASK = """
const { check } = certificate_kernel();
const lines = require("fs").readFileSync(0, "utf8").split("\\n").filter(Boolean);
const answers = lines.map((text) => {
  try {
    const { accepted, reason } = check(...parsed_canonical(text));
    return accepted ? "" : reason || "refused";
  } catch (why) {
    return `${why}`;
  }
});
console.log(JSON.stringify(answers));
"""


def node() -> str | None:
    """Return the path of Node: that on the PATH, else playwright's, else None."""
    playwright = find_spec("playwright")
    driver = Path(playwright.origin).with_name("driver") if playwright and playwright.origin else ""
    return shutil.which("node") or shutil.which("node", path=driver)


def compact(pair: Sequence) -> str:
    """Return a statement and its certificate as the text "[statement,certificate]" that a checker is given."""
    return json.dumps(pair, separators=(",", ":"), ensure_ascii=False)


def reasons_of(texts: Sequence[str]) -> list[str]:
    """Return why each text "[statement,certificate]" is refused, "" where it is accepted. Needs `node`."""
    code = SCRIPT.read_text(encoding="utf-8") + ASK
    command = [str(node()), "-e", code]
    ran = subprocess.run(command, input="\n".join(texts), capture_output=True, encoding="utf-8", check=True)
    return json.loads(ran.stdout)


def stored() -> dict[str, dict]:
    """Return {"theorem/claim/number": (statement, certificate, point)} of all stored certificates."""
    return {
        f"{path.stem}/{claim['claim']}/{number}": entry
        for path in sorted(PROJECT.certificates.glob("*.json"))
        for claim in json.loads(path.read_text("utf-8"))["claims"]
        for number, entry in enumerate(claim["statements"])
    }
