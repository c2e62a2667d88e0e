"""The program of a pixel for Coq, recorded from the shader: `python -m renderer.generate` prints it as data."""

import math
import textwrap
from itertools import chain, islice, product, repeat, zip_longest
from types import SimpleNamespace
from typing import Any

import numpy as np

from renderer.kernels import FIELDS, LIGHT_MODELS
from renderer.machines.forms import COLORS, of_form
from renderer.operations import UNIT
from renderer.scene.methods import DIFFERENCES
from renderer.scene.raster import Raster
from renderer.scene.scene import BUMPS, MAX_LIGHTS, Scene
from renderer.shader.numbers import LIGHT_FORM, SCENE_FORM, Shot, Want
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
"""
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
COLUMNS, ROWS = [111, 202, 133, 152, 44, 218, 238, 59, 28, 222], [125, 37, 220, 83, 188, 82, 148, 216, 182, 169]
"""Ten pixels of it, each in a chamber of its own."""
DEFAULT = SHOT.want
WANTS = (ANY, ANY._replace(horizon=True), DEFAULT)
KNOWN = {name: getattr(SCENE_FORM, name) for name in ("power", "power_u", "power_v")}
"""The powers of the default scene, by squaring."""


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
        numbers = SimpleNamespace(**vars(scene) | (KNOWN if want is DEFAULT else {}))
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
    inputs, drawing = len(recorder.lines) - len(lines), len(WANTS) * len(Scene().lights) + WANTS.index(DEFAULT)
    drawn = _list(recorder.outputs[name][drawing] for name in COLORS)
    parts += [
        f"Definition drawn : list nat := {drawn}.",
        f"Definition inputs : nat := {inputs}.",
        "Open Scope N_scope.",
    ]
    firsts = range(0, len(lines), PART)
    for first in firsts:
        part = "; ".join(lines[first : first + PART])
        parts.append(f"Definition from_{first} : list (operation * list N) := [{part}].")
    parts.append(f"Definition lines := concat {_list(f'from_{first}' for first in firsts)}.")
    parts.append("Definition pixel := map (fun line => (fst line, map N.to_nat (snd line))) lines.")
    (scene, points), kind = _numbers_of_points(inputs), "list ((Z * Z) * (Z * Z))"
    parts += [
        "Open Scope Z_scope.",
        f"Definition scene : {kind} := {scene}.",
        f"Definition points : list ({kind}) := {points}.",
    ]
    fill = textwrap.TextWrapper(120, break_on_hyphens=False).fill
    return HEADER + "\n".join(map(fill, parts)) + "\nEnd recorded_pixel.\n"


def _numbers_of_points(inputs):
    """Return the default scene's numbers, and each point's, with their counts."""
    of, (x, y) = input_bounds(SHOT, SHOT.raster.width), SHOT.raster.image_points(SHOT.scene)
    numbers = np.clip(np.concatenate([*map(np.ravel, SHOT.numbers)]), -FAR, FAR)
    pairs = zip_longest([0.0, 0.0, *numbers], [0.0, 0.0, *of["scene_bounds"]], fillvalue=0.0)
    scene = islice(chain(pairs, repeat((0.0, 0.0))), inputs - 2)
    at = [[x[COLUMNS], of["x_bound"][COLUMNS]], [y[ROWS], of["y_bound"][ROWS]]]
    return _counted(scene), _list(map(_counted, np.transpose(at, (2, 0, 1))))


def _counted(numbers):
    return _list(f"({_dyadic(number)}, {_dyadic(bound / UNIT)})" for number, bound in numbers)


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
