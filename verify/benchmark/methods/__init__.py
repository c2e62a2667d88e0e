"""Ways to take the gradient of the height field, side by side: what `python -m verify.benchmark.work_precision`
times."""
