"""One theorem as one Python script: the kernel's source, the statement, its certificate, and nothing else to install.

`python -m proofs.engine.standalone ID > theorem.py` writes it; `python -I -S theorem.py` runs it, with the standard
library alone. It prints what was checked, and exits with 1 where the kernel rejects something.
"""

import hashlib
import inspect
import json
import sys
import textwrap
import time

from proofs.engine import kernel
from proofs.engine.certificate import path_of
from proofs.engine.kernel import check
from proofs.engine.theorem import all_theorems

SCRIPT = '''#!/usr/bin/env python3
{header}

# 1. The kernel: proofs/engine/kernel.py, as it stands. Read it first; it decides.

{kernel}

# 2. The statement, as polynomials, and its certificate, as the search found it; proofs/engine/statement_data.py has
# the format.

DATA = r"""
{data}
"""

GIVEN = {given!r}  # what it borrows from theorems, which have scripts of their own, or cites from elsewhere

# 3. What happens when the script is run.

import hashlib
import json
import sys
import time


{run}

if __name__ == "__main__":
    sys.exit(run(DATA, GIVEN))
'''


def run(text, given=""):
    """Check every statement of the certificate's JSON text; print what was checked; return 0, or 1 on a rejection."""
    start, data, failures, terms = time.perf_counter(), json.loads(text), 0, 0
    if json.dumps(data, indent=1, ensure_ascii=False) != text.strip():
        print("REJECTED: the text is not its own canonical form.")
        return 1
    kinds = {pair["statement"]["kind"] for claim in data["claims"] for pair in claim["statements"]}
    for claim in data["claims"]:
        for number, pair in enumerate(claim["statements"], 1):
            statement = pair["statement"]
            canonical = json.dumps(statement, sort_keys=True, separators=(",", ":"))
            same = hashlib.sha256(canonical.encode()).hexdigest() == pair["sha256"]
            why = check(statement, pair["certificate"]) if same else "the statement is not the one that was hashed"
            failures += why is not None
            parts = next(statement[key] for key in ("steps", "lines", "show") if key in statement)
            terms += len(json.dumps(pair["certificate"]).split())
            verdict = "accepted" if why is None else f"REJECTED: {why}"
            shown = f"{claim['claim']} {number}: {statement['kind']}, {len(parts)} lines, sha256 {pair['sha256'][:12]}"
            print(f"{shown}: {verdict}")
    verdict = "REJECTED" if failures or not kinds else "REFUTED" if kinds == {"refutation"} else "PROVED"
    given = f", given {given}" if given and verdict == "PROVED" else ""
    print(f"{data['theorem']}: {verdict}{given}.")
    size = f"{len(text)} characters of statements and certificates, {terms} words of them in the certificates"
    print(f"{size}, checked in {time.perf_counter() - start:.3f} s by exact rational arithmetic.")
    return int(verdict == "REJECTED")


def standalone_script(theorem_id: str) -> str:
    """Return the text of the theorem's script. Raises ValueError for a theorem that has no certificate."""
    theorem = all_theorems()[theorem_id]
    if not theorem.claims:
        raise ValueError(f"{theorem_id} is {theorem.expected}: it has no certificate")
    borrowed = [f"{id}/{name}" for claim in theorem.claims for id, name in getattr(claim, "borrowed", ())]
    cited = [lemma.source for claim in theorem.claims for lemma in getattr(claim, "cited", ())]
    cited += [theorem.source] if theorem.source else []
    return SCRIPT.format(
        header=_header(theorem),
        kernel=inspect.getsource(kernel).strip(),
        data=path_of(theorem).read_text(encoding="utf-8").strip(),
        given=", ".join(dict.fromkeys([*borrowed, *cited])),
        run=inspect.getsource(run).strip(),
    )


def _header(theorem):
    """Return the script's docstring: the theorem as the reader sees it, and what to do with the file."""
    lemmas = [lemma for claim in theorem.claims for lemma in getattr(claim, "cited", ())]
    claim = "refuted by an exact counterexample" if theorem.expected == "refuted" else "proved by a certificate"
    parts = [
        f"{theorem.title} ({theorem.id}), {claim}.",
        theorem.words,
        *(f"Argued, and not checked here: {clause.text} ({clause.argued})." for clause in theorem.argued),
        *(f"Given: {hypothesis}." for hypothesis in theorem.hypotheses),
        *(f"Given, from {lemma.source}: {lemma.text}." for lemma in lemmas),
        *([f"It uses, each with a script of its own: {', '.join(theorem.uses)}."] if theorem.uses else []),
        "Run it with Python 3.10 or later, and nothing else: python -I -S theorem.py. It prints a verdict, and exits "
        "with 1 if the kernel rejects anything. Change a number below, and it does.",
    ]
    text = "\n\n".join(textwrap.fill(part, 112, break_long_words=False, break_on_hyphens=False) for part in parts)
    return f'r"""{text}\n"""'


def main(arguments):
    """Write the named theorem's script to standard output."""
    if len(arguments) != 1 or arguments[0] not in all_theorems():
        print(
            f"usage: python -m proofs.engine.standalone ID, with one of: {', '.join(all_theorems())}", file=sys.stderr
        )
        return 2
    sys.stdout.reconfigure(encoding="utf-8")
    sys.stdout.write(standalone_script(arguments[0]))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
