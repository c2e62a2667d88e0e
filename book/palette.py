"""Every colour and width of the book, once: plots read them from here, the page from the CSS made of them.

`python -m book.palette` writes `book/static/palette.css`; a test fails when the file is out of date.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path

__all__ = [
    "MODES",
    "PAGE_WIDTH",
    "ROLE",
    "TEXT_WIDTH",
    "contrast",
    "css",
    "dark",
    "light",
    "mode",
    "palette",
    "readable",
]

CSS_FILE = Path(__file__).parent / "static" / "palette.css"
CSS_PIXELS_PER_INCH = 96
TEXT_WIDTH = 640 / CSS_PIXELS_PER_INCH  # inches; the column of prose
PAGE_WIDTH = 928 / CSS_PIXELS_PER_INCH  # inches; the column and the margin beside it

# What a colour means is the same everywhere. Okabe and Ito's set, safe for colour-blind readers.
ROLE = {"numeric": "#D55E00", "symbolic": "#0072B2", "difference": "#CC79A7", "reference": "#009E73"}

MODES = {
    "light": ROLE
    | {"bound": "#000000", "paper": "#fcfbf8", "surface": "#f4f2ec", "ink": "#1d1c1a", "muted": "#66625a",
       "grid": "#e3dfd6", "rule": "#cfcabf"},
    "dark": ROLE
    | {"bound": "#c9c6bf", "paper": "#17181a", "surface": "#202225", "ink": "#e4e1da", "muted": "#a29e95",
       "grid": "#33363a", "rule": "#46494e"},
}  # fmt: skip

_mode: ContextVar[str] = ContextVar("mode", default="light")


def mode() -> str:
    """The mode that is being drawn for: "light" or "dark"."""
    return _mode.get()


def palette() -> dict[str, str]:
    """The colours of the current mode: the four roles, bound, paper, surface, ink, muted, grid, rule."""
    return dict(MODES[_mode.get()])


@contextmanager
def _drawing_for(name: str) -> Iterator[None]:
    token = _mode.set(name)
    try:
        yield
    finally:
        _mode.reset(token)


def light():
    """A context in which `palette()` gives the colours of the white page."""
    return _drawing_for("light")


def dark():
    """A context in which `palette()` gives the colours of the dark page."""
    return _drawing_for("dark")


def readable(colour: str, least: float = 4.5, against: str | None = None) -> str:
    """The colour, moved towards the ink just as far as text of that colour needs to be read on the page."""
    colours = palette()
    paper = against or colours["paper"]
    for step in range(101):
        mixed = _mix(colour, colours["ink"], step / 100)
        if contrast(mixed, paper) >= least:
            return mixed
    return colours["ink"]


def _channels(colour: str) -> list[int]:
    return [int(colour[i : i + 2], 16) for i in (1, 3, 5)]


def _mix(colour: str, other: str, share: float) -> str:
    pairs = zip(_channels(colour), _channels(other), strict=True)
    return "#" + "".join(f"{round(a + (b - a) * share):02x}" for a, b in pairs)


def _luminance(colour: str) -> float:
    """Relative luminance as the Web Content Accessibility Guidelines define it."""
    red, green, blue = (
        c / 12.92 if c <= 0.03928 else ((c + 0.055) / 1.055) ** 2.4
        for c in (value / 255 for value in _channels(colour))
    )
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(one: str, other: str) -> float:
    """The contrast of two colours, from 1 to 21, as the same guidelines define it."""
    brighter, darker = sorted((_luminance(one), _luminance(other)), reverse=True)
    return (brighter + 0.05) / (darker + 0.05)


def _declarations(name: str) -> str:
    with _drawing_for(name):
        colours = palette()
        lines = [f"  --{role}: {value};" for role, value in colours.items()]
        # Text in a role's colour must stay readable on the page and on its slightly darker surfaces.
        lines += [f"  --{role}-text: {readable(colours[role], against=colours['surface'])};" for role in ROLE]
    return "\n".join(lines)


def css() -> str:
    """The palette as CSS custom properties, light and dark; paper is always printed light."""
    widths = f"  --text-width: {TEXT_WIDTH * CSS_PIXELS_PER_INCH:.0f}px;\n" + (
        f"  --page-width: {PAGE_WIDTH * CSS_PIXELS_PER_INCH:.0f}px;"
    )
    widths += f"\n  --paper-light: {MODES['light']['paper']};"
    return (
        "/* Generated from book/palette.py by `python -m book.palette`: edit that file, not this one. */\n"
        f":root {{\n{widths}\n}}\n\n"
        f"html, html[data-theme] {{\n{_declarations('light')}\n}}\n\n"
        f'@media screen {{\nhtml[data-theme="dark"] {{\n{_declarations("dark")}\n}}\n}}\n'
    )


if __name__ == "__main__":
    CSS_FILE.write_text(css(), encoding="utf-8")
    print(f"wrote {CSS_FILE.name}")
