"""The options of each verb of the command line, and the scene, the size and the method that they give."""

import argparse
import hashlib
import re
import sys
from argparse import Namespace
from collections.abc import Callable, Collection
from dataclasses import fields, replace
from functools import partial
from typing import Any, NoReturn

from renderer.checks import not_allowed
from renderer.scene.fields import field_from_record
from renderer.scene.methods import DECADES, DIFFERENCES, METHODS, GradientMethod, warned
from renderer.scene.scene import MOVE_NO_BOUNDARY, Light, Scene

Option = dict[str, Any]  # the arguments of argparse's add_argument


class OneLineParser(argparse.ArgumentParser):
    """A parser whose errors are one line, and takes -1e-3, -6,2,8 and -v**2 for values, not for options."""

    def __init__(self, *arguments: Any, **options: Any):
        super().__init__(*arguments, **options | {"allow_abbrev": False})
        self._negative_number_matcher = re.compile("-[^-]")  # argparse's own knows no exponent, no list and no formula

    def error(self, message: str) -> NoReturn:
        self.exit(2, f"{self.prog}: error: {message}\n")


def value(read: Callable[[str], Any], allowed: str, metavar: str) -> Option:
    """Return argparse's options for a value: `read` makes it of a text, or raises ValueError."""

    def parse(text):
        try:
            return read(text)
        except ValueError:
            raise argparse.ArgumentTypeError(f"{text!r} is not allowed: {allowed}") from None

    return {"type": parse, "metavar": metavar}


def several(one: Option) -> Option:
    """Return argparse's options for values with commas between them, of those for one."""
    read = one["type"]
    return one | {"type": lambda text: [read(item) for item in text.split(",")], "metavar": one["metavar"] + ",..."}


def numbers(kind: Callable[[str], Any], lengths: Collection[int], form: str, metavar: str) -> Option:
    """Return argparse's options for a tuple of numbers, "a,b,c", of one of the lengths."""

    def read(text):
        values = tuple(kind(item) for item in text.split(","))
        if len(values) not in lengths:
            raise ValueError
        return values

    return value(read, form, metavar)


def _parameter(text):
    name, number = text.split("=")
    return name, float(number)


NAME, WHOLE, NUMBER = value(str, "", "NAME"), value(int, "a whole number", "N"), value(float, "a number", "X")
TRIPLE = numbers(float, (3,), "X,Y,Z", "X,Y,Z")
LIGHT = numbers(float, (3, 6), "X,Y,Z or X,Y,Z,R,G,B", "X,Y,Z[,R,G,B]")
PARAMETER = value(_parameter, "NAME=NUMBER", "NAME=X")
KINDS: dict[Any, Option] = {str: NAME, float: NUMBER, tuple: TRIPLE, bool: {"action": "store_false"}}
RASTER = {
    "--size": WHOLE | {"default": "256", "help": "width and height (default: %(default)s)"},
    "--width": WHOLE | {"help": "width, if it is not --size"},
    "--height": WHOLE | {"help": "height, if it is not --size"},
    "--threads": WHOLE | {"help": "threads for a frame (default: all cores)"},
}
GRADIENT = {
    "--gradient": NAME | {"default": "exact", "help": f"{', '.join(METHODS)} (default: %(default)s)"},
    "--eps": NUMBER | {"help": "step of a difference (default: 1e-3)"},
}
DIFFERENCE = {"default": "central", "help": f"{', '.join(DIFFERENCES)} (default: %(default)s)"}
OUT = "a .png; - for one in a pipe; a .tif; a .npz with every buffer; a .npy (float64), of any size, drawn in bands"
OF_IMAGE: dict[str, Option] = {
    "--again": {"metavar": "FILE", "help": "draw the picture that a .png or .npz has a record of, of the same raster"},
    "--out": {"required": True, "metavar": "FILE", "help": OUT},
    "--bounds": {"metavar": "FILE", "help": "write how far off each colour is at most, and what is open, to a .npz"},
    "--linear": NAME | {"help": "float32 or float64: linear light in such numbers, in a .tif, and not sRGB bytes"},
    "--by": several(NAME)
    | {"help": "draw the slope by a number of the scene instead, such as beta or lights[0].position[2]; several: .npz"},
    "--samples": WHOLE | {"default": 1, "help": "N² points a pixel, whose mean it is (default: 1)"},
    "--crop": numbers(int, (4,), "LEFT,TOP,WIDTH,HEIGHT", "L,T,W,H") | {"help": "draw this part of the raster alone"},
    **GRADIENT,
    **RASTER,
}
OF_VIEWS = {
    "--out": {"required": True, "metavar": "FOLDER", "help": "the folder to write to; it is made if need be"},
    "--gain": NUMBER | {"default": 100.0, "help": "of the linear map (default: 100)"},
    **GRADIENT,
    "--gradient": NAME | DIFFERENCE,
    **RASTER,
}
OF_SWEEP = {
    "--eps": several(NUMBER) | {"nargs": "+", "default": [DECADES], "help": "steps (default: 1e-1 ... 1e-6)"},
    "--gradient": several(NAME) | DIFFERENCE,
    "--csv": {"metavar": "FILE", "help": "write the table to a .csv too"},
    "--no-facts": {"action": "store_true", "help": "print the table alone"},
    "--checkpoint": {"metavar": "FILE", "help": "a .jsonl that keeps every result: a killed sweep goes on from it"},
    "--workers": WHOLE | {"help": "threads that draw frames of a grid (default: all cores), each --threads 1"},
    "--dask": {"metavar": "ADDRESS", "help": "workers of the Dask scheduler there, such as tcp://host:8786"},
    **RASTER,
    "--size": several(RASTER["--size"]),
}


