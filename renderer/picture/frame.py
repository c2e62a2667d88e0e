"""A rendered picture and the data of its pixels, each computed when it is first asked for."""

from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path
from typing import Any

import numpy as np

from renderer.checks import check_kind, check_number, check_whole, not_allowed
from renderer.files import pictures
from renderer.files.record import text_of
from renderer.files.srgb import to_bytes
from renderer.kernels import bumped_normal, chart, light_cosine, point_on_a, slope
from renderer.machines import at_points, machine
from renderer.picture.stage import SURFACE_BITS, Stage
from renderer.scene.fields import field_kernels, parameters
from renderer.scene.methods import GradientMethod
from renderer.scene.raster import Raster
from renderer.scene.scene import Scene
from renderer.shader.numbers import Shot, read_only
from renderer.shader.shader import ON_A, slopes_of_bump
from renderer.threads import run_bands
from renderer.whole_files import checked_target

BOUNDARIES = ("eye", "radius", "ball_center", "ball_radius")
MOVES_A = ("beta", "ku", "kv", "albedo_a")  # the colours of A alone


@cache
def _data_of(field):
    """Return the function from a point's angles, slopes, (k_u, k_v) and ε to the data of a field there."""
    kernels = field_kernels(field)

    def data(cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, k_u, k_v, eps):
        here = *chart(cos_theta, sin_theta, cos_phi, sin_phi), k_u, k_v
        flags = kernels["kink"](sin_phi, *here), kernels["straddling"](*here, eps)
        return *here[:2], kernels["height"](*here), h_u, h_v, slope(h_u, h_v), *flags

    return data


