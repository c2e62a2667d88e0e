"""The search for certificates. Nothing here is trusted: the kernel checks each, and a claim without one may be true."""

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import combinations, combinations_with_replacement

from proofs.engine import kernel
from proofs.engine.feasible import feasible
from proofs.engine.ideal import Ideal
from proofs.engine.kernel import Fact, Values
from proofs.engine.statement import polynomial_data
from proofs.engine.stored import NotFound, show_polynomial

EFFORTS = ((1, False), (2, False), (2, True), (3, True))  # factors of a product; squares of names and sums
MAX_EFFORT = len(EFFORTS)


def search(statement: dict, squares: Iterable = (), effort: int = MAX_EFFORT) -> dict:
    """Return a certificate of the statement, or raise NotFound.

    squares: SymPy polynomials in the statement's names whose squares may be used in inequalities. effort: how many of
    EFFORTS to try for an inequality.
    """
    try:
        match statement["kind"]:
            case "separation":
                return _separation(statement)
            case "induction":
                proofs = _proofs(kernel.carry, statement)
                return {"base": proofs[::2], "step": proofs[1::2]}
        return {"proofs": _proofs(kernel.derive, statement, [polynomial_data(s) for s in squares], effort)}
    except kernel.Rejected as why:  # it is too long
        raise NotFound(f"no certificate found: {why}") from None


def _proofs(goals, statement, *how):
    """Return a proof of each of the kernel's goals."""
    proofs = []
    goals(statement, lambda goal, facts, values: proofs.append(find(goal, facts, values, *how)))
    return proofs


def find(goal: Fact, facts: list[Fact], values: Values, squares: Sequence[dict] = (), effort: int = 2) -> dict:
    """Return a proof of the goal from the facts, or raise NotFound."""
    names = [name for name, value in values.items() if value == kernel.variable(name)]
    equations = {i: p for i, (p, relation) in enumerate(facts) if relation == "="}
    ideal = Ideal(names, equations)
    p, relation = ideal.element(goal[0]), goal[1]
    remainder, cofactors = ideal.divide(p)
    if relation == "=" and not remainder:
        return {"rule": "ideal", "cofactors": _stored(ideal, cofactors)}
    if relation != "=" or len(p) <= 8:  # the square of a long polynomial is too long to guess with
        hints = [q for q in squares if all(n.partition("^")[0] in values for text in q for n in text.split())]
        proof = _contradiction(goal, facts, values, names, ideal, hints, effort)
        if proof is not None:
            return proof
    left = f"; what is left of it: {show_polynomial(ideal.data(remainder))}" if remainder else ""
    raise NotFound(f"no certificate found for {show_polynomial(ideal.data(p))} {relation} 0{left}")


def _stored(ideal, cofactors):
    return [[i, ideal.data(q)] for i, q in sorted(cofactors.items()) if q]


def _contradiction(goal, facts, values, names, ideal, squares, effort):
    scale, opposite = kernel.NEGATION[goal[1]]
    negated = kernel.multiply(scale, goal[0])
    facts = [*facts, (negated, opposite)]
    if opposite == "=":
        ideal = Ideal(names, {i: p for i, (p, relation) in enumerate(facts) if relation == "="})
    hints = [({"": "1"}, kernel.multiply(1)), *((q, kernel.read(q, values)) for q in squares)]
    abbreviations = [({n: "1"}, q) for n, q in values.items()
                     if n not in names and 1 < len(q) <= 8 and not n.startswith("sum_")][-16:]  # fmt: skip
    if opposite == "!=":
        hints.append((ideal.data(ideal.element(negated)), negated))
        effort = min(effort, 2)
    for degree, wide in EFFORTS[:effort]:
        roots = hints + (_monomials(negated, facts) if wide else [])
        proof = _combine(facts, opposite, ideal, roots, abbreviations, degree)
        if proof is not None:
            return proof
    return None


def _monomials(p, facts):
    """Return candidates whose squares are tried: the names of p, their sums and differences."""
    names = sorted({name for monomial in p for name in monomial})[:6]
    single = [({n: "1"}, kernel.variable(n)) for n in names]
    pairs = [
        ({a: "1", b: str(s)}, kernel.add(kernel.variable(a), kernel.multiply(s, kernel.variable(b))))
        for a, b in combinations(names, 2)
        for s in (1, -1)
    ]
    return single + (pairs if len(facts) < 16 else [])


def _combine(facts, opposite, ideal, roots, plain_roots, degree):
    """Return the proof Σ σ S + Σ λ s² Π h = Σ q g with Σ σ = 1, by linear programming, or None."""
    last = len(facts) - 1
    squared = [i for i, (_, relation) in enumerate(facts[:last]) if relation == "!="]
    strict = [i for i, (_, relation) in enumerate(facts) if relation == ">"]
    ordered = [i for i, (_, relation) in enumerate(facts) if relation in (">", ">=")]
    negated, unequal = facts[last][0], [last] if opposite == "!=" else []
    candidates = []  # (polynomial, positive indices or None, root of the square, factor indices)
    if unequal and len(negated) <= 4:
        square = kernel.multiply(1, negated, negated)
        candidates.append((kernel.multiply(1, square, square), (last, last), ideal.data(ideal.element(square)), ()))
    for i in squared:
        p = facts[i][0]
        candidates.append((kernel.multiply(1, p, p), (i,), ideal.data(ideal.element(p)), ()))
    own_root = ideal.data(ideal.element(negated)) if unequal else {"": "1"}
    for size in range(degree + 1):
        for indices in combinations_with_replacement(strict, size):
            product = kernel.multiply(1, *(facts[i][0] for i in (*indices, *unequal, *unequal)))
            candidates.append((product, (*indices, *unequal), own_root, indices))
        few = [roots + plain_roots, roots, roots[:1] + roots[-1:] * len(unequal)][min(size, 2)]
        for indices in combinations_with_replacement(ordered, size):
            product = kernel.multiply(1, *(facts[i][0] for i in indices))
            candidates += [(kernel.multiply(1, product, root, root), None, data, indices) for data, root in few]
            if len(candidates) > 1000:
                return None
    elements = [ideal.element(p) for p, *_ in candidates]
    columns = []
    for element, (_, positive, *_) in zip(elements, candidates, strict=True):
        remainder, _ = ideal.divide(element)
        column = {m: Fraction(int(c.numerator), int(c.denominator)) for m, c in remainder.items()}
        columns.append(column | ({"total": Fraction(1)} if positive is not None else {}))
    solution = feasible(columns, {"total": Fraction(1)})
    return None if solution is None else _contradiction_proof(candidates, elements, solution, ideal)


def _contradiction_proof(candidates, elements, solution, ideal):
    chosen = min(j for j in solution if candidates[j][1] is not None)
    total, terms = elements[chosen], []
    for j, weight in sorted(solution.items()):
        if j != chosen:
            scaled = weight / solution[chosen]
            terms.append([str(scaled), candidates[j][2], list(candidates[j][3])])
            total += elements[j] * ideal.ring.domain(scaled.numerator, scaled.denominator)
    remainder, cofactors = ideal.divide(total)
    positive = {"rule": "contradiction", "positive": list(candidates[chosen][1]), "sum": terms}
    return None if remainder else positive | {"cofactors": _stored(ideal, cofactors)}


def _separation(statement):
    reached = set(statement["outputs"])
    for name, uses in reversed(statement["lines"]):
        reached.update(uses if name in reached else ())
    if bad := sorted(reached & set(statement["avoid"])):
        raise NotFound(f"no certificate found: {', '.join(statement['outputs'])} without {', '.join(bad)}")
    return {"reached": sorted(reached)}
