"""The shader, written once, and the numbers and gradients that it is given."""
