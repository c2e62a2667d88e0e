"""The records of long runs over scenes and formulas: their counts and their labels; numbers only."""

from book.drawing.registry import Drawing, figure
from verify.records import RECORDS, read

LABEL = ("processor", "python", "date", "commit")


def _counts(name) -> Drawing:
    record = read(name)
    return Drawing(numbers=record["numbers"] | {key: record["label"][key] for key in LABEL})


@figure("accepted_scenes", data=[RECORDS["accepted_scenes"].path])
def accepted_scenes() -> Drawing:
    """The committed long run over random accepted scenes: its counts and its label; numbers only."""
    return _counts("accepted_scenes")


@figure("edited_formulas", data=[RECORDS["edited_formulas"].path])
def edited_formulas() -> Drawing:
    """The committed run over edits of the formulas: its counts and its label; numbers only."""
    return _counts("edited_formulas")


@figure("enclosed_pixels", data=[RECORDS["enclosed_pixels"].path])
def enclosed_pixels() -> Drawing:
    """The committed run over pixels with bounds: its counts and its label; numbers only."""
    return _counts("enclosed_pixels")
