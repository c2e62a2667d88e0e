"""What is true: every formula of the chapter, written once, as SymPy expressions with exact rationals."""
