"""What stands in a claim that is printed for Coq: its derivatives are Coq's own, and have to exist."""

import pytest
from sympy import Abs, Derivative, cos, sqrt

from proofs.engine.claim import Claim, equation
from proofs.formulas.symbols import real
from renderer.generate.statements import proposition

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
