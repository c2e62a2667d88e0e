"""A picture and what is known of it: drawing, frames, stages, single pixels, the ε-table."""
