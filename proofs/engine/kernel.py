"""The kernel: it decides whether a certificate proves a statement, by exact rational arithmetic and nothing else.

Trust this file and the translation of formulas into statements (`proofs.engine.statement`; `certificate` has the
format). A polynomial is {monomial: coefficient}, a monomial the sorted tuple of its names: 2x²y is {("x", "x", "y"):
2}. A fact or goal is (p, is_relation): p = 0, p ≥ 0, p > 0 or p ≠ 0.
"""

import re
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache

Polynomial = dict[tuple[str, ...], int | Fraction]
Fact = tuple[Polynomial, str]
Values = dict[str, Polynomial]

HOLDS = {"=": lambda a: a == 0, "!=": lambda a: a != 0, ">": lambda a: a > 0, ">=": lambda a: a >= 0}
NEGATION = {"=": (1, "!="), "!=": (1, "="), ">": (-1, ">="), ">=": (-1, ">")}  # not p > 0 is −p ≥ 0
NAME = r"(?:[A-Za-z][A-Za-z0-9_]{0,99}|(?:cos|sin)\([A-Za-z0-9_*/()+-]{1,99}\))"
POWER = rf"{NAME}(?:\^(?:[2-9]|[1-9][0-9]{{1,2}}))?"  # "x", or "x^2" to "x^999"
NUMBER = re.compile(r"-?[0-9]{1,500}(?:/[0-9]{1,500})?")  # and in lowest terms
LONGEST = 100_000  # items of a list, terms of a polynomial, names in all terms of a product, bits of a number


class Rejected(Exception):
    """(reason, residual): why a certificate proves nothing; where two sides differ, the residual polynomial."""

    def __str__(self) -> str:
        try:
            return super().__str__()
        except ValueError:  # Python writes no number of more than 4300 digits
            return str(self.args[0])


def require(condition: object, reason: str, residual: Polynomial | None = None) -> None:
    """Raise Rejected with the reason unless the condition holds."""
    if not condition:
        raise Rejected(reason, residual)


# The grammar: what has another shape is no statement and no certificate


def is_name(text: object) -> bool:
    """Return whether this is a name, or the cosine or sine of an angle, which is one, too."""
    return isinstance(text, str) and re.fullmatch(NAME, text) is not None


@cache
def is_number(text: object) -> bool:
    """Return whether this is the text of a whole number or a fraction in lowest terms."""
    return isinstance(text, str) and NUMBER.fullmatch(text) is not None and text == str(Fraction(text))


@cache
def is_monomial(text: str) -> bool:
    """Return whether these are powers of different names, a blank between them; none: 1."""
    names = [factor.partition("^")[0] for factor in text.split()]
    return re.fullmatch(f"(?:{POWER}(?: {POWER})*)?", text) is not None and len(set(names)) == len(names)


def is_polynomial(data: object) -> bool:
    """Return whether this is {monomial: coefficient}, no coefficient 0."""
    if type(data) is not dict or len(data) > LONGEST:
        return False
    return all(is_monomial(m) and is_number(c) and c != "0" for m, c in data.items())


def is_index(i: object) -> bool:
    """Return whether this may number a fact."""
    return type(i) is int and 0 <= i <= LONGEST


def is_relation(text: object) -> bool:
    """Return whether this is =, !=, > or >=."""
    return text in tuple(HOLDS)


def fits(value: object, shape: object) -> bool:
    """Return whether a value has a shape: [of each item], (of the items, …), {key: shape}, a test, or a text itself."""
    if isinstance(shape, list):
        return type(value) is list and len(value) <= LONGEST and all(fits(item, shape[0]) for item in value)
    if isinstance(shape, tuple):
        return type(value) is list and len(value) == len(shape) and all(map(fits, value, shape))
    if isinstance(shape, dict):
        return type(value) is dict and value.keys() == shape.keys() and all(fits(value[k], shape[k]) for k in shape)
    return shape(value) if callable(shape) else type(value) is type(shape) and value == shape


def is_step(data: dict) -> bool:
    """Return whether this is a step of one of the STEPS."""
    return fits(data, STEPS[data["step"]])


def is_proof(data: dict) -> bool:
    """Return whether this is a proof by one of the rules in PROOFS."""
    return fits(data, PROOFS[data["rule"]])


def values_of(test: Callable) -> Callable:
    """Return the test of {name: what passes the given test}."""
    return lambda data: type(data) is dict and fits([*data], [is_name]) and all(map(test, data.values()))


