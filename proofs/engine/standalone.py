"""One theorem as one Python script: the kernel's source, the statement, its certificate, and nothing else to install.

`python -m proofs.engine.standalone ID > theorem.py` writes it; `python -I -S theorem.py` runs it, with the standard
library alone. It prints what was checked, and exits with 1 where the kernel rejects something.
"""

import argparse
import inspect
import json
import sys
import textwrap

from proofs import check
from proofs.check import verdicts
from proofs.engine import kernel
from proofs.engine.stored import path_of
from proofs.engine.theorem import all_theorems

SCRIPT = '''#!/usr/bin/env python3
{header}

# 1. The kernel: proofs/engine/kernel.py, as it stands. Read it first; it decides.

{kernel}

# 2. That hypotheses can hold, and what a file of certificates looks like: proofs/check.py, as it stands. The lines
# before it let it import the kernel above, and keep its own command from running.

import sys
import types

sys.modules["proofs.engine"] = types.ModuleType("proofs.engine")
sys.modules["proofs.engine"].kernel = sys.modules[__name__]
this_script, __name__ = __name__, "proofs.check"

{check}

__name__ = this_script

# 3. The statement, as polynomials, its certificate, as the search found it, and a point where its hypotheses hold;
# proofs/engine/certificate.py has the format.

DATA = r"""{data}"""

# 4. What happens when the script is run.

{run}

if __name__ == "__main__":
    sys.exit(run(DATA, {id!r}, {given!r}))
'''


def run(text: str, theorem: str, given: str = "") -> int:
    """Check every statement of a certificate file's text; print what was checked; return 0, or 1 on a rejection."""
    found = verdicts(text, theorem)
    for claim, why in found:
        print(f"{claim}: {'accepted' if why is None else f'REJECTED: {why}'}")
    if rejected := any(why is not None for _, why in found) or not found:
        verdict = "REJECTED"
    else:
        kinds = {entry["statement"]["kind"] for claim in json.loads(text)["claims"] for entry in claim["statements"]}
        verdict = "REFUTED" if kinds == {"refutation"} else f"PROVED, given {given}" if given else "PROVED"
    print(f"{theorem}: {verdict}.")
    print(f"{len(text)} characters of statements, certificates and points, checked by exact rational arithmetic.")
    return int(rejected)


def standalone_script(theorem_id: str) -> str:
    """Return the text of the theorem's script. Raises ValueError for a theorem that has no certificate."""
    theorem = all_theorems()[theorem_id]
    if not theorem.claims:
        raise ValueError(f"{theorem_id} is {theorem.expected}: it has no certificate")
    cited = [lemma.source for claim in theorem.claims for lemma in claim.cited]
    return SCRIPT.format(
        header=_header(theorem),
        kernel=inspect.getsource(kernel).strip(),
        check=inspect.getsource(check).strip(),
        data=path_of(theorem).read_text(encoding="utf-8"),
        id=theorem_id,
        given=", ".join(dict.fromkeys(cited)),
        run=inspect.getsource(run).strip(),
    )


def _header(theorem):
    """Return the script's docstring: the theorem as the reader sees it, and what to do with the file."""
    lemmas = [lemma for claim in theorem.claims for lemma in claim.cited]
    claim = "refuted by an exact counterexample" if theorem.expected == "refuted" else "proved by a certificate"
    parts = [
        f"{theorem.title} ({theorem.id}), {claim}.",
        theorem.words,
        *(f"Given: {hypothesis}." for hypothesis in theorem.hypotheses),
        *(f"Given, from {lemma.source}: {lemma.text}." for lemma in lemmas),
        *([f"It uses, each with a script of its own: {', '.join(theorem.uses)}."] if theorem.uses else []),
        "Run it with Python 3.10 or later, and nothing else: python -I -S theorem.py. It prints a verdict, and exits "
        "with 1 if the kernel rejects anything. Change a number below, and it does.",
    ]
    text = "\n\n".join(textwrap.fill(part, 112, break_long_words=False, break_on_hyphens=False) for part in parts)
    return f'r"""{text}\n"""'


def main(arguments: list[str] | None = None) -> None:
    """Write the named theorem's script to standard output; an unknown name is a usage error."""
    parser = argparse.ArgumentParser(prog="python -m proofs.engine.standalone", description=__doc__)
    parser.add_argument("id", metavar="ID", choices=all_theorems(), help="the theorem")
    sys.stdout.buffer.write(standalone_script(parser.parse_args(arguments).id).encode())


if __name__ == "__main__":
    main()
