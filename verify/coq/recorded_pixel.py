"""The program of a pixel for Coq, recorded from the shader: `python -m renderer.generate` prints it as data."""

import math
import textwrap
from itertools import product, zip_longest
from types import SimpleNamespace
from typing import Any

import numpy as np

from renderer import exact, render
from renderer.kernels import FIELDS, LIGHT_MODELS
from renderer.machines.forms import COLORS, flat, of_form
from renderer.scene.methods import DIFFERENCES
from renderer.scene.raster import Raster
from renderer.scene.scene import BUMPS, MAX_LIGHTS, Scene
from renderer.shader.numbers import LIGHT_FORM, ROUNDED, SCENE_FORM, SHADOWS, Shot, Want
from renderer.shader.rounded_inputs import input_bounds
from renderer.shader.shader import SLOPES, Group
from verify.coq.recorder import Recorder

HEADER = """(* Printed from renderer/shader by `python -m renderer.generate`. Do not edit: change the shader.
   A pixel's program, recorded from the shader: the places of inputs and outputs by their names; then the lines, each an
   operation and the places of what it takes. A selection takes two numbers, and those that its condition compares. *)

From Coq Require Import List NArith ZArith.
Import ListNotations.

Module recorded_pixel.
Inductive condition : Type := Lt (i j : nat) | Le (i j : nat) | Eq (i j : nat) | Ne (i j : nat)
  | And (c d : condition) | Or (c d : condition) | Invert (c : condition).
Inductive operation : Type := Literal (m e : Z) | Infinite | Constant (m e : Z) | Neg | Abs | Add | Sub | Mul | Truediv
  | Product_error | Sqrt | Floor | Rint | Sinpi | Cospi | Atan2pi | Exp | Log | Power | Where (c : condition).
(* The least that a number is, the most, and how far it may be off, each m 2^e. *)
Definition number : Type := (Z * Z) * (Z * Z) * (Z * Z).
Definition exactly (n : Z * Z) : number := (n, n, (0%Z, 0%Z)).
"""
Range = tuple[float, float, float]
PART = 50  # lines in one list: Coq's time to read one grows with its square
ANY = Want(
    (*product(FIELDS, ("general", *DIFFERENCES)), ("sine", "stored")),
    tuple(
        (model, style)
        for model, style in product(LIGHT_MODELS, ("base", "diffuse", "squared"))
        if style != "squared" or LIGHT_MODELS[model][1]
    ),
    integer_power=False,
    bumps=BUMPS,
)
SHOT = Shot(Scene(), raster=Raster(256, 256))
FAR = 2.0**1023  # stands for infinity
PIXELS = (
    (111, 125),
    (202, 37),
    (133, 220),
    (152, 83),
    (44, 188),
    (218, 82),
    (238, 148),
    (59, 216),
    (28, 182),
    (222, 169),
)
"""(column, row) of ten pixels of it, each in a chamber of its own."""
SPREAD = (204, 117), (195, 26), (3, 46), (158, 98), (21, 93), (215, 80), (234, 109), (29, 44), (22, 115), (238, 80)
"""The same, further from the edges of these chambers."""
PLACES = {"sine": [(140, 109), (204, 109)], "ridges": [(101, 102), (177, 92)], "rings": [(138, 155), (157, 58)]}
"""{field: (column, row) of pixels on A}"""
MODELS = {model: ANY.lights.index((model, "squared" if LIGHT_MODELS[model][1] else "base")) for model in LIGHT_MODELS}
DEFAULT, BY_SLOPES = SHOT.want, ANY._replace(ways=(("sine", "stored"),), integer_power=True)
WANTS = (ANY, ANY._replace(horizon=True), DEFAULT, BY_SLOPES)
KNOWN = {name: getattr(SCENE_FORM, name) for name in ("power", "power_u", "power_v")}
"""The powers of the default scene, by squaring."""
COLORED = "ka kd ks albedo_a albedo_b ambient_light ambient floor_light floor_dark light_color"
WIDE = dict.fromkeys(COLORED.split(), (0.0, 1.0)) | {"beta": (0.3, 0.4)}
"""{number: its least and largest value} of a range of scenes. The others are the default scene's."""
MOVED = {"light_position": 2.0**-5} | {f"light_{name}": 2.0**-4 for name in SHADOWS}
"""{number: how far from the default scene's it may be}, each coordinate."""
AROUND = 2.0**-11  # how far a place may be from a pixel's centre, in the image
SLOPES_OFF, PRODUCTS_OFF = 2.0**-44, 2.0**-51  # how far slopes and products of such numbers may be off


class Pixel(Group):
    """A pixel that has the heights of its normals as outputs, too: of N' on A, then of N on B and the floor."""

    def light_up(self, mask: Any, place: Any, *rest: Any, **upright: Any) -> None:
        """Light it."""
        self.pixels.store("normal", place[-1])
        super().light_up(mask, place, *rest, **upright)


def recorded() -> Recorder:
    """Return the recording of a pixel, drawn with no light by each of WANTS, then with one, up to MAX_LIGHTS."""
    recorder = Recorder(*SLOPES)

    def inputs(form, before="", *numbers):
        each = [(before + name, *numbers, n) for name, part in vars(form).items() for n in range(np.size(part))]
        return of_form(form, [recorder.load(*name) for name in each])

    scene, lights = inputs(SCENE_FORM), [inputs(LIGHT_FORM, "light_", number) for number in range(MAX_LIGHTS)]
    for number, want in product(range(MAX_LIGHTS + 1), WANTS):
        recorder.lights = lights[:number]
        numbers = SimpleNamespace(**vars(scene) | (KNOWN if want.integer_power else {}))
        Pixel(recorder, numbers, want, recorder).draw()
    return recorder


