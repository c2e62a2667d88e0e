"""The description of a picture: bodies, lights, the gradient's method, the raster; checked when they are made."""
