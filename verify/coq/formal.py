"""The formal proofs:  python -m verify.coq compiles `proofs/formal/` with Coq and records the theorems that it accepts,
and the goals of each step.

A claim x is proved by `Theorem x : Statements.x.`, where Statements.x is printed from it: Coq is asked in a process of
its own, which loads compiled files only, whether x has that type, and for its axioms. Other theorems, ID__NAME, are
additions of the book's theorem ID: ID__NAME__point gives values at which its hypotheses hold, and ID__NAME__false
refutes a false variant. A theorem is formal where all of its words are said by claims that are proved so, or by
additions that it pins.
"""

import argparse
import hashlib
import json
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterable
from concurrent.futures import FIRST_COMPLETED, ThreadPoolExecutor, wait
from datetime import date
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

from proofs.engine.claim import Separation
from proofs.engine.project import PROJECT
from proofs.engine.theorem import Theorem
from renderer.whole_files import write_whole
from verify.coq import survey, vernacular
from verify.coq.recorded import FOLDER, RECORD, coq_hashes, record, why_not_pinned
from verify.coq.survey import COQS_OWN, MACHINE_NUMBERS, Formalization, NotAccepted, Statements
from verify.evidence.sources import ROOT, key

KEPT = ROOT / ".stamps" / "formal"  # what Coq was last asked about here
STATEMENT = re.compile(r"^Theorem ((\w+?)__\w+)", re.MULTILINE)
PROVED = re.compile(r"(?:Theorem|Lemma) (\w+) : Statements\.(\w+)")
REQUIRED = re.compile(r"^From Formal Require (?:Import )?([\w\s]+)\.", re.MULTILINE)
LIBRARY = re.compile(r"^From (?!Formal\b)\w+ Require Import [\w\s]+\.", re.MULTILINE)
COQC = ("coqc", "-w", "-ambiguous-paths", "-Q", ".", "Formal")
WORKERS = 2
PRINTED = tuple(Path(name).stem for name in PROJECT.printed if name.endswith(".v"))
TRUSTED = PROJECT.trusted
"""{what printed files need and no library has: its hash}, which the book prints."""
GIVEN = {*PRINTED, *TRUSTED}


def in_order(*wanted: str) -> tuple[dict[str, str], dict[str, set[str]]]:
    """Return {name: text} of the files that Coq reads, each after those that it requires, and {name: what it requires}.

    All, or those that are wanted and theirs. Raises NotAccepted where one requires what is not there, or itself, where
    one written by hand could change how a statement is read, where a printed or trusted one requires one written by
    hand, or another text stands in it, and where a file has a name of Coq's own: an axiom in it would be printed as one
    of those that are allowed.
    """
    texts = {path.stem: path.read_text(encoding="utf-8") for path in FOLDER.glob("*.v")}
    if taken := sorted(COQS_OWN.intersection(texts)):
        raise NotAccepted(f"{', '.join(taken)}: a module of Coq's own has this name")
    needs = {name: set(" ".join(REQUIRED.findall(text)).split()) for name, text in texts.items()}
    for name, text in texts.items():
        _readable(name, text, needs[name])
    if twice := vernacular.given_twice(_by_hand(texts)):
        raise NotAccepted(f"names that are given twice: {', '.join(twice)}")
    if missing := set().union(*needs.values(), wanted) - needs.keys():
        raise NotAccepted(f"there is no {', '.join(sorted(missing))} in {FOLDER.name}/")
    try:
        order = [*TopologicalSorter({name: sorted(needs[name]) for name in sorted(needs)}).static_order()]
    except CycleError as error:
        raise NotAccepted(f"files that require each other: {', '.join(error.args[1])}") from error
    reached = set(wanted or needs)
    for name in reversed(order):
        reached |= needs[name] if name in reached else set()
    return {name: texts[name] for name in order if name in reached}, {name: needs[name] for name in reached}


def _by_hand(texts):
    return {name: text for name, text in texts.items() if name not in GIVEN}


