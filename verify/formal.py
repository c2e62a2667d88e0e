"""The formal proofs:  python -m verify.formal compiles `proofs/formal/` with Coq and records what it accepted.

The statement ID__CLAUSE says a clause of the book's theorem ID; ID__CLAUSE__point gives values at which its hypotheses
hold, and ID__CLAUSE__false refutes a false variant. A refuted theorem's statements are negations.
"""

import argparse
import json
import re
import shutil
import subprocess
import sys
import tempfile
import textwrap
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from tqdm import tqdm

from renderer.files import write_whole
from verify.sources import ROOT, hashes, key

FOLDER = ROOT / "proofs" / "formal"
RECORD = FOLDER / "record.json"
KEPT = ROOT / ".stamps" / "formal"  # what Coq was last asked about here
STATEMENT = re.compile(r"^Theorem ((\w+?)__\w+)", re.MULTILINE)
REQUIRED = re.compile(r"From Formal Require Import ([\w\s]+)\.")
COQC = ("coqc", "-w", "-ambiguous-paths", "-Q", ".", "Formal")
AXIOMS = {
    "ClassicalDedekindReals.sig_forall_dec": "the real numbers",
    "ClassicalDedekindReals.sig_not_dec": "the real numbers",
    "FunctionalExtensionality.functional_extensionality_dep": "functions",
    "Classical_Prop.classic": "the excluded middle",
}
"""{axiom: what it is about}. Where `interval` computes, the specifications of Coq's machine numbers come to these."""
SEPARATOR = "I\n     : True\n"
MACHINE_NUMBERS = ("Uint63.", "PrimInt63.", "PrimFloat.", "FloatAxioms.", "FloatOps.", "Int63.", "Sint63.")

PARTLY = {
    "crease_error_area": "how many tents there are, and that they do not overlap",
    "elementary_functions": "how each operation is rounded, and the arctangent",
}
"""{theorem: what of its words no statement says}"""


class NotAccepted(ValueError):
    """Coq did not accept a file, or a statement rests on an axiom that is not among those that are named."""


def files(*wanted: str) -> list[Path]:
    """Return the files that Coq reads, each after those that it requires: all, or those that are wanted and theirs."""
    required = {path: REQUIRED.search(path.read_text(encoding="utf-8")) for path in FOLDER.glob("*.v")}
    needs = {path.stem: set(found[1].split()) if found else set() for path, found in required.items()}
    order: list[str] = []
    while len(order) < len(needs):
        order += sorted(name for name, names in needs.items() if name not in order and names <= set(order))
    reached = set(wanted or order)
    for name in reversed(order):
        reached |= needs[name] if name in reached else set()
    return [FOLDER / f"{name}.v" for name in order if name in reached]


def statements(*wanted: str) -> dict[str, list[str]]:
    """Return {theorem's id: the names of its statements}, in the order of the files."""
    found: dict[str, list[str]] = {}
    for path in files(*wanted):
        for name, theorem in STATEMENT.findall(path.read_text(encoding="utf-8")):
            found.setdefault(theorem, []).append(name)
    return found


def record() -> dict:
    """Return what Coq accepted, {} if that is stale: {theorem: {"statements": {name: text}, "axioms": [name, …]}}."""
    if not RECORD.is_file():
        return {}
    content = json.loads(RECORD.read_text(encoding="utf-8"))
    return content["theorems"] if content["sources"] == sources() else {}


def sources() -> dict[str, str]:
    """Return {file: hash} of everything that Coq reads."""
    return hashes(FOLDER.glob("*.v"))


def _coqc(folder: Path, name: str) -> str:
    done = subprocess.run([*COQC, name], cwd=folder, capture_output=True, text=True)
    if done.returncode:
        raise NotAccepted(f"Coq does not accept {name}:\n{done.stdout}{done.stderr}")
    return done.stdout


