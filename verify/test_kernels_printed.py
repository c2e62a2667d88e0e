"""The printed files are what the expressions print: an edited formula shows here, and in the diff."""

import pytest

from renderer.generate.__main__ import PRINTED


@pytest.mark.parametrize("path", PRINTED, ids=lambda path: path.name)
def test_printed_files_are_up_to_date(path):
    assert path.read_text("utf-8") == PRINTED[path]()
