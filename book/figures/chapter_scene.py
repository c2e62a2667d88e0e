"""What the figures share: the chapter's scene, its rasters, and renders that several figures look at."""

from functools import cache

from renderer import Scene, central, exact, render

SCENE = Scene()
SIZE = 256  # the raster of every number on the default scene
TELLING_EPS = 1e-2  # a step at which the creases are plainly wrong to the eye
FIELD_NAMES = ("sine", "ridges", "rings")


@cache
def symbolic(field="ridges", size=SIZE):
    """Return the exact frame of a field on the chapter's scene."""
    return render(Scene(field=field), size, size, exact())


@cache
def numeric(field="ridges", size=SIZE, eps=TELLING_EPS):
    """Return the central-difference frame of a field on the chapter's scene."""
    return render(Scene(field=field), size, size, central(eps), stage=symbolic(field, size).stage)
