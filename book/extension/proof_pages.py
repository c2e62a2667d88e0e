"""Files of Coq's as pages: each step of a proof opens the goals that it leaves, and each theorem has an anchor."""

import re
from functools import cache
from pathlib import Path

from markupsafe import Markup

from proofs.engine.project import PROJECT
from verify.coq import goals
from verify.coq.formal import GIVEN

NAMED = re.compile(r"(?:Theorem|Lemma|Corollary) (\w+)")
TEXT, STEP = Markup("<pre>{}</pre>"), Markup("<details{}><summary>{}</summary><pre>{}</pre></details>")
ANCHOR = Markup(' id="{}"')
STALE = Markup("<p>The goals of this text are not recorded: <code>python -m verify.coq</code> records them.</p>")


def proof_files() -> list[Path]:
    """Return the files of proofs that are written by hand."""
    return sorted(path for path in PROJECT.formal.glob("*.v") if path.stem not in GIVEN)


@cache
def places() -> dict[str, Path]:
    """Return {theorem of Coq's: the file that proves it}."""
    return {name: path for path in proof_files() for name in NAMED.findall(path.read_text(encoding="utf-8"))}


def proof_body(path: Path) -> Markup:
    """Return a file as HTML: sentences that leave goals can be opened, what stands between them is text."""
    text, steps, at = path.read_bytes(), goals.steps_of(path), 0
    parts = [Markup() if steps else STALE]
    for start, end, left in (step for step in steps if step[2]):
        between, sentence = text[at:start].decode(), text[start:end].decode()
        if between.strip():
            parts.append(TEXT.format(between.strip()))
        named = NAMED.match(sentence)
        parts.append(STEP.format(ANCHOR.format(named[1]) if named else "", sentence, left))
        at = end
    return Markup().join([*parts, TEXT.format(text[at:].decode())])
