"""Formulas of custom fields as text: a reader and its inverse."""

from functools import partial

from proofs.formulas.symbols import k_u, k_v, u, v
from proofs.printers import text

OF_FIELDS = {symbol.name: symbol for symbol in (u, v, k_u, k_v)}
parse_expression = partial(text.parse_expression, names=OF_FIELDS)
expression_text = partial(text.expression_text, names=OF_FIELDS)
