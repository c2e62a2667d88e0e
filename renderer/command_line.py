"""The command line: image (one picture), views (all of them), sweep (the ε-table)."""

import argparse
import dataclasses
import re
import sys
from pathlib import Path

from renderer import files, views
from renderer.facts import facts
from renderer.kernels import FIELDS
from renderer.methods import METHODS, GradientMethod, exact
from renderer.raster import Raster
from renderer.render import render
from renderer.scene import MODELS, Light, Scene
from renderer.sweep import DECADES, sweep, table, write_csv
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


class OneLineParser(argparse.ArgumentParser):
    """A parser that says what is wrong in one line, and takes -1e-3 and -6,2,8 for values, not for options."""

    def __init__(self, *arguments, **options):
        super().__init__(*arguments, **options)
        self._negative_number_matcher = re.compile(r"-(\d|\.|inf|nan)")  # argparse's own knows no exponent and no list

    def error(self, message):
        self.exit(2, f"{self.prog}: error: {message}\n")


def _number(text):
    try:
        return float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not allowed: a number") from None


def _whole(text):
    try:
        return int(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not allowed: a whole number") from None


def _light(text):
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


def _crop(text):
    try:
        left, top, width, height = (int(item) for item in text.split(","))
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not allowed: LEFT,TOP,WIDTH,HEIGHT") from None
    return left, top, width, height


def _add_scene(parser):
    group = parser.add_argument_group("scene (defaults are the chapter's)")
    default = Scene()
    group.add_argument(
        "--field", default=default.field, help=f"height field: {', '.join(FIELDS)} (default: {default.field})"
    )
    group.add_argument(
        "--model", default=default.model, help=f"shading model: {', '.join(MODELS)} (default: {default.model})"
    )
    for name, what in NUMBERS.items():
        value = getattr(default, name)
        option = "--" + name.replace("_", "-")
        group.add_argument(
            option, dest=name, type=_number, default=value, help=f"{what} (default: {value:g})", metavar="X"
        )
    group.add_argument("--no-ball", dest="ball", action="store_false", help="leave sphere B out")
    group.add_argument("--no-floor", dest="floor", action="store_false", help="leave the floor out")
    group.add_argument(
        "--light", dest="lights", type=_light, action="append", metavar="X,Y,Z[,R,G,B]",
        help="a light, in place of the default two; repeat it for more, at most five",
    )  # fmt: skip


def _add_raster(parser):
    group = parser.add_argument_group("raster")
    group.add_argument("--size", type=_whole, default=256, metavar="N", help="width and height (default: 256)")
    group.add_argument("--width", type=_whole, metavar="N", help="width, if it is not --size")
    group.add_argument("--height", type=_whole, metavar="N", help="height, if it is not --size")
    group.add_argument("--threads", type=_whole, metavar="N", help="threads (default: all cores)")


def _add_gradient(parser, default):
    parser.add_argument("--gradient", default=default, help=f"{', '.join(METHODS)} (default: {default})")
    parser.add_argument("--eps", type=_number, default=1e-3, metavar="X", help="step of a difference (default: 1e-3)")


def build_parser():
    """Return the argument parser."""
    parser = OneLineParser(prog="python -m renderer", description=__doc__)
    verbs = parser.add_subparsers(dest="verb", required=True, metavar="image|views|sweep")
    image = verbs.add_parser("image", help="draw one picture", description="Draw one picture.")
    image.add_argument("--out", required=True, metavar="FILE", help="a .png, or a .npz with every buffer")
    image.add_argument("--crop", type=_crop, metavar="L,T,W,H", help="draw this part of the raster alone")
    _add_gradient(image, "exact")
    several = verbs.add_parser("views", help="draw every view", description="Draw both pipelines and their difference.")
    several.add_argument("--out", required=True, metavar="FOLDER", help="the folder to write to; it is made if need be")
    several.add_argument(
        "--gain", type=_number, default=100.0, metavar="X", help="of the linear difference (default: 100)"
    )
    _add_gradient(several, "central")
    epsilons = verbs.add_parser("sweep", help="print the table of eps", description="Print the table of eps.")
    epsilons.add_argument(
        "--eps", type=_number, nargs="+", default=list(DECADES), metavar="X", help="steps (default: 1e-1 … 1e-6)"
    )
    epsilons.add_argument("--gradient", default="central", help="forward, central, central4 (default: central)")
    epsilons.add_argument("--csv", metavar="FILE", help="write the table to a .csv too")
    epsilons.add_argument("--no-facts", dest="facts", action="store_false", help="print the table alone")
    for verb in (image, several, epsilons):
        _add_raster(verb)
        _add_scene(verb)
    return parser


def _scene(options):
    names = {f.name for f in dataclasses.fields(Scene)} & set(vars(options))
    chosen = {name: getattr(options, name) for name in names}
    if chosen["lights"] is None:
        del chosen["lights"]
    return Scene(**chosen)


def _size(options):
    width = options.size if options.width is None else options.width
    height = options.size if options.height is None else options.height
    checked_threads(options.threads)
    return width, height


def _method(options):
    is_exact = options.gradient == "exact"
    difference = GradientMethod("central" if is_exact else options.gradient, options.eps)  # a bad step is never let by
    return exact() if is_exact else difference


def _image(options):
    target = files.checked_target(options.out, files.PICTURE_SUFFIXES)
    scene, size = _scene(options), _size(options)
    frame = render(scene, *size, _method(options), crop=options.crop, threads=options.threads)
    if target.suffix == ".npz":
        files.write_npz(target, frame)
    else:
        files.write_png(target, views.image_view(frame))
    print(f"wrote {target}: {frame.raster.shape[1]} x {frame.raster.shape[0]} pixels")


def _views(options):
    scene, size, method = _scene(options), _size(options), _method(options)
    if method.name == "exact":
        raise ValueError("gradient = 'exact' is not allowed: views compare a difference with the exact gradient")
    Raster(*size)
    views.difference_linear(0.0, options.gain)
    folder = Path(options.out)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ValueError(f"out = {options.out!r} is not allowed: {error.strerror}") from None
    symbolic = render(scene, *size, exact(), threads=options.threads)
    numeric = render(scene, *size, method, threads=options.threads, stage=symbolic.stage)
    delta = numeric.rgb - symbolic.rgb
    pictures = {
        "numeric": views.image_view(numeric),
        "symbolic": views.image_view(symbolic),
        "slope": views.slope_view(symbolic),
        "kink": views.kink_view(symbolic),
        "difference_linear": views.difference_linear(delta, options.gain),
        "difference_logarithmic": views.with_colour_bar(views.difference_logarithmic(delta)),
    }
    for name, picture in pictures.items():
        files.write_png(files.checked_target(folder / f"{name}.png", (".png",)), picture)
    print(f"wrote {folder}: {', '.join(f'{name}.png' for name in pictures)}")


def _sweep(options):
    from tqdm import tqdm

    target = files.checked_target(options.csv, (".csv",), "csv") if options.csv else None
    scene, size = _scene(options), _size(options)
    if options.gradient == "exact":
        raise ValueError("gradient = 'exact' is not allowed: one of 'forward', 'central', 'central4'")
    for eps in options.eps:
        GradientMethod(options.gradient, eps)

    def progress(steps):
        return tqdm(steps, desc="eps", delay=1.0, disable=not sys.stderr.isatty(), leave=False)

    rows = sweep(scene, *size, options.eps, options.gradient, options.threads, progress)
    print(
        f"{scene.field}, {scene.model}, {size[0]} x {size[1]}: {options.gradient} difference against the exact gradient"
    )
    print(table(rows))
    if target:
        write_csv(target, rows)
        print(f"wrote {target}")
    if options.facts:
        print()
        for what, value in facts(scene, *size):
            print(f"{what + ' ':.<60} {value}")


def main(arguments=None):
    """Run the command line and return its exit status: 0, or 2 with one line on stderr about what is not allowed."""
    options = build_parser().parse_args(arguments)
    try:
        {"image": _image, "views": _views, "sweep": _sweep}[options.verb](options)
    except (ValueError, OSError, MemoryError) as error:
        print(f"python -m renderer {options.verb}: error: {error}", file=sys.stderr)
        return 2
    return 0
