"""The counts of committed records of long runs; numbers only."""

from book.drawing.registry import Drawing, figure

LABEL = ("python", "date", "commit")


def _counts(record) -> Drawing:
    return Drawing(numbers=record["numbers"] | {key: record["label"][key] for key in LABEL})


@figure(record="edited_formulas")
def edited_formulas(record: dict) -> Drawing:
    """The committed run over edits of the formulas: its counts and its label; numbers only."""
    return _counts(record)


@figure(record="enclosed_pixels")
def enclosed_pixels(record: dict) -> Drawing:
    """The committed run over pixels with bounds: its counts and its label; numbers only."""
    return _counts(record)