@dataclass(eq=False, repr=False)
class Frame:
    """A picture of a scene.

    rgb: (height, width, 3) float64, linear light in [0, 1], row 0 at the top (a view of three planes).
    planes: the same, (3, height, width). chambers: (height, width) uint8, see `renderer.picture.stage.Stage`.
    scene, raster, method, or all three as the `shot`, and stage: its origin.

    >>> from renderer import Scene, render
    >>> frame = render(Scene(), 16, 16, bounds=True)
    >>> bool((frame.bounds[frame.stage.on_a & ~frame.open] < 1e-11).all()), frame.rgb.shape
    (True, (16, 16, 3))
    >>> frame.work["pixels_a"], sorted(frame.surface_data)
    (115, ['h', 'h_u', 'h_v', 'kink', 'slope', 'u', 'v'])
    """

    shot: Shot
    stage: Stage
    _planes: np.ndarray | None
    _counts: dict[str, int]
    _enclosure: tuple[np.ndarray, np.ndarray] | None
    _by: tuple[str, ...]
    _slopes: np.ndarray

    def __post_init__(self) -> None:
        read_only(self._slopes, *self._enclosure or ())

    @property
    def scene(self) -> Scene:
        """The scene of the picture."""
        return self.shot.scene

    @property
    def method(self) -> GradientMethod:
        """The method of its gradient."""
        return self.shot.method

    @property
    def raster(self) -> Raster:
        """The raster that it is drawn on."""
        return self.shot.raster

    @cached_property
    def work(self) -> dict[str, Any]:
        """The work of this frame, without that of a given stage: a dict of counts, and which `machine` drew.

        machine: "llvm" or "numpy". pixels: {chamber code: pixels}; pixels_a, pixels_b, pixels_floor;
        gradient_evaluations (exact ones), algebraic_gradients among them, height_evaluations, shadow_tests,
        specular_powers, light_terms. slopes: {name: pixels of the surfaces that one of `derivatives` may move}.
        """
        codes, pixels = (column.tolist() for column in np.unique(self.chambers, return_counts=True))
        _, on_a, on_b, on_floor = np.bincount(self.chambers.ravel() & SURFACE_BITS, minlength=4).tolist()
        ((field, way),) = self.shot.want.ways
        heights = field_kernels(field)["height_evaluations"].get(way, 0)
        gradients = self._counts["gradient_evaluations"]
        return self._counts | {
            "machine": machine().NAME,
            "pixels": dict(zip(codes, pixels, strict=True)),
            "pixels_a": on_a,
            "pixels_b": on_b,
            "pixels_floor": on_floor,
            "gradient_evaluations": 0 if heights else gradients,
            "algebraic_gradients": gradients if way == "algebraic" else 0,
            "height_evaluations": heights * gradients,
            "slopes": {
                n: on_a if n.startswith(MOVES_A) or n in parameters(field) else on_a + on_b + on_floor for n in self._by
            },
        }

    def hand_over(self) -> np.ndarray:
        """Return the memory of the colours for another frame to be drawn into; this one has none any more.

        Raises ValueError if it has handed them over.
        """
        planes, self._planes = self._held("into"), None
        return planes

    def _held(self, name):
        """Return the memory of the colours, or raise ValueError if it is handed over."""
        if self._planes is None:
            raise not_allowed(name, self, "another frame has been drawn into it")
        return self._planes

    @property
    def planes(self) -> np.ndarray:
        """(3, height, width) float64 in [0, 1]. Raises ValueError when they are handed over."""
        return self._held("frame")[..., : self.raster.shape[1]]

    @property
    def rgb(self) -> np.ndarray:
        """(height, width, 3) float64 in [0, 1]. Raises ValueError when they are handed over."""
        return np.moveaxis(self.planes, 0, -1)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> np.ndarray:
        """Return `rgb`, as NumPy asks for it."""
        return np.array(self.rgb, dtype, copy=copy)

    def __repr__(self) -> str:
        return f"Frame({self.raster}, {self.method}, {self.scene})"

    @property
    def shape(self) -> tuple[int, int, int]:
        """(height, width, 3), as of `rgb`."""
        return *self.raster.shape, 3

    def __sub__(self, other: "Frame") -> np.ndarray:
        """Return the difference of `rgb` from another frame's. Raises ValueError where its shape is another."""
        if check_kind("frame", other, Frame).shape != self.shape:
            raise not_allowed("frame", other, f"one of the shape {self.shape}")
        return self.rgb - other.rgb

    @property
    def srgb(self) -> np.ndarray:
        """(height, width, 3) uint8: the sRGB bytes that a screen shows, and a `.png` has."""
        return to_bytes(self.rgb)

    def to_png(self) -> bytes:
        """Return the PNG that `save` writes."""
        return pictures.png_of(self.rgb, self._record())

    _repr_png_ = to_png  # which a notebook shows

    def _record(self):
        """Return the record, a text, from which `--again` draws the picture."""
        return text_of(self.shot)

    def save(self, path: str | Path, linear: str | None = None) -> None:
        """Write the picture to a file, of a kind that its name's suffix says; it appears whole or not at all.

        `.png`: for the eye, sRGB bytes. `.tif`, `.tiff`, with the extra `tiff`: the same bytes, or linear light in
        numbers as `linear` says, "float32" or "float64". `.npy`: `rgb`, float64. `.npz`: `rgb`, `chambers`,
        `slope_arrays()` and `data_on_a`, whose numbers are those of the pixels where `chambers & 3` is 1, row by row. A
        `.png` and a `.npz` carry the scene, the method and the raster: `python -m renderer image --again FILE` draws
        them again, unless a custom field has no text.

        Raises ValueError on another name, or one that cannot be written.
        """
        path = checked_target(path, pictures.PICTURE_SUFFIXES, "path")
        pictures.check_linear(linear, path)
        match path.suffix.lower():
            case ".png":
                pictures.write_png(path, self.rgb, self._record())
            case ".npz":
                arrays = {"rgb": self.rgb, "chambers": self.chambers, **self.data_on_a, **self.slope_arrays()}
                pictures.write_npz(path, arrays, record=self._record())
            case ".npy":
                pictures.write_npy(path, self.raster.shape, [self.rgb])
            case _:
                pictures.write_tiff(path, self.rgb.astype(linear) if linear else self.srgb)

    @property
    def bounded(self) -> bool:
        """True if it was drawn with `bounds=True`."""
        return self._enclosure is not None

    def _enclosed(self, name, part):
        if self._enclosure is None:
            raise not_allowed(name, None, "a frame drawn by render(..., bounds=True)")
        return self._enclosure[part][..., : self.raster.shape[1]]

    @property
    def bounds(self) -> np.ndarray:
        """(height, width, 3) float64: |rgb − exact| is at most this, of a frame drawn with `bounds=True`.

        Exact is the same formula in real arithmetic, of the scene's float64 numbers and the raster's exact image
        points, by the same gradient method: a difference's truncation is no error of the program. Raises ValueError
        without bounds.
        """
        return np.moveaxis(self._enclosed("bounds", 0), 0, -1)

    @property
    def open(self) -> np.ndarray:
        """(height, width) bool: a chamber or the side of a crease is undecided; the bounds cover each choice.

        Every pixel of a floor whose coordinates reach 2⁵³ is: float64 numbers are whole there, and have no square.
        Raises ValueError without bounds.
        """
        return self._enclosed("open", 1) > 0

    @property
    def derivatives(self) -> dict[str, np.ndarray]:
        """{name: (height, width, 3) float64}: the slope of each colour by a number, drawn with `derivatives=(name, …)`.

        It is that of the exact picture, or of a difference's. A clipped colour has slope 0. By a number on which
        boundaries depend it is the slope inside them.

        >>> from renderer import Scene, render
        >>> frame = render(Scene(), 16, 16, derivatives=("beta", "eye"))
        >>> {name: round(float(abs(slope).max()), 2) for name, slope in frame.derivatives.items()}
        {'beta': 1.15, 'eye': 0.47}
        >>> frame.moves_boundaries
        ('eye',)
        """
        return dict(zip(self._by, self._slopes[0], strict=True))

    @property
    def derivative_bounds(self) -> dict[str, np.ndarray]:
        """{name: (height, width, 3) float64}: |slope − exact| is at most this, of a frame drawn with `bounds=True`.

        At a kink the slopes of both sides lie within it. It is infinite where an exact crease moves, or is not shown to
        stay, as there is no slope; by the shininess also where the highlight's base may be 0. Raises ValueError without
        bounds.
        """
        self._enclosed("derivative_bounds", 0)
        return dict(zip(self._by, self._slopes[1], strict=True))

    def slope_arrays(self) -> dict[str, np.ndarray]:
        """Return {"derivative_" and a number's name: its slopes}, and "derivative_bound_…" with bounds, for a file."""
        arrays = {f"derivative_{name}": slope for name, slope in self.derivatives.items()}
        bounds = self.derivative_bounds if self.bounded else {}
        return arrays | {f"derivative_bound_{name}": bound for name, bound in bounds.items()}

    def derivative(self, direction: dict[str, float]) -> np.ndarray:
        """Return the slope in a direction of several numbers, {name: its part}: (height, width, 3) float64.

        Raises ValueError on a number by which the frame has no slope.
        """
        slopes = self.derivatives
        for name, part in check_kind("direction", direction, dict, "{name: number}").items():
            if name not in slopes:
                raise not_allowed("direction", name, f"a number of the frame's derivatives={self._by}")
            check_number(name, part, -1e100, 1e100)
        return sum((part * slopes[name] for name, part in direction.items()), np.zeros(self.rgb.shape))

    @property
    def moves_boundaries(self) -> tuple[str, ...]:
        """The names of `derivatives` on which boundaries depend: to the slope of a mean of pixels these edges add."""
        moving: tuple[str, ...] = BOUNDARIES
        if self.scene.model == "blinn_gated":  # where a highlight ends at once
            moving += ("beta", "ku", "kv", *parameters(self.scene.field))
        if not isinstance(field_kernels(self.scene.field)["straddling"](0.3, 0.3, 1.0, 1.0, 0.1), float):
            moving += ("ku", "kv")  # a crease, where the colour jumps
        return tuple(name for name in self._by if name.startswith(moving) or "position" in name)

    @property
    def chambers(self) -> np.ndarray:
        """(height, width) uint8, the codes that `Stage` defines; read-only, as all frames of the stage share them."""
        return self.stage.chambers

    @cached_property
    def planes_on_a(self) -> np.ndarray:
        """(6, pixels of A) float64: cos θ, sin θ, cos φ, sin φ, h_u, h_v by the frame's method, row by row.

        A picture without a bump is drawn without a gradient; the field has one all the same.
        """
        planes = self.stage.new_plane(channels=len(ON_A))
        named = dict(zip(ON_A, planes, strict=True))
        want: Any = {"ways": ((self.scene.field, self.shot.way),), "colors": False, "stored": ON_A}
        self.stage.draw(self.shot, None, named, chambers_known=True, surfaces="a", **want)
        places = np.flatnonzero(self.stage.on_a)
        on_a = np.empty((len(ON_A), len(places)))

        def gather(part):
            plane = planes[part.start, :, : self.raster.shape[1]].ravel()
            plane.take(places, out=on_a[part.start], mode="wrap")  # without a copy, which "raise" makes

        run_bands(gather, len(ON_A), 1, None)
        read_only(on_a)
        return on_a

    @cached_property
    def data_on_a(self) -> dict[str, np.ndarray]:
        """The data of A's pixels, row by row: {name: (pixels of A,) float64}, as in `surface_data`; read-only."""
        scene, names = self.scene, ["u", "v", "h", "h_u", "h_v", "slope", "kink", "straddling"]
        numbers = scene.ku, scene.kv, self.method.eps or 0.0
        data = dict(zip(names, at_points(_data_of(scene.field), *self.planes_on_a, *numbers), strict=True))
        return data if self.method.eps else {name: data[name] for name in names[:-1]}

    def light_cosines(self, light: int) -> np.ndarray:
        """Return μ = N'·ω of light number `light` on sphere A, (height, width) float64, NaN off A.

        Its sign decides the attached shadow; a cast shadow of B is not looked at. Raises ValueError on a number that
        no light of the scene has.
        """
        if not self.scene.lights:
            raise not_allowed("light", light, "none, as the scene has no light")
        light = check_whole("light", light, len(self.scene.lights) - 1, low=0)
        normal = self._normal_on_a()
        point, position = point_on_a(*self.planes_on_a[:4], self.scene.radius), self.scene.lights[light].position
        return self._plane(light_cosine(*point, *position, *normal), np.nan)

    @property
    def normal(self) -> np.ndarray:
        """(height, width, 3) float64: the bumped normal N' by the frame's method, of length 1; NaN off A."""
        return np.stack([self._plane(part, np.nan) for part in self._normal_on_a()], axis=-1)

    @np.errstate(all="ignore")  # a selection computes both of its sides
    def _normal_on_a(self):
        *angles, h_u, h_v = self.planes_on_a
        slopes = slopes_of_bump(self.scene.bump, angles[-1], self.scene.radius, (h_u, h_v))
        return bumped_normal(*angles, *slopes, self.scene.beta)

    def _plane(self, values, off_a, kind=np.float64):
        plane = np.full(self.raster.shape, off_a, kind)
        plane[self.stage.on_a] = values
        return plane

    @cached_property
    def surface_data(self) -> dict[str, np.ndarray]:
        """The data of sphere A: a dict of (height, width) float64 planes, NaN off A.

        u, v, h, h_u, h_v (by the frame's method), slope, kink (1 or 0), and straddling (1 or 0) for a difference. They
        are read-only, and so are `chambers`, `planes_on_a`, bounds and slopes, which more than one answer is made from.
        """
        data = {name: self._plane(values, np.nan) for name, values in self.data_on_a.items()}
        read_only(*data.values())
        return data

    @property
    def kink(self) -> np.ndarray:
        """(height, width) bool: a crease factor of the field is below 0.03 in magnitude, or the pole; False off A.

        There is a crease where a factor of sines is 0; where any other expression is, there may be one.
        """
        return self._plane(self.data_on_a["kink"] == 1.0, False, bool)

    @property
    def slope(self) -> np.ndarray:
        """(height, width) float64: √(h_u² + h_v²) by the frame's method; 0 off A."""
        return self._plane(self.data_on_a["slope"], 0.0)

    @property
    def straddling(self) -> np.ndarray:
        """(height, width) bool: a crease lies strictly within ε of the pixel in u or in v; False if exact.

        One that is no line of zeros of sines is found by the signs of its factor at the difference's heights.
        """
        return self._plane(self.data_on_a["straddling"] == 1.0 if self.method.eps else False, False, bool)
