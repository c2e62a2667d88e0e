"""What a page carries: its sections' own ids."""

from docutils import nodes


def put_explicit_ids_first(app, document) -> None:
    """`(s1)=` before a heading gives `<section id="s1">`; Sphinx alone gives the section its title's id."""
    explicit = {document.nameids.get(name) for name, is_explicit in document.nametypes.items() if is_explicit}
    for number, section in enumerate(document.findall(nodes.section)):
        section["ids"].sort(key=lambda id: id not in explicit)
        if section["ids"] == ["proof-content"]:  # sphinx-proof gives every theorem's body this one id
            section["ids"] = [f"proof-content-{number}"]


def setup(app) -> None:
    """Connect to Sphinx, before contents are collected."""
    app.connect("doctree-read", put_explicit_ids_first, priority=100)
