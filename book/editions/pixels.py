"""PNG data made smaller without changing a pixel: as WebP without loss, or with a palette for up to 256 colours."""

import base64
import io
import re

from PIL import Image

EMBEDDED = re.compile(r"data:image/png;base64,([A-Za-z0-9+/=\s]+)")


def smaller(png: bytes) -> bytes:
    """The same picture in fewer bytes, or the same bytes."""
    picture = Image.open(io.BytesIO(png))
    if picture.mode == "RGBA" and picture.getextrema()[3] == (255, 255):
        picture = picture.convert("RGB")
    tries = [png, written(picture)]
    if picture.mode == "RGB" and (colours := picture.getcolors(256)):
        indexed = picture.quantize(len(colours))
        if indexed.convert("RGB").tobytes() == picture.tobytes():
            tries.append(written(indexed))
    return min(tries, key=len)


def written(picture: Image.Image) -> bytes:
    """A picture as PNG."""
    out = io.BytesIO()
    picture.save(out, "PNG", optimize=True)
    return out.getvalue()


def as_webp(png: bytes) -> bytes:
    """The same pixels as WebP, without loss; those of no colour at all too."""
    out = io.BytesIO()
    Image.open(io.BytesIO(png)).save(out, "WEBP", lossless=True, exact=True, method=2)
    return out.getvalue()


def address(png: bytes) -> str:
    """PNG data as a data: address of whichever format takes fewer bytes."""
    kind, data = min(("png", smaller(png)), ("webp", as_webp(png)), key=lambda pair: len(pair[1]))
    return f"data:image/{kind};base64,{base64.b64encode(data).decode()}"


def smaller_inside(text: str) -> str:
    """A drawing with the pictures inside it made smaller."""
    return EMBEDDED.sub(lambda match: address(base64.b64decode(match[1])), text)
