"""Read the ledger's files into entries, and refuse what no run is needed to refuse."""

import re
import tomllib
from dataclasses import dataclass
from pathlib import Path

from book.ledger.relations import relation

FOLDER = Path(__file__).resolve().parent
CONDITIONAL, OUTSIDE = "holds with a condition", "outside this chapter: not checked"
VERDICTS = ("false", "corrected", CONDITIONAL, "holds", OUTSIDE)  # in the order in which a reader meets them
FINDINGS = tuple(f"F{number}" for number in range(1, 23))
KINDS = {  # what an evidence may be, and the fields that go with each: required, optional
    "theorem": ({"grade"}, {"refutes"}),
    "number": ({"is"}, {"claimed"}),
    "test": (set(), {"refutes"}),
    "source": (set(), {"refutes"}),
}
REQUIRED = ("id", "words", "where", "verdict")
FIELDS = {*REQUIRED, "findings", "evidence", "so", "merit", "condition", "reason"}
NUMBER_ROLE = re.compile(r"\{number\}`([^`|\s]+)[^`]*`")


class BadLedger(ValueError):
    """What is wrong with the ledger, one line a fault; each names the entry and the field."""

    def __init__(self, faults: list[str]):
        super().__init__("the ledger does not stand:\n" + "\n".join(f"  {fault}" for fault in faults))
        self.faults = faults


@dataclass(frozen=True)
class Evidence:
    """One piece: `kind` is theorem, number, test or source, `name` its id; `wants` the grade or the relation.

    claimed: the relation that the claim's words give a number ("" for none). refutes: what the entry says, or None.
    """

    kind: str
    name: str
    wants: str = ""
    claimed: str = ""
    refutes: bool | None = None


@dataclass(frozen=True)
class Claim:
    """One entry; texts are MyST, "" where there is none."""

    id: str
    words: str
    where: str
    verdict: str
    so: str = ""
    merit: str = ""
    condition: str = ""
    reason: str = ""
    findings: tuple[str, ...] = ()
    evidence: tuple[Evidence, ...] = ()

    @property
    def of_seed(self) -> bool:
        """Whether the seed says it; otherwise the book does."""
        return self.where.startswith("seed:")

    def texts(self) -> dict[str, str]:
        """Every text by its field."""
        fields = ("words", "so", "merit", "condition", "reason")
        return {name: getattr(self, name) for name in fields if getattr(self, name)}


@dataclass(frozen=True)
class Ledger:
    """All claims; the theorems that need none, with the reason; and the places of the seed, with their names."""

    claims: tuple[Claim, ...]
    background: dict[str, str]
    places: dict[str, str]

    def get(self, id: str) -> Claim:
        """The claim of that id; BadLedger if there is none."""
        for claim in self.claims:
            if claim.id == id:
                return claim
        raise BadLedger([f"{id!r}: no claim has this id"])

    def cited_numbers(self) -> dict[str, tuple[str, ...]]:
        """Every number that a claim rests on, with the relations that are asked of it."""
        found: dict[str, tuple[str, ...]] = {}
        for piece in (piece for claim in self.claims for piece in claim.evidence if piece.kind == "number"):
            found[piece.name] = tuple(dict.fromkeys((*found.get(piece.name, ()), piece.wants)))
        return dict(sorted(found.items()))

    def sorted_by_place(self) -> list[Claim]:
        """The seed's claims in the order of its places, then the book's by page."""
        order = {f"seed:{place}": number for number, place in enumerate(self.places)}
        return sorted(self.claims, key=lambda claim: (order.get(claim.where, len(order)), page_order(claim.where)))


def page_order(where: str) -> tuple:
    """s2 before s10, and numbered pages before named ones."""
    match = re.fullmatch(r"s(\d+)", where)
    return (0, int(match[1]), "") if match else (1, 0, where)


