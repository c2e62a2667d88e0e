"""Certificates once: the list of all that checks everything names the cards, which hold them."""

import json
from collections.abc import Iterable

from bs4 import Tag

DATA = {"type": "application/json"}


def share_certificates(articles: Iterable[Tag]) -> None:
    """Replace what a list of all certificates repeats of a card by the card's name; the file's script puts it back."""
    articles = list(articles)
    cards = {}
    for article in articles:
        for place in article.select(".checker[data-theorem]"):
            cards[place["data-theorem"]] = json.loads(place.find("script", attrs=DATA).string)["claims"]
    for article in articles:
        for place in article.select(".checker[data-all]"):
            script = place.find("script", attrs=DATA)
            entries = json.loads(script.string)
            short = [e["theorem"] if cards.get(e["theorem"]) == e["claims"] else e for e in entries]
            script.string = json.dumps(short, separators=(",", ":"), ensure_ascii=False).replace("<", r"\u003c")
            script["data-shared"] = ""
