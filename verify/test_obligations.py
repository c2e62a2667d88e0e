"""Obligations of a claim's divisors, radicands and derivatives: Coq is asked for all that the kernel asks for.

The statements that the kernel checks are compared with the text of Statements.v, by their values at points at which
the hypotheses hold. Coq is not asked which branch of |x|, max or a case is taken: it computes that.
"""

import re
from functools import cache

import mpmath
import pytest
from sympy import Piecewise, Pow, Rational, Symbol, cos, factor_list, sin, true

from proofs.check import is_empty, parsed, text_of
from proofs.engine.claim import Claim
from proofs.engine.stored import FOLDER
from proofs.engine.theorem import all_theorems
from proofs.printers.coq_statements import StatementPrinter
from verify.checkers.digits import WORKING_DIGITS, Code, Relations, Undefined, differentiated, parts_of
from verify.checkers.sampler import Sampler
from verify.coq import formal

POINTS, ATTEMPTS = 2, 3000
CLOSE = mpmath.mpf(10) ** -30
DEFINITION = re.compile(r"^Definition (\w+) : Prop :=\n(.*?)\.$", re.MULTILINE | re.DOTALL)
WRITTEN = dict(DEFINITION.findall(re.sub(r"\n {6,}", " ", (formal.FOLDER / "Statements.v").read_text("utf-8"))))
CONDITIONAL = re.compile(r"^\((.* -> .*)\)$")
CLAIMS = {f"{t.id}__{c.name}": (t, c) for t in all_theorems().values() for c in t.claims if isinstance(c, Claim)}


def near(one, other):
    return abs(one - other) < CLOSE * (1 + abs(other))


def as_code(data):
    """Return a polynomial {"x^2 y": "-3/2"} as the text of a sum."""
    return "+".join(f"mpf('{c}')*{m.replace('^', '**').replace(' ', '*') or '1'}" for m, c in data.items()) or "mpf(0)"


def is_square(code, names):
    """Return whether a polynomial is a square, as of |x| = √x²."""
    symbols = {name: Symbol(name) for name in names}
    coefficient, factors = factor_list(eval(code, symbols | {"mpf": Rational, "cos": cos, "sin": sin}))
    return coefficient > 0 and all(power % 2 == 0 for _, power in factors)


def asked_by_the_kernel(statement, values):
    """Return [(relation, values that say it)] of a case's obligations at a point; None if it is another case's.

    Hypotheses, and relations of numbers alone, are not asked for.
    """
    at = {str(symbol): value for symbol, value in values.items()}
    at |= {"pi": +mpmath.pi, "cos": mpmath.cos, "sin": mpmath.sin, "mpf": mpmath.mpf}
    obligations, hypotheses, radicands, numbers = [], [], {}, {"pi", "mpf"}
    for step in statement["steps"]:
        code, new, kind, relation = as_code(step["of"]), step.get("new"), step["step"], step.get("is")
        value, names = eval(code, at), {*re.findall(r"[A-Za-z]\w*", code)}
        alone = names <= numbers
        numbers |= {new} if alone else set()
        if kind == "assume":
            if (value < -CLOSE and relation != "!=") or (abs(value) > CLOSE and relation == "="):
                return None
            hypotheses.append(value)
        elif kind == "define":
            at[new] = value
        elif kind == "root":
            obligations += [] if alone or is_square(code, names) else [(">=", [value])]
            at[new], radicands[new] = mpmath.sqrt(abs(value)), value
        elif kind == "inverse":
            obligations += [] if alone else [("!=", [value, *(radicands[name] for name in names & radicands.keys())])]
            at[new] = 1 / value
        elif relation in ("=", "!=") and not any(near(abs(g), abs(value)) for g in hypotheses):
            obligations.append((relation, [value, -value]))
    return obligations


def asked_of_coq(theorem, text):
    """Return [(conditions, need or conclusion)] of what a definition asks to be shown; of a negation, of what it gives.

    Both stand one a line, in this order: hypotheses, each with an arrow at its end, and conjuncts.
    """
    lines = text.splitlines()
    hypotheses = [number for number, line in enumerate(lines) if line.endswith((" ->", ",", " in"))]
    asked = [line.removesuffix(" /\\") for line in lines[max(hypotheses, default=-1) + 1 :]]
    if theorem.expected == "refuted":
        asked = [lines[number].removesuffix(" ->") for number in hypotheses]
    parts = [CONDITIONAL.sub(r"\1", line.strip()).split(" -> ") for line in asked]
    return [(conditions, last) for *conditions, last in parts]


