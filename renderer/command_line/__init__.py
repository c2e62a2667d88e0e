"""The commands of `python -m renderer`: image, sweep, views."""
