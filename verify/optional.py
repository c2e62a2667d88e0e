"""Libraries that `pytest verify` uses where they are installed, and elsewhere names as missing."""

try:
    from flint import arb
except ImportError:

    class arb:  # type: ignore[no-redef]
        """The name of a ball's type, where there are no balls."""


LIBRARIES = {"flint": "python-flint"} | {name: name for name in ("hypothesis", "llvmlite", "tqdm")}
"""{module: the distribution that has it}"""


def lacking(error: object) -> str | None:
    """Return the distribution that is not installed, if that is why an import failed, else None."""
    return next((name for module, name in LIBRARIES.items() if f"No module named '{module}" in str(error)), None)
