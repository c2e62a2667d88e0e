"""The proof checker: everything that a run knows about a theorem, and the grade that follows from it.

proved     both checkers accept a certificate of every claim, no sample at 50 digits contradicts one, every side
           condition behaves as stated at its edge, every mutant is refuted, every theorem it uses is proved
refuted    both checkers accept an exact counterexample, and 50 digits agree
failed     anything else. Nothing raises a grade by hand.
"""

from dataclasses import dataclass, field
from fractions import Fraction

import mpmath

from proofs import kernel
from proofs.certificate import Stale, evidence, prove, stored
from proofs.claim import Separation
from proofs.counterexample import refutation
from proofs.search import MAX_EFFORT, NotFound
from proofs.statement import derivations
from proofs.theorem import borrowed
from verify import second_checker, witness

POINTS, LONG_POINTS = 32, 2000
MUTANT_FAILURES, MUTANT_POINTS = 6, 400


@dataclass
class Evidence:
    """What a run found about one theorem. `problems` name what is missing; `record` is what the report keeps."""

    id: str
    expected: str
    uses: tuple
    record: dict = field(default_factory=dict)
    problems: list = field(default_factory=list)
    mutants_killed: int = 0
    mutants: int = 0

    @property
    def grade(self):
        """The grade on this theorem's own evidence; `final_grades` adds what it rests on."""
        if self.problems:
            return "failed"
        return self.expected if self.expected in ("proved", "refuted") else self.record.get("grade", "failed")


def show_polynomial(p, limit=12):
    """Return a polynomial, the kernel's or polynomial data, as text of at most `limit` terms."""
    terms = p if all(isinstance(k, str) for k in p) else {" ".join(m): str(c) for m, c in p.items()}
    text = " + ".join(f"{c}·{m.replace(' ', '·')}" if m else str(c) for m, c in list(terms.items())[:limit]) or "0"
    return text + (f" + … ({len(terms)} terms)" if len(terms) > limit else "")


def why_rejected(statement, certificate):
    """Return None if both checkers accept, else the reason, with the residual polynomial."""
    for name, checker in (("the kernel", kernel.check), ("the second checker", second_checker.check)):
        why = checker(statement, certificate)
        if why is not None:
            reason, *residual = why.args or (repr(why),)
            shown = f"; residual {show_polynomial(residual[0])}" if residual and residual[0] else ""
            return f"{name} rejects: {reason}{shown}"
    return None


def not_found(error):
    """Return the text of a failed search: the goal, and what is left of it."""
    goal, relation = error.goal
    if isinstance(goal, dict):
        left = f"; what is left of it: {show_polynomial(error.remainder)}" if error.remainder else ""
        return f"no certificate found for {show_polynomial(goal)} {relation} 0{left}"
    return f"no certificate found: {goal}"


def accept(claim, theorems, pairs=None, effort=MAX_EFFORT):
    """Return (the reasons why a claim is not accepted, the certified pairs): the one path for theorems and mutants."""
    try:
        pairs = prove(claim, theorems, effort) if pairs is None else pairs
    except NotFound as error:
        return [not_found(error)], []
    return [why for pair in pairs if (why := why_rejected(*pair))], pairs


def examine(theorem, theorems, anew=False, points=POINTS):
    """Return the Evidence of a theorem. anew: search for every certificate, whatever is stored."""
    found = Evidence(theorem.id, theorem.expected, theorem.uses)
    found.record = {"id": theorem.id, "expected": theorem.expected, "uses": sorted(theorem.uses)}
    _check_certificates(found, theorem, theorems, anew)
    found.record["witness"] = [_sampled(found, theorem, claim, points) for claim in theorem.claims]
    found.record["side_conditions"] = [_edges(found, theorem, condition) for condition in theorem.side_conditions]
    found.mutants = len(theorem.mutants)
    refute = _refute_variant if theorem.expected == "refuted" else _refute_mutant
    found.record["mutants"] = [refute(found, theorem, mutant, theorems, anew) for mutant in theorem.mutants]
    found.record["grade"] = found.grade
    return found


def _check_certificates(found, theorem, theorems, anew):
    try:
        claims = evidence(theorem, theorems) if anew else stored(theorem, theorems)
    except (Stale, NotFound) as error:
        found.problems.append(not_found(error) if isinstance(error, NotFound) else _stale(theorem, theorems, error))
        return
    count = 0
    for claim, pairs in claims:
        reasons, _ = accept(claim, theorems, pairs)
        found.problems += [f"{claim.name}: {why}" for why in reasons]
        count += len(pairs)
    found.record["statements"] = count


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
        if witness.fails_at(claim, dict(theorem.refuted_at)[claim.name]) is None:
            found.problems.append(f"{claim.name}: at 50 digits the point is not a counterexample")
        return {"claim": claim.name, "points": 1}
    seed = f"{theorem.id}/{claim.name}"
    seen = witness.sample(claim, seed, points, failures=MUTANT_FAILURES)
    if seen.failures:
        found.problems.append(f"{claim.name}: false at {witness.printed(seen.smallest, 20)}")
    if not seen.points:
        found.problems.append(f"{claim.name}: no sample satisfies the hypotheses")
    return {"claim": claim.name, "points": seen.points, "digits": witness.DIGITS, "seed": seed}


