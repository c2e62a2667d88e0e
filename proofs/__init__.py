"""The formulas of the chapter, each written once in SymPy with exact rationals, and the theorems about them."""
