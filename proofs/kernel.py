"""The kernel decides whether a certificate proves a statement, by exact rational arithmetic and nothing else.

Trust this file and the translation of formulas into statements (`proofs.statement`, which documents the data).
A polynomial is {monomial: coefficient}, a monomial the sorted tuple of its names: 2x²y is {("x", "x", "y"): 2}.
A fact or goal is (p, relation): p = 0, p ≥ 0, p > 0 or p ≠ 0.
"""

from fractions import Fraction

HOLDS = {"=": lambda a: a == 0, "!=": lambda a: a != 0, ">": lambda a: a > 0, ">=": lambda a: a >= 0}
NEGATION = {"=": (1, "!="), "!=": (1, "="), ">": (-1, ">="), ">=": (-1, ">")}  # not p > 0 is −p ≥ 0
CASES = {"<": (-1, ">"), "=": (1, "="), ">": (1, ">")}
ONE = {(): Fraction(1)}


class Rejected(Exception):
    """(reason, residual): why a certificate proves nothing; where two sides differ, the residual polynomial."""


def require(condition, reason, residual=None):
    if not condition:
        raise Rejected(reason, residual)


def variable(name):
    return {(name,): Fraction(1)}


def add(p, q, scale=1):
    """Return p + scale · q."""
    total = dict(p)
    for monomial, coefficient in q.items():
        total[monomial] = total.get(monomial, 0) + scale * coefficient
    return {monomial: coefficient for monomial, coefficient in total.items() if coefficient}


def multiply(*polynomials):
    product = ONE
    for q in polynomials:
        p, product = product, {}
        for a, c in p.items():
            for b, d in q.items():
                monomial = tuple(sorted(a + b))
                product[monomial] = product.get(monomial, 0) + c * d
    return {monomial: coefficient for monomial, coefficient in product.items() if coefficient}


def substitute(p, values):
    """Return p with names replaced by polynomials, {name: polynomial}, all at once."""
    total = {}
    for monomial, coefficient in p.items():
        rest = {tuple(name for name in monomial if name not in values): coefficient}
        total = add(total, multiply(rest, *(values[name] for name in monomial if name in values)))
    return total


def read(data, values):
    """Return the polynomial {"x^2 y": "-3/2", "": "1"}; `values` has every name: itself, or what abbreviates."""
    total = {}
    for text, coefficient in data.items():
        factors = [factor.partition("^") for factor in text.split()]
        require(all(name in values for name, _, _ in factors), f"a name in {text} is not declared")
        monomial = tuple(sorted(name for name, _, power in factors for _ in range(int(power or 1))))
        total = add(total, {monomial: Fraction(coefficient)})
    return substitute(total, {name: q for name, q in values.items() if q != variable(name)})


def close(p, facts, cofactors, values):
    """Reject unless p = Σ q_i g_i, where every g_i = 0 is a fact."""
    for index, cofactor in cofactors:
        require(facts[index][1] == "=", f"fact {index} is not an equation")
        p = add(p, multiply(read(cofactor, values), facts[index][0]), -1)
    require(not p, "the two sides differ", p)


def prove(goal, facts, proof, values):
    """Reject unless `proof` derives the goal from the facts."""
    p, relation = goal
    if proof["rule"] == "ideal":  # p = Σ q_i g_i
        require(relation == "=", "membership in an ideal proves equations only")
        close(p, facts, proof["cofactors"], values)
    elif proof["rule"] == "contradiction":  # of facts and negated goal: positive + Σ c s² Π h_j = Σ q_i g_i
        scale, opposite = NEGATION[relation]
        facts, total = [*facts, (add({}, p, scale), opposite)], ONE
        for index in proof["positive"]:
            q, strict = facts[index]
            require(strict in (">", "!="), f"fact {index} is not strict")
            total = multiply(total, q, q) if strict == "!=" else multiply(total, q)
        for coefficient, root, factors in proof["sum"]:
            require(Fraction(coefficient) >= 0, "a coefficient is negative")
            require(all(facts[j][1] in (">", ">=") for j in factors), "a factor is not known to be non-negative")
            square = [read(root, values)] * 2
            total = add(total, multiply({(): Fraction(coefficient)}, *square, *(facts[j][0] for j in factors)))
        close(total, facts, proof["cofactors"], values)
    elif proof["rule"] == "cases":  # by the sign of a polynomial
        for branch, (scale, added) in CASES.items():
            split = (add({}, read(proof["on"], values), scale), added)
            prove(goal, [*facts, split], proof["branches"][branch], values)
    else:
        require(False, f"there is no rule {proof['rule']!r}")


