"""Certificates that no checker may accept, and some that every checker has to: a run begins with them."""

from collections.abc import Callable, Iterable, Mapping
from typing import Any


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
BY_CASES = {"rule": "cases", "on": X, "branches": {">": NOTHING}}
UNSOUND: list[tuple[list, dict, str]] = [
    ([show(X, "=")], NOTHING, "the two sides differ"),
    ([show({}, ">")], NOTHING, "equations only"),
    ([show({"x^2": "-1"}, ">=")], NEGATIVE, "negative weight"),
    ([show(X, ">=")], EMPTY, "the two sides differ"),
    ([show(X, ">=")], BY_CASES, "no rule"),
    ([show(X, "=")], {"rule": "trust me"}, "no rule"),
    ([("inverse", X, {"new": "r"}), show({"r x": "1", "": "-1"}, "=")], NOTHING, "equations only"),
    ([("root", X, {"new": "w"})], NOTHING, "equations only"),
    ([("define", ONE, {"new": "x"}), show({"x": "1", "": "-1"}, "=")], NOTHING, "twice"),
    ([show({"z": "1"}, "=")], NOTHING, "z stands for nothing"),
    ([show({"x": "1.5"}, "=")], NOTHING, "not a fraction"),
    ([show({"x^-1": "0"}, "=")], NOTHING, "exponent"),
    ([show([], "=")], NOTHING, "a polynomial is missing"),
    ([assume(X, "<>"), show({}, "=")], NOTHING, "no relation"),
    ([assume(X, "toString"), show({}, "=")], NOTHING, "no relation"),
    ([assume(X, ">"), show(X, "=")], BY_FIRST_FACT, "not ="),
    ([show(X, "=")], {"rule": "ideal", "cofactors": [[-1, ONE]]}, "no fact -1"),
    ([show(X, "=")], BY_FIRST_FACT, "no fact 0"),
    ([("conjure", {}, {"new": "w"})], NOTHING, "no step"),
]  # fmt: skip
"""[(steps, the proof of each, what the page's kernel says of it)]"""


STATEMENT, CERTIFICATE = GOOD = [derivation(show({"x^2": "1"}, ">=")), {"proofs": [SQUARES]}]


def inverse(new: object) -> list:
    """Return the attack that took "" for a name of its own: an inverse of 1 called `new`, then 1 = 0."""
    named = {} if new is None else {"new": new}
    proofs = [EMPTY, BY_FIRST_FACT]
    return [derivation(("inverse", {"": "2"}, named), show(ONE, "=")), {"proofs": proofs}]


def refuted(point: dict, *steps: tuple, variables: Iterable[str] | None = None) -> list:
    """Return the counterexample at a point, whose names are the variables if none are given, to what steps show."""
    return [derivation(*steps, variables=point if variables is None else variables) | {"kind": "refutation"},
            {"point": point}]  # fmt: skip


def refutation(of: dict, point: dict, variables: Iterable[str] | None = None) -> list:
    """Return that to of > 0."""
    return refuted(point, show(of, ">"), variables=variables)


def above(point: dict) -> list:
    """Return that to x ≥ 1 where x > 0."""
    return refuted(point, assume(X, ">"), show({"x": "1", "": "-1"}, ">="), variables=["x"])


def zero(relation: str) -> list:
    """Return that to a relation of 0 to 0, which leaves no name open."""
    return refuted({}, ("define", {}, {"new": "y"}), show({"y": "1"}, relation))


LINES = {"version": 1, "kind": "separation", "lines": [["b", ["a"]], ["c", ["b"]]], "outputs": ["c"], "avoid": ["a"]}
EMPTY_INDUCTION: dict[str, Any] = {key: [] for key in ("variables", "state", "assume", "show")}
EMPTY_INDUCTION |= {"version": 1, "kind": "induction", "start": {}, "next": {}}
COUNT = EMPTY_INDUCTION | {"state": ["x"], "start": {"x": {}}, "next": {"x": {"x": "1", "": "1"}}, "show": [X]}
BY_ITSELF = {"base": [NOTHING], "step": [BY_FIRST_FACT]}
WELL_FORMED: list[list] = [
    GOOD,
    [COUNT | {"next": {"x": X}}, BY_ITSELF],
    [LINES | {"avoid": ["d"]}, {"reached": ["a", "b", "c"]}],
    above({"x": "1/2"}),
    zero(">"),
    [EMPTY_INDUCTION | {"show": [{}]}, {"base": [NOTHING], "step": [NOTHING]}],
]
nested: list = []
for _ in range(900):
    nested = [nested]


def huge(power: int) -> list:
    """Return powers of powers of a sum, which nobody waits for."""
    steps = [("define", {"x": "1", "y": "1", "": "9" * 500}, {"new": "a0"})]
    steps += [("define", {f"a{i}^{power}": "1", "x": "1"}, {"new": f"a{i + 1}"}) for i in range(5)]
    return pair_of([*steps, show({"a5": "1"}, "=")], NOTHING)