def load(folder: Path = FOLDER) -> Ledger:
    """Read claims/*.toml, background.toml and places.toml; BadLedger with every fault that shows without a run."""
    faults: list[str] = []
    claims = []
    for path in sorted((folder / "claims").glob("*.toml")):
        tables = _read(path, faults)
        if unknown := sorted(tables.keys() - {"claim"}):
            faults.append(f"{path.name}: {', '.join(unknown)}: a file of claims holds [[claim]] tables alone")
        claims += [claim for table in tables.get("claim", ()) if (claim := _claim(table, path.name, faults))]
    seen: set[str] = set()
    for claim in claims:
        if claim.id in seen:
            faults.append(f"{claim.id}: id: two claims have it")
        seen.add(claim.id)
    background = {}
    for table in _read(folder / "background.toml", faults).get("background", ()):
        if not table.get("reason"):
            faults.append(f"background {table.get('theorem')!r}: reason: missing")
        background[table.get("theorem", "")] = table.get("reason", "")
    places = _read(folder / "places.toml", faults).get("places", {})
    if faults:
        raise BadLedger(faults)
    return Ledger(tuple(claims), background, places)


def _read(path: Path, faults: list[str]) -> dict:
    if not path.is_file():
        return {}
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except tomllib.TOMLDecodeError as error:
        faults.append(f"{path.name}: {error}")
        return {}


def _claim(table: dict, file: str, faults: list[str]) -> Claim | None:
    """One table as a claim; None, with the faults noted, where it is not one."""
    name = table.get("id") or f"{file}: a claim without an id"
    before = len(faults)
    faults += [f"{name}: {field}: missing" for field in REQUIRED if not table.get(field)]
    faults += [f"{name}: {field}: unknown field" for field in sorted(table.keys() - FIELDS)]
    evidence = tuple(_evidence(piece, name, faults) for piece in table.get("evidence", ()))
    faults += [f"{name}: {field}: {what}" for field, what in _faults(table)]
    if len(faults) > before:
        return None
    texts = {field: " ".join(table[field].split()) for field in FIELDS - {"findings", "evidence"} if field in table}
    return Claim(**texts, findings=tuple(table.get("findings", ())), evidence=evidence)


def _faults(table: dict) -> list[tuple[str, str]]:
    """What a claim's fields say about each other."""
    found = []
    if table.get("id") and not re.fullmatch(r"[a-z0-9_]+", table["id"]):
        found.append(("id", "made of a-z, 0-9 and _"))
    for code in table.get("findings", ()):
        if code not in FINDINGS:
            found.append(("findings", f"{code!r} is none of {FINDINGS[0]} to {FINDINGS[-1]}"))
    verdict = table.get("verdict")
    if verdict and verdict not in VERDICTS:
        return [*found, ("verdict", f"{verdict!r} is not one of {'; '.join(VERDICTS)}")]
    outside = verdict == OUTSIDE
    wanted = {"so": not outside, "reason": outside, "condition": verdict == CONDITIONAL}
    for field, wants in wanted.items():
        if wants != bool(table.get(field)):
            found.append((field, f"missing for {verdict!r}" if wants else f"does not go with {verdict!r}"))
    pieces = table.get("evidence", ())
    if outside and (pieces or table.get("merit")):
        found.append(("evidence", "what is not checked has no evidence and no figure of merit"))
    if not outside and not pieces:
        found.append(("evidence", "missing"))
    if not table.get("merit") and any("number" in piece for piece in pieces):
        found.append(("merit", "missing, and a number is evidence"))
    if table.get("merit") and not NUMBER_ROLE.search(table["merit"]):
        found.append(("merit", "shows no {number}"))
    return found


def _evidence(piece: dict, name: str, faults: list[str]) -> Evidence:
    """One piece of evidence."""
    kinds = [kind for kind in KINDS if kind in piece]
    if len(kinds) != 1:
        faults.append(f"{name}: evidence: {piece} is not one of {', '.join(KINDS)}")
        return Evidence("", "")
    kind = kinds[0]
    required, optional = KINDS[kind]
    for field in sorted(required - piece.keys()):
        faults.append(f"{name}: evidence {piece[kind]}: {field}: missing")
    for field in sorted(piece.keys() - required - optional - {kind}):
        faults.append(f"{name}: evidence {piece[kind]}: {field}: unknown field")
    for field in {"is", "claimed"} & piece.keys():
        try:
            relation(piece[field])
        except ValueError as error:
            faults.append(f"{name}: evidence {piece[kind]}: {field}: {error}")
    wants = str(piece.get("grade", piece.get("is", "")))
    return Evidence(kind, piece[kind], wants, piece.get("claimed", ""), piece.get("refutes"))
