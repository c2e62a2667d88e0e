"""Kernels from `proofs/`, which nothing else of the renderer imports, nor SymPy.

Registry: `programs`, of the chapter's kernels; `custom_fields` makes, checks and records those of custom fields.
Printers: `kernels` of the file, `custom_printer` of a custom field's kernels, `float64` for Coq. Reader: `reader`.
"""
