"""Judges of a theorem: its certificates, samples at 50 digits, false variants, measurements, and its grade."""
