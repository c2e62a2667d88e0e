"""Coq's record, proofs/formal/record.json: what Coq accepted, and whether that is what theorems have pinned."""

import hashlib
import json
import re
from collections.abc import Mapping

from proofs.engine.project import PROJECT
from proofs.engine.theorem import Theorem
from verify.evidence.sources import file_hashes

FOLDER = PROJECT.formal
RECORD = FOLDER / "record.json"
WORD = re.compile(r"[\w.']+")
IMPLIES = re.compile(r"(?<!<)->")


def coq_hashes() -> dict[str, str]:
    """Return {file: hash} of everything that Coq reads."""
    return file_hashes(FOLDER.glob("*.v"))


def record() -> dict:
    """Return what Coq accepted, {} if that is stale.

    {theorem: {"claims": [those that are proved as they are printed], "statements": {addition: text}, "definitions":
    {name: text of each that these name}, "axioms": [name, …]}}.
    """
    if not RECORD.is_file():
        return {}
    content = json.loads(RECORD.read_text(encoding="utf-8"))
    return content["theorems"] if content["sources"] == coq_hashes() else {}


def reached(text: str, definitions: Mapping[str, str]) -> dict[str, str]:
    """Return the definitions that a text names, directly or through others."""
    found: dict[str, str] = {}
    texts = [text]
    for each in texts:
        names = [name for name in WORD.findall(each) if name in definitions and name not in found]
        found |= {name: definitions[name] for name in names}
        texts += [definitions[name] for name in dict.fromkeys(names)]
    return found


def in_full(name: str, accepted: Mapping[str, dict]) -> str:
    """Return the text of an addition as it is pinned, with the definitions that it names; "" if it is not recorded."""
    entry = accepted.get(name.partition("__")[0], {})
    if not (text := entry.get("statements", {}).get(name, "")):
        return ""
    return "\n\n".join([text, *reached(text, entry["definitions"]).values()])


def digest(text: str) -> str:
    """Return the digest by which a text is pinned."""
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def why_not_pinned(theorem: Theorem) -> list[str]:
    """Return why Coq's record does not bear a theorem out.

    A pinned statement must be recorded with that text, with a refuted false variant of its own names, and with a point.
    Claims of float64, which Coq alone proves, and claims that cite a lemma must be proved there.
    """
    accepted, problems = record(), []
    for claim in (*theorem.rounded, *(claim for claim in theorem.claims if claim.cited)):
        if f"{theorem.id}__{claim.name}" not in accepted.get(theorem.id, {}).get("claims", ()):
            problems.append(f"{claim.name}: Coq's record of the files as they are has no proof of it")
    for pin in theorem.pinned:
        if not (text := in_full(pin.name, accepted)):
            problems.append(f"{pin.name} is not in Coq's record of the files as they are")
        elif digest(text) != pin.digest:
            problems.append(f"Coq proves another {pin.name} than was read: {digest(text)}, not {pin.digest}:\n{text}")
        elif not _denies(in_full(f"{pin.name}__false", accepted), text):
            problems.append(f"{pin.name} has no false variant that Coq refutes")
        elif IMPLIES.search(text.partition("\n\n")[0]) and "exists" not in in_full(f"{pin.name}__point", accepted):
            problems.append(f"{pin.name} has no point at which Coq shows its hypotheses to hold")
    return problems


def _denies(false, text):
    """Return whether a text denies something, and uses at least a third of the names of another text."""
    denied, stated = ({*WORD.findall(each.partition("\n\n")[0])} for each in (false, text))
    return false.startswith("~") and 3 * len(denied & stated) >= len(stated)
