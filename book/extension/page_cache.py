"""What Sphinx needs told after an edit of a page's prose, so that the site has the bytes of one built whole."""

import hashlib
import pickle
from pathlib import Path

from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment

from book.extension.elements import on


@on("env-get-outdated")
def edited_pages(
    app: Sphinx, environment: BuildEnvironment, added: set[str], changed: set[str], removed: set[str]
) -> list[str]:
    """The pages that are not as they were read; Sphinx itself looks at their times."""
    paths = {name: Path(environment.doc2path(name)) for name in environment.found_docs}
    now = {name: hashlib.sha256(path.read_bytes()).digest() for name, path in paths.items()}
    before, environment.chapter_pages = getattr(environment, "chapter_pages", {}), now
    return [name for name in now if name not in added and now[name] != before.get(name)]


@on("builder-inited")
def complete_search(app: Sphinx) -> None:
    """Before the search's index is written, give it what Sphinx forgets of the pages that it has not written."""
    written = getattr(app.builder, "dump_search_index", None)  # the HTML builders' alone

    def complete() -> None:
        index, path = app.builder.indexer, Path(app.doctreedir) / "index_entries.pickle"
        kept = pickle.loads(path.read_bytes()) if path.is_file() else {}
        index._index_entries = dict(sorted((kept | index._index_entries).items()))
        path.write_bytes(pickle.dumps(index._index_entries))
        for words in (index._mapping, index._title_mapping):
            for word in [word for word, pages in words.items() if not pages]:
                del words[word]
        written()

    if written:
        app.builder.dump_search_index = complete
