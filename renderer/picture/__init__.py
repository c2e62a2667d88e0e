"""A picture and its data: drawing, frames, stages, single pixels, the ε-table."""
