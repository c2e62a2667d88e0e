"""What is drawn and how: bodies, lights, the gradient's method, the raster; checked when they are made."""
