"""What the kernel asks of a claim's divisors, radicands and derivatives, Coq is asked, too: no printed form says less.

The statements that the kernel checks are compared with the text of Statements.v, by their values at points at which
the hypotheses hold. That a branch of |x|, max or a case is the one that is taken Coq computes; it is not asked.
"""

import re
from math import prod

import mpmath
import pytest
from sympy import Piecewise, Pow, Rational, Symbol, factor_list, true

from proofs.check import FOLDER, is_empty, parsed, text_of
from proofs.engine.claim import Claim
from proofs.engine.theorem import all_theorems
from renderer.generate.printer import differentiated
from renderer.generate.statements import StatementPrinter
from verify import formal
from verify.checkers.digits import WORKING_DIGITS, Code, Relations, Undefined, parts_of
from verify.checkers.sampler import Sampler

POINTS, ATTEMPTS = 2, 3000
CLOSE = mpmath.mpf(10) ** -30
DEFINITION = re.compile(r"^Definition (\w+) : Prop :=\n(.*?)\.$", re.MULTILINE | re.DOTALL)
WRITTEN = dict(DEFINITION.findall((formal.FOLDER / "Statements.v").read_text(encoding="utf-8")))
CONDITIONAL = re.compile(r"^\((.* -> .*)\)$")
CLAIMS = [(t, c) for t in all_theorems().values() for c in t.claims if isinstance(c, Claim)]


def near(one, other):
    return one is not None and abs(one - other) < CLOSE * (1 + abs(other))


def powers(monomial):
    return [(name, int(power or 1)) for name, _, power in (factor.partition("^") for factor in monomial.split())]


def polynomial(data, values):
    """Return the value of a polynomial {"x^2 y": "-3/2"} where its names have values."""
    total = mpmath.mpf(0)
    for monomial, coefficient in data.items():
        product = mpmath.fprod(values[name] ** power for name, power in powers(monomial))
        total += product * mpmath.mpf(int((parts := coefficient.split("/"))[0])) / int([*parts, 1][1])
    return total


def is_square(data):
    """Return whether a polynomial is a square, as of |x| = √x²."""
    p = sum(Rational(c) * prod(Symbol(n) ** k for n, k in powers(m)) for m, c in data.items())
    coefficient, factors = factor_list(p)
    return coefficient > 0 and all(power % 2 == 0 for _, power in factors)


def asked_by_the_kernel(statement, values):
    """Return [(relation, values that say it)] of a case's obligations at a point; None if it is another case's.

    What holds of numbers alone, and what is given, needs no word.
    """
    names = {str(symbol): value for symbol, value in values.items()} | {"pi": +mpmath.pi}
    functions = {"cos": mpmath.cos, "sin": mpmath.sin}
    at = {name: eval(name, functions, names) for name in statement["variables"]}
    found, given, radicands, numbers = [], [], {}, {"pi"}
    for step in statement["steps"]:
        value, new = polynomial(step["of"], at), step.get("new")
        alone = {name for monomial in step["of"] for name, _ in powers(monomial)} <= numbers
        numbers |= {new} if alone else set()
        match step["step"]:
            case "assume" if (value < -CLOSE and step["is"] != "!=") or (abs(value) > CLOSE and step["is"] == "="):
                return None
            case "assume":
                given.append(value)
            case "define":
                at[new] = value
            case "root":
                found += [] if alone or is_square(step["of"]) else [(">=", [value])]
                at[new], radicands[new] = mpmath.sqrt(abs(value)), value
            case "inverse":
                of_root = [radicands[name] for name in step["of"] if name in radicands]
                found += [] if alone else [("!=", [value, *of_root])]
                at[new] = 1 / value
            case "show" if step["is"] in ("=", "!=") and not any(near(abs(g), abs(value)) for g in given):
                found.append((step["is"], [value, -value]))
    return found


def asked_of_coq(theorem, text):
    """Return [(conditions, need or conclusion)] of what a definition asks to be shown; of a negation, of what it gives.

    Both stand one a line, in this order: hypotheses, each with an arrow at its end, and conjuncts.
    """
    lines = text.splitlines()
    hypotheses = [number for number, line in enumerate(lines) if line.endswith((" ->", ",", " in"))]
    if theorem.expected == "refuted":
        asked = [lines[number].removesuffix(" ->") for number in hypotheses]
    else:
        asked = [line.removesuffix(" /\\") for line in lines[max(hypotheses, default=-1) + 1 :]]
    return [
        (conditions, last)
        for *conditions, last in (CONDITIONAL.sub(r"\1", line.strip()).split(" -> ") for line in asked)
    ]


