"""Entries of the ledger, read from its files by schema.json; errors that show without a run are refused here.

A number has to satisfy a relation: `== 0`, `< 1e-12`, `in [0.45, 0.65]`.
"""

import operator
import re
import tomllib
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

from jsonschema import Draft202012Validator

from book.assembly.stamps import table_in
from proofs.engine.project import PROJECT
from renderer.intervals import Interval

HOLDS: dict[str, Callable[..., bool]] = {
    "==": operator.eq,
    "!=": operator.ne,
    "<=": operator.le,
    ">=": operator.ge,
    "<": operator.lt,
    ">": operator.gt,
    "in": lambda value, low, high: low <= value <= high,
}


class Relation(NamedTuple):
    """A comparison with a number, or "in" with the two ends of an interval."""

    sign: str
    numbers: tuple[float, ...]

    def holds(self, value: float | Interval) -> bool:
        """Return whether a number satisfies it; of one that is enclosed, whether it certainly does."""
        ends = (value.lower, value.upper) if isinstance(value, Interval) else (value,)
        return all(HOLDS[self.sign](end, *self.numbers) for end in ends)


def relation(text: str) -> Relation:
    """Read a relation, of the form that the schema allows; ValueError where an interval ends before it begins."""
    sign, *ends = re.findall(r"[^\s\[\],]+", text)
    numbers = tuple(map(float, ends))
    if list(numbers) != sorted(numbers):
        raise ValueError(f"{text!r} ends before it begins")
    return Relation(sign, numbers)


FOLDER = PROJECT.pages / "ledger"
CONDITIONAL, OUTSIDE = "holds with a condition", "outside this chapter: not checked"
SCHEMA = table_in(Path(__file__).with_name("schema.json"))
VERDICTS = tuple(SCHEMA["$defs"]["claim"]["properties"]["verdict"]["enum"])  # as a reader meets them
FINDINGS, WORDS = (
    table_in(path)[path.stem] if (path := FOLDER / f"{name}.toml").is_file() else {} for name in ("findings", "words")
)
"""{code: the name of the finding}, {number: what it says}"""
KINDS = ("theorem", "number", "test", "source")


class BadLedger(ValueError):
    """Return the ledger's faults, one line a fault; each names the entry and the field."""

    def __init__(self, faults: list[str]):
        super().__init__("the ledger does not stand:\n" + "\n".join(f"  {fault}" for fault in faults))
        self.faults = faults


@dataclass(frozen=True)
class Evidence:
    """One piece: `kind` is theorem, number, test or source, `name` its id; `wants` a number's relation.

    claimed: the relation that the claim's words give a number ("" for none). refutes: what the entry says, or None.
    """

    kind: str
    name: str
    wants: str = ""
    claimed: str = ""
    refutes: bool | None = None


@dataclass(frozen=True)
class LedgerClaim:
    """One entry; texts are MyST, "" where there is none. Of one whose form is wrong no verdict, and what is right."""

    id: str = ""
    words: str = ""
    where: str = ""
    verdict: str = ""
    file: str = ""
    so: str = ""
    merit: str = ""
    condition: str = ""
    reason: str = ""
    findings: tuple[str, ...] = ()
    evidence: tuple[Evidence, ...] = ()

    @property
    def of_seed(self) -> bool:
        """Return whether the seed says it; otherwise the book does."""
        return self.where.startswith("seed:")


@dataclass(frozen=True)
class Ledger:
    """All claims, the places of the seed, with their names, and the faults that show without a run."""

    claims: tuple[LedgerClaim, ...]
    places: dict[str, str]
    faults: tuple[str, ...] = ()

    def get(self, id: str) -> LedgerClaim:
        """Return the claim of an id; KeyError if there is none."""
        return {claim.id: claim for claim in self.claims}[id]

    def sorted_by_place(self) -> list[LedgerClaim]:
        """Return the seed's claims in the order of its places, then the book's by page."""
        order = {f"seed:{place}": number for number, place in enumerate(self.places)}
        sections = PROJECT.sections  # before the other pages
        return sorted(self.claims, key=lambda c: (order.get(c.where, len(order)), c.where not in sections, c.where))


def load(folder: Path = FOLDER) -> Ledger:
    """Read claims/*.toml and places.toml."""
    faults: list[str] = []
    claims = []
    for path in sorted((folder / "claims").glob("*.toml")):
        for table in _read(path, "file", faults).get("claim", ()):
            odd = dict(_faults("claim", table, f"{path.name}: {table.get('id')}"))
            faults += odd
            right = {field: value for field, value in table.items() if field not in odd.values()}
            claims.append(_claim(right | {"file": path.name} | ({"verdict": ""} if odd else {})))
    ids = [claim.id for claim in claims]
    faults += [f"{id}: id: two claims have it" for id in sorted({id for id in ids if id and ids.count(id) > 1})]
    places = _read(folder / "places.toml", "places", faults).get("places", {})
    return Ledger(tuple(claims), places, tuple(faults))


def _read(path: Path, kind: str, faults: list[str]) -> dict:
    """Return a file's content; what is wrong with it is added to the faults."""
    try:
        content = table_in(path)
    except tomllib.TOMLDecodeError as error:
        faults.append(f"{path.name}: {error}")
        return {}
    faults += dict(_faults(kind, content, path.name))
    return content


def _faults(kind: str, table: dict, name: str) -> Iterator[tuple[str, Any]]:
    """Return a table's fault by schema.json: its name, field, value and what is allowed; and that field."""
    schema = {"$ref": f"#/$defs/{kind}", "$defs": SCHEMA["$defs"]}
    for error in Draft202012Validator(schema).iter_errors(table):
        place = " ".join([name, *map(str, error.absolute_path)])
        told = repr(error.instance) if error.validator == "pattern" else error.message
        told = ": ".join(filter(None, [place, told, error.schema.get("description")]))
        yield told, next(iter(error.absolute_path), "")


def _claim(table: dict) -> LedgerClaim:
    names = table.keys() & LedgerClaim.__annotations__
    texts = {field: " ".join(table[field].split()) for field in names if isinstance(table[field], str)}
    return LedgerClaim(
        **texts, findings=tuple(table.get("findings", ())), evidence=tuple(map(_evidence, table.get("evidence", ())))
    )


def _evidence(piece: dict) -> Evidence:
    kind = next(kind for kind in KINDS if kind in piece)
    return Evidence(kind, piece[kind], piece.get("is", ""), piece.get("claimed", ""), piece.get("refutes"))
