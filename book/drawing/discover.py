"""Find the registered figures: import every module of book/figures."""

import importlib
import pkgutil
from pathlib import Path

from book.drawing.registry import FIGURES, Registered

FOLDER = Path(__file__).parent.parent / "figures"


def all_figures() -> dict[str, Registered]:
    """Every figure by its id, in alphabetical order."""
    for module in pkgutil.iter_modules([str(FOLDER)]):
        importlib.import_module(f"book.figures.{module.name}")
    return dict(sorted(FIGURES.items()))
