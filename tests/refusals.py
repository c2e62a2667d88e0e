"""Refusals of the renderer: always a ValueError of one line."""

import pytest


def rejection(make, *arguments, **fields):
    """Return the one line of the exception; it has the shape NAME = VALUE is not allowed: WHAT IS."""
    with pytest.raises(ValueError) as error:
        make(*arguments, **fields)
    text = str(error.value)
    assert "\n" not in text
    assert " is not allowed: " in text
    return text