BROKEN = {
    **{f"inverse {new!r}": inverse(new) for new in ("", None, "x y", "x", 1, "__proto__", "pi^2")},
    "x > 0, as x ≥ 0": pair_of([assume(X, ">="), show(X, ">")], SQUARES | {"sum": [["1", ONE, [1]]]}),
    "an assumption refuted": refuted({"x": "1"}, show(X, ">"), assume(X, "=")),
    "no show": [derivation(assume(X, ">")), {"proofs": []}],
    "no steps": [derivation(), {"proofs": []}],
    "a proof left over": [STATEMENT, {"proofs": [SQUARES, NOTHING]}],
    "a proof too few": [STATEMENT, {"proofs": []}],
    "an unknown key": [STATEMENT | {"trust": "me"}, CERTIFICATE],
    "an unknown key of a step": [derivation(("show", {"x^2": "1"}, {"is": ">=", "new": "w"})), CERTIFICATE],
    "an unknown key of a certificate": [STATEMENT, CERTIFICATE | {"strengthen": []}],
    "an unknown key of a proof": [STATEMENT, {"proofs": [SQUARES | {"on": {}}]}],
    "version 1.5": [STATEMENT | {"version": 1.5}, CERTIFICATE],
    "version true": [STATEMENT | {"version": True}, CERTIFICATE],
    "a list for a text": [STATEMENT | {"kind": ["derivation"]}, CERTIFICATE],
    **{
        f"the coefficient {c!r}": [derivation(show({"x^2": c}, ">=")), CERTIFICATE]
        for c in ("1e0", "1e999999999", "0.5", 1, 1.5, "+1", "01", "2/2", "1/-2", "1/0", "", None, "0", "1 ", "１")
    },
    **{
        f"the monomial {m!r}": [derivation(show({m: "1", "x^2": "1"}, ">=")), CERTIFICATE]
        for m in ("x x", "x^1000", "x^1", "x^-1", "x^0", "x^02", " x", "x ", "x  y", "x^2^2", "x\t", "^2", "z")
    },
    **{
        f"the index {i!r}": [STATEMENT, {"proofs": [SQUARES | {"positive": [i]}]}]
        for i in (-1, 1, "0", 0.5, None, True, 2**53 + 1)
    },
    "a variable twice": [STATEMENT | {"variables": ["x", "x"]}, CERTIFICATE],
    "an empty induction": [EMPTY_INDUCTION, {"base": [], "step": []}],
    "an empty separation": [
        {"version": 1, "kind": "separation", "lines": [], "outputs": [], "avoid": []},
        {"reached": []},
    ],
    "pi as a coordinate": refutation({"pi": "1", "": "-4"}, {"pi": "31/10"}),
    "off the circle": refutation({"cos(x)": "1", "": "-1"}, {"cos(x)": "0", "sin(x)": "0"}),
    "a cosine alone": refutation({"cos(x)": "1", "": "-1"}, {"cos(x)": "0"}),
    "x = n by induction": [COUNT, BY_ITSELF],
    **{
        f"an induction with {base} and {step} proofs of a claim": [
            COUNT | {"next": {"x": X}},
            {"base": [NOTHING] * base, "step": [BY_FIRST_FACT] * step},
        ]
        for base, step in ((0, 0), (1, 0), (0, 1), (2, 2))
    },
    "its claim assumed": [COUNT | {"assume": [{"of": X, "is": "="}]}, BY_ITSELF],
    "a set that is not closed": [LINES, {"reached": ["b", "c"]}],
    "a name to avoid": [LINES, {"reached": ["a", "b", "c"]}],
    **{f"no counterexample at x = {x}": above({"x": x}) for x in ("-1", "1")},
    "no point": above({}),
    "0 ≥ 0 refuted": zero(">="),
    **{f"powers of powers, {power}": huge(power) for power in (998, 999)},
    "a large power at a point": refutation({"x^999": "1"}, {"x": "9" * 500}),
    "an induction over large powers": [
        COUNT | {"next": {"x": {"x^999": "1", "": "1"}}, "show": [{"x^999": "1"}]},
        BY_ITSELF,
    ],
    "nested lists": pair_of([show({"x": nested}, "=")], NOTHING),
    "a name too many": refutation(X, {"x": "0", "y": "0"}, variables=("x",)),
}


def wrong_verdicts(checkers: Mapping[str, Callable]) -> list[str]:
    """Return what is wrong with checkers, {name: a function of a statement and a certificate}: none, if all is well."""
    bad: list[tuple[str, Any]] = [*BROKEN.items(), *((why, pair_of(s, proof)) for s, proof, why in UNSOUND)]
    wrong = [f"{name} accepts {why}" for name, check in checkers.items() for why, pair in bad if check(*pair) is None]
    return wrong + [f"{n} refuses {pair}" for n, check in checkers.items() for pair in WELL_FORMED if check(*pair)]
