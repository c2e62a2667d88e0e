"""The proof checker: everything that a run knows about a theorem, and the grade that follows from it.

proved     both checkers accept a certificate of every claim, no sample at 50 digits contradicts one, every side
           condition behaves as stated at its edge, every mutant is refuted, every theorem it uses is proved
refuted    both checkers accept an exact counterexample, and 50 digits agree
argued     the same, but a clause of its words is said by no claim
by definition  the same, where every claim reads 0 = 0 once it is translated: nothing was left to prove
certified  every measurement holds in ball arithmetic, and rejects its false variants
measured   every measurement holds on its samples, and rejects its false variants
cited      the source is in the bibliography
failed     anything else. Nothing raises a grade by hand.
"""

import re
from pathlib import Path

from proofs.engine.certificate import Stale, evidence, stored
from proofs.engine.claim import Claim, Separation
from proofs.engine.search import MAX_EFFORT, NotFound
from proofs.engine.theorem import Theorem, Theorems, incomplete
from verify.checkers import witness
from verify.checkers.acceptance import CHECKERS, accept, by_definition, not_found, why_rejected
from verify.checkers.counterexamples import FAILURES, counterexample
from verify.checkers.grades import Examination
from verify.checkers.registry import measurements
from verify.checkers.splices import says_the_same, splices

POINTS, LONG_POINTS = 32, 2000
BIBLIOGRAPHY = Path(__file__).resolve().parents[2] / "book" / "references.bib"


def examine(theorem: Theorem, theorems: Theorems, anew: bool = False, points: int = POINTS) -> Examination:
    """Return the Examination of a theorem. anew: search for every certificate, whatever is stored."""
    found = Examination(theorem.id, theorem.expected, theorem.uses)
    found.record = {"id": theorem.id, "expected": theorem.expected, "uses": sorted(theorem.uses)}
    found.problems += incomplete(theorem, theorems)
    _check_certificates(found, theorem, theorems, anew)
    _check_sources(found, theorem)
    found.record["measurements"] = [_measured(found, *entry) for entry in measurements(theorem.id)]
    found.record["witness"] = [_sampled(found, theorem, claim, points) for claim in theorem.claims]
    found.record["side_conditions"] = [_edges(found, theorem, condition) for condition in theorem.side_conditions]
    found.mutants += len(theorem.mutants)
    refute = _refute_variant if theorem.expected == "refuted" else _refute_mutant
    found.record["mutants"] = [refute(found, theorem, mutant, theorems, anew) for mutant in theorem.mutants]
    _settle(found, theorem)
    found.record["grade"] = found.grade
    return found


def _settle(found, theorem):
    """Find what a theorem reaches for which the checkers have no verdict: by measurement, or else by citation."""
    if theorem.expected in ("certified", "measured"):
        seen = found.record["measurements"]
        found.reached = "certified" if seen and all(m["certified"] for m in seen) else "measured"
        if not seen:
            found.problems.append("no measurement is registered for it in verify/checkers/measurements")
    elif theorem.expected == "cited":
        found.reached = "cited"
    elif found.record["measurements"] and not theorem.claims:
        found.problems.append("measurements alone prove nothing")


def _measured(found, function, false):
    """Run a measurement, and its false variants, which it has to reject."""
    seen, rejected = function(), []
    if not seen.accepted:
        found.problems.append(f"{seen.what}: worst {seen.worst}, bound {seen.bound}, holds: {seen.holds}")
    for text, changes in false.items():
        rejected.append({"variant": text, "rejected": not function(**changes).accepted})
        found.mutants, found.mutants_killed = found.mutants + 1, found.mutants_killed + rejected[-1]["rejected"]
        if not rejected[-1]["rejected"]:
            found.problems.append(f"{seen.what}: does not reject the false variant “{text}”")
    return seen.record() | {"false_variants": rejected}


def _check_sources(found, theorem):
    """Keep the cited source and lemmas; each key has to be in the bibliography."""
    lemmas = [lemma for claim in theorem.claims for lemma in getattr(claim, "cited", ())]
    if theorem.source:
        found.record["source"] = theorem.source
    if lemmas:
        found.record["cited_lemmas"] = [{"relation": lemma.text, "source": lemma.source} for lemma in lemmas]
    keys = {lemma.source for lemma in lemmas} | ({theorem.source} if theorem.source else set())
    known = set(re.findall(r"^@\w+\{([^,\s]+)", BIBLIOGRAPHY.read_text(encoding="utf-8"), re.MULTILINE))
    found.problems += [f"the bibliography has no {key}" for key in sorted(keys - known)]


def certificate_problems(theorem: Theorem, theorems: Theorems) -> list[str]:
    """Return what both checkers, and the formulas as they stand, have against the stored certificates alone."""
    found = Examination(theorem.id, theorem.expected, theorem.uses)
    _check_certificates(found, theorem, theorems, anew=False)
    return found.problems


