"""The formal proofs:  python -m verify.formal compiles `proofs/formal/` with Coq and records what it accepted.

The statement ID__NAME is of the book's theorem ID; where that has several clauses, a comment says which ones it says:
Theorem (* clauses 2, 3 *) ID__NAME. ID__NAME__point gives values at which its hypotheses hold, and ID__NAME__false
refutes a false variant. A refuted theorem's statements are negations.
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
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

from tqdm import tqdm

from renderer.whole_files import write_whole
from verify.sources import ROOT, hashes, key

FOLDER = ROOT / "proofs" / "formal"
RECORD = FOLDER / "record.json"
KEPT = ROOT / ".stamps" / "formal"  # what Coq was last asked about here
STATEMENT = re.compile(r"^Theorem (?:\(\* clauses? ([\d, ]+) \*\) )?((\w+?)__\w+)", re.MULTILINE)
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
CLOSED = "Closed under the global context\n"
AXIOM = re.compile(r"[\w.]+( : .*)?$|  ")  # its name, and its type there or indented below it
MACHINE_NUMBERS = ("Uint63.", "PrimInt63.", "PrimFloat.", "FloatAxioms.", "FloatOps.", "Int63.", "Sint63.")
COQS_OWN = {name.partition(".")[0] for name in (*AXIOMS, *MACHINE_NUMBERS)}
MODULE = re.compile(r"\bModule (\w+)\.")
HIDING = re.compile(r"\b(?:Notation|Infix|Coercion|Declare|Load|Module(?! \w+\.))\b[^.\n]*")
"""What could hide from the survey what a statement says or rests on, and modules that are not named at once."""

PARTLY = {
    "bump_moves_no_boundary": "that none of these depends on the bump: the lines printed for them have no such input",
    "crease_error_area": "how many tents there are, and that they do not overlap",
    "elementary_functions": "the reduction of the argument, how many units in the last place, and all functions but "
    "sine and cosine",
    "gradient_accuracy": "ridges and rings, and the argument's reduction",
    "rounded_powers": "what one rounded square or product loses, and what a product of two real factors does",
}
"""{theorem: what of its words no statement says}"""


class NotAccepted(ValueError):
    """Coq did not accept a file, or a statement rests on an axiom that is not among those that are named."""


def layers(*wanted: str) -> list[list[str]]:
    """Return the names of the files that Coq reads, each in a later layer than those that it requires.

    All, or those that are wanted and theirs. Raises NotAccepted where one requires what is not there, or itself, where
    something is HIDING, and where a module has a name of Coq's own: an axiom in it would be printed as one of those
    that are allowed.
    """
    texts = {path.stem: path.read_text(encoding="utf-8") for path in FOLDER.glob("*.v")}
    if hiding := HIDING.findall("\n".join(texts.values())):
        raise NotAccepted(f"{'; '.join(hiding)}: that could hide what is said, or assumed")
    if taken := sorted(COQS_OWN.intersection([*texts, *MODULE.findall("\n".join(texts.values()))])):
        raise NotAccepted(f"{', '.join(taken)}: a module of Coq's own has this name")
    required = {name: REQUIRED.search(text) for name, text in texts.items()}
    needs = {name: set(match[1].split()) if match else set() for name, match in required.items()}
    if missing := set().union(*needs.values(), wanted) - needs.keys():
        raise NotAccepted(f"there is no {', '.join(sorted(missing))} in {FOLDER.name}/")
    sorter, batches = TopologicalSorter(needs), []
    try:
        sorter.prepare()
    except CycleError as error:
        raise NotAccepted(f"files that require each other: {', '.join(error.args[1])}") from error
    while ready := sorter.get_ready():
        sorter.done(*ready)
        batches.append(ready)
    reached = set(wanted or needs)
    for name in (name for batch in reversed(batches) for name in batch):
        reached |= needs[name] if name in reached else set()
    return [sorted(reached.intersection(batch)) for batch in batches]


def files(*wanted: str) -> list[Path]:
    """Return the files that Coq reads, each after those that it requires: all, or those that are wanted and theirs."""
    return [FOLDER / f"{name}.v" for layer in layers(*wanted) for name in layer]


Statements = dict[str, dict[str, list[int]]]
"""{theorem's id: {a statement's name: the clauses, counted from 1, that it is said to say}}"""


def statements(*wanted: str) -> Statements:
    """Return the statements in the order of the files."""
    named: Statements = {}
    for path in files(*wanted):
        for clauses, name, theorem in STATEMENT.findall(path.read_text(encoding="utf-8")):
            named.setdefault(theorem, {})[name] = [int(number) for number in clauses.split(",") if clauses]
    return named


def record() -> dict:
    """Return what Coq accepted, {} if that is stale.

    {theorem: {"statements": {name: text}, "clauses": {name: those it says, of several}, "axioms": [name, …]}}.
    """
    if not RECORD.is_file():
        return {}
    content = json.loads(RECORD.read_text(encoding="utf-8"))
    return content["theorems"] if content["sources"] == coq_hashes() else {}


def coq_hashes() -> dict[str, str]:
    """Return {file: hash} of everything that Coq reads; which Python asks it is no matter."""
    return {path: of for path, of in hashes(FOLDER.glob("*.v")).items() if path != "python"}


def seen() -> str:
    """Return the key of what Coq reads and of what the record says of it, to be KEPT where Coq said so, too."""
    return key({"sources": coq_hashes(), "record": RECORD.read_text(encoding="utf-8")})


def _coqc(folder: Path, name: str) -> str:
    done = subprocess.run([*COQC, name], cwd=folder, capture_output=True, text=True)
    if done.returncode:
        raise NotAccepted(f"Coq does not accept {name}:\n{done.stdout}{done.stderr}")
    return done.stdout


def compile_files(*wanted: str, said: dict | None = None) -> dict:
    """Compile files in a folder of their own and return what `record` returns; raises NotAccepted.

    said: what a record says. Coq takes long to list axioms, so it is then asked once for all theorems that are said to
    rest on the same: each rests on no more than these.
    """
    named, order = statements(*wanted), files(*wanted)
    groups = _groups(named, said or {})
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for path in order:
            shutil.copy(path, folder)
        (folder / "Survey.v").write_text(_survey(named, groups, order), encoding="utf-8")
        with tqdm(total=len(order) + 1, unit="file", disable=None) as bar, ThreadPoolExecutor(2) as pool:
            for layer in [*layers(*wanted), ["Survey"]]:
                printed = list(pool.map(lambda name: _coqc(folder, f"{name}.v"), layer))
                bar.update(len(layer))
    return _read(named, groups, printed[-1])


def _groups(named: Statements, said: dict) -> list[list[str]]:
    """Return lists of theorems: together those that are said to rest on the same axioms, else each alone."""
    groups: dict[object, list[str]] = {}
    for theorem in named:
        groups.setdefault(tuple(said[theorem]["axioms"]) if theorem in said else theorem, []).append(theorem)
    return list(groups.values())


def _survey(named: Statements, groups: list[list[str]], order: list[Path]) -> str:
    """Return the text of a file that prints each theorem's statements, then each group's axioms."""
    lines = ["From Coq Require Import Reals.", "From Coquelicot Require Import Coquelicot.", "Open Scope R_scope."]
    lines += [f"From Formal Require Import {' '.join(path.stem for path in order)}.", "Set Printing Width 72."]
    for said in named.values():
        lines += [*(f"Check {name}." for name in said), "Check I."]
    for group in groups:
        names = [name for theorem in group for name in named[theorem]]
        lines += [f"Definition all_of_{group[0]} := ({', '.join(names)}, I)."]
        lines += [f"Print Assumptions all_of_{group[0]}.", "Check I."]
    return "\n".join([*lines, ""])


def _read(named: Statements, groups: list[list[str]], printed: str) -> dict:
    """Return the record out of what the survey printed."""
    *parts, rest = printed.split(SEPARATOR)
    if len(parts) != (asked := len(named) + len(groups)) or rest.strip():
        raise NotAccepted(f"Coq printed {len(parts)} parts, not the {asked} of {len(named)} theorems")
    table = {}
    for theorem, part in zip(named, parts, strict=False):
        pieces = re.split(rf"^({'|'.join(named[theorem])})\s*:", part, flags=re.M)
        if pieces[1::2] != list(named[theorem]):
            raise NotAccepted(f"a statement of {theorem} was not printed")
        texts = {name: _dedented(text) for name, text in zip(pieces[1::2], pieces[2::2], strict=True)}
        clauses = {name: said for name, said in named[theorem].items() if said}
        table[theorem] = {"statements": texts, "clauses": clauses}
    for group, listed in zip(groups, parts[len(named) :], strict=True):
        for theorem in group:
            table[theorem]["axioms"] = _axioms(", ".join(group), listed)
    return table


def _axioms(theorem: str, printed: str) -> list[str]:
    """Return the axioms out of what Coq printed; raises NotAccepted for others, and for whatever is not an axiom."""
    if printed == CLOSED:
        return []
    heading, _, listed = printed.partition("\n")
    lines = listed.splitlines()
    names = [line.partition(" ")[0] for line in lines if not line.startswith(" ")]
    odd = [line for line in lines if not AXIOM.match(line)]
    odd += [name for name in names if name not in AXIOMS and not name.startswith(MACHINE_NUMBERS)]
    if heading != "Axioms:" or odd or not names:
        raise NotAccepted(f"{theorem} rests on {'; '.join(odd) or printed}")
    return sorted(names)


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
            text = json.dumps({"sources": coq_hashes(), "theorems": table}, indent=1, ensure_ascii=False)
            write_whole(RECORD, f"{text}\n".encode())
            write_whole(KEPT, seen().encode())
    for theorem, entry in table.items():
        short = sorted({a.split(".")[0 if a.startswith(MACHINE_NUMBERS) else -1] for a in entry["axioms"]})
        rests = ", ".join(short) or "closed under the global context"
        print(f"{theorem:32} {len(entry['statements']):2} statements   {rests}")


if __name__ == "__main__":
    try:
        main()
    except NotAccepted as error:
        sys.exit(str(error))
