"""The filters of the page of all claims: radio buttons, and the classes that the style sheet goes by."""

from collections import Counter

from docutils import nodes

from book.extension.elements import Html
from book.extension.ledger_evidence import TITLES
from book.ledger.entries import Claim


def classes(claim: Claim) -> list[str]:
    """What the filters go by."""
    origin = "of-seed" if claim.of_seed else "of-book"
    return ["claim", f"is-{TITLES[claim.verdict]}", origin, *(["with-code"] if claim.findings else [])]


def filters(claims: list[Claim]) -> Html:
    """Two rows of radio buttons; the style sheet does the rest."""
    counts = Counter(TITLES[claim.verdict] for claim in claims)
    verdicts = [("all", f"all {len(claims)}")]
    verdicts += [(slug, f"{counts[slug]} {verdict.partition(':')[0]}") for verdict, slug in TITLES.items()]
    seed = sum(claim.of_seed for claim in claims)
    coded = sum(bool(claim.findings) for claim in claims)
    origins = [
        ("everybody", "everybody's"),
        ("seed", f"{seed} of the seed"),
        ("book", f"{len(claims) - seed} of this book"),
        ("code", f"{coded} with a code, F1 to F22"),
    ]
    rows = [choices("verdict", "Verdict:", verdicts), choices("origin", "Whose:", origins)]
    return Html("div", *rows, classes=["ledger-filters"])


def choices(name: str, legend: str, options: list[tuple[str, str]]) -> Html:
    """One row of radio buttons; the first is chosen."""
    parts = [Html("legend", nodes.Text(legend))]
    for number, (slug, text) in enumerate(options):
        checked = {"checked": None} if number == 0 else {}
        box = Html("input", type="radio", name=name, id=f"only-{slug}", **checked)
        parts.append(Html("label", box, nodes.Text(f" {text}"), for_=f"only-{slug}"))
    return Html("fieldset", *parts, classes=["grade-filter"])
