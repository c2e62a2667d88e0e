"""Printer for Coq: the text of `proofs/formal/Float64.v`, the operations that our machines carry out."""

from proofs import coq_files


def float64_source() -> str:
    """Return the text of proofs/formal/Float64.v."""
    from renderer import kernels, operations  # not above: kernels may be about to be printed
    from renderer.machines.enclosing import Enclosed

    return coq_files.float64_source(vars(operations), vars(kernels), Enclosed.counted)
