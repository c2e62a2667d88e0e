"""Two frontiers, priced: a height field that is a table of samples, and the surface that a bump pretends to be."""
