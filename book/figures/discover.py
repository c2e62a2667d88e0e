"""Find the registered figures: import every module of this folder."""

import importlib
import pkgutil
from pathlib import Path

from book.figures.registry import FIGURES, Registered

INFRASTRUCTURE = {"__main__", "data", "discover", "draw", "fresh", "keys", "registry", "save", "trace"}


def all_figures() -> dict[str, Registered]:
    """Every figure by its id, in alphabetical order."""
    for module in pkgutil.iter_modules([str(Path(__file__).parent)]):
        if module.name not in INFRASTRUCTURE:
            importlib.import_module(f"book.figures.{module.name}")
    return dict(sorted(FIGURES.items()))
