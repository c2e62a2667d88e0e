"""The laboratory's cells as notebooks that stand alone: each carries the sources that it uses."""

WHOLE = "laboratory"
"""What the notebook of all cells is called; the others are cell1, cell2, …"""
