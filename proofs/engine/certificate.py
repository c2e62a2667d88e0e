"""Certificates: made by the search, stored as JSON beside the theorems, compared with what the formulas say now.

`python -m proofs.engine.certificate [ID …]` finds the certificates of the named theorems (default: of those whose
stored ones are missing or stale; --all: of all) and writes them. Format, version 1: {"version", "theorem", "claims":
[{"claim", "statements": [{"sha256", "statement", "certificate", "point"}]}]}; `proofs.engine.statement_data` documents
statements. A stored statement may lack assumptions of the claim's: those that no proof uses are left out. The point,
{name: rational}, is one at which all that is assumed holds, roots and inverses among its names: it refutes 1 = 0, the
statement that `proofs.engine.hypotheses` makes (π is 355/113 there). Of a case that cannot occur that statement is
proved instead; it, a separation and a refutation have the point null.

A derivation's facts are p ⋈ 0, counted from 0 in the order of its steps: `assume` and, once proved, `show` give one,
`inverse` one (new · of − 1 = 0), `root` two (new² − of = 0, new ≥ 0), `define` none: its name stands for its polynomial
from there on. A goal is proved from the facts before it. Its certificate is {"proofs": […]}, one proof for each `show`,
`root` and `inverse`, in order. A proof has a `rule`:

    ideal          {"cofactors": [[i, q], …]}: the goal is p = 0; every fact i is g = 0; and p = Σ q g.
    contradiction  {"positive": [i, …], "sum": [[c, s, [i, …]], …], "cofactors": [[i, q], …]}: the goal's negation is
                   appended to the facts (of p = 0: p ≠ 0; of p ≠ 0: p = 0; of p > 0: −p ≥ 0; of p ≥ 0: −p > 0), and
                   Π f + Σ c s² Π h = Σ q g, where f: the facts in `positive`, each > 0, or ≠ 0 and then squared (none:
                   Π f = 1); c ≥ 0 a rational, s a polynomial, h: facts that are > 0 or ≥ 0; g: facts that are = 0.
                   The left side is positive, the right side zero.
Of a "refutation", which has the form of a derivation and ends in a `show`, it is {"point": {name: rational}}: a value
for every variable, root and inverse, and for nothing else, at which every fact holds but the last, and the last fails;
pi is no coordinate, and cos(…)² + sin(…)² = 1. Of an "induction", {"base": [proof, …], "step": [proof, …]}: base[k]
proves p = 0, for the k-th p of `show`, with `start` put in for the state, from the assumptions; step[k] proves it with
`next` put in, from the assumptions and then every p of `show` (as it is now) = 0. Of a "separation",
{"reached": [name, …]}: it has every output, and with a line's name every name that the line uses, and nothing that is
to be avoided.

No key more or less, no proof left over, no text that is not JSON as `json.dumps(…, indent=1, ensure_ascii=False)`
writes it: proofs/certificates.schema.json has the grammar.
"""

import json
import sys
from collections.abc import Iterable
from contextlib import suppress
from fractions import Fraction
from pathlib import Path

from sympy import sympify

from proofs.check import canonical, digest
from proofs.engine.angles import Untranslatable
from proofs.engine.claim import AnyClaim, Induction, Separation
from proofs.engine.counterexample import refutation
from proofs.engine.hypotheses import contradiction, reasons, weaker
from proofs.engine.induction import induction
from proofs.engine.points import find_point, without_unused
from proofs.engine.search import MAX_EFFORT, NotFound, search
from proofs.engine.statement import VERSION, derivations
from proofs.engine.theorem import Theorem, Theorems, all_theorems, borrowed

FOLDER = Path(__file__).parents[1] / "certificates"

Proved = tuple[dict, dict, dict | None]  # a statement, its certificate, a point where its hypotheses hold


class Stale(ValueError):
    """A stored certificate is missing, or belongs to an older statement."""


def statements(claim: AnyClaim, theorems: Theorems) -> list[dict]:
    """Return the statements of a claim, as the formulas stand now."""
    if isinstance(claim, Separation):
        known = {*claim.lines.inputs, *(symbol for symbol, _ in claim.lines.definitions)}
        if unknown := set(claim.outputs) - known:
            raise Untranslatable(f"{claim.name}: the program has no {', '.join(sorted(map(str, unknown)))}")
        lines = [[s.name, sorted(t.name for t in e.free_symbols)] for s, e in claim.lines.definitions]
        outputs, avoid = (sorted(s.name for s in names) for names in (claim.outputs, claim.avoid))
        return [{"version": VERSION, "kind": "separation", "lines": lines, "outputs": outputs, "avoid": avoid}]
    if isinstance(claim, Induction):
        return [induction(claim)]
    return derivations(borrowed(claim, theorems))


