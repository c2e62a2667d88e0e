"""Stored certificates, accepted only if they prove the statements of today's formulas. This file is trusted."""

from collections.abc import Callable, Iterable
from pathlib import Path

from proofs.check import contradiction, digest, parsed, text_of
from proofs.engine.claim import AnyClaim, Claim, Induction, Separation
from proofs.engine.counterexample import refutation
from proofs.engine.derivative import NotFound, Untranslatable
from proofs.engine.induction import induction
from proofs.engine.names import plain
from proofs.engine.project import PROJECT
from proofs.engine.statement import VERSION, cases_of
from proofs.engine.theorem import Theorem

Proved = tuple[dict, dict, dict | None]  # a statement, its certificate, a point where its hypotheses hold
Found = list[tuple[AnyClaim, list[Proved]]]
MOST_SHOWN = 12
FOLDER = PROJECT.certificates


class Stale(ValueError):
    """The error that a stored certificate is missing, or belongs to an older statement."""


def show_polynomial(p: dict) -> str:
    """Return a polynomial, the kernel's or polynomial data, as text of at most MOST_SHOWN terms."""
    try:
        terms = p if all(isinstance(k, str) for k in p) else {" ".join(m): str(c) for m, c in p.items()}
    except ValueError:  # Python writes no number of more than 4300 digits
        return f"{len(p)} terms, one of them with thousands of digits"
    text = " + ".join(f"{c}·{m.replace(' ', '·')}" if m else str(c) for m, c in list(terms.items())[:MOST_SHOWN]) or "0"
    return text + (f" + … ({len(terms)} terms)" if len(terms) > MOST_SHOWN else "")


def statements(claim: AnyClaim) -> list[dict]:
    """Return the statements of a claim, as the formulas stand now; raises Untranslatable."""
    try:
        return _statements(claim)
    except Untranslatable:
        raise
    except RecursionError:
        raise Untranslatable(f"{claim.name}: it is nested too deeply") from None
    except Exception as why:  # too large, or nothing that can be compared
        words = "; ".join(map(str, why.args)) or "SymPy gives no reason"
        raise Untranslatable(f"{claim.name}: no rule translates it: {words}") from None


def _statements(claim):
    if isinstance(claim, Separation):
        defined = {*claim.lines.inputs, *dict(claim.lines.definitions)}
        plain(defined, "extended_real")
        if unknown := {*claim.outputs, *claim.avoid} - defined:
            raise Untranslatable(f"{claim.name}: the program has no {', '.join(sorted(map(str, unknown)))}")
        lines = [[s.name, sorted(t.name for t in e.free_symbols)] for s, e in claim.lines.definitions]
        outputs, avoid = (sorted(s.name for s in names) for names in (claim.outputs, claim.avoid))
        return [{"version": VERSION, "kind": "separation", "lines": lines, "outputs": outputs, "avoid": avoid}]
    if isinstance(claim, Induction):
        return [induction(claim)]
    return [statement for statement, _ in cases_of(claim)]


def each_shown(claim: AnyClaim) -> list[dict]:
    """Return the derivations of a Claim's conclusions, one each.

    A cited lemma is left out: a point need not meet its conditions to be a counterexample of the claim.
    """
    shows = claim.shows if isinstance(claim, Claim) else ()
    return [s for shown in shows for s in statements(claim.but(cited=(), shows=shown))]


def refute(claim: AnyClaim, point: Iterable[tuple]) -> list[Proved]:
    """Return the refutation of a claim at the point ((symbol, value), …); raises NotFound."""
    pair = refutation(each_shown(claim), dict(point))
    if pair is None:
        raise NotFound(f"no certificate found: {claim.name}")
    return [(*pair, None)]


def evidence(theorem: Theorem, prove: Callable) -> Found:
    """Return the proofs that `prove` finds of each claim of a theorem, or its refutation; raises NotFound."""
    point = theorem.refuted_at
    return [(c, prove(c) if point is None else refute(c, point)) for c in theorem.claims]


def path_of(theorem: Theorem) -> Path:
    """Return the path of the theorem's stored certificates."""
    return FOLDER / f"{theorem.id}.json"


def stored(theorem: Theorem) -> Found:
    """Return [(claim, its proofs or refutation)] from the file, or raise Stale.

    The statements are translated afresh from the formulas; the file's must be the same, or assume less.
    """
    path = path_of(theorem)
    if not path.exists():
        raise Stale(f"{theorem.id} has no stored certificate: run python -m proofs.engine.certificate {theorem.id}")
    try:
        entries = {entry["claim"]: entry["statements"] for entry in parsed(text_of(path), theorem.id)}
    except ValueError as error:
        raise Stale(f"{theorem.id}: of its stored certificates: {error}") from None
    result = []
    for claim in theorem.claims:
        old = entries.pop(claim.name, [])
        if theorem.expected == "refuted":
            now = [s for s, *_ in refute(claim, theorem.refuted_at or ())]
        else:
            now = statements(claim)
        if len(now) != len(old) or not all(_still_proves(claim, *pair) for pair in zip(now, old, strict=True)):
            raise Stale(
                f"{theorem.id}/{claim.name}: the formulas no longer say what the stored certificate proves; "
                f"if the theorem still holds, python -m proofs.engine.certificate {theorem.id} finds a new one"
            )
        result.append((claim, [(entry["statement"], entry["certificate"], entry["point"]) for entry in old]))
    if entries:
        raise Stale(f"{theorem.id}: the stored certificates have other claims: {', '.join(sorted(entries))}")
    return result


def _still_proves(claim, now, entry):
    old, less = entry["statement"], now
    steps = old["steps"] if isinstance(old, dict) and isinstance(old.get("steps"), list) else []
    if now["kind"] == "derivation":  # what follows from fewer assumptions follows from all of them
        less = now | {"steps": [step for step in now["steps"] if step["step"] != "assume" or step in steps]}
    # a cited lemma's conditions are shown, not assumed: a case of its claim is never stored as one that cannot occur
    empty = [contradiction(less)] if now["kind"] == "derivation" and not claim.cited else []
    return digest(old) == entry["sha256"] and old in [less, *empty]
