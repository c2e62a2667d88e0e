"""The chapter's pictures: the front page's, numeric beside symbolic and their difference, and means of many samples."""

from functools import cache

from book.drawing.registry import Drawing, certified, figure
from book.drawing.style import TITLE, canvas, panels, pixel_picture, pixel_text
from book.figures.chapter_scene import FINE, SCENE, TELLING_EPS, numeric, smooth, symbolic
from renderer import Scene, central, exact, render
from renderer.picture.differences import distance_on_a
from renderer.picture.views import difference_logarithmic, to_bytes
from verify.accuracy import stacking

LOW, HIGH = -8, 0
SIDE = 264
WIDTH, HEIGHT, HERO_EPS = 640, 480, 3e-2
ENLARGED, CREASE = 4, (690, 270, 272, 216)  # where the creases are that are shown enlarged, in enlarged pixels
TITLES = ("numeric", "symbolic", "difference")


@figure
def three_pictures() -> Drawing:
    """Ridges by central differences, exactly, and the difference on a logarithmic scale."""
    (one, other), fine = ([numeric(size=side, bounds=True), symbolic(size=side)] for side in (SIDE, SIDE * FINE))
    pictures, shown = [*map(smooth, fine), difference_logarithmic(one.rgb - other.rgb, LOW, HIGH)], (*fine, one, other)
    sizes = dict(zip(("largest", "rms_channels"), distance_on_a(one, other), strict=True))
    fig, numbers = panels(pictures, TITLES, (LOW, HIGH)), {"eps": TELLING_EPS, "side": SIDE} | sizes | certified(shown)
    if numbers["undecided"]:
        raise ValueError("a pixel of the three pictures is undecided, and §1 says that every colour has its bound")
    return Drawing(fig, numbers, shown=shown)


@cache
def _front(numerically, times=1, crop=None):
    """Return a frame of the front page's scene, of FINE² samples a pixel; `crop` is in pixels of `times` the raster."""
    method, fine = central(HERO_EPS) if numerically else exact(), FINE * times
    finer = crop and tuple(FINE * side for side in crop)
    return render(SCENE, fine * WIDTH, fine * HEIGHT, method, crop=finer, bounds=True)


@figure
def hero() -> Drawing:
    """The default scene by central differences of a step at which the creases glow."""
    return Drawing(smooth(_front(True)), {"eps": HERO_EPS}, shown=(_front(True),))


@figure
def hero_symbolic() -> Drawing:
    """The same scene with the exact derivative."""
    return Drawing(smooth(_front(False)), shown=(_front(False),))


@figure
def hero_crease() -> Drawing:
    """Two creases of the front page's pictures, enlarged: numeric above, symbolic below."""
    frames = [_front(way, ENLARGED, CREASE) for way in (True, False)]
    _, _, wide, high = CREASE
    fig = canvas(wide, 2 * (TITLE + high))
    for number, (frame, title) in enumerate(zip(frames, TITLES, strict=False)):
        top = number * (TITLE + high)
        pixel_text(fig, 0, top + 16, title)
        pixel_picture(fig, 0, top + TITLE, smooth(frame))
    return Drawing(fig, {"times": ENLARGED}, {"rgb": smooth(frames[0])}, frames)


SHOWN, MANY = 208, 4
WAYS = {"one": {}, "lamp": {"lamp": MANY}, "pixel": {"pixel": MANY}}


@figure("stacking")
def stacked_pictures() -> Drawing:
    """One light and one sample a pixel; a lamp and many samples; and how far the pipelines are apart in the second."""
    plain, mean = (stacking.stacked(SCENE, many, many, SHOWN) for many in (1, MANY))
    pictures = [to_bytes(plain.picture), to_bytes(mean.picture), difference_logarithmic(mean.difference, LOW, HIGH)]
    titles = ("one point, one sample", "a lamp, many samples", "numeric − symbolic")
    comparisons = {
        f"{field}_{name}": stacking.stacked(Scene(field=field), **samples)
        for field in ("ridges", "sine")
        for name, samples in WAYS.items()
    }
    apart, mirrored = stacking.mirrors_apart(SCENE)
    numbers = {
        "eps": stacking.EPS,
        "lamp_points": MANY**2,
        "pixel_points": MANY**2,
        "half": stacking.HALF,
        "mirror_apart": apart,
        "mirrored": mirrored,
        "largest_share": max(both.of_the_bound for both in comparisons.values()),
        "flips": sum(both.flips for both in comparisons.values()),
    }
    return Drawing(
        panels(pictures, titles, (LOW, HIGH)), numbers | {name: {"rms": both.rms} for name, both in comparisons.items()}
    )
