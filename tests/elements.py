"""A document's elements, as its source has them."""

from html.parser import HTMLParser


class Elements(HTMLParser):
    """Every element of a document: its tag and its attributes."""

    def __init__(self, text: str):
        super().__init__()
        self.all = []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.all.append((tag, dict(attributes)))
