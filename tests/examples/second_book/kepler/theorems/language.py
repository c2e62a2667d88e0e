"""What the theorems are written in."""

from proofs.engine.claim import Claim, equation  # noqa: F401
from proofs.engine.theorem import Theorem, variant  # noqa: F401
