"""The committed kernels are what the expressions print to, byte for byte: an edited formula shows here."""

import pytest

from renderer.generate.__main__ import PRINTED


@pytest.mark.parametrize("path", PRINTED, ids=lambda path: path.name)
def test_printed_files_are_what_the_expressions_print_to(path):
    """Fails when a formula, a printer or the file was edited: run `python -m renderer.generate` and read the diff."""
    assert path.read_text(encoding="utf-8") == PRINTED[path]()