def meaning(theorem, claim, text):
    """Return a function of a point: [(relation, value)] of what is asked for there, and of what is shown."""
    _, program = claim.names()
    lines = [(symbol, differentiated(e)) for symbol, e in program.definitions] if program else []
    shown = parts_of(map(differentiated, claim.shows))
    relations = *claim.given, *claim.shows
    expressions = [*relations, *map(differentiated, relations), *(e for line in lines for e in line)]
    show = StatementPrinter(set().union(*(e.free_symbols for e in expressions)))
    bases = {power.base for e in expressions for power in e.atoms(Pow)}
    signs = ("<>", "!="), (">=", ">="), (">", ">")
    meant = {f"{show.doprint(base)} {sign} 0": (relation, base) for base in bases for sign, relation in signs}
    cases = {c for e in expressions for piecewise in e.atoms(Piecewise) for _, c in piecewise.args if c != true}
    is_met = {show.relation(c): (c, True) for c in cases}
    is_met |= {f"~ ({text})": (c, False) for text, (c, _) in is_met.items()}
    needs = [(*meant[last], conditions) for conditions, last in asked_of_coq(theorem, text) if last in meant]

    @cache
    def code(*sides):
        return Code(sides, lines)

    def value(values, *sides):
        try:
            first, *others = code(*sides)(values)
            return first - sum(others)
        except Undefined:
            return mpmath.nan

    def met(text, values):
        condition, holds = is_met[text]
        return Relations([condition], lines)(values) == holds

    def printed(values):
        asked = [(sign, value(values, e)) for sign, e, where in needs if all(met(text, values) for text in where)]
        differences = [value(values, r.lhs, r.rhs) for r in shown]
        return asked + [(relation, difference) for difference in differences for relation in ("=", "!=")]

    return printed


@cache
def certificates(id):
    return parsed(text_of(FOLDER / f"{id}.json"), id)


def left_out(name, text):
    """Return what the kernel asks of a claim at some point, and its printed form does not."""
    theorem, claim = CLAIMS[name]
    printed_at, sampler, missing = meaning(theorem, claim, text), Sampler(claim, "obligations"), []
    (entry,) = (each for each in certificates(theorem.id) if each["claim"] == claim.name)
    fixed = {symbol: Code([value])({})[0] for symbol, value in theorem.refuted_at or ()}
    for case in (e["statement"] for e in entry["statements"] if not is_empty(e["statement"])):
        points = 0
        for _ in range(ATTEMPTS):
            values = sampler.inputs_at_random(fixed)
            asked = None if values is None or sampler.verdict(values) is None else asked_by_the_kernel(case, values)
            if asked is None:
                continue
            printed, points = printed_at(values), points + 1
            missing += [
                relation
                for relation, of in asked
                if not any(r in (relation, ">") and near(v, one) for r, v in printed for one in of)
            ]
            if missing or points == POINTS:
                break
        assert points, f"{name}: no point"
    return missing


def test_the_printed_form_of_a_claim_asks_for_all_that_the_kernel_asks_for():
    with mpmath.workdps(WORKING_DIGITS):
        less = {name: left_out(name, WRITTEN[name]) for name in CLAIMS}
    assert len(less) > 180 and not any(less.values()), less


LESS = [
    ("normalising_is_lipschitz__normalise", "  length_a <> 0 /\\\n", ""),
    ("normalising_is_lipschitz__normalise", "length_a <> 0 /\\", "length_a <> 0 ->"),
    ("normalising_is_lipschitz__normalise", "length_a <> 0", "length_a >= 0"),
    ("normalising_is_lipschitz__normalise", "length_a <> 0", "length_a ^ 2 >= 0"),
    ("image_derivative__lit_shiny", "(specular_base > 0 -> ", "(~ (specular_base > 0) -> "),
    ("image_derivative__lit_shiny", "  (specular_base > 0 -> specular_base <> 0) /\\\n", ""),
    ("seed_step_in_beta__verifies", " >= 0 ->", " >= 1 ->"),  # of a negation, radicands
    ("seed_step_in_beta__verifies", " <> 0 ->", " <> 0 /\\"),  # and divisors
]


@pytest.mark.parametrize("name, was, less", LESS)
def test_a_need_that_is_left_out_is_missed(name, was, less):
    assert was in WRITTEN[name]
    with mpmath.workdps(WORKING_DIGITS):
        assert left_out(name, WRITTEN[name].replace(was, less))
