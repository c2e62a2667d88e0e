"""Print programs and claims, which are handed in: as Python, as other numbers' code, as Coq. No formula is imported."""
