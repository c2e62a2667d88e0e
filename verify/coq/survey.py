"""Coq's survey of compiled files: the statements of each theorem, the claims that it proves, and their axioms."""

import re
import textwrap
from collections.abc import Iterable
from dataclasses import dataclass, field

from verify.coq.recorded import reached

AXIOMS = {
    "ClassicalDedekindReals.sig_forall_dec": "the real numbers",
    "ClassicalDedekindReals.sig_not_dec": "the real numbers",
    "FunctionalExtensionality.functional_extensionality_dep": "functions",
    "Classical_Prop.classic": "the excluded middle",
}
"""{axiom: its subject}. Where `interval` computes, the specifications of Coq's machine numbers come to these."""
BESIDE = ("__point", "__false")
"""The suffixes of additions that add nothing to a theorem: values for its hypotheses, a refuted false variant. Their
axioms are no theorem's, and have to be among these, too."""
SEPARATOR = "I\n     : True\n"
CLOSED = "Closed under the global context\n"
AXIOM = re.compile(r"[\w.]+( : .*)?$|  ")  # its name, and its type there or indented below it
MACHINE_NUMBERS = ("Uint63.", "PrimInt63.", "PrimFloat.", "FloatAxioms.", "FloatOps.", "Int63.", "Sint63.")
COQS_OWN = {name.partition(".")[0] for name in (*AXIOMS, *MACHINE_NUMBERS)}


class NotAccepted(ValueError):
    """Coq did not accept a file, or a statement rests on an axiom that is not among those that are named."""


@dataclass
class Formalization:
    """The parts of a theorem's formalization that are written by hand.

    claims: {its printed name: the file that proves it}. additions: the names of other statements.
    """

    claims: dict[str, str] = field(default_factory=dict)
    additions: list[str] = field(default_factory=list)


Statements = dict[str, Formalization]


def groups(named: Statements, record: dict) -> list[list[str]]:
    """Group theorems by their axioms in the record; return the lists. One that is not in the record is alone."""
    alike: dict[object, list[str]] = {}
    for theorem in named:
        alike.setdefault(tuple(record[theorem]["axioms"]) if theorem in record else theorem, []).append(theorem)
    return list(alike.values())


def survey(named: Statements, definitions: list[str], asked: list[list[str]], order: list[str]) -> dict[str, str]:
    """Return the texts of two files: one prints each theorem's statements and what is defined by hand, then both print
    half of the groups' axioms.

    Coq lists axioms as long as it checks proofs, so both are asked at once; what they print is read as one.
    A claim's proof is asked for by its full name, to be of the printed proposition's full name: the kernel decides.
    """
    lines = ["From Coq Require Import Reals.", "From Coquelicot Require Import Coquelicot.", "Open Scope R_scope."]
    lines += [f"From Formal Require Import {' '.join(order)}.", "Set Printing Width 72."]
    lines += ["Set Printing Depth 1000."]
    checks = []
    for by_hand in named.values():
        for name, file in by_hand.claims.items():
            lines += [f"Definition proved_{name} : Formal.Statements.{name} := Formal.{file}.{name}."]
        checks += [*(f"Check {name}." for name in by_hand.additions), "Check I."]
    checks += [f"Print {name}. Check I." for name in definitions]
    half = len(asked) // 2
    beside = [name for each in named.values() for name in each.additions if name.endswith(BESIDE)]
    axioms = [*_axioms_asked(named, asked[half:]), *_listed("beside", beside)]
    parts = {"Survey": [*checks, *_axioms_asked(named, asked[:half])], "Axioms": axioms}
    return {file: "\n".join([*lines, *part, ""]) for file, part in parts.items()}


def _axioms_asked(named: Statements, asked: list[list[str]]) -> list[str]:
    lines = []
    for group in asked:
        names = [name for theorem in group for name in named[theorem].additions if not name.endswith(BESIDE)]
        names += [f"proved_{name}" for theorem in group for name in named[theorem].claims]
        lines += _listed(f"of_{group[0]}", names)
    return lines


def _listed(of: str, names: list[str]) -> list[str]:
    return [f"Definition all_{of} := ({', '.join([*names, 'I'])}).", f"Print Assumptions all_{of}.", "Check I."]


def names_asked(names: Iterable[str], required: Iterable[str]) -> str:
    """Return the text of a file that Coq accepts if none of the names is taken by then."""
    return "\n".join([*sorted(set(required)), *(f"Fail Check {name}." for name in sorted(set(names))), ""])


def read(named: Statements, definitions: list[str], asked: list[list[str]], printed: str) -> dict:
    """Return the record from the two texts that Coq printed for the files of the survey."""
    *parts, rest = printed.split(SEPARATOR)
    if len(parts) != (number := len(named) + len(definitions) + len(asked) + 1) or rest.strip():
        raise NotAccepted(f"Coq printed {len(parts)} parts, not the {number} of {len(named)} theorems")
    of_axioms = len(named) + len(definitions)
    defined = [part.partition("\n\nArguments ")[0].strip() for part in parts[len(named) : of_axioms]]
    table: dict[str, dict] = {}
    meaning = dict(zip(definitions, defined, strict=True))
    for (theorem, by_hand), part in zip(named.items(), parts, strict=False):
        pieces = re.split(rf"^({'|'.join(by_hand.additions)})\s*:", part, flags=re.M) if by_hand.additions else [part]
        if pieces[1::2] != list(by_hand.additions) or pieces[0].strip():
            raise NotAccepted(f"a statement of {theorem} was not printed")
        texts = {name: _dedented(text) for name, text in zip(pieces[1::2], pieces[2::2], strict=True)}
        table[theorem] = {"claims": list(by_hand.claims), "statements": texts}
        table[theorem]["definitions"] = reached(" ".join(texts.values()), meaning)
        if "..." in "".join([*texts.values(), *table[theorem]["definitions"].values()]):
            raise NotAccepted(f"a statement of {theorem} was printed in part")
    for group, listed in zip(asked, parts[of_axioms:-1], strict=True):
        for theorem in group:
            table[theorem]["axioms"] = _axioms(", ".join(group), listed)
    _axioms("a point or a false variant", parts[-1])
    return table


def _axioms(theorem: str, printed: str) -> list[str]:
    """Return the axioms that Coq printed; raises NotAccepted for one that is not allowed, and for any other text."""
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
