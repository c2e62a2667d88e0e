"""The three kernels side by side: Python's, FLINT's, and the page's JavaScript, run by node where that is installed."""

import json
import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path

from verify.checkers.proof_checker import CHECKERS

JAVASCRIPT = Path(__file__).resolve().parents[2] / "book" / "static" / "checker" / "kernel.js"
ASK = """
const { check } = certificate_kernel();
const lines = require("fs").readFileSync(0, "utf8").split("\\n").filter(Boolean);
const answers = lines.map((text) => {
  try {
    return check(...parsed_canonical(text)).accepted;
  } catch {
    return false;
  }
});
console.log(JSON.stringify(answers));
"""


def compact(pair: Sequence) -> str:
    """Return a statement and its certificate as the text "[statement,certificate]" that the kernels are given."""
    return json.dumps(pair, separators=(",", ":"), ensure_ascii=False)


def canonical(text: str) -> bool:
    """Return whether a compact JSON text is its own canonical form."""
    try:
        return compact(json.loads(text)) == text
    except (ValueError, RecursionError):
        return False


def accepted(texts: Sequence[str]) -> list[dict[str, bool]]:
    """Return [{kernel: whether it accepts}] of texts "[statement,certificate]"; JavaScript needs node."""
    verdicts_of_each = [
        {name: canonical(text) and check(*json.loads(text)) is None for name, check in CHECKERS.items()}
        for text in texts
    ]
    if shutil.which("node"):
        code = JAVASCRIPT.read_text(encoding="utf-8") + ASK
        ran = subprocess.run(["node", "-e", code], input="\n".join(texts), capture_output=True, text=True, check=True)
        for verdicts, answer in zip(verdicts_of_each, json.loads(ran.stdout), strict=True):
            verdicts["JavaScript"] = answer
    return verdicts_of_each
