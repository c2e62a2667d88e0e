"""What the printed files do not show of themselves: a derivative at a root's edge, and words about a proof."""

import re

import pytest
from sympy import Derivative, sqrt

from proofs.engine.claim import Claim, equation
from proofs.engine.theorem import all_theorems
from proofs.formulas.symbols import real
from renderer.generate.statements import proposition
from verify.formal import FOLDER

x, y = real("x y")
OF_ROOT = """forall x : R,
  x >= 0 /\\
  x > 0 /\\
  ex_derive (fun x : R => sqrt x) x /\\
  (Derive (fun x : R => sqrt x) x) = 1"""


def test_a_derivative_has_to_exist():
    """Beyond 0 Coq's root is a number, and so is its Derive."""
    assert proposition(Claim("one", (equation(Derivative(sqrt(x), x), 1),))) == OF_ROOT
    with pytest.raises(ValueError, match="several symbols"):
        proposition(Claim("one", (equation(Derivative(x * y, x, y), 1),)))


def test_the_roundings_that_steps_name_are_those_of_the_proof():
    proof = (FOLDER / "RoundedGradient.v").read_text(encoding="utf-8")
    words = " ".join(step.what for step in all_theorems()["gradient_accuracy"].steps)
    named = re.findall(r"(\d+)\.(\d+)\\mu", words)
    assert len(named) == 2
    assert all(f" <= {int(whole + digits)}/{10 ** len(digits)} / 2 ^ 53" in proof for whole, digits in named)