def add_scene(parser: argparse.ArgumentParser, lists: bool) -> None:
    """Add an option for every field of Scene; with `lists`, those that move no boundary take several values."""
    group = parser.add_argument_group("scene (defaults are the chapter's)", argument_default=argparse.SUPPRESS)
    group.add_argument(
        "--scene", metavar="FILE", help="a .toml to take what is not given from, as Scene.to_file writes"
    )
    for field in fields(Scene):
        option, kind, text = field.name.replace("_", "-"), KINDS[type(field.default)], field.metadata["help"]
        if field.name == "lights":
            option, kind = "light", LIGHT | {"action": "append"}
        elif field.type is bool:
            option, kind = (f"no-{option}", kind) if field.default else (option, {"action": "store_true"})
        else:
            text += f" (default: {field.default})"
        if lists and field.name in MOVE_NO_BOUNDARY:
            kind = several(kind)
        either = group.add_mutually_exclusive_group() if field.name == "field" else group
        either.add_argument(f"--{option}", dest=field.name, help=text, **kind)
        if field.name == "field":
            text = "a field of your own instead, of u, v, k_u and k_v, such as 'abs(sin(pi*k_u*u))'"
            either.add_argument("--field-expression", metavar="FORMULA", help=text)
            text = "a number of the formula's, by which a picture has slopes too; may be given again"
            group.add_argument("--field-parameter", action="append", help=text, **PARAMETER)
            group.add_argument("--field-seam", action="store_true", help="let it differ at u = 0 and u = 1")


def scene_of(options: Namespace) -> Scene:
    """Return the Scene of the options."""
    values = {field.name: getattr(options, field.name) for field in fields(Scene) if field.name in options}
    if "lights" in values:
        values["lights"] = [Light(light[:3], light[3:] or (1.0, 1.0, 1.0)) for light in values["lights"]]
    scene = Scene.from_file(options.scene) if "scene" in options else Scene()
    seam, parameters = getattr(options, "field_seam", False), getattr(options, "field_parameter", [])
    if "field_expression" not in options:
        for name, given in (("seam", seam), ("parameter", parameters)):
            if given:
                raise not_allowed(f"field-{name}", given, "given with --field-expression")
        return replace(scene, **values)
    record = {"expression": options.field_expression, "seam": seam, "parameters": dict(parameters)}
    if len(record["parameters"]) < len(parameters):
        raise not_allowed("field-parameter", parameters, "each name once")
    name = f"own_{hashlib.sha256(options.field_expression.encode()).hexdigest()[:6]}"
    try:
        return replace(scene, **values, field=field_from_record({"name": name} | record))
    except ValueError as error:  # in the words of Python, and by a name that nobody gave
        told = str(error).replace("seam=True", "--field-seam").replace(repr(name), "--field-expression")
        told = re.sub("^(field.)?parameters?", "field-parameter", told)
        raise ValueError(re.sub("^(expression|field = --field-expression)", "field-expression", told)) from None


def size_of(options: Namespace, size: int) -> tuple[int, int]:
    """Return (width, height): `size` where --width and --height are not given."""
    width, height = (size if side is None else side for side in (options.width, options.height))
    return width, height


def method_of(options: Namespace) -> GradientMethod:
    """Return the gradient method."""
    eps = 1e-3 if options.eps is None and options.gradient != "exact" else options.eps
    return warned(GradientMethod(options.gradient, eps))


def progress_bar(**options: Any) -> Callable:
    """Return a function that adds a bar on stderr to an iterable, if that is a terminal and takes more than a second.

    Without tqdm the terminal shows the description alone.
    """
    is_shown = bool(sys.stderr and sys.stderr.isatty())
    try:
        from tqdm import tqdm
    except ImportError:
        if is_shown:
            print(f"{options['desc']} …", file=sys.stderr)
        return lambda iterable, **_: iterable
    return partial(tqdm, delay=1.0, disable=not is_shown, leave=False, **options)
