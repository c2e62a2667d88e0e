"""What a cell printed, as it was printed, wherever the kernel's clock happened to cut it into messages.

MyST-NB ends every message's text with a line end when it merges them, so that a line cut in two gains an empty one: two
builds then differ. Here each stream's messages are joined first, and MyST-NB finds nothing left to merge.
"""

from copy import deepcopy

from myst_nb.core import render
from sphinx.application import Sphinx

from book.extension.elements import on

_merge = render.coalesce_streams


def joined(outputs: list) -> list:
    """A cell's outputs with all of a stream's text in its first message; the outputs given stay as they are."""
    found, streams = [], {}
    for output in outputs:
        if output["output_type"] == "stream" and output["name"] in streams:
            streams[output["name"]]["text"] += output["text"]
            continue
        if output["output_type"] == "stream":
            output = streams[output["name"]] = deepcopy(output)
        found.append(output)
    return found


@on("builder-inited")
def join_first(app: Sphinx) -> None:
    """Join before MyST-NB merges."""
    render.coalesce_streams = lambda outputs: _merge(joined(outputs))