COFACTORS = [(is_index, is_polynomial)]
PROOFS = {
    "ideal": {"rule": "ideal", "cofactors": COFACTORS},
    "contradiction": {
        "rule": "contradiction",
        "positive": [is_index],
        "sum": [(is_number, is_polynomial, [is_index])],
        "cofactors": COFACTORS,
    },
}
STEPS = {kind: {"step": kind, "is": is_relation, "of": is_polynomial} for kind in ("assume", "show")}
STEPS |= {kind: {"step": kind, "new": is_name, "of": is_polynomial} for kind in ("define", "root", "inverse")}
SHAPES = {
    "derivation": ({"variables": [is_name], "steps": [is_step]}, {"proofs": [is_proof]}),
    "refutation": ({"variables": [is_name], "steps": [is_step]}, {"point": values_of(is_number)}),
    "induction": (
        {"variables": [is_name], "state": [is_name], "assume": [{"of": is_polynomial, "is": is_relation}]}
        | {"start": values_of(is_polynomial), "next": values_of(is_polynomial), "show": [is_polynomial]},
        {"base": [is_proof], "step": [is_proof]},
    ),
    "separation": ({"lines": [(is_name, [is_name])], "outputs": [is_name], "avoid": [is_name]}, {"reached": [is_name]}),
}


# Polynomials


def exact(text: str) -> int | Fraction:
    """Return the number of a text: an int where it is whole, which is quicker."""
    return Fraction(text) if "/" in text else int(text)


def variable(name: str) -> Polynomial:
    """Return the polynomial that is one name."""
    return {(name,): 1}


def add(*polynomials: Polynomial) -> Polynomial:
    """Return the sum; no coefficient in it is 0."""
    total: Polynomial = {}
    for p in polynomials:
        for monomial, coefficient in p.items():
            total[monomial] = total.get(monomial, 0) + coefficient
    return {monomial: coefficient for monomial, coefficient in total.items() if coefficient}


def multiply(number: int | Fraction, *polynomials: Polynomial) -> Polynomial:
    """Return the product of a number and polynomials; reject one that would take more than seconds."""
    product: Polynomial = {(): number}
    for p in polynomials:
        degree = sum(max(map(len, q), default=0) for q in (product, p))
        require(len(product) * len(p) * (1 + degree) <= LONGEST, "a product is too long")
        bits = sum(max((c.numerator.bit_length() for c in q.values()), default=0) for q in (product, p))
        require(bits <= LONGEST, "a number is too long")
        product = add(*({tuple(sorted(a + b)): c * d for b, d in p.items()} for a, c in product.items()))
    return product


def substitute(p: Polynomial, values: Values) -> Polynomial:
    """Return p with every name replaced by its polynomial in `values`."""
    return add(*(multiply(coefficient, *(values[name] for name in monomial)) for monomial, coefficient in p.items()))


def read(data: dict[str, str], values: Values) -> Polynomial:
    """Return the polynomial {"x^2 y": "-3/2", "": "1"} with every name replaced by its polynomial in `values`."""
    terms = []
    for text, coefficient in data.items():
        powers = [(name, int(power or 1)) for name, _, power in (f.partition("^") for f in text.split())]
        terms.append(multiply(exact(coefficient), *(values[name] for name, power in powers for _ in range(power))))
    return add(*terms)


# Proofs


def prove(goal: Fact, facts: list[Fact], proof: dict, values: Values) -> None:
    """Reject unless `proof` derives the goal from the facts."""
    p, relation = goal
    if proof["rule"] == "ideal":  # p = Σ q_i g_i, where every g_i = 0 is a fact
        require(relation == "=", "membership in an ideal proves equations only")
    else:  # contradiction of facts and negated goal: Π of what is ≠ 0 or > 0, + Σ c s² Π h_j = Σ q_i g_i
        sign, opposite = NEGATION[relation]
        facts = [*facts, (multiply(sign, p), opposite)]
        strict = [facts[index] for index in proof["positive"]]
        require(all(r in (">", "!=") for _, r in strict), "a fact is not strict")
        p = multiply(1, *(q for f, r in strict for q in ([f, f] if r == "!=" else [f])))
        for coefficient, root, factors in proof["sum"]:
            require(all(facts[j][1] in (">", ">=") for j in factors) and exact(coefficient) >= 0, "may be negative")
            p = add(p, multiply(exact(coefficient), *[read(root, values)] * 2, *(facts[j][0] for j in factors)))
    for index, cofactor in proof["cofactors"]:
        require(facts[index][1] == "=", f"fact {index} is not an equation")
        p = add(p, multiply(-1, read(cofactor, values), facts[index][0]))
    require(not p, "the two sides differ", p)


def named(names: Sequence[str]) -> Values:
    """Return {name: the polynomial that is that name}; reject a name that comes twice."""
    require(len(set(names)) == len(names), "a name is introduced twice")
    return {name: variable(name) for name in names}


