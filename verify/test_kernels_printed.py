"""The committed kernels are what the expressions print to, byte for byte: an edited formula shows here."""

from renderer.generate.__main__ import KERNELS
from renderer.generate.kernels import kernels_source


def test_printed_files_are_what_the_expressions_print_to():
    """Fails when a formula, a printer or the file was edited: run `python -m renderer.generate` and read the diff."""
    assert KERNELS.read_text(encoding="utf-8") == kernels_source()
