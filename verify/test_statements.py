"""What stands in a claim that is printed for Coq: its derivatives are Coq's own, and have to exist."""

import re

import pytest
from sympy import Abs, Derivative, cos, sqrt

from proofs.engine.claim import Claim, equation
from proofs.engine.theorem import all_theorems
from proofs.formulas.enclosed import RULES
from proofs.formulas.symbols import real
from renderer.generate.rules import rule
from renderer.generate.statements import proposition, rounded_proposition
from renderer.machines.enclosing import Enclosed
from verify.formal import FOLDER

x, y = real("x y")
PRINTED = {
    Derivative(Abs(x), x): ["ex_derive (fun x : R => Rabs x) x", "(Derive (fun x : R => Rabs x) x) = 1"],
    Derivative(cos(x), (x, 2)): ["ex_derive_n (fun x : R => cos x) 2 x", "(Derive_n (fun x : R => cos x) 2 x) = 1"],
    Derivative(cos(y), x): ["ex_derive (fun x : R => cos y) x", "(Derive (fun x : R => cos y) x) = 1"],
    Derivative(sqrt(x), x): [
        "x >= 0",
        "x > 0",
        "ex_derive (fun x : R => sqrt x) x",
        "(Derive (fun x : R => sqrt x) x) = 1",
    ],
}  # at 0 Coq's Derive of |x| is a number too, and beyond 0 its root is one


@pytest.mark.parametrize("derivative", PRINTED, ids=str)
def test_a_derivative_is_coqs_and_has_to_exist(derivative):
    symbols = " ".join(sorted(symbol.name for symbol in derivative.atoms() & {x, y}))
    conjuncts = " /\\\n  ".join(PRINTED[derivative])
    assert proposition(Claim("one", (equation(derivative, 1),))) == f"forall {symbols} : R,\n  {conjuncts}"


def test_a_derivative_by_several_symbols_has_no_proposition():
    with pytest.raises(ValueError, match="several symbols"):
        proposition(Claim("one", (equation(Derivative(x * y, x, y), 1),)))


def test_a_rounded_claim_is_about_its_own_program_inputs_and_bound():
    """Another bound, a hypothesis left out and another program are other statements, so that no proof fits them all."""
    claims = {claim.name: claim for claim in all_theorems()["gradient_accuracy"].rounded}
    sine, rings = claims["sine"], claims["rings"]
    printed = rounded_proposition(rings)
    assert printed.startswith("forall v k_v : R,\n  float64 v ->\n  float64 k_v ->")  # u is not an input of it
    assert "Rabs (gradient_rings_float64.h_v v k_v - gradient_rings.h_v v k_v) <= " in printed
    near = tuple((output, bound / 2) for output, bound in sine.bounds)
    changed = [sine.but(bounds=near), sine.but(given=sine.given[1:]), sine.but(program=claims["ridges"].program)]
    assert len({rounded_proposition(claim) for claim in (sine, *changed)}) == 4


def test_a_rule_is_printed_as_the_machine_carries_it_out(monkeypatch):
    """A machine that leaves a product's own rounding out prints another rule, of which no proof holds."""
    product = RULES["enclosed_product"]
    before = rule(product)
    monkeypatch.setattr(Enclosed, "lost_in_product", lambda self, other, product: (0.0, False))
    assert rule(product)[:2] == before[:2]
    assert rule(product)[2] != before[2]


def test_the_roundings_that_steps_name_are_those_of_the_proof():
    proof = (FOLDER / "RoundedGradient.v").read_text(encoding="utf-8")
    words = " ".join(step.what for step in all_theorems()["gradient_accuracy"].steps)
    named = re.findall(r"(\d+)\.(\d+)\\mu", words)
    assert len(named) == 2
    for whole, digits in named:
        assert f" <= {int(whole + digits)}/{10 ** len(digits)} / 2 ^ 53" in proof
