"""Checks of proofs, of the printed kernels against 50 digits, of accuracy and stability; measurements of time."""
