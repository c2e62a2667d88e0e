"""What the verbs share: values, lists of values, and the options of scene, raster and gradient."""

import argparse
import dataclasses
import re
import sys

from renderer.kernels import FIELDS
from renderer.methods import METHODS, GradientMethod, exact
from renderer.scene import MODELS, Light, Scene
from renderer.threads import checked_threads

NUMBERS = {
    "ku": "wave number in u",
    "kv": "wave number in v",
    "beta": "bump amplitude",
    "shininess": "exponent of the highlight",
    "radius": "radius of sphere A",
    "eye": "height of the eye",
    "ball_radius": "radius of sphere B",
    "ka": "ambient weight",
    "kd": "diffuse weight",
    "ks": "specular weight",
    "floor_tint": "how much red and green the floor lacks",
}


DEFAULT_SIZE = 256
LISTED = ("field", "ku", "kv", "beta")  # of which a sweep takes lists


class OneLineParser(argparse.ArgumentParser):
    """A parser that says what is wrong in one line, and takes -1e-3 and -6,2,8 for values, not for options."""

    def __init__(self, *arguments, **options):
        super().__init__(*arguments, **options)
        self._negative_number_matcher = re.compile(r"-(\d|\.|inf|nan)")  # argparse's own knows no exponent and no list

    def error(self, message):
        self.exit(2, f"{self.prog}: error: {message}\n")


def number(text):
    """Return a float."""
    try:
        return float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not allowed: a number") from None


def whole(text):
    """Return an int."""
    try:
        return int(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not allowed: a whole number") from None


def several(kind):
    """Return what reads "a,b,c" as a list of `kind`."""
    return lambda text: [kind(item) for item in text.split(",")]


def light(text):
    """Return a Light from "x,y,z" or "x,y,z,r,g,b"."""
    try:
        numbers = [float(item) for item in text.split(",")]
        if len(numbers) not in (3, 6):
            raise ValueError
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not allowed: X,Y,Z or X,Y,Z,R,G,B") from None
    try:
        return Light(tuple(numbers[:3]), tuple(numbers[3:]) or (1.0, 1.0, 1.0))
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def crop(text):
    """Return the four whole numbers of a crop."""
    try:
        left, top, width, height = (int(item) for item in text.split(","))
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not allowed: LEFT,TOP,WIDTH,HEIGHT") from None
    return left, top, width, height


def add_scene(parser, lists=False):
    """Add the scene's options; with `lists`, those of LISTED take several values."""
    group = parser.add_argument_group("scene (defaults are the chapter's)")
    default = Scene()

    def add(name, kind, metavar, what, shown):
        value, many = getattr(default, name), lists and name in LISTED
        group.add_argument(
            "--" + name.replace("_", "-"),
            dest=name,
            type=several(kind) if many else kind,
            default=[value] if many else value,
            metavar=f"{metavar}[,{metavar}…]" if many else metavar,
            help=f"{what} (default: {shown.format(value)})",
        )

    add("field", str, "FIELD", f"height field: {', '.join(FIELDS)}", "{}")
    add("model", str, "MODEL", f"shading model: {', '.join(MODELS)}", "{}")
    for name, what in NUMBERS.items():
        add(name, number, "X", what, "{:g}")
    group.add_argument("--no-ball", dest="ball", action="store_false", help="leave sphere B out")
    group.add_argument("--no-floor", dest="floor", action="store_false", help="leave the floor out")
    group.add_argument(
        "--light", dest="lights", type=light, action="append", metavar="X,Y,Z[,R,G,B]",
        help="a light, in place of the default two; repeat it for more, at most five",
    )  # fmt: skip


def add_raster(parser, lists=False):
    """Add the raster's options; with `lists`, --size takes several values."""
    group = parser.add_argument_group("raster")
    if lists:
        size = {"type": several(whole), "default": [DEFAULT_SIZE], "metavar": "N[,N…]"}
    else:
        size = {"type": whole, "default": DEFAULT_SIZE, "metavar": "N"}
    group.add_argument("--size", help=f"width and height (default: {DEFAULT_SIZE})", **size)
    group.add_argument("--width", type=whole, metavar="N", help="width, if it is not --size")
    group.add_argument("--height", type=whole, metavar="N", help="height, if it is not --size")
    group.add_argument("--threads", type=whole, metavar="N", help="threads for a frame (default: all cores)")


def add_gradient(parser, default):
    """Add the options of one gradient method."""
    parser.add_argument("--gradient", default=default, help=f"{', '.join(METHODS)} (default: {default})")
    parser.add_argument("--eps", type=number, default=1e-3, metavar="X", help="step of a difference (default: 1e-3)")


def scene_of(options, **values):
    """Return the Scene of the options, with `values` in place of the options of that name."""
    names = {f.name for f in dataclasses.fields(Scene)} & set(vars(options))
    chosen = {name: getattr(options, name) for name in names} | values
    if chosen["lights"] is None:
        del chosen["lights"]
    return Scene(**chosen)


def size_of(options, size=None):
    """Return (width, height), from --size or from `size` where --width and --height are not given."""
    size = options.size if size is None else size
    checked_threads(options.threads)
    return (size if options.width is None else options.width, size if options.height is None else options.height)


def method_of(options):
    """Return the gradient method."""
    is_exact = options.gradient == "exact"
    difference = GradientMethod("central" if is_exact else options.gradient, options.eps)  # a bad step is never let by
    return exact() if is_exact else difference


def progress_bar(iterable, **options):
    """Return the iterable with a progress bar on stderr, where that is a terminal, if it takes more than a second."""
    from tqdm import tqdm

    return tqdm(iterable, delay=1.0, disable=not sys.stderr.isatty(), leave=False, **options)
