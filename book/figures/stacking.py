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
    fig = panels(pictures, titles, bar=(LOW, HIGH), bar_label="largest |ΔI| of a channel")
    numbers = {"eps": stacking.EPS, "lamp_points": LAMP**2, "pixel_points": PIXEL**2, "half": stacking.HALF}
    for field in ("ridges", "sine"):
        for name, samples in WAYS.items():
            found = stacking.stacked(Scene(field=field), **samples)
            numbers |= {f"{field}_{name}_rms": found.rms, f"{field}_{name}_share": found.of_the_bound}
            numbers |= {f"{field}_{name}_flips": found.flips}
    numbers |= {"largest_share": max(value for name, value in numbers.items() if name.endswith("share"))}
    numbers |= {"flips": sum(value for name, value in numbers.items() if name.endswith("flips"))}
    return Drawing(fig, numbers=numbers)
