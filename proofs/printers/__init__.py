"""Printers, which are handed programs, claims and names, and import no formula.

`python` is for NumPy and LLVM's traced values, `numbers` for mpmath and balls, `text` and `tex` for readers; `coq`,
`coq_statements` and `coq_float64` are for Coq.
"""
