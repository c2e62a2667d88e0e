"""Stability under stress: float64 programs against 50 digits, each with a bound that is computed beside the result.

One idea a file. `measure` runs a program of `proofs/` three times over arrays of inputs: in float64, in balls of 50
digits, and with running error bounds (`running`). What is stressed is in the other files; the tests state the bounds.
"""