def recorded_source() -> str:
    """Return the text of proofs/formal/RecordedPixel.v."""
    recorder, lines = recorded(), []
    named: dict[str, list] = {}
    for (kind, text, *places), place in recorder.lines.items():
        if kind == "input":
            named.setdefault(text[0], []).append(place)
        else:
            lines.append(f"({_operation(kind, text)}, {_list(places)})")
    named |= {name: [*dict.fromkeys(places)] for name, places in recorder.outputs.items()}
    parts = [f"Definition {name} : list nat := {_list(places)}." for name, places in named.items()]
    inputs = len(recorder.lines) - len(lines)
    parts.append(f"Definition inputs : nat := {inputs}.")
    for name, want in {"drawn": DEFAULT, "by_slopes": BY_SLOPES}.items():
        drawing = len(WANTS) * len(Scene().lights) + WANTS.index(want)
        parts.append(f"Definition {name} : list nat := {_list(recorder.outputs[c][drawing] for c in COLORS)}.")
    parts.append("Open Scope N_scope.")
    firsts = range(0, len(lines), PART)
    for first in firsts:
        part = "; ".join(lines[first : first + PART])
        parts.append(f"Definition from_{first} : list (operation * list N) := [{part}].")
    parts.append(f"Definition lines := concat {_list(f'from_{first}' for first in firsts)}.")
    parts.append("Definition pixel := map (fun line => (fst line, map N.to_nat (snd line))) lines.")
    parts += ["Open Scope Z_scope.", *_boxes()]
    fill = textwrap.TextWrapper(120, break_on_hyphens=False).fill
    return HEADER + "\n".join(map(fill, parts)) + "\nEnd recorded_pixel.\n"


def scene_ranges() -> tuple[list[Range], list[Range]]:
    """Return the default scene's numbers as ranges, those of its lights among them; and wide ones, by WIDE and MOVED.

    A range is a number's least value, its largest, and how far it may be off.
    """
    numbers = np.clip(np.concatenate([*map(np.ravel, SHOT.numbers)]), -FAR, FAR)
    bounds = input_bounds(SHOT, SHOT.raster.width)["scene_bounds"]
    still = [(number, number, bound) for number, bound in zip_longest(numbers, bounds, fillvalue=0.0)]
    named = _named(SCENE_FORM) + [f"light_{name}" for name in _named(LIGHT_FORM)] * len(Scene().lights)
    wide = []
    for name, (number, _, bound) in zip(named, still, strict=True):
        moved, off = MOVED.get(name, 0.0), PRODUCTS_OFF if name in WIDE and name in ROUNDED else bound
        wide.append((*WIDE.get(name, (number - moved, number + moved)), off))
    return still, wide


def _named(form):
    return [name for name, part in vars(form).items() for _ in range(np.size(part))]


def _boxes():
    """Yield the definitions of ten points of the default scene, and of ranges: each its outputs, and its inputs."""
    of, at = input_bounds(SHOT, SHOT.raster.width), SHOT.raster.image_points(SHOT.scene)
    zero = [(0.0, 0.0, 0.0)]
    still, wide = (
        part + zero * np.size(flat(LIGHT_FORM)) * (MAX_LIGHTS - len(Scene().lights)) for part in scene_ranges()
    )

    def place(pixel, around, slopes=zero * 2):
        middles = [(x[n], of[f"{name}_bound"][n]) for name, x, n in zip("xy", at, pixel, strict=True)]
        return _list(map(_range, (*((n - around, n + around, bound) for n, bound in middles), *slopes)))

    ranges = [f"(drawn, {place(pixel, AROUND)} ++ wide 0)" for pixel in SPREAD]
    for field, pixels in PLACES.items():
        for pixel, model in product(pixels, MODELS.values()):
            data = render(Scene(field=field), 256, 256, exact("general"), (*pixel, 1, 1)).surface_data
            slopes = [(data[name].item(), data[name].item(), SLOPES_OFF) for name in SLOPES]
            ranges.append(f"(by_slopes, {place(pixel, 0.0, slopes)} ++ wide {model})")
    points = [f"(drawn, {place(pixel, 0.0)} ++ scene)" for pixel in PIXELS]
    wide = [*map(_range, wide)]
    wide[_named(SCENE_FORM).index("model")] = "exactly (model, 0)"
    yield f"Definition scene : list number := {_list(map(_range, still))}."
    yield f"Definition wide (model : Z) : list number := {_list(wide)}."
    yield f"Definition points : list (list nat * list number) := {_list(points)}."
    yield f"Definition ranges : list (list nat * list number) := {_list(ranges)}."


def _range(ends):
    low, high, off = map(_dyadic, ends)
    same = low == high and not ends[2]
    return f"exactly {low}" if same else f"({low}, {high}, {off})"


def _dyadic(number):
    mantissa, exponent = math.frexp(number)
    return f"({int(mantissa * 2**53)}, {exponent - 53})"


def _list(places):
    return f"[{'; '.join(map(str, places))}]"


def _operation(kind, text):
    if text == "inf":
        return "Infinite"
    name = kind.capitalize()
    if isinstance(text, tuple):
        return f"{name} {_condition(*text)}"
    numerator, denominator = float.fromhex(text or "0").as_integer_ratio()
    return f"{name} ({numerator}) ({1 - denominator.bit_length()})" if text else name


def _condition(kind, *parts):
    return f"({kind.capitalize()} {' '.join(_condition(*p) if isinstance(p, tuple) else str(p) for p in parts)})"
