"""What a cell needs of the cells before it: the statements that bind the names that it uses, and what those need."""

import ast
import dis
from types import CodeType


def statements(code):
    """Return the texts of a source's top-level statements."""
    return [ast.get_source_segment(code, node) for node in ast.parse(code).body]


def names(statement):
    """Return (the names that a top-level statement binds, those it uses before that, or may use once it is called)."""
    bound, used, waiting = set(), set(), [compile(statement, "cell", "exec")]
    for code in waiting:  # it grows by the functions inside
        for step in dis.get_instructions(code):
            if step.opname == "STORE_NAME":
                bound.add(step.argval)
            elif step.opname in ("LOAD_NAME", "LOAD_GLOBAL") and step.argval not in bound:
                used.add(step.argval)
        waiting += [inner for inner in code.co_consts if isinstance(inner, CodeType)]
    return bound, used


def needed(code, before):
    """Return those statements of the sources `before`, in their order, that bind what `code` takes from them."""
    wanted, known = set(), set()
    for bound, used in map(names, statements(code)):
        wanted |= used - known
        known |= bound
    kept = []
    for statement in reversed([s for source in before for s in statements(source)]):
        bound, used = names(statement)
        if bound & wanted:
            kept.append(statement)
            wanted = (wanted - bound) | used
    return kept[::-1]
