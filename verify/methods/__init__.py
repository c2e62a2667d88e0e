"""Ways to take the gradient of the height field, side by side: what `python -m verify.work_precision` times."""