def _readable(name, text, needs):
    if name not in GIVEN:
        try:
            vernacular.check(text)
        except vernacular.Unreadable as error:
            raise NotAccepted(f"{name}: {error}: that could hide what is said, or assumed") from error
    elif by_hand := needs - GIVEN:
        raise NotAccepted(f"{name} requires {', '.join(sorted(by_hand))}, which is written by hand")
    elif name in TRUSTED and hashlib.sha256(text.encode()).hexdigest() != TRUSTED[name]:
        raise NotAccepted(f"{name} is not the text that is trusted")


def statements(*wanted: str) -> Statements:
    """Return what is said of each theorem, in the order of the files."""
    named: Statements = {}
    for file, text in in_order(*wanted)[0].items():
        matches = filter(None, map(PROVED.fullmatch, vernacular.sentences(text) if file not in PRINTED else ()))
        proved = {match[1]: match[2] for match in matches}
        for name, claim in proved.items():
            if name != claim:
                raise NotAccepted(f"{name} proves {claim}, and has to have its name")
            named.setdefault(name.partition("__")[0], Formalization()).claims[name] = file
        for name, theorem in STATEMENT.findall(text):
            if name not in proved:
                named.setdefault(theorem, Formalization()).additions.append(name)
    return named


def is_formal(theorem: Theorem, accepted: dict | None) -> bool:
    """Return whether Coq accepted each claim of a theorem and each statement that it pins.

    accepted: its entry of the record. A Separation is left to the kernel.
    """
    claims = (*theorem.claims, *theorem.rounded)
    names = {f"{theorem.id}__{claim.name}" for claim in claims if not isinstance(claim, Separation)}
    if not (names or theorem.pinned) or why_not_pinned(theorem):
        return False
    return names <= set(accepted["claims"] if accepted else ())


def accepted_key() -> str:
    """Return the key of the files that Coq reads and of their record; KEPT has it after Coq accepted them."""
    return key({"sources": coq_hashes(), "record": RECORD.read_text(encoding="utf-8")})


def accepted_here() -> bool:
    """Return whether Coq has accepted on this machine what the record says of the files as they are."""
    return bool(record()) and KEPT.is_file() and KEPT.read_text(encoding="utf-8") == accepted_key()


def proved(theorems: Iterable[Theorem]) -> set[str]:
    """Return the ids of the theorems of which the record has every claim; Coq must have agreed to it before."""
    accepted = record()
    return {theorem.id for theorem in theorems if is_formal(theorem, accepted.get(theorem.id))}


def day() -> str:
    """Return the day on which Coq accepted what the record says."""
    return json.loads(RECORD.read_text(encoding="utf-8"))["date"]


def when() -> str:
    """Return where, or on which day, Coq accepted what the record says. KEPT decides the words, and no grade."""
    return "accepted here" if accepted_here() else f"recorded on {day()}, not re-checked here"


def _asked(folder: Path, *command: str) -> str:
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if done.returncode:
        raise NotAccepted(f"{command[0]} does not accept {command[-1]}:\n{done.stdout}{done.stderr}")
    return done.stdout


def _compiled(folder, needs, pool, bar):
    """Compile files, each as soon as those that it requires are compiled, and return what Coq printed of each."""
    sorter, printed, ready, running = TopologicalSorter(needs), {}, [], {}
    sorter.prepare()
    while sorter.is_active():
        ready += sorter.get_ready()
        while ready and len(running) < WORKERS:
            name = ready.pop(0)
            running[pool.submit(_asked, folder, *COQC, f"{name}.v")] = name
        for done in wait(running, return_when=FIRST_COMPLETED).done:
            name = running.pop(done)
            printed[name] = done.result()
            sorter.done(name)
            bar.update()
    return printed


def check_again(folder: Path, names: list[str]) -> None:
    """Let Coq's own checker read compiled files, each by itself; raises NotAccepted."""
    each = [part for name in names for part in ("-norec", f"Formal.{name}")]
    _asked(folder, "coqchk", "-silent", "-bytecode-compiler", "yes", *each, *COQC[-3:])


