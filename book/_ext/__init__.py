"""Sphinx extensions that only this book uses."""
