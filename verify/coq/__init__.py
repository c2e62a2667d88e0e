"""Coq: what it is asked of `proofs/formal/`, what a file written by hand may say to it, and what it accepted."""
