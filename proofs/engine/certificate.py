"""Certificates: made by the search, stored as JSON beside the theorems, compared with what the formulas say now.

`python -m proofs.engine.certificate [ID …]` finds anew what is missing or stale, of the named theorems or of all, and
leaves the rest alone; with --all it finds every certificate anew. Nothing here is trusted.

Format, version 1 (JSON). A polynomial is {"x^2 y": "-3/2", "": "1"}: names (no blank, no ^), powers, exact rationals.
A statement has a `kind`. A "derivation" has `variables` (all real numbers, unless a step says more) and `steps`, each
with a polynomial `of`:

    assume   of ⋈ 0 is given; ⋈ is `is`: "=", "!=", ">", ">="
    define   `new` abbreviates `of`
    root     `new` = √of; needs a proof of `of` ≥ 0; gives new² = of and new ≥ 0
    inverse  `new` = 1/of; needs a proof of `of` ≠ 0; gives new · of = 1
    show     of ⋈ 0 has to be proved; later steps may use it

A "separation" has `lines` [[name, [names it uses]], …], `outputs`, `avoid`. An "induction" has `variables`, `state`,
`assume` (about the variables), `start` and `next` (polynomials of each state), `show` (polynomials, zero for every n).

The file of a theorem is {"version", "theorem", "claims": [{"claim", "statements": [{"sha256", "statement",
"certificate", "point"}]}]}. A stored statement may lack assumptions of the claim's: those that no proof uses are left
out. The point, {name: rational}, is one at which all that is assumed holds, roots and inverses among its names: it
refutes 1 = 0, the statement that `proofs.check` makes (π is 355/113 there). Of a case that cannot occur that statement
is proved instead; it, a separation and a refutation have the point null.

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
writes it.
"""

import argparse
import sys

from proofs.check import canonical, contradiction, digest, reasons
from proofs.engine.claim import AnyClaim
from proofs.engine.points import find_point, without_unused
from proofs.engine.project import PROJECT
from proofs.engine.search import MAX_EFFORT, search
from proofs.engine.statement import VERSION
from proofs.engine.stored import FOLDER, Found, NotFound, Proved, Stale, evidence, path_of, statements, stored
from proofs.engine.theorem import Theorem, all_theorems


def prove(claim: AnyClaim, effort: int = MAX_EFFORT) -> list[Proved]:
    """Return the proofs of a claim, searched anew; raises NotFound.

    >>> from proofs.engine import kernel
    >>> from proofs.engine.certificate import prove
    >>> from proofs.theorems.language import Claim, at_least, real
    >>> x, y = real("x y")
    >>> ((statement, certificate, _),) = prove(Claim("means", at_least(x**2 + y**2, 2 * x * y)))
    >>> statement["steps"][0]["of"], kernel.check(statement, certificate)
    ({'x y': '-2', 'x^2': '1', 'y^2': '1'}, None)
    """
    return [_proved(s, claim.squares, effort) for s in statements(claim)]


def _proved(statement, squares, effort):
    certificate = search(statement, squares, effort)
    if statement["kind"] == "separation":
        return statement, certificate, None
    if statement["kind"] == "derivation":
        statement, certificate = without_unused(statement, certificate)
    point = find_point(statement)
    if point is None:  # a case that cannot occur, then, and no claim has such cases alone
        statement, previous = contradiction(statement), None
        while statement != previous:
            certificate, previous = search(statement, (), effort), statement
            statement = contradiction(without_unused(statement, certificate)[0])
    return statement, certificate, point


def text(theorem: Theorem, proofs: Found) -> str:
    """Return the file's text for [(claim, its proofs or refutation)]."""
    claims = []
    for claim, cases in proofs:
        listed = [{"sha256": digest(s), "statement": s, "certificate": c, "point": point} for s, c, point in cases]
        claims.append({"claim": claim.name, "statements": listed})
    return canonical({"version": VERSION, "theorem": theorem.id, "claims": claims})


def wrong_with(proofs: Found) -> list[str]:
    """Return the kernel's objections to [(claim, its proofs or refutation)]."""
    return [f"{claim.name}: {why}" for claim, cases in proofs for why in reasons(cases) if why]


def _is_stale(theorem):
    try:
        return bool(wrong_with(stored(theorem)))
    except (Stale, NotFound):
        return True


def main(arguments: list[str] | None = None) -> int:
    """Find and write certificates; return 0 if all were found and the kernel accepts them."""
    theorems, failed = all_theorems(), False
    parser = argparse.ArgumentParser("python -m proofs.engine.certificate", description=__doc__.split("\n\n")[1])
    parser.add_argument("ids", nargs="*", metavar="ID", help="theorems (default: all)")
    parser.add_argument("--all", action="store_true", help="find every certificate anew")
    options = parser.parse_args(arguments)
    named = options.ids or [id for id, theorem in theorems.items() if theorem.claims]
    if unknown := {*named} - {*theorems}:
        print(f"there is no theorem {', '.join(sorted(unknown))}")
        return 2
    PROJECT.require_writable()
    FOLDER.mkdir(exist_ok=True)
    for id in named:
        theorem = theorems[id]
        if not options.all and not _is_stale(theorem):
            continue
        try:
            proofs = evidence(theorem, prove)
            wrong = wrong_with(proofs)
        except NotFound as error:
            wrong = [str(error)]
        if wrong:
            print(f"{id}: {'; '.join(wrong)}", flush=True)
            failed = True
            continue
        unfinished = path_of(theorem).with_suffix(".unfinished")
        unfinished.write_text(text(theorem, proofs), encoding="utf-8")
        unfinished.replace(path_of(theorem))
        print(f"{id}: {sum(len(cases) for _, cases in proofs)} statements", flush=True)
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
