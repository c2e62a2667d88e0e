"""The committed long runs: their counts and their labels; numbers only."""

from book.drawing.registry import Drawing, committed, figure

SCENES, CERTIFICATES = "verify/results/accepted_scenes.json", "verify/results/tampered_certificates.json"
FORMULAS = "verify/results/edited_formulas.json"


def _run(path, *keys) -> Drawing:
    result = committed(path)
    return Drawing(numbers=result["numbers"] | {key: result["label"][key] for key in keys})


@figure("accepted_scenes", data=[SCENES])
def accepted_scenes() -> Drawing:
    """The committed long run over random accepted scenes: its counts and its label; numbers only."""
    return _run(SCENES, "processor", "python", "date", "commit")


@figure("tampered_certificates", data=[CERTIFICATES])
def tampered_certificates() -> Drawing:
    """The committed run over false changes of every certificate: its counts and its label; numbers only."""
    return _run(CERTIFICATES, "date", "commit")


@figure("edited_formulas", data=[FORMULAS])
def edited_formulas() -> Drawing:
    """The committed run over edits of the formulas: its counts and its label; numbers only."""
    return _run(FORMULAS, "date", "commit")
