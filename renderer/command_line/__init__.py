"""The commands of `python -m renderer`: image, views, sweep, doctor."""