def derive(statement: dict, meet: Callable) -> list[Fact]:
    """Take a derivation's steps in order; meet(goal, facts, values) is called for whatever has to be proved."""
    values = named(statement["variables"])
    facts: list[Fact] = []
    for step in statement["steps"]:
        kind, p = step["step"], read(step["of"], values)
        goal = (p, {"root": ">=", "inverse": "!="}.get(kind) or step.get("is"))
        if kind in ("show", "root", "inverse"):
            meet(goal, facts, values)
        if kind in ("show", "assume"):
            facts.append(goal)
            continue
        name, y = step["new"], variable(step["new"])
        require(name not in values, f"{name} is not new")
        if kind == "root":  # y = √p
            facts += [(add(multiply(1, y, y), multiply(-1, p)), "="), (y, ">=")]
        elif kind == "inverse":  # y = 1/p
            facts.append((add(multiply(1, y, p), multiply(-1)), "="))
        values[name] = p if kind == "define" else y
    return facts


def prove_each(goals: Callable, statement: dict, proofs: list) -> None:
    """Reject unless each of the `goals` of a statement has its proof, in order; goals: `derive` or `carry`."""
    waiting = iter(proofs)
    goals(statement, lambda goal, facts, values: prove(goal, facts, next(waiting), values))
    require(next(waiting, None) is None, "a proof is left over")


def prove_all(statement: dict, certificate: dict) -> None:
    """Reject unless something is shown, and each goal of a derivation has its proof."""
    require(any(step["step"] == "show" for step in statement["steps"]), "nothing is claimed")
    prove_each(derive, statement, certificate["proofs"])


def refute(statement: dict, certificate: dict) -> None:
    """Reject unless at the point everything holds except the last goal; π is no coordinate, a cosine has its sine."""
    point, goals = {name: multiply(exact(value)) for name, value in certificate["point"].items()}, []
    *facts, (claim, relation) = derive(statement, lambda goal, *_: goals.append(goal))
    require(statement["steps"][-1]["step"] == "show", "there is no last goal")
    new = {step["new"] for step in statement["steps"] if step["step"] in ("root", "inverse")}
    require(point.keys() == new.union(statement["variables"]), "the point is of other names")
    require("pi" not in point, "π is no coordinate")
    for name in [name for name in point if "(" in name]:
        pair = [point[function + name[3:]] for function in ("cos", "sin")]
        require(add(*(multiply(1, p, p) for p in pair)) == multiply(1), f"{name} is off the circle")
    for p, holds in [(q, HOLDS[r]) for q, r in facts + goals[:-1]] + [(claim, lambda a: not HOLDS[relation](a))]:
        require(holds(substitute(p, point).get((), 0)), "the point is not a counterexample", p)


def carry(statement: dict, meet: Callable) -> None:
    """Call meet(goal, facts, values) for each p of an induction's `show`: at the start, then at the next state."""
    fixed, values = (named([*statement["variables"], *more]) for more in ((), statement["state"]))
    require(statement["start"].keys() == statement["next"].keys() == set(statement["state"]), "a state is not given")
    start = {name: read(p, fixed) for name, p in statement["start"].items()}
    following = {name: read(p, values) for name, p in statement["next"].items()}
    facts = [(read(step["of"], fixed), step["is"]) for step in statement["assume"]]
    claims = [read(p, values) for p in statement["show"]]
    for p in claims:
        meet((substitute(p, values | start), "="), facts, values)
        meet((substitute(p, values | following), "="), facts + [(q, "=") for q in claims], values)


def induct(statement: dict, certificate: dict) -> None:
    """Reject unless every p of `show` is 0 at the start, and at the next state if all of them are 0 now."""
    require(statement["show"], "nothing is claimed")
    pairs = zip(certificate["base"], certificate["step"], strict=True)
    prove_each(carry, statement, [proof for pair in pairs for proof in pair])


def separate(statement: dict, certificate: dict) -> None:
    """Reject unless the certificate's set holds the outputs and all that they use, and nothing to be avoided."""
    reached = set(certificate["reached"])
    require(statement["outputs"] and statement["avoid"], "nothing is claimed")
    closed = all(reached >= set(uses) for name, uses in statement["lines"] if name in reached)
    require(closed and reached >= set(statement["outputs"]), "an output, or a name that is used, is missing")
    require(not reached & set(statement["avoid"]), "reaches what was to be avoided")


RULES = {"derivation": prove_all, "refutation": refute, "induction": induct, "separation": separate}


def check(statement: dict, certificate: dict) -> Exception | None:
    """Return None if the certificate proves the statement, else the exception that says why it does not."""
    try:
        kind = statement["kind"]
        of_statement, of_certificate = SHAPES[kind]
        require(fits(statement, {"version": 1, "kind": kind} | of_statement), "not a statement's form")
        require(fits(certificate, of_certificate), "not a certificate's form")
        RULES[kind](statement, certificate)
    except Exception as why:  # a malformed certificate proves nothing either
        return why
    return None
