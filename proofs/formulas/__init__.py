"""The formulas of the picture, as straight-line programs."""