def compile_files(*wanted: str, before: dict | None = None, again: bool = False, steps: bool = False) -> dict:
    """Compile files in a folder of their own and return what `record` returns; raises NotAccepted.

    before: a record. Coq takes long to list axioms, so it is then asked once for all theorems that by it rest on
    the same: each rests on no more than these. again: Coq's own checker, which has a kernel and no tactics, has
    to accept each compiled file, too. steps: the goals of each step of the files by hand are recorded.
    """
    from tqdm import tqdm

    named, (texts, needs) = statements(*wanted), in_order(*wanted)
    asked, by_hand = survey.groups(named, before or {}), _by_hand(texts)
    names = {name for text in by_hand.values() for name in vernacular.named(text)}
    required = [line for text in by_hand.values() for line in LIBRARY.findall(text)]
    required += [f"From Formal Require Import {name}." for name in GIVEN.intersection(texts)]
    proved = {name for each in named.values() for name in each.claims}
    names_asked = survey.names_asked(names - proved, required)
    definitions = [name for text in by_hand.values() for name in vernacular.defined(text)]
    asks = {"Names": names_asked, **survey.survey(named, definitions, asked, [*texts])}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for file, text in (texts | asks).items():
            (folder / f"{file}.v").write_text(text, encoding="utf-8")
        with tqdm(total=len(texts) + len(asks), unit="file", disable=None) as bar, ThreadPoolExecutor(WORKERS) as pool:
            printed = _compiled(folder, needs | {name: {*texts} for name in asks}, pool, bar)
        if again:
            check_again(folder, [*texts])
        if steps:
            from verify.coq import goals  # not above: pages show them, and no grade rests on them

            goals.write(folder, by_hand, COQC[1:], GIVEN.intersection(texts))
    return survey.read(named, definitions, asked, "".join(printed[name] for name in [*asks][1:]))


def printed_otherwise() -> list[str]:
    """Return the names of the printed files whose text is not the one printed now: it could state another claim."""
    from renderer.generate.__main__ import PRINTED as SOURCES  # not above: it prints, and decides nothing

    texts = {FOLDER / path.name: source_of for path, source_of in SOURCES.items() if path.suffix == ".v"}
    return [path.name for path, source_of in texts.items() if path.read_text(encoding="utf-8") != source_of()]


def main() -> None:
    """Compile what changed since the record was made, say what was accepted, and write the record."""
    parser = argparse.ArgumentParser(prog="python -m verify.coq", description=__doc__)
    parser.add_argument("file", nargs="*", help="this file alone, and what it requires: no record is written")
    parser.add_argument("--fresh", action="store_true", help="compile although nothing changed")
    parser.add_argument("--coqchk", action="store_true", help="compile again, and let Coq's own checker read it, too")
    asked = parser.parse_args()
    PROJECT.require_writable()
    if unknown := set(asked.file) - (names := in_order()[0].keys()):
        parser.error(f"file: {', '.join(sorted(unknown))} is not one of {', '.join(sorted(names))}")
    table = {} if asked.fresh or asked.file or asked.coqchk else record()
    if table:
        print("nothing changed since Coq accepted it (--fresh: again)")
    elif shutil.which("coqc") is None:
        sys.exit("Coq is not installed: apt-get install coq libcoq-coquelicot libcoq-interval libcoq-flocq")
    elif changed := printed_otherwise():
        sys.exit(f"{', '.join(changed)}: not what python -m renderer.generate prints now")
    else:
        table = compile_files(*asked.file, again=asked.coqchk, steps=not asked.file)
        if not asked.file:
            content = {"date": date.today().isoformat(), "sources": coq_hashes(), "theorems": table}
            text = json.dumps(content, indent=1, ensure_ascii=False)
            write_whole(RECORD, f"{text}\n".encode())
            write_whole(KEPT, accepted_key().encode())
    for theorem, entry in table.items():
        short = sorted({a.split(".")[0 if a.startswith(MACHINE_NUMBERS) else -1] for a in entry["axioms"]})
        rests = ", ".join(short) or "closed under the global context"
        counts = "  ".join(f"{len(entry[of]):2} {of}" for of in ("claims", "statements"))
        print(f"{theorem:32} {counts}   {rests}")
