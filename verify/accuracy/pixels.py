"""A picture's float64 pixels against balls of the same program: random pixels, and the places that are hard.

Truth is the pixel's program in balls of 256 bits, whose radius is below 1e-50; what rounding may do to it is the radius
of the same program in balls of 53 bits. A pixel whose chamber or side of a crease those leave open is counted apart.
"""

from collections.abc import Iterable, Mapping
from copy import copy
from dataclasses import replace
from functools import lru_cache
from itertools import cycle, product
from typing import NamedTuple

import numpy as np
from flint import arb, ctx

from proofs.formulas.height_fields import HEIGHT_FIELDS
from proofs.formulas.pixel import CHANNELS, pixel
from proofs.formulas.shading import LIGHT_MODELS
from renderer import Scene, render
from renderer.picture.frame import Frame
from verify.evaluate.balls import Balls
from verify.reference import lights_on, scene_values

SIZE, EACH, SEED, BITS = 255, 46, 5, 256  # an odd size: a column of pixels lies on x = 0, on a crease
OFF_RIM, TOLERANCE = 0.01, 5e-14
COLORS = tuple(f"rgb_{c}" for c in CHANNELS)
SCENES = {f"{field}, {model}": Scene(field=field, model=model) for field, model in product(HEIGHT_FIELDS, LIGHT_MODELS)}
SHININESSES = {
    f"shininess {p:g}": Scene(model=model, shininess=p)
    for p, model in zip((0.5, 7.3, 1000.0, 1e6), cycle(LIGHT_MODELS), strict=False)
}


class Checked(NamedTuple):
    """One pixel. error: the largest of its channels; radius: of its 53-bit balls; off_rim: 1 − (ρ/ρ_s)² ≥ 0.01."""

    scene: str
    kind: str
    column: int
    row: int
    error: float
    radius: float
    off_rim: bool
    undecided: frozenset
    same_chamber: bool

    def bound(self, share: float = 1.0) -> float:
        """Return the bound that the pixel is held to; share: of the radius, where that is the bound."""
        default = not self.scene.startswith("shininess")
        return TOLERANCE if self.off_rim and default else share * self.radius


def _edges(codes):
    """Return where a code differs from that of the pixel to the right, to the left, above or below."""
    around = np.lib.stride_tricks.sliding_window_view(np.pad(codes, 1, "edge"), (3, 3))
    return (around[..., (0, 2, 1, 1), (1, 1, 0, 2)] != codes[..., None]).any(axis=-1)


def _kinds(scene, frame):
    """Return {kind: a plane in which the pixels of that kind have the smallest numbers}."""
    surface, shadows = frame.chambers & 3, frame.chambers >> 2 & 31
    u, v = frame.surface_data["u"], frame.surface_data["v"]
    waves = [w - np.rint(w) for w in (scene.ku * u, scene.kv * v)]
    lights, flat = range(len(scene.lights)), copy(frame)
    flat.scene = replace(scene, beta=0.0)  # its light's cosines are of the same points, without the bump
    return {
        "at random": np.zeros(surface.shape),
        "silhouette": np.where(_edges(surface), 0.0, np.inf),
        "shadow's edge": np.where(_edges(shadows) & ~_edges(surface), 0.0, np.inf),
        "next to the pole": v,
        "next to the seam": np.minimum(u, 1 - u),
        "next to a crease": np.minimum(*np.abs(waves)),
        "terminator": np.min([np.abs(frame.light_cosines(i)) for i in lights], axis=0),
        "grazing light": np.min([np.abs(flat.light_cosines(i)) for i in lights], axis=0),
    }


def chosen(scene: Scene, frame: Frame, each: int = EACH) -> list[tuple[str, int, int]]:
    """Return [(kind, column, row)]: `each` pixels of every kind; among equals at random."""
    rng, found = np.random.default_rng(SEED), []
    for kind, plane in _kinds(scene, frame).items():
        order = np.lexsort((rng.random(plane.size), plane.ravel()))[:each]
        rows, columns = np.unravel_index(order[np.isfinite(plane.ravel()[order])], plane.shape)
        found += [(kind, int(c), int(r)) for c, r in zip(columns, rows, strict=True)]
    return found


@lru_cache(maxsize=32)
def balls_of(field: str, model: str, lights: int) -> Balls:
    """Return the Balls of a whole pixel by the exact gradient in its general form."""
    return Balls(pixel(HEIGHT_FIELDS[field], model, lights))


def _off_rim(scene, lines):
    """Return whether the ray's distance from the centre of the sphere that it hits is below √0.99 radii."""
    seen = int(lines["surface"].unique_fmpz() or 0)
    if seen == 1:
        return bool(1 - (lines["rho"] / lines["rho_silhouette"]) ** 2 >= OFF_RIM)
    if seen == 2:
        squared = lines["x"] ** 2 + lines["y"] ** 2 + arb(scene.eye) ** 2
        return bool(lines["discriminant_b"] / (squared * arb(scene.ball_radius) ** 2) >= OFF_RIM)
    return seen == 3


def _code(lines, lights):
    names = ("surface", *(f"occluded_{i}" for i in range(lights)), "dark_square")
    parts = [int(lines[name].unique_fmpz() or 0) for name in names]
    return parts[0] | sum(bit << (2 + i) for i, bit in enumerate(parts[1:-1])) | parts[-1] << 7


def checked_pixel(name: str, scene: Scene, frame: Frame, kind: str, column: int, row: int) -> Checked:
    """Return a pixel of a frame, Checked."""
    height, width = frame.raster.shape
    values, lights = scene_values(scene, column=column, row=row, width=width, height=height), len(lights_on(scene))
    balls = balls_of(scene.field, scene.model, lights)
    truth, _ = balls(values, BITS)
    rounded, undecided = balls(values)
    with ctx.workprec(BITS):
        errors = [abs(arb(float(c)) - truth[n]).upper() for c, n in zip(frame.rgb[row, column], COLORS, strict=True)]
        error, radius = max(map(float, errors)), max(float(rounded[n].rad()) for n in COLORS)
        same_chamber = _code(truth, lights) == int(frame.chambers[row, column])
        return Checked(name, kind, column, row, error, radius, _off_rim(scene, truth), undecided, same_chamber)


def checked_pixels(scenes: Mapping[str, Scene], each: int = EACH) -> list[Checked]:
    """Return every chosen pixel of {name: Scene}, Checked."""
    found = []
    for name, scene in scenes.items():
        frame = render(scene, SIZE, SIZE)
        found += [checked_pixel(name, scene, frame, *place) for place in chosen(scene, frame, each)]
    return found


def problems(pixels: Iterable[Checked], share: float = 1.0) -> list[Checked]:
    """Return the decided pixels that are above their bound or in another chamber."""
    return [p for p in pixels if not p.undecided and not (p.error <= p.bound(share) and p.same_chamber)]
