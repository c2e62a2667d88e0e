"""Kernels from `proofs/`, which nothing else of the renderer imports, nor SymPy.

`programs` says which there are, `kernels` prints their file, `float64` has them printed for Coq; `reader` reads the
formula of a custom field, `custom_printer` prints its kernels, `custom_fields` makes, checks and records it.
"""
