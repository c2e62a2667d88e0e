"""Files that pages load, as text that stands in the document: pictures, style sheets, scripts, files."""

import base64
import gzip
import io
import re
from functools import cache
from pathlib import Path

from PIL import Image

EMBEDDED = re.compile(r"data:image/png;base64,([A-Za-z0-9+/=\s]+)")
COORDINATES = re.compile(r'(?<= d=")[^"]+|(?<= [xy]=")[^"]+')
FRACTION = re.compile(r"-?\d+\.\d{3,}")
TYPES = {".woff": "font/woff", ".svg": "image/svg+xml"}


def base64_address(kind: str, content: bytes) -> str:
    return f"data:{kind};base64,{base64.b64encode(content).decode()}"


def data_address(path: Path) -> str:
    content, suffix = path.read_bytes(), path.suffix
    if suffix == ".png":
        return base64_address("image/webp", as_webp(content))
    return base64_address(TYPES[suffix], content)


@cache
def as_webp(png: bytes) -> bytes:
    """Return the same pixels as WebP, without loss; those of no colour at all too."""
    out = io.BytesIO()
    Image.open(io.BytesIO(png)).save(out, "WEBP", lossless=True, exact=True, method=6)
    return out.getvalue()


def base64_gzip(content: bytes) -> str:
    """Return bytes compressed, as text; the same every time."""
    return base64.b64encode(gzip.compress(content, 9, mtime=0)).decode()


def packed_address(content: bytes) -> str:
    return f"data:application/gzip;base64,{base64_gzip(content)}"


def svg_parts(path: Path) -> list[str]:
    """Return a drawing as it stands in a data: address with single quotes, cut before each of its tags."""
    text = re.sub(r"<!--.*?-->|<metadata>.*?</metadata>", "", path.read_text(encoding="utf-8"), flags=re.DOTALL)
    text = re.sub(r"\s*\n\s*", " ", text).replace("> <", "><").strip()
    text = EMBEDDED.sub(lambda match: base64_address("image/webp", as_webp(base64.b64decode(match[1]))), text)
    # A hundredth of a point cannot be seen.
    shorter = lambda match: f"{float(match[0]):.2f}".rstrip("0").rstrip(".")  # noqa: E731
    text = COORDINATES.sub(lambda match: FRACTION.sub(shorter, match[0]), text)
    text = re.sub("[%#]", lambda match: f"%{ord(match[0]):02X}", text)
    return text.replace("'", "&apos;").replace('"', "'").split("<")


def svg_address(parts: list[str]) -> str:
    """Return the parts as an address; it stands between double quotation marks."""
    return "data:image/svg+xml;charset=utf-8," + "<".join(parts)


def inlined_styles(path: Path) -> str:
    """Return a style sheet with what it loads as data."""

    def inlined(match: re.Match) -> str:
        file = path.parent / match[1].strip("'\"")
        return f'url("{data_address(file)}")' if file.is_file() else "none"

    text = path.read_text(encoding="utf-8")
    text = re.sub(r'@import "([^"]+)";', lambda match: inlined_styles(path.parent / match[1]), text)
    return re.sub(r"""url\((?!["']?data:)([^)]*)\)""", inlined, text).replace("</style", "<\\/style")


def inlined_script(path: Path) -> str:
    """Return a script that may stand between <script> and </script>."""
    return re.sub(r"<(?=/script|!--)", r"<\\", path.read_text(encoding="utf-8"), flags=re.IGNORECASE)