def _check_certificates(found, theorem, theorems, anew):
    if not theorem.claims:
        return
    found.claims, found.argued = len(theorem.claims), [clause.text for clause in theorem.argued]
    try:
        claims = evidence(theorem, theorems) if anew else stored(theorem, theorems)
    except (Stale, NotFound) as error:
        found.problems.append(not_found(error) if isinstance(error, NotFound) else _stale(theorem, theorems, error))
        return
    for claim, cases in claims:
        if by_definition(claim, cases):
            found.by_definition.append(claim.name)
        found.problems += [f"{claim.name}: {why}" for why in accept(claim, theorems, cases)]
    said = [statement for _, cases in claims for statement, *_ in cases]
    given = sum(step["step"] == "assume" for statement in said for step in statement.get("steps", ()))
    found.record |= {"statements": len(said), "by_definition": found.by_definition, "argued": found.argued}
    found.record |= {"hypotheses": given}
    if len(CHECKERS) < 2:
        found.record["second_checker"] = "not run"


def _stale(theorem, theorems, error):
    """Return what is wrong where the formulas changed: whether the theorem still holds, and if not, the residual."""
    try:
        evidence(theorem, theorems)
    except NotFound as failed:
        return f"{error}\n  searched anew: {not_found(failed)}"
    return f"{error}\n  searched anew: a certificate exists"


def _sampled(found, theorem, claim, points):
    """Sample a claim at 50 digits; a refuted claim is evaluated at its exact point instead."""
    if isinstance(claim, Separation):
        return {"claim": claim.name, "points": 0}
    if theorem.expected == "refuted":
        if witness.fails_at(claim, theorem.refuted_at) is None:
            found.problems.append(f"{claim.name}: at 50 digits the point is not a counterexample")
        return {"claim": claim.name, "points": 1}
    seed = f"{theorem.id}/{claim.name}"
    for lemma in getattr(claim, "cited", ()):  # under the source's conditions alone
        alone = Claim("cited", (lemma.relation,), lemma.given, ranges=claim.ranges)
        if failing := witness.sample(alone, seed, points, failures=FAILURES).smallest:
            found.problems.append(f"{lemma.text}, from {lemma.source}: false at {witness.printed(failing, 20)}")
    seen = witness.sample(claim, seed, points, failures=FAILURES)
    if seen.failures:
        found.problems.append(f"{claim.name}: false at {witness.printed(seen.smallest, 20)}")
    if seen.undefined:
        found.problems.append(f"{claim.name}: undefined at {witness.printed(seen.undefined[0], 20)}")
    if not seen.points:
        found.problems.append(f"{claim.name}: no sample satisfies the hypotheses")
    return {"claim": claim.name, "points": seen.points, "digits": witness.DIGITS, "seed": seed}


def _edges(found, theorem, condition):
    claim, edges = theorem.claim(condition.claim), []
    for at, expected in condition.edges:
        outcome = witness.outcome(claim, at)
        if outcome != expected:
            found.problems.append(f"side condition {condition.text}: {outcome} at {dict(at)}, not {expected}")
        edges.append({"at": {str(s): str(v) for s, v in at}, "outcome": outcome})
    return {"condition": condition.text, "claim": condition.claim, "edges": edges}


def _refute_mutant(found, theorem, mutant, theorems, anew):
    """Check that a mutant is refused, and find its counterexample."""
    reasons = accept(mutant.claim, theorems, effort=MAX_EFFORT if anew else 2)
    tried, wrong = splices(theorem, mutant.claim, theorems), []
    if any(not any(why_rejected(*pair) for pair in pairs) for pairs in tried):
        wrong.append(f"a certificate of the theorem proves the mutant: {mutant.text}")
    if alike := says_the_same(theorem, mutant, theorems):
        wrong.append(f"mutant {mutant.text} says what {alike} says")
    found.problems += wrong
    point = counterexample(mutant, f"{theorem.id}/{mutant.text}", theorems, why_rejected)
    if not reasons:
        found.problems.append(f"mutant accepted: {mutant.text}")
    if point is None:
        found.problems.append(f"mutant without a counterexample: {mutant.text}")
    found.mutants_killed += bool(reasons) and point is not None and not wrong
    return {"mutant": mutant.text, "refused": bool(reasons), "spliced": len(tried), "counterexample": point}


def _refute_variant(found, theorem, mutant, theorems, anew):
    """Check that a true variant of a refuted statement is accepted, and that the counterexample spares it."""
    reasons = accept(mutant.claim, theorems)
    spared = not theorem.refuted_at or witness.fails_at(mutant.claim, theorem.refuted_at, attempts=1) is None
    if reasons:
        found.problems.append(f"true variant not accepted: {mutant.text}: {reasons[0]}")
    if not spared:
        found.problems.append(f"the counterexample also refutes the true variant: {mutant.text}")
    found.mutants_killed += not reasons and spared
    return {"variant": mutant.text, "accepted": not reasons, "spared": spared}