def derive(statement, meet):
    """Take a derivation's steps in order; meet(goal, facts, values) is called for whatever has to be proved."""
    values, facts = {name: variable(name) for name in statement["variables"]}, []
    for step in statement["steps"]:
        kind, p = step["step"], read(step["of"], values)
        goal = (p, {"root": ">=", "inverse": "!="}.get(kind) or step.get("is"))
        if kind in ("show", "root", "inverse"):
            meet(goal, facts, values)
        if kind in ("show", "assume"):
            require(goal[1] in HOLDS, f"there is no relation {goal[1]}")
            facts.append(goal)
            continue
        name, y = step["new"], variable(step["new"])
        require(name not in values, f"{name} is not new")
        if kind == "root":  # y = √p
            facts += [(add(multiply(y, y), p, -1), "="), (y, ">=")]
        elif kind == "inverse":  # y = 1/p
            facts.append((add(multiply(y, p), ONE, -1), "="))
        else:
            require(kind == "define", f"there is no step {kind}")
        values[name] = p if kind == "define" else y
    return facts


def prove_all(statement, certificate):
    proofs = iter(certificate["proofs"])
    derive(statement, lambda goal, facts, values: prove(goal, facts, next(proofs), values))


def refute(statement, certificate):
    """Reject unless at the point everything holds except the last goal."""
    point, goals = {name: {(): Fraction(value)} for name, value in certificate["point"].items()}, []
    *facts, (claim, relation) = derive(statement, lambda goal, *_: goals.append(goal))
    require(statement["steps"][-1]["step"] == "show", "there is no last goal")
    for p, holds in [(q, HOLDS[r]) for q, r in facts + goals[:-1]] + [(claim, lambda a: not HOLDS[relation](a))]:
        value = substitute(p, point)
        require(set(value) <= {()}, "the point leaves a name without a value", value)
        require(holds(value.get((), 0)), "the point is not a counterexample", p)


def induct(statement, certificate):
    """Reject unless every p of `show` is 0 at the start, and at the next state if it, and what else, is 0 now."""
    values = {name: variable(name) for name in (*statement["variables"], *statement["state"])}
    start, following = ({n: read(p, values) for n, p in statement[k].items()} for k in ("start", "next"))
    require(start.keys() == following.keys() == set(statement["state"]), "a state is not given")
    facts = [(read(step["of"], values), step["is"]) for step in statement["assume"]]
    require(not any(set(n) & start.keys() for p, _ in facts for n in p), "an assumption about the state")
    claims = [read(p, values) for p in statement["show"] + certificate["strengthen"]]
    for p, base, step in zip(claims, certificate["base"], certificate["step"], strict=True):
        prove((substitute(p, start), "="), facts, base, values)
        prove((substitute(p, following), "="), facts + [(q, "=") for q in claims], step, values)


def separate(statement, certificate):
    """Reject unless the certificate's set holds the outputs and all that they use, and nothing to be avoided."""
    reached = set(certificate["reached"])
    require(reached >= set(statement["outputs"]), "an output is missing")
    for name, uses in statement["lines"]:
        require(name not in reached or reached >= set(uses), f"{name} uses a name that is missing")
    require(not reached & set(statement["avoid"]), "reaches what was to be avoided")


RULES = {"derivation": prove_all, "refutation": refute, "induction": induct, "separation": separate}


def check(statement, certificate):
    """Return None if the certificate proves the statement, else the exception that says why it does not."""
    try:
        RULES[statement["kind"]](statement, certificate)
    except Exception as why:  # a malformed certificate proves nothing either
        return why
