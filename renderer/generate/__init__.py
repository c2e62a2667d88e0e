"""Prints the kernels from `proofs/`. It alone imports `proofs` and SymPy; drawing a picture imports neither."""
