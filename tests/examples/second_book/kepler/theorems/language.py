"""The language of the theorems."""

from proofs.engine.claim import Claim, equation  # noqa: F401
from proofs.engine.theorem import Theorem, variant  # noqa: F401
