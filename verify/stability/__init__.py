"""Stability under stress: float64 programs against 50 digits, each with a bound that is computed beside the result.

Each file has one stress. `verify.evaluate.arrays` runs a program of `proofs/` three times over arrays of
inputs: in float64, in balls of 50 digits, and with bounds. The tests state the bounds.
"""