def compile_files(*wanted: str) -> dict:
    """Compile files in a folder of their own and return what `record` returns; raises NotAccepted."""
    found, order = statements(*wanted), files(*wanted)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for path in order:
            shutil.copy(path, folder)
        waiting, compiled = [path.name for path in order], set()
        with tqdm(total=len(order) + 1, unit="file", disable=None) as bar, ThreadPoolExecutor(2) as pool:
            while waiting:
                ready = [name for name in waiting if _needs(folder / name) <= compiled]
                for name, _ in zip(ready, pool.map(lambda name: _coqc(folder, name), ready), strict=True):
                    bar.update()
                    compiled.add(name)
                    waiting.remove(name)
            (folder / "Survey.v").write_text(_survey(found, order), encoding="utf-8")
            printed = _coqc(folder, "Survey.v")
            bar.update()
    return _read(found, printed)


def _needs(path: Path) -> set[str]:
    required = REQUIRED.search(path.read_text(encoding="utf-8"))
    return {f"{name}.v" for name in required[1].split()} if required else set()


def _survey(found: dict[str, list[str]], order: list[Path]) -> str:
    """Return the text of a file that prints every statement, and each theorem's axioms."""
    lines = ["From Coq Require Import Reals.", "From Coquelicot Require Import Coquelicot.", "Open Scope R_scope."]
    lines += [f"From Formal Require Import {' '.join(path.stem for path in order)}.", "Set Printing Width 72."]
    for theorem, names in found.items():
        lines += [f"Check {name}." for name in names]
        lines += [f"Definition all_of_{theorem} := ({', '.join(names)}, I).", "Check I."]
        lines += [f"Print Assumptions all_of_{theorem}.", "Check I."]
    return "\n".join([*lines, ""])


def _read(found: dict[str, list[str]], printed: str) -> dict:
    """Return the record out of what the survey printed: each theorem's statements, then its axioms."""
    parts, table = printed.split(SEPARATOR), {}
    for theorem, said, rests in zip(found, parts[0::2], parts[1::2], strict=False):
        pieces = re.split(rf"^({'|'.join(found[theorem])})\s*:", said, flags=re.M)
        axioms = sorted(re.findall(r"^([\w.]+)\s*:", rests.partition("Axioms:")[2], flags=re.M))
        strange = [name for name in axioms if name not in AXIOMS and not name.startswith(MACHINE_NUMBERS)]
        if strange or pieces[1::2] != found[theorem]:
            raise NotAccepted(f"{theorem} rests on {', '.join(strange) or 'a statement that was not printed'}")
        texts = {name: _dedented(text) for name, text in zip(pieces[1::2], pieces[2::2], strict=True)}
        table[theorem] = {"statements": texts, "axioms": axioms}
    return table


def _dedented(text: str) -> str:
    """Return a printed statement without the indentation that its name's line gave it."""
    first, *others = text.rstrip().split("\n")
    return textwrap.dedent("\n".join([f"       {first.strip()}", *others])).strip()


def main() -> None:
    """Compile what changed since the record was made, say what was accepted, and write the record."""
    parser = argparse.ArgumentParser(prog="python -m verify.formal", description=__doc__)
    parser.add_argument("file", nargs="*", help="this file alone, and what it requires: no record is written")
    parser.add_argument("--fresh", action="store_true", help="compile although nothing changed")
    asked = parser.parse_args()
    if unknown := set(asked.file) - (known := {path.stem for path in files()}):
        parser.error(f"file: {', '.join(sorted(unknown))} is not one of {', '.join(sorted(known))}")
    table = {} if asked.fresh or asked.file else record()
    if table:
        print("nothing changed since Coq accepted it (--fresh: again)")
    elif shutil.which("coqc") is None:
        sys.exit("Coq is not installed: apt-get install coq libcoq-coquelicot libcoq-interval libcoq-flocq")
    else:
        table = compile_files(*asked.file)
        if not asked.file:
            write_whole(KEPT, key(sources()).encode())
            text = json.dumps({"sources": sources(), "theorems": table}, indent=1, ensure_ascii=False)
            write_whole(RECORD, f"{text}\n".encode())
    for theorem, entry in table.items():
        short = sorted({a.split(".")[0 if a.startswith(MACHINE_NUMBERS) else -1] for a in entry["axioms"]})
        rests = ", ".join(short) or "closed under the global context"
        print(f"{theorem:32} {len(entry['statements']):2} statements   {rests}")


if __name__ == "__main__":
    try:
        main()
    except NotAccepted as error:
        sys.exit(str(error))
