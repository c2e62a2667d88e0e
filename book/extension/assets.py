"""The simulator's compiled code, and how cells are executed and kept."""

import os
from functools import partial
from pathlib import Path

import nbclient
from jupyter_cache.executors import utils
from sphinx.application import Sphinx
from sphinx.config import Config

from book import idea_kernels, loupe_module, simulator_module
from book.extension.elements import on

PROGRAMS = {
    "simulator/compiled.js": simulator_module,
    "simulator/compiled_closer.js": loupe_module,
    "ideas/compiled.js": idea_kernels,
}


@on("builder-inited")
def write_simulator(app: Sphinx) -> None:
    """Compile what the simulator and the small interactives run."""
    for name, module in PROGRAMS.items():
        place = Path(app.outdir) / "_static" / name
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(module.source(), encoding="utf-8")


@on("config-inited", priority=100)
def use_execution_cache(app: Sphinx, config: Config) -> None:
    """The build names a cache that changes with the packages; Jupyter's own looks at the cells alone."""
    if cache := os.environ.get("BOOK_EXECUTION_CACHE"):
        config.nb_execution_cache_path = cache


@on("builder-inited")
def join_streams(app: Sphinx) -> None:
    """A cell's printed text is one message; of several, MyST-NB would end each with a line end, wherever it was cut."""
    utils.executenb = partial(nbclient.execute, coalesce_streams=True)