def prove(claim: AnyClaim, theorems: Theorems, effort: int = MAX_EFFORT) -> list[Proved]:
    """Return what proves a claim, found anew; raises NotFound."""
    example = {str(s).replace(" ", ""): Fraction(str(sympify(value))) for s, value in getattr(claim, "example", ())}
    return [_proved(s, getattr(claim, "squares", ()), effort, example) for s in statements(claim, theorems)]


def _proved(statement, squares, effort, example):
    certificate = search(statement, squares, effort)
    if statement["kind"] == "separation":
        return statement, certificate, None
    if statement["kind"] == "derivation":
        statement, certificate = without_unused(statement, certificate)
    point = find_point(statement, example)
    if point is None:  # a case that cannot occur, then, and no claim has such cases alone
        statement, previous = contradiction(statement), None
        while statement != previous:
            certificate, previous = search(statement, (), effort), statement
            statement = contradiction(without_unused(statement, certificate)[0])
    return statement, certificate, point


def refute(claim: AnyClaim, point: Iterable[tuple], theorems: Theorems) -> list[Proved]:
    """Return what refutes a claim at the point ((symbol, value), …); raises NotFound."""
    found = refutation(statements(claim, theorems), dict(point))
    if found is None:
        raise NotFound((claim.name, "counterexample"))
    return [(*found, None)]


def evidence(theorem: Theorem, theorems: Theorems) -> list[tuple[AnyClaim, list[Proved]]]:
    """Return [(claim, what proves or refutes it)] of a theorem, found anew; raises NotFound."""
    point = theorem.refuted_at
    return [(c, prove(c, theorems) if point is None else refute(c, point, theorems)) for c in theorem.claims]


def path_of(theorem: Theorem) -> Path:
    """Return the path of the theorem's stored certificates."""
    return FOLDER / f"{theorem.id}.json"


def stored(theorem: Theorem, theorems: Theorems) -> list[tuple[AnyClaim, list[Proved]]]:
    """Return [(claim, what proves or refutes it)] from the file, or raise Stale.

    The statements are translated afresh from the formulas; the file's must be the same, or assume less.
    """
    path = path_of(theorem)
    if not path.exists():
        raise Stale(f"{theorem.id} has no stored certificate: run python -m proofs.engine.certificate {theorem.id}")
    entries = {entry["claim"]: entry["statements"] for entry in json.loads(path.read_text("utf-8"))["claims"]}
    result = []
    for claim in theorem.claims:
        kept = entries.pop(claim.name, [])
        if theorem.expected == "refuted":
            now = [s for s, *_ in refute(claim, theorem.refuted_at or (), theorems)]
        else:
            now = statements(claim, theorems)
        if len(now) != len(kept) or not all(map(_still_said, now, kept)):
            raise Stale(
                f"{theorem.id}/{claim.name}: the formulas no longer say what the stored certificate proves; "
                f"if the theorem still holds, python -m proofs.engine.certificate {theorem.id} finds a new one"
            )
        result.append((claim, [(entry["statement"], entry["certificate"], entry["point"]) for entry in kept]))
    if entries:
        raise Stale(f"{theorem.id}: the stored certificates have other claims: {', '.join(sorted(entries))}")
    return result


def _still_said(now, entry):
    kept = entry["statement"]
    if digest(kept) != entry["sha256"] or "point" not in entry:
        return False
    less = weaker(now, kept) if now["kind"] == kept["kind"] == "derivation" else now
    return kept == less or (kept["kind"] == "derivation" and kept == contradiction(less))


def text(theorem: Theorem, found: list[tuple[AnyClaim, list[Proved]]]) -> str:
    """Return the file's text for [(claim, what proves or refutes it)]."""
    claims = [
        {
            "claim": claim.name,
            "statements": [
                {"sha256": digest(s), "statement": s, "certificate": certificate, "point": point}
                for s, certificate, point in cases
            ],
        }
        for claim, cases in found
    ]
    return canonical({"version": VERSION, "theorem": theorem.id, "claims": claims})


def wrong_with(found: list[tuple[AnyClaim, list[Proved]]]) -> list[str]:
    """Return what the kernel has against [(claim, what proves or refutes it)]."""
    return [f"{claim.name}: {why}" for claim, cases in found for why in reasons(cases) if why]


def main(arguments: list[str]) -> int:
    """Find and write certificates; return 0 if all were found and the kernel accepts them."""
    theorems, failed = all_theorems(), False
    named = [a for a in arguments if a != "--all"]
    for id in named or [id for id, theorem in theorems.items() if theorem.claims]:
        theorem = theorems[id]
        with suppress(Stale, NotFound):
            if "--all" not in arguments and not wrong_with(stored(theorem, theorems)):
                continue
        try:
            found = evidence(theorem, theorems)
            wrong = wrong_with(found)
        except NotFound as error:
            wrong = [str(error)]
        if wrong:
            print(f"{id}: {'; '.join(wrong)}")
            failed = True
            continue
        path_of(theorem).write_text(text(theorem, found), encoding="utf-8")
        print(f"{id}: {sum(len(cases) for _, cases in found)} statements")
    return int(failed)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
