"""The laboratory's cells: what is printed in them from `proofs/`, and the notebooks to take home."""

WHOLE = "laboratory"
"""Name of the notebook of all cells; the others are cell1, cell2, …"""
