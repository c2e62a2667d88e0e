"""Releases: the record of each, and the differences from the one before."""
