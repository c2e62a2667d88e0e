"""Certificates that no checker may accept, and some that every checker has to: a run begins with them."""

import json
from collections.abc import Callable, Iterable, Sequence
from itertools import pairwise
from typing import Any

from proofs.engine import kernel
from verify.checkers.second_checker import compact


def derivation(*steps: tuple, variables: Iterable[str] = ("x", "y")) -> dict:
    """Return a derivation of the given steps: (kind, of, further keys)."""
    listed = [{"step": kind, "of": of, **more} for kind, of, more in steps]
    return {"version": 1, "kind": "derivation", "variables": list(variables), "steps": listed}


def show(of: object, relation: str, step: str = "show") -> tuple:
    """Return the step that shows, or assumes, a relation."""
    return (step, of, {"is": relation})


def assume(of: object, relation: str) -> tuple:
    """Return the step that assumes a relation."""
    return show(of, relation, "assume")


def pair_of(steps: Iterable[tuple], proof: dict) -> list:
    """Return the derivation of some steps, and a certificate that has the proof for each that needs one."""
    return [derivation(*steps), {"proofs": [proof for step in steps if step[0] in ("show", "root", "inverse")]}]


ONE, X = {"": "1"}, {"x": "1"}
BY_FIRST_FACT = {"rule": "ideal", "cofactors": [[0, ONE]]}
NOTHING = {"rule": "ideal", "cofactors": []}
EMPTY = {"rule": "contradiction", "positive": [], "sum": [], "cofactors": []}
SQUARES = EMPTY | {"positive": [0], "sum": [["1", X, []]]}
NEGATIVE = SQUARES | {"sum": [["-1", X, []]]}
UNSOUND: list[tuple[list, dict]] = [
    ([show(X, "=")], NOTHING),  # the two sides differ
    ([show({}, ">")], NOTHING),  # equations only
    ([show({"x^2": "-1"}, ">=")], NEGATIVE),  # negative weight
    ([show(X, ">=")], EMPTY),  # the two sides differ
    ([show(X, "=")], {"rule": "trust me"}),  # no rule
    ([("inverse", X, {"new": "r"}), show({"r x": "1", "": "-1"}, "=")], NOTHING),  # equations only
    ([("root", X, {"new": "w"})], NOTHING),  # equations only
    ([("define", ONE, {"new": "x"}), show({"x": "1", "": "-1"}, "=")], NOTHING),  # twice
    ([show([], "=")], NOTHING),  # a polynomial is missing
    ([assume(X, "toString"), show({}, "=")], NOTHING),  # no relation
    ([assume(X, ">"), show(X, "=")], BY_FIRST_FACT),  # not =
    ([show(X, "=")], BY_FIRST_FACT),  # no fact 0
    ([("conjure", {}, {"new": "w"})], NOTHING),  # no step
]
"""[(steps, the proof of each)]"""


STATEMENT, CERTIFICATE = GOOD = [derivation(show({"x^2": "1"}, ">=")), {"proofs": [SQUARES]}]


def refuted(point: dict, *steps: tuple, variables: Iterable[str] = ()) -> list:
    """Return the counterexample at a point, whose names are the variables if none are given, to what steps show."""
    return [derivation(*steps, variables=variables or point) | {"kind": "refutation"}, {"point": point}]


def proved(claim: dict) -> list:
    """Return a derivation of p ≥ 0 by the certificate of x² ≥ 0."""
    return [derivation(show(claim, ">=")), CERTIFICATE]


def product(off: int) -> list:
    """Return a claim of a product of fractions of a hundred digits: true if it is off by 0 units, else false."""
    of, proof = {"x": f"{3**200}/{2**100}", "": "1/3"}, {"rule": "ideal", "cofactors": [[0, {"x": "7/11"}]]}
    return pair_of([assume(of, "="), show({"x^2": f"{7 * 3**200 + off}/{11 * 2**100}", "x": "7/33"}, "=")], proof)


def huge() -> list:
    """Return powers of powers of a sum, which would take years to write out."""
    steps = [("define", {f"{of}^999": "1", "y": "1"}, {"new": new}) for of, new in pairwise("xabcde")]
    return pair_of([*steps, show({"e": "1"}, "=")], NOTHING)


ABOVE = assume(X, ">"), show({"x": "1", "": "-1"}, ">=")
LINES = {"version": 1, "kind": "separation", "lines": [["b", ["a"]], ["c", ["b"]]], "outputs": ["c"], "avoid": ["a"]}
EMPTY_INDUCTION: dict[str, Any] = {key: [] for key in ("variables", "state", "assume", "show")}
EMPTY_INDUCTION |= {"version": 1, "kind": "induction", "start": {}, "next": {}}
COUNT = EMPTY_INDUCTION | {"state": ["x"], "start": {"x": {}}, "next": {"x": {"x": "1", "": "1"}}, "show": [X]}
BY_ITSELF = {"base": [NOTHING], "step": [BY_FIRST_FACT]}
of = {"cos(constructor)": "1"}  # which every object of JavaScript has
WELL_FORMED: list[list] = [
    GOOD,
    product(off=0),
    [derivation(assume(of, "="), show(of, "="), variables=of), {"proofs": [BY_FIRST_FACT]}],
]
nested: list = []
for _ in range(900):
    nested = [nested]
