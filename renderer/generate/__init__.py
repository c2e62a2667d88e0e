"""The generator of kernels: one list of kernels, one way to print them, a small printer for each back end.

It alone imports `proofs` and SymPy; drawing a picture imports neither.
"""
