"""Accuracy of the float64 programs: certified bounds, exact errors against 50 digits, and their sources."""