WRONG: list[dict] = [
    *({"version": version} for version in (1.5, True, 2)),
    *({"kind": kind} for kind in (["derivation"], "constructor")),
    {"trust": "me"},
    {"variables": ["x", "x"]},
]
BROKEN: list[list] = [
    *(  # an inverse of 1 that is called "", then 1 = 0
        [derivation(("inverse", {"": "2"}, new), show(ONE, "=")), {"proofs": [EMPTY, BY_FIRST_FACT]}]
        for new in ({}, *({"new": new} for new in ("", "x y", "x", 1, "__proto__")))
    ),
    pair_of([assume(X, ">="), show(X, ">")], SQUARES | {"sum": [["1", ONE, [1]]]}),
    refuted({"x": "1"}, show(X, ">"), assume(X, "=")),
    [derivation(assume(X, ">")), {"proofs": []}],
    *([STATEMENT, {"proofs": proofs}] for proofs in ([SQUARES, NOTHING], [])),
    *([STATEMENT | wrong, CERTIFICATE] for wrong in WRONG),
    [derivation(("show", {"x^2": "1"}, {"is": ">=", "new": "w"})), CERTIFICATE],
    [STATEMENT, CERTIFICATE | {"strengthen": []}],
    [STATEMENT, {"proofs": [SQUARES | {"on": {}}]}],
    *(proved({"x^2": c}) for c in ("0.5", 1, 2**53 + 1, "+1", "01", "2/2", "1/0", "", "0", "1 ", "１")),
    *(proved({m: "1", "x^2": "1"}) for m in ("x x", "x^1000", "x^1", "x^02", " x", "x\t", "^2", "z")),
    *([STATEMENT, {"proofs": [SQUARES | {"positive": [i]}]}] for i in (-1, 1, "0", True)),
    [EMPTY_INDUCTION, {"base": [], "step": []}],
    [LINES | {"lines": [], "outputs": [], "avoid": []}, {"reached": []}],
    refuted({"pi": "31/10"}, show({"pi": "1", "": "-4"}, ">")),
    *(refuted({"cos(x)": "0", **more}, show({"cos(x)": "1", "": "-1"}, ">")) for more in ({}, {"sin(x)": "0"})),
    [COUNT, BY_ITSELF],
    *(
        [COUNT | {"next": {"x": X}}, {"base": [NOTHING] * n, "step": [BY_FIRST_FACT] * m}]
        for n, m in ((1, 0), (0, 1), (2, 2))
    ),
    [COUNT | {"assume": [{"of": X, "is": "="}]}, BY_ITSELF],
    *([LINES, {"reached": reached}] for reached in (["b", "c"], ["a", "b", "c"])),
    *(refuted(point, *ABOVE, variables=["x"]) for point in ({"x": "-1"}, {"x": "1"}, {}, {"x": "1/2", "y": "0"})),
    huge(),
    refuted({"x": "9" * 500}, show({"x^999": "1"}, ">")),
    pair_of([show({"x": nested}, "=")], NOTHING),
    product(off=2),
]
REWRITTEN = ('"x^2":"1"', '"x^2":"-1","x^2":"1"'), ('"x^2"', '"\\u0078^2"'), ('"version":1', '"version":1.0')


def reasons_of(texts: Sequence[str], check: Callable = kernel.check) -> list[str]:
    """Return why the kernel refuses each text "[statement,certificate]", "" where it accepts."""

    def reason(text):
        try:
            pair = json.loads(text)
            return "" if compact(pair) == text and check(*pair) is None else "refused"
        except (ValueError, RecursionError) as why:
            return str(why)

    return [reason(text) for text in texts]


def wrong_verdicts(reasons_of: Callable[[Sequence[str]], list[str]]) -> list[str]:
    """Return the texts of which a checker's verdict is wrong; reasons_of(texts) gives its verdicts."""
    good, bad = map(compact, WELL_FORMED), [*map(compact, [*BROKEN, *(pair_of(*each) for each in UNSOUND)])]
    bad += ["[" * 10**5 + "]" * 10**5, *(compact(GOOD).replace(*was) for was in REWRITTEN)]
    texts = [*good, *bad]
    refused = [bool(reason) for reason in reasons_of(texts)]
    return [text for number, text in enumerate(texts) if refused[number] != (number >= len(WELL_FORMED))]
