"""The program of a pixel for Coq, recorded from the shader: `python -m renderer.generate` prints it as data."""

import textwrap
from types import SimpleNamespace
from typing import Any

import numpy as np

from renderer.kernels import FIELDS, LIGHT_MODELS
from renderer.machines.forms import of_form
from renderer.machines.recording import Recorder
from renderer.scene.methods import DIFFERENCES
from renderer.scene.scene import BUMPS, MAX_LIGHTS, Scene
from renderer.shader.numbers import LIGHT_FORM, SCENE_FORM, Shot, Want
from renderer.shader.shader import SLOPES, Group

WAYS = (*((field, way) for field in FIELDS for way in ("general", *DIFFERENCES)), ("sine", "stored"))
MODELS = tuple(
    (model, style)
    for model, (_, squared) in LIGHT_MODELS.items()
    for style in ("base", "diffuse", *(["squared"] if squared else []))
)
ANY = Want(WAYS, MODELS, integer_power=False, bumps=BUMPS)
DEFAULT = Shot(Scene()).want
WANTS = (ANY, ANY._replace(horizon=True), DEFAULT)
KNOWN = ("power", "power_u", "power_v")  # by the last, as the default scene has them: so often it squares
PART = 50  # lines in one list: Coq's time to read one grows with its square
FILLED = textwrap.TextWrapper(120, break_on_hyphens=False).fill

HEADER = """(* Printed from renderer/shader by `python -m renderer.generate`. Do not edit: change the shader.
   A pixel's program, recorded from the shader: the places of inputs and outputs by their names; then the lines, each an
   operation and the places of what it takes. A selection takes two numbers, and those that its condition compares. *)

From Coq Require Import List NArith ZArith.
Import ListNotations.

Module recorded_pixel.
Inductive condition : Type := Less (i j : nat) | At_most (i j : nat) | Same (i j : nat)
  | Not (c : condition) | Both (c d : condition) | Either (c d : condition).
Inductive operation : Type := Literal (m e : Z) | Infinite | Constant (m e : Z) | Negative | Size | Sum | Difference
  | Product | Quotient | Root | Floor | Nearest | Sine | Cosine | Angle | Power | Choose (c : condition).
"""


class Pixel(Group):
    """A pixel that has the heights of its normals as outputs, too: of N' on A, then of N on B and the floor."""

    def light_up(self, mask: Any, place: Any, *rest: Any, **upright: Any) -> None:
        """Light it."""
        self.pixels.store("normal", place[-1])
        super().light_up(mask, place, *rest, **upright)


def recorded() -> Recorder:
    """Return the recording of a pixel, drawn with no light by each of WANTS, then with one, up to MAX_LIGHTS."""
    recorder = Recorder(*SLOPES)

    def inputs(form: SimpleNamespace, before: str = "", *numbers: int) -> SimpleNamespace:
        each = [(before + name, *numbers, n) for name, part in vars(form).items() for n in range(np.size(part))]
        return of_form(form, [recorder.load(*name) for name in each])

    scene = inputs(SCENE_FORM)
    known = SimpleNamespace(**vars(scene) | {name: getattr(SCENE_FORM, name) for name in KNOWN})
    lights = [inputs(LIGHT_FORM, "light_", number) for number in range(MAX_LIGHTS)]
    for number in range(MAX_LIGHTS + 1):
        recorder.lights = lights[:number]
        for want in WANTS:
            Pixel(recorder, known if want is DEFAULT else scene, want, recorder).draw()
    return recorder


def recorded_source() -> str:
    """Return the text of proofs/formal/RecordedPixel.v."""
    recorder, lines, named = recorded(), [], {}
    for (kind, text, *places), place in recorder.lines.items():
        if kind == "Input":
            named.setdefault(text[0], []).append(place)
        else:
            lines.append(f"({_operation(kind, text)}, {_list(places)})")
    named |= {name: dict.fromkeys(places) for name, places in recorder.outputs.items()}
    parts = [f"Definition {name} : list nat := {_list(places)}." for name, places in named.items()]
    parts += [f"Definition inputs : nat := {len(recorder.lines) - len(lines)}.", "Open Scope N_scope."]
    firsts = range(0, len(lines), PART)
    for first in firsts:
        part = "; ".join(lines[first : first + PART])
        parts.append(f"Definition from_{first} : list (operation * list N) := [{part}].")
    parts.append(f"Definition lines := concat {_list(f'from_{first}' for first in firsts)}.")
    parts.append("Definition pixel := map (fun line => (fst line, map N.to_nat (snd line))) lines.")
    return HEADER + "\n".join(map(FILLED, parts)) + "\nEnd recorded_pixel.\n"


def _list(places):
    return f"[{'; '.join(map(str, places))}]"


def _operation(kind, text):
    if kind == "Choose":
        return f"Choose {_condition(text)}"
    if not text:
        return kind
    if text == "inf":
        return "Infinite"
    numerator, denominator = float.fromhex(text).as_integer_ratio()
    return f"{kind} ({numerator}) ({1 - denominator.bit_length()})"


def _condition(condition):
    kind, *parts = condition
    return f"({kind} {' '.join(_condition(part) if isinstance(part, tuple) else str(part) for part in parts)})"
