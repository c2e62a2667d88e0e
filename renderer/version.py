"""The version of this package: of the checkout that this file is in, or else of what is installed."""

import tomllib
from importlib import metadata
from pathlib import Path


def _version() -> str:
    settings = Path(__file__).parents[1] / "pyproject.toml"
    if settings.is_file():
        return str(tomllib.loads(settings.read_text(encoding="utf-8"))["project"]["version"])
    return metadata.version("symbolic-rendering")


__version__ = _version()
