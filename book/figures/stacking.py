"""§6's stacking, computed: a lamp and many samples a pixel, through the bump, by both pipelines."""

from functools import cache, partial

from book.drawing.registry import Drawing, figure
from book.drawing.style import panels
from book.figures.three_pictures import HIGH, LOW
from renderer import Scene
from renderer.picture.views import difference_logarithmic, to_bytes
from verify.accuracy import stacking

SHOWN, LAMP, PIXEL = 208, 4, 4
WAYS = {"one": {}, "lamp": {"lamp": LAMP}, "pixel": {"pixel": PIXEL}}
_stacked = cache(partial(stacking.stacked, Scene(), LAMP, PIXEL, SHOWN))


@figure("stacking")
def stacked_pictures() -> Drawing:
    """One light and one sample a pixel; a lamp and many samples; and how far the pipelines are apart in the second."""
    plain, mean = stacking.stacked(Scene(), side=SHOWN), _stacked()
    pictures = [to_bytes(plain.picture), to_bytes(mean.picture), difference_logarithmic(mean.difference, LOW, HIGH)]
    titles = ("one point, one sample", "a lamp, many samples", "numeric − symbolic")
    fig = panels(pictures, titles, (LOW, HIGH))
    numbers = {"eps": stacking.EPS, "lamp_points": LAMP**2, "pixel_points": PIXEL**2, "half": stacking.HALF}
    shares, flips = [], []
    for field in ("ridges", "sine"):
        for name, samples in WAYS.items():
            both = stacking.stacked(Scene(field=field), **samples)
            numbers[f"{field}_{name}"] = {"rms": both.rms, "share": both.of_the_bound, "flips": both.flips}
            shares.append(both.of_the_bound)
            flips.append(both.flips)
    numbers["mirror_apart"], numbers["mirrored"] = stacking.mirrors_apart(Scene())
    return Drawing(fig, numbers | {"largest_share": max(shares), "flips": sum(flips)})
