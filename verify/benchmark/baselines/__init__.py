"""Renderers to compare with: the chapter's method as loops in Python, and as NumPy arrays. None uses our kernels."""