def _edges(found, theorem, condition):
    claim, edges = theorem.claim(condition.claim), []
    for edge in condition.edges:
        outcome = witness.outcome(claim, edge.at)
        if outcome != edge.outcome:
            found.problems.append(f"side condition {condition.text}: {outcome} at {dict(edge.at)}, not {edge.outcome}")
        edges.append({"at": {str(s): str(v) for s, v in edge.at}, "outcome": outcome})
    return {"condition": condition.text, "claim": condition.claim, "edges": edges}


def _refute_mutant(found, theorem, mutant, theorems, anew):
    """Check that a mutant is refused, and find its counterexample."""
    reasons, _ = accept(mutant.claim, theorems, effort=MAX_EFFORT if anew else 2)
    point = counterexample(mutant, f"{theorem.id}/{mutant.text}", theorems)
    if not reasons:
        found.problems.append(f"mutant accepted: {mutant.text}")
    if point is None:
        found.problems.append(f"mutant without a counterexample: {mutant.text}")
    found.mutants_killed += bool(reasons) and point is not None
    return {"mutant": mutant.text, "refused": bool(reasons), "counterexample": point}


def counterexample(mutant, seed, theorems):
    """Return {"exact": bool, "at": {name: text}} where a mutant fails, the simplest that was found, or None."""
    if isinstance(mutant.claim, Separation):
        path = path_to_avoided(mutant.claim)
        return None if path is None else {"exact": True, "at": {"path": " → ".join(path)}}
    if mutant.at:
        failing = witness.fails_at(mutant.claim, mutant.at)
        failures = [failing] if failing else []
    else:
        failures = witness.sample(mutant.claim, seed, MUTANT_POINTS, failures=MUTANT_FAILURES).failures
    if not failures:
        return None
    exact = exact_counterexample(mutant.claim, failures, theorems)
    if exact is not None:
        return {"exact": True, "at": exact}
    return {"exact": False, "at": witness.printed(witness.Witness(1, failures).smallest)}


def exact_counterexample(claim, failures, theorems):
    """Return a rational point, {name: text}, near one of the failures, that both checkers accept, or None."""
    if not hasattr(claim, "lines"):
        return None
    statements = derivations(borrowed(claim, theorems))
    for point in sorted(failures, key=witness._length):
        rational = {str(s): _rational(v) for s, v in point.items()}
        if all(q is not None for q in rational.values()):
            pair = refutation(statements, rational)
            if pair is not None and why_rejected(*pair) is None:
                return {name: str(q) for name, q in sorted(rational.items())}
    return None


def _rational(value):
    """Return the Fraction of small denominator that a 50-digit number is, or None."""
    with mpmath.workdps(witness.WORKING_DIGITS):
        q = Fraction(mpmath.nstr(value, 40)).limit_denominator(10**4)
        return q if abs(value - mpmath.mpf(q.numerator) / q.denominator) < witness.TOLERANCE else None


def path_to_avoided(claim):
    """Return the shortest list of names from an output of a Separation to a name that it should avoid, or None."""
    uses = {s: sorted(e.free_symbols, key=str) for s, e in claim.lines.definitions}
    paths, seen = [[s] for s in claim.outputs], set(claim.outputs)
    for path in paths:
        if path[-1] in claim.avoid:
            return [s.name for s in path]
        for name in uses.get(path[-1], []):
            if name not in seen:
                seen.add(name)
                paths.append([*path, name])
    return None


def _refute_variant(found, theorem, mutant, theorems, anew):
    """Check that a true variant of a refuted statement is accepted, and that the counterexample spares it."""
    reasons, _ = accept(mutant.claim, theorems)
    points = [point for _, point in theorem.refuted_at]
    names = {s for point in points for s, _ in point}
    spared = all(witness.fails_at(mutant.claim, point, attempts=1) is None for point in points) or not names
    if reasons:
        found.problems.append(f"true variant not accepted: {mutant.text}: {reasons[0]}")
    if not spared:
        found.problems.append(f"the counterexample also refutes the true variant: {mutant.text}")
    found.mutants_killed += not reasons and spared
    return {"variant": mutant.text, "accepted": not reasons, "spared": spared}


def final_grades(evidences):
    """Return {id: (grade, reason)}: a theorem is proved only if all that it uses, in the same run, is proved."""
    grades = {}
    by_id = {e["id"]: e for e in evidences}

    def grade(id):
        if id not in grades:
            record = by_id.get(id)
            if record is None:
                return "missing", f"{id} was not run"
            weak = [use for use in record["uses"] if grade(use)[0] != "proved"]
            if record["grade"] == "proved" and weak:
                grades[id] = "failed", f"it uses {', '.join(weak)}, not proved in this run"
            else:
                grades[id] = record["grade"], ""
        return grades[id]

    for id in by_id:
        grade(id)
    return grades
