"""The kernel decides whether a certificate proves a statement, by exact rational arithmetic and nothing else.

Trust this file and the translation of formulas into statements (`proofs.engine.statement`; `statement_data` has the
format). A polynomial is {monomial: coefficient}, a monomial the sorted tuple of its names: 2x²y is {("x", "x", "y"):
2}. A fact or goal is (p, relation): p = 0, p ≥ 0, p > 0 or p ≠ 0.
"""

from fractions import Fraction

HOLDS = {"=": lambda a: a == 0, "!=": lambda a: a != 0, ">": lambda a: a > 0, ">=": lambda a: a >= 0}
NEGATION = {"=": (1, "!="), "!=": (1, "="), ">": (-1, ">="), ">=": (-1, ">")}  # not p > 0 is −p ≥ 0


class Rejected(Exception):
    """(reason, residual): why a certificate proves nothing; where two sides differ, the residual polynomial."""


def require(condition, reason, residual=None):
    if not condition:
        raise Rejected(reason, residual)


def variable(name):
    return {(name,): Fraction(1)}


def add(*polynomials):
    total = {}
    for p in polynomials:
        for monomial, coefficient in p.items():
            total[monomial] = total.get(monomial, 0) + coefficient
    return {monomial: coefficient for monomial, coefficient in total.items() if coefficient}


def multiply(number, *polynomials):
    product = {(): Fraction(number)}
    for p in polynomials:
        product = add(*({tuple(sorted(a + b)): c * d for b, d in p.items()} for a, c in product.items()))
    return product


def substitute(p, values):
    """Return p with every name replaced by its polynomial in `values`."""
    return add(*(multiply(coefficient, *(values[name] for name in monomial)) for monomial, coefficient in p.items()))


def read(data, values):
    """Return the polynomial {"x^2 y": "-3/2", "": "1"} with every name replaced by its polynomial in `values`."""
    terms = []
    for text, coefficient in data.items():
        powers = [(name, int(power) if sign else 1) for name, sign, power in (f.partition("^") for f in text.split())]
        require(all(power > 0 for _, power in powers), f"{text!r} is not a product of powers")
        terms.append(multiply(coefficient, *(values[name] for name, power in powers for _ in range(power))))
    return add(*terms)


def prove(goal, facts, proof, values):
    """Reject unless `proof` derives the goal from the facts."""
    p, relation = goal
    if proof["rule"] == "cases":  # by the sign of a polynomial
        for branch, sign, added in (("<", -1, ">"), ("=", 1, "="), (">", 1, ">")):
            split = (multiply(sign, read(proof["on"], values)), added)
            prove(goal, [*facts, split], proof["branches"][branch], values)
        return
    if proof["rule"] == "ideal":  # p = Σ q_i g_i, where every g_i = 0 is a fact
        require(relation == "=", "membership in an ideal proves equations only")
    else:  # contradiction of facts and negated goal: Π of what is ≠ 0 or > 0, + Σ c s² Π h_j = Σ q_i g_i
        require(proof["rule"] == "contradiction", f"there is no rule {proof['rule']!r}")
        sign, opposite = NEGATION[relation]
        facts = [*facts, (multiply(sign, p), opposite)]
        strict = [facts[index] for index in proof["positive"]]
        require(all(r in (">", "!=") for _, r in strict), "a fact is not strict")
        p = multiply(1, *(q for f, r in strict for q in ([f, f] if r == "!=" else [f])))
        for coefficient, root, factors in proof["sum"]:
            require(all(facts[j][1] in (">", ">=") for j in factors) and Fraction(coefficient) >= 0, "may be negative")
            p = add(p, multiply(coefficient, *[read(root, values)] * 2, *(facts[j][0] for j in factors)))
    for index, cofactor in proof["cofactors"]:
        require(facts[index][1] == "=", f"fact {index} is not an equation")
        p = add(p, multiply(-1, read(cofactor, values), facts[index][0]))
    require(not p, "the two sides differ", p)


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
            facts += [(add(multiply(1, y, y), multiply(-1, p)), "="), (y, ">=")]
        elif kind == "inverse":  # y = 1/p
            facts.append((add(multiply(1, y, p), multiply(-1)), "="))
        else:
            require(kind == "define", f"there is no step {kind}")
        values[name] = p if kind == "define" else y
    return facts


def prove_all(statement, certificate):
    proofs = iter(certificate["proofs"])
    derive(statement, lambda goal, facts, values: prove(goal, facts, next(proofs), values))


def refute(statement, certificate):
    """Reject unless at the point everything holds except the last goal."""
    point, goals = {name: multiply(value) for name, value in certificate["point"].items()}, []
    *facts, (claim, relation) = derive(statement, lambda goal, *_: goals.append(goal))
    require(statement["steps"][-1]["step"] == "show", "there is no last goal")
    for p, holds in [(q, HOLDS[r]) for q, r in facts + goals[:-1]] + [(claim, lambda a: not HOLDS[relation](a))]:
        require(holds(substitute(p, point).get((), 0)), "the point is not a counterexample", p)


def induct(statement, certificate):
    """Reject unless every p of `show` is 0 at the start, and at the next state if it, and what else, is 0 now."""
    values = {name: variable(name) for name in (*statement["variables"], *statement["state"])}
    start, following = ({n: read(p, values) for n, p in statement[k].items()} for k in ("start", "next"))
    require(start.keys() == following.keys() == set(statement["state"]), "a state is not given")
    facts = [(read(step["of"], values), step["is"]) for step in statement["assume"]]
    require(not any(set(n) & start.keys() for p, _ in facts for n in p), "an assumption about the state")
    claims = [read(p, values) for p in statement["show"] + certificate["strengthen"]]
    for p, base, step in zip(claims, certificate["base"], certificate["step"], strict=True):
        prove((substitute(p, values | start), "="), facts, base, values)
        prove((substitute(p, values | following), "="), facts + [(q, "=") for q in claims], step, values)


def separate(statement, certificate):
    """Reject unless the certificate's set holds the outputs and all that they use, and nothing to be avoided."""
    reached = set(certificate["reached"])
    closed = all(reached >= set(uses) for name, uses in statement["lines"] if name in reached)
    require(closed and reached >= set(statement["outputs"]), "an output, or a name that is used, is missing")
    require(not reached & set(statement["avoid"]), "reaches what was to be avoided")


RULES = {"derivation": prove_all, "refutation": refute, "induction": induct, "separation": separate}


def check(statement, certificate):
    """Return None if the certificate proves the statement, else the exception that says why it does not."""
    try:
        require(statement["version"] == 1, "only version 1 is known")
        RULES[statement["kind"]](statement, certificate)
    except Exception as why:  # a malformed certificate proves nothing either
        return why
