"""The version of this package: of the checkout that this file is in, or else of the installed package."""

import tomllib
from importlib import metadata
from pathlib import Path

_settings = Path(__file__).parents[1] / "pyproject.toml"
__version__: str
if _settings.is_file():
    __version__ = tomllib.loads(_settings.read_text(encoding="utf-8"))["project"]["version"]
else:
    __version__ = metadata.version("symbolic-rendering")
