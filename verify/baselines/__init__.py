"""Renderers to be faster than: the chapter's method as loops in Python, and as NumPy arrays. No kernel of ours is in them."""
