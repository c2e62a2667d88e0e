"""The laboratory's cells: what is printed in them from `proofs/`, and the notebooks to take home."""

WHOLE = "laboratory"
"""What the notebook of all cells is called; the others are cell1, cell2, …"""
