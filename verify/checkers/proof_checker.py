"""The proof checker: everything that a run knows about a theorem with claims, and the grade that follows from it.

    proved         the kernel accepts a certificate of every claim,
                   Coq's record has every statement that is pinned, as it was read, and
                   every claim that cites a lemma,
                   no sample at 50 digits contradicts one,
                   no relation that one shows reads 0 = 0 once translated,
                   every side condition behaves as stated at its edge,
                   every mutant is refuted, and
                   every theorem that it uses is proved
    refuted        the kernel accepts an exact counterexample, and 50 digits agree
    failed         anything else

Nothing raises a grade by hand. A run also gives every certificate to the second checker (`verify.test_theorems`).

Theorems that are certified or measured have no claims: `verify.checkers.measurements`. This module imports that one,
and the search, only where a theorem needs them: the grade `proved` rests on neither.
"""

import importlib
from collections.abc import Callable
from dataclasses import fields

from sympy import Basic, Derivative, NumberSymbol, Symbol, expand, pi

from proofs.check import reasons
from proofs.engine import kernel
from proofs.engine.angles import COSINES, SINES
from proofs.engine.claim import AnyClaim, Claim, Induction, Separation
from proofs.engine.derivative import Untranslatable
from proofs.engine.induction import induction
from proofs.engine.program import flat
from proofs.engine.statement import cases_of
from proofs.engine.stored import NotFound, Stale, evidence, show_polynomial, statements, stored
from proofs.engine.theorem import WITHOUT_CLAIMS, Theorem
from verify.checkers import witness
from verify.checkers.counterexamples import FAILURES, counterexample, flint
from verify.checkers.grades import Examination

POINTS, LONG_POINTS, SEARCHED = 32, 2000, 4000
HINTS = ("name", "squares", "ranges", "cited")  # of a claim: what its search and its samples use
ANGLE_DIGITS = 1000  # twice the longest number: to the kernel sin(3.14159…) may be 0, if nothing else tells


def why_rejected(statement: dict, certificate: dict) -> str | None:
    """Return None if the kernel accepts, else the reason, with the residual polynomial."""
    why = kernel.check(statement, certificate)
    if why is None:
        return None
    reason, *residual = why.args or (repr(why),)
    shown = f"; residual {show_polynomial(residual[0])}" if residual and residual[0] else ""
    return f"the kernel rejects: {reason}{shown}"


def examine(theorem: Theorem, anew: bool = False, points: int = POINTS) -> Examination:
    """Return the Examination of a theorem.

    The search, which nobody has to trust, is asked to prove each mutant, and for what is left over where no stored
    certificate fits; with `anew`, for every certificate.
    """
    if not theorem.claims and (theorem.pinned or theorem.rounded or theorem.expected in WITHOUT_CLAIMS):
        return importlib.import_module("verify.checkers.measurements").examine(theorem)
    prove = importlib.import_module("proofs.engine.certificate").prove
    examination = Examination(theorem.id, theorem.expected, theorem.uses)
    examination.record["grade"] = "failed"
    try:
        for claim in theorem.claims:
            statements(claim)
    except Untranslatable as error:  # nor is it sampled
        examination.problems.append(str(error))
        return examination
    _check_certificates(examination, theorem, prove, anew)
    examination.check_sources(theorem)
    examination.record["witness"] = [_sampled(examination, theorem, claim, points) for claim in theorem.claims]
    examination.record["side_conditions"] = [_edges(examination, theorem, each) for each in theorem.side_conditions]
    examination.mutants += len(theorem.mutants)
    refute = _refute_variant if theorem.expected == "refuted" else _refute_mutant
    examination.record["mutants"] = [refute(examination, theorem, mutant, prove, anew) for mutant in theorem.mutants]
    examination.record["grade"] = examination.grade
    return examination


def _check_certificates(examination, theorem, prove, anew):
    examination.claims = len(theorem.claims)
    try:
        claims = evidence(theorem, prove) if anew else stored(theorem)
    except Stale as error:
        try:
            evidence(theorem, prove)
            why = "a certificate exists"
        except NotFound as failed:
            why = str(failed)
        examination.problems.append(f"{error}\n  searched anew: {why}")
        return
    except NotFound as error:
        examination.problems.append(str(error))
        return
    for claim in theorem.claims:
        examination.problems += [f"{claim.name}: {idle} says nothing" for idle in by_definition(claim)]
    for claim, cases in claims:
        examination.problems += [f"{claim.name}: {why}" for why in reasons(cases, why_rejected) if why]
    shown = [statement for _, cases in claims for statement, *_ in cases]
    hypotheses = sum(step["step"] == "assume" for statement in shown for step in statement.get("steps", ()))
    examination.record |= {"statements": len(shown), "hypotheses": hypotheses}


def by_definition(claim: AnyClaim) -> list[str]:
    """Return the relations that a claim shows in vain: translated, they read 0 = 0 or 3 > 2, or are hypotheses."""
    if isinstance(claim, Induction):
        translated = induction(claim)
        equations = [step["of"] for step in translated["assume"] if step["is"] == "="]
        return [str(r) for r, p in zip(claim.shows, translated["show"], strict=True) if not p or p in equations]
    if isinstance(claim, Separation):  # of outputs that are inputs it says nothing
        return [] if {*dict(claim.lines.definitions)}.intersection(claim.outputs) else [claim.name]
    idle = set.intersection(*(idle for _, idle in cases_of(claim)))
    shows = [claim.shows[number] for number in sorted(idle)]
    alone = len(shows) == len(claim.shows)  # beside what says something, 3 > 2 is a step to it
    return [str(relation) for relation in shows if alone or relation.free_symbols or relation.rel_op == "=="]


