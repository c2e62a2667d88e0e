"""What became of tampered certificates: the committed long run's counts; numbers only."""

import json
from pathlib import Path

from book.drawing.registry import Drawing, figure

RESULT = "verify/results/tampered_certificates.json"


@figure("tampered_certificates", data=[RESULT])
def tampered_certificates() -> Drawing:
    """The committed run over false changes of every certificate: its counts and its label; numbers only."""
    result = json.loads((Path(__file__).resolve().parents[2] / RESULT).read_text(encoding="utf-8"))
    label = {key: result["label"][key] for key in ("date", "commit")}
    return Drawing(numbers=result["numbers"] | label)
