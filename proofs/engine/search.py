"""Finding certificates. Nothing here is trusted: the kernel checks what it finds, and what it misses may be true."""

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import combinations_with_replacement

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
    finders = {"derivation": _derivation, "separation": _separation, "induction": _induction}
    return finders[statement["kind"]](statement, [polynomial_data(s) for s in squares], effort)


def _derivation(statement, squares, effort):
    proofs = []

    def meet(goal, facts, values):
        proofs.append(find(goal, facts, values, squares, effort))

    kernel.derive(statement, meet)
    return {"proofs": proofs}


def find(goal: Fact, facts: list[Fact], values: Values, squares: Sequence[dict] = (), effort: int = 2) -> dict:
    """Return a proof of the goal from the facts, or raise NotFound."""
    names = [name for name, value in values.items() if value == kernel.variable(name)]
    equations = {i: p for i, (p, relation) in enumerate(facts) if relation == "="}
    ideal = Ideal(names, equations)
    p, relation = goal
    if relation == "=":
        remainder, cofactors = ideal.divide(ideal.element(p))
        if not remainder:
            return {"rule": "ideal", "cofactors": _stored(ideal, cofactors)}
        if len(p) > 8:  # the square of a long polynomial is too long to guess with
            raise _not_found(ideal, goal)
    hints = [q for q in squares if all(n.partition("^")[0] in values for text in q for n in text.split())]
    proof = _contradiction(goal, facts, values, names, ideal, hints, effort)
    if proof is None:
        raise _not_found(ideal, goal)
    return proof


def _not_found(ideal, goal):
    p = ideal.element(goal[0])
    remainder = ideal.data(ideal.divide(p)[0])
    left = f"; what is left of it: {show_polynomial(remainder)}" if remainder else ""
    return NotFound(f"no certificate found for {show_polynomial(ideal.data(p))} {goal[1]} 0{left}")


def _stored(ideal, cofactors):
    return [[i, ideal.data(q)] for i, q in sorted(cofactors.items()) if q]


def _contradiction(goal, facts, values, names, ideal, squares, effort):
    scale, opposite = kernel.NEGATION[goal[1]]
    negated = (kernel.multiply(scale, goal[0]), opposite)
    facts = [*facts, negated]
    if opposite == "=":
        ideal = Ideal(names, {i: p for i, (p, relation) in enumerate(facts) if relation == "="})
    hints = [({"": "1"}, kernel.multiply(1))] + [(q, kernel.read(q, values)) for q in squares]
    abbreviations = [({n: "1"}, q) for n, q in values.items() if n not in names and 1 < len(q) <= 8]
    abbreviations = [(data, q) for data, q in abbreviations if not next(iter(data)).startswith("sum_")][-16:]
    if opposite == "!=":
        hints.append((ideal.data(ideal.element(negated[0])), negated[0]))
    for degree, wide in EFFORTS[: min(effort, 2) if opposite == "!=" else effort]:
        roots = hints + (_monomials(negated[0], facts) if wide else [])
        proof = _combine(facts, opposite, ideal, roots, abbreviations, degree)
        if proof is not None:
            return proof
    return None


def _monomials(p, facts):
    """Return candidates for squares: the names of p, their sums and differences."""
    names = sorted({name for monomial in p for name in monomial})[:6]
    single = [({n: "1"}, kernel.variable(n)) for n in names]
    pairs = [
        ({a: "1", b: str(s)}, kernel.add(kernel.variable(a), kernel.multiply(s, kernel.variable(b))))
        for i, a in enumerate(names)
        for b in names[i + 1 :]
        for s in (1, -1)
    ]
    return single + (pairs if len(facts) < 16 else [])


def _combine(facts, opposite, ideal, roots, plain_roots, degree):
    """Return the proof Σ σ S + Σ λ s² Π h = Σ q g with Σ σ = 1, by linear programming, or None."""
    last = len(facts) - 1
    ordered = [i for i, (_, relation) in enumerate(facts) if relation in (">", ">=")]
    strict = [i for i, (_, relation) in enumerate(facts) if relation == ">"]
    roots_of_unequal = ideal.data(ideal.element(facts[last][0]))
    p = facts[last][0]
    candidates = []  # (polynomial, positive indices or None, root of the square, factor indices)
    if opposite == "!=" and len(p) <= 4:
        square = kernel.multiply(1, p, p)
        candidates.append((kernel.multiply(1, square, square), (last, last), ideal.data(ideal.element(square)), ()))
    for size in range(degree + 1):
        for indices in combinations_with_replacement(strict, size):
            unequal = [last] if opposite == "!=" else []
            q = kernel.multiply(1, *(facts[i][0] for i in (*indices, *unequal, *unequal)))
            candidates.append((q, (*indices, *unequal), roots_of_unequal if unequal else {"": "1"}, indices))
        for indices in combinations_with_replacement(ordered, size):
            q = kernel.multiply(1, *(facts[i][0] for i in indices))
            few = roots + plain_roots * (size == 0)
            for data, root in few if size < 2 else roots[:1] + roots[-1:] * (opposite == "!="):
                candidates.append((kernel.multiply(1, q, root, root), None, data, indices))
    if len(candidates) > 1000:
        return None
    columns, elements = [], []
    for p, positive, _, _ in candidates:
        remainder, _ = ideal.divide(ideal.element(p))
        column = {m: Fraction(int(c.numerator), int(c.denominator)) for m, c in remainder.items()}
        elements.append(ideal.element(p))
        columns.append(column | ({"total": Fraction(1)} if positive is not None else {}))
    solution = feasible(columns, {"total": Fraction(1)})
    if solution is None:
        return None
    return _contradiction_proof(candidates, elements, solution, ideal)


def _contradiction_proof(candidates, elements, solution, ideal):
    chosen = min(j for j in solution if candidates[j][1] is not None)
    total, terms = elements[chosen], []
    for j, weight in sorted(solution.items()):
        if j != chosen:
            scaled = weight / solution[chosen]
            terms.append([str(scaled), candidates[j][2], list(candidates[j][3])])
            total += elements[j] * ideal.ring.domain(scaled.numerator, scaled.denominator)
    remainder, cofactors = ideal.divide(total)
    if remainder:
        return None
    return {
        "rule": "contradiction",
        "positive": list(candidates[chosen][1]),
        "sum": terms,
        "cofactors": _stored(ideal, cofactors),
    }


def _separation(statement, squares, effort):
    uses = dict(statement["lines"])
    reached, pending = set(), list(statement["outputs"])
    while pending:
        name = pending.pop()
        if name not in reached:
            reached.add(name)
            pending += uses.get(name, [])
    if bad := sorted(reached & set(statement["avoid"])):
        raise NotFound(f"no certificate found: {', '.join(statement['outputs'])} without {', '.join(bad)}")
    return {"reached": sorted(reached)}


def _induction(statement, squares, effort):
    certificate = {"base": [], "step": []}
    names = (*statement["variables"], *statement["state"])
    values = {name: kernel.variable(name) for name in names}
    start, following = ({n: kernel.read(p, values) for n, p in statement[k].items()} for k in ("start", "next"))
    facts = [(kernel.read(step["of"], values), step["is"]) for step in statement["assume"]]
    claims = [kernel.read(p, values) for p in statement["show"]]
    for p in claims:
        certificate["base"].append(find((kernel.substitute(p, values | start), "="), facts, values))
        step_facts = facts + [(q, "=") for q in claims]
        certificate["step"].append(find((kernel.substitute(p, values | following), "="), step_facts, values))
    return certificate