def why_unproved(claim: AnyClaim, prove: Callable, **effort: int) -> str | None:
    """Return None if a search finds a proof of the claim that the kernel accepts, else why not."""
    try:
        cases = prove(claim, **effort)
    except NotFound as error:
        return str(error)
    return next((str(why) for why in reasons(cases, why_rejected) if why), None)


def _sampled(examination, theorem, claim, points):
    """Sample a claim at 50 digits; a refuted claim is evaluated at its exact point instead."""
    if isinstance(claim, Separation):
        return {"claim": claim.name, "points": 0}
    if theorem.expected == "refuted":
        if witness.fails_at(claim, theorem.refuted_at) is None:
            examination.problems.append(f"{claim.name}: at 50 digits the point is not a counterexample")
        return {"claim": claim.name, "points": 1}
    seed = f"{theorem.id}/{claim.name}"
    for lemma in claim.cited:
        if failing := witness.sample(Claim("cited", (lemma.relation,), lemma.given), seed, points, 1).smallest:
            examination.problems.append(f"{lemma.text}, from {lemma.source}: false at {witness.printed(failing, 20)}")
    sampling = witness.sample(claim, seed, points, failures=FAILURES)
    if sampling.failures:
        examination.problems.append(f"{claim.name}: false at {witness.printed(sampling.smallest, 20)}")
    if sampling.undefined:
        examination.problems.append(f"{claim.name}: undefined at {witness.printed(sampling.undefined[0], 20)}")
    satisfied = sampling.points
    parts = [*claim.given, *claim.everywhere()] if isinstance(claim, Claim) else ()
    if satisfied and any(part.has(*COSINES, *SINES, pi) for part in parts):
        satisfied = witness.sample(claim, seed, 1, attempts=SEARCHED, digits=ANGLE_DIGITS).points
    if not satisfied:
        examination.problems.append(f"{claim.name}: no sample satisfies the hypotheses")
    return {"claim": claim.name, "points": sampling.points, "digits": witness.DIGITS, "seed": seed}


def _edges(examination, theorem, condition):
    claim, edges = theorem.claim(condition.claim), []
    for at, expected in condition.edges:
        outcome = witness.outcome(claim, at)
        if outcome != expected:
            examination.problems.append(f"side condition {condition.text}: {outcome} at {dict(at)}, not {expected}")
        edges.append({"at": {str(s): str(v) for s, v in at}, "outcome": outcome})
    return {"condition": condition.text, "claim": condition.claim, "edges": edges}


def _refute_mutant(examination, theorem, mutant, prove, anew):
    """Check that a mutant is refused, and find its counterexample."""
    effort = {} if anew else {"effort": 2}
    refused = why_unproved(mutant.claim, prove, **effort) is not None
    translated, wrong = _said(mutant), []
    if why := why_no_variant(theorem, mutant.claim):
        wrong.append(f"{mutant.text}: {why}")
    alike = [other.text for other in theorem.mutants if translated and _said(other) == translated]
    if len(alike) > 1:
        wrong.append(f"these say the same: {', '.join(alike)}")
    if not refused:
        wrong.append(f"mutant accepted: {mutant.text}")
    point = counterexample(mutant, f"{theorem.id}/{mutant.text}")
    if point is None:
        wrong.append(f"mutant without a counterexample: {mutant.text}")
    elif not point["exact"] and flint and not point["certified"]:
        wrong.append(f"mutant whose counterexample is neither exact nor enclosed: {mutant.text}")
    examination.problems += wrong
    examination.mutants_killed += not wrong
    return {"mutant": mutant.text, "refused": refused, "counterexample": point}


def _said(mutant):
    try:
        return statements(mutant.claim)
    except Untranslatable:
        return None


def why_no_variant(theorem: Theorem, variant: AnyClaim) -> str | None:
    """Return why a false claim is no variant of the theorem's claim of that name, or None.

    A variant changes one field, and each relation that it shows is about the claim's symbols, or π.
    """
    claim = next((c for c in theorem.claims if (c.name, type(c)) == (variant.name, type(variant))), None)
    if claim is None:
        return f"the theorem has no claim {variant.name}"
    before = {field.name: getattr(claim, field.name) for field in fields(claim)}
    changed = [name for name, value in before.items() if name not in HINTS and getattr(variant, name) != value]
    if len(changed) != 1:
        return f"it changes {', '.join(changed) or 'nothing'}: a variant changes one field"
    atoms = _atoms([*before.values(), *(claim.everywhere() if isinstance(claim, Claim) else ())])
    for relation in getattr(variant, "shows", ()) if changed == ["shows"] else ():
        named = _atoms(
            [expand(side if side.has(Derivative) else side.doit()) for side in relation.args]
            if relation.free_symbols
            else [relation]
        )
        if not (named and named <= atoms):
            return f"{relation} is about {', '.join(map(str, named - atoms)) or 'nothing'}"
    return None


def _atoms(parts):
    expressions = [part for part in flat(parts) if isinstance(part, Basic)]
    return set().union(*(e.atoms(Symbol, NumberSymbol) for e in expressions))


def _refute_variant(examination, theorem, mutant, prove, anew):
    """Check that a true variant of a refuted statement is accepted, and that the counterexample spares it."""
    why = why_unproved(mutant.claim, prove)
    spared = not theorem.refuted_at or witness.fails_at(mutant.claim, theorem.refuted_at, attempts=1) is None
    if why:
        examination.problems.append(f"true variant not accepted: {mutant.text}: {why}")
    if not spared:
        examination.problems.append(f"the counterexample also refutes the true variant: {mutant.text}")
    examination.mutants_killed += not why and spared
    return {"variant": mutant.text, "accepted": not why, "spared": spared}
