"""Which measurements there are: those of every module in verify/checkers/measurements that can be imported here."""

import importlib
import inspect
import pkgutil
import re
from collections.abc import Callable
from functools import cache
from pathlib import Path

from verify.checkers.measurement import REGISTERED
from verify.optional import lacking

FOLDER = Path(__file__).parent / "measurements"


@cache
def _left_out():
    """Import every module of measurements; return {id: the library it needs} of those that cannot be imported."""
    needs = {}
    for module in sorted(m.name for m in pkgutil.iter_modules([str(FOLDER)])):
        try:
            importlib.import_module(f"verify.checkers.measurements.{module}")
        except ImportError as error:
            if not (library := lacking(error)):
                raise
            text = (FOLDER / f"{module}.py").read_text(encoding="utf-8")
            needs |= dict.fromkeys(re.findall(r'@measures\(\s*"(\w+)"', text), library)
    return needs


def measurements(theorem_id: str) -> list[tuple[Callable, dict]]:
    """Return [(function, {text: keyword arguments of a false variant})] that are registered for a theorem."""
    _left_out()
    return list(REGISTERED.get(theorem_id, ()))


def measured_ids() -> set[str]:
    """Return the ids that have a measurement."""
    return REGISTERED.keys() | _left_out()


def library_for(theorem_id: str) -> str | None:
    """Return the library without which a theorem cannot be measured here, or None if it can."""
    return _left_out().get(theorem_id)


def sources_of(theorem_id: str) -> set[Path]:
    """Return the files in which a theorem's measurements are written."""
    return {Path(inspect.getfile(function)).resolve() for function, _ in measurements(theorem_id)}