class Meaning:
    """What the needs among a definition's lines say at a point."""

    def __init__(self, theorem, claim, text):
        _, program = claim.names()
        self.lines = [(symbol, differentiated(e)) for symbol, e in program.definitions] if program else []
        written = (*claim.given, *claim.shows)
        relations = [differentiated(r) for r in written]
        expressions = [*relations, *written, *(e for line in self.lines for e in line)]
        show = StatementPrinter(set().union(*(e.free_symbols for e in expressions)))
        bases = {power.base for e in expressions for power in e.atoms(Pow)}
        signs = (("<>", "!="), (">=", ">="), (">", ">"))
        meant = {f"{show.doprint(b)} {s} 0": (r, b) for b in bases for s, r in signs}
        conditions = {c for e in expressions for cases in e.atoms(Piecewise) for _, c in cases.args if c != true}
        self.conditions = {show.relation(c): (c, True) for c in conditions}
        self.conditions |= {f"~ ({show.relation(c)})": (c, False) for c in conditions}
        self.needs = [(meant[last], conditions) for conditions, last in asked_of_coq(theorem, text) if last in meant]
        self.shown = parts_of(relations[len(claim.given) :])

    def __call__(self, values):
        """Return [(relation, value)] of the needs that are asked for at a point, and of what is shown."""
        with_conditions = [need for need, conditions in self.needs if all(self.is_met(c, values) for c in conditions)]
        differences = [self.value((r.lhs, r.rhs), values) for r in self.shown]
        found = [(relation, d) for d in differences for relation in ("=", "!=")]
        return found + [(relation, self.value((e,), values)) for relation, e in with_conditions]

    def is_met(self, condition, values):
        relation, holds = self.conditions[condition]
        return Relations([relation], self.lines)(values) == holds

    def value(self, sides, values):
        """Return the value of an expression, or of left − right, None where there is none."""
        try:
            first, *others = Code(sides, self.lines)(values)
            return first - sum(others)
        except Undefined:
            return None


def left_out(theorem, claim, text):
    """Return what the kernel asks of a claim at some point, and its printed form does not."""
    meaning, sampler, found = Meaning(theorem, claim, text), Sampler(claim, "obligations"), []
    (entry,) = (e for e in parsed(text_of(FOLDER / f"{theorem.id}.json"), theorem.id) if e["claim"] == claim.name)
    fixed = Code([v for _, v in theorem.refuted_at or ()])({})
    fixed = dict(zip((s for s, _ in theorem.refuted_at or ()), fixed, strict=True))
    for case in (e["statement"] for e in entry["statements"] if not is_empty(e["statement"])):
        seen = 0
        for _ in range(ATTEMPTS):
            values = sampler.inputs_at_random(fixed)
            asked = None if values is None or sampler.verdict(values) is None else asked_by_the_kernel(case, values)
            if asked is None:
                continue
            said, seen = meaning(values), seen + 1
            found += [
                (relation, mpmath.nstr(of[0], 5))
                for relation, of in asked
                if not any(r in (relation, ">") and near(v, one) for r, v in said for one in of)
            ]
            if found or seen == POINTS:
                break
        assert seen, f"{theorem.id}/{claim.name}: no point"
    return found


def test_the_printed_form_of_a_claim_asks_for_all_that_the_kernel_asks_for():
    with mpmath.workdps(WORKING_DIGITS):
        less = {f"{t.id}__{c.name}": left_out(t, c, WRITTEN[f"{t.id}__{c.name}"]) for t, c in CLAIMS}
    assert len(less) > 180 and not any(less.values()), less
    for theorem, claim in CLAIMS:
        said = [last for _, last in asked_of_coq(theorem, WRITTEN[f"{theorem.id}__{claim.name}"])]
        assert not {"True", "False"}.intersection(said), f"{theorem.id}/{claim.name}: SymPy decided a relation"


LESS = [
    ("normalising_is_lipschitz__normalise", "  length_a <> 0 /\\\n", "", "left out"),
    ("normalising_is_lipschitz__normalise", "length_a <> 0 /\\", "length_a <> 0 ->", "a hypothesis"),
    ("normalising_is_lipschitz__normalise", "length_a <> 0", "length_a >= 0", "another relation"),
    ("normalising_is_lipschitz__normalise", "length_a <> 0", "length_a ^ 2 >= 0", "of another number"),
    ("image_derivative__lit_shiny", "(specular_base > 0 -> ", "(~ (specular_base > 0) -> ", "another condition"),
    ("image_derivative__lit_shiny", "  (specular_base > 0 -> specular_base <> 0) /\\\n", "", "left out of a case"),
    ("image_derivative__blinn", "halfway_length <> 0", "True", "left out of a derivative"),
    ("seed_step_in_beta__verifies", " >= 0 ->", " >= 1 ->", "of a negation, radicands"),
    ("seed_step_in_beta__verifies", " <> 0 ->", " <> 0 /\\", "of a negation, divisors"),
]


@pytest.mark.parametrize(("name", "was", "less"), [case[:3] for case in LESS], ids=[case[3] for case in LESS])
def test_a_need_that_is_left_out_is_missed(name, was, less):
    ((theorem, claim),) = ((t, c) for t, c in CLAIMS if f"{t.id}__{c.name}" == name)
    assert was in WRITTEN[name]
    with mpmath.workdps(WORKING_DIGITS):
        assert left_out(theorem, claim, WRITTEN[name]) == []
        assert left_out(theorem, claim, WRITTEN[name].replace(was, less))
