"""What a cell needs of the cells before it: the statements that bind the names that it uses, and what those need."""

import ast
import symtable


def statements(code):
    """Return the texts of a source's top-level statements."""
    return [ast.get_source_segment(code, node) for node in ast.parse(code).body]


def bound(statement):
    """Return the names that a top-level statement binds."""
    table = symtable.symtable(statement, "statement", "exec")
    return {symbol.get_name() for symbol in table.get_symbols() if symbol.is_assigned() or symbol.is_imported()}


def used(statement):
    """Return the global names that a top-level statement uses before it binds them, or may use once it is called."""

    def globals_of(table):
        for inner in table.get_children():
            yield from (symbol.get_name() for symbol in inner.get_symbols() if symbol.is_global())
            yield from globals_of(inner)

    (node,) = ast.parse(statement).body
    table = symtable.symtable(statement, "statement", "exec")
    names = {symbol.get_name() for symbol in table.get_symbols() if symbol.is_referenced()} | {*globals_of(table)}
    if isinstance(node, ast.AugAssign):
        return names | bound(statement)
    return names if isinstance(node, (ast.Assign, ast.AnnAssign, ast.Expr)) else names - bound(statement)


def free_names(code):
    """Return the names that a source takes from before it."""
    free, known = set(), set()
    for statement in statements(code):
        free |= used(statement) - known
        known |= bound(statement)
    return free


def needed(code, before):
    """Return those statements of the sources `before`, in their order, that bind what `code` takes from them."""
    wanted, kept = free_names(code), []
    for statement in reversed([s for source in before for s in statements(source)]):
        if bound(statement) & wanted:
            kept.append(statement)
            wanted = (wanted - bound(statement)) | used(statement)
    return kept[::-1]
