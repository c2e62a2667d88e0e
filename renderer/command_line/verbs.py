"""The command line: image (one picture), views (all of them), sweep (the table of eps), doctor (what draws here)."""

import os
import re
import sys
import warnings
from argparse import Namespace, RawDescriptionHelpFormatter
from collections.abc import Sequence
from dataclasses import fields
from inspect import cleandoc
from pathlib import Path

import renderer
from renderer.checks import check_choice, extra, not_allowed
from renderer.command_line.options import (
    OF_IMAGE,
    OF_SWEEP,
    OF_VIEWS,
    OneLineParser,
    add_scene,
    method_of,
    progress_bar,
    scene_of,
    size_of,
)
from renderer.command_line.signals import first_signal_stops, say_stopped
from renderer.files import pictures as files, record
from renderer.machines import machine
from renderer.picture import views
from renderer.picture.drawing import render
from renderer.picture.stream import stream
from renderer.scene.methods import DIFFERENCES
from renderer.scene.raster import Raster
from renderer.scene.scene import Scene
from renderer.shader.numbers import Shot
from renderer.threads import checked_threads
from renderer.whole_files import checked_target, named

PIPE = "-"
OF_FIELD = "field_expression", "field_parameter", "field_seam"
OF_RASTER = ("size", "width", "height", "crop", "samples", "gradient", "eps")  # of a picture's record, beside its scene


def draw_image(options: Namespace) -> None:
    """Draw one picture, whole in memory or streamed to a file."""
    target = _checked_out(options.out)
    files.check_linear(options.linear, target)
    bounds = None if options.bounds is None else checked_target(options.bounds, (".npz",), "bounds")
    if bounds and bounds.resolve() == target.resolve():
        raise not_allowed("bounds", options.bounds, "another file than --out")
    if options.again is not None:
        shot = _drawn_again(options)
    else:
        raster = Raster(*size_of(options, options.size), options.crop)
        shot = Shot(scene_of(options), method_of(options), raster, options.samples)
    picture = shot.scene, shot.raster.width, shot.raster.height
    by, suffix = options.by or (), target.suffix.lower()
    if len(by) > 1 and suffix != ".npz":
        raise not_allowed("by", ",".join(by), "several numbers for a .npz, one for another file")
    more = {"gradient": shot.method, "crop": shot.raster.crop, "threads": options.threads}
    more |= {"samples": shot.samples, "derivatives": by}
    if suffix == ".npy":
        if bounds:
            raise not_allowed("bounds", options.bounds, "no --out that is drawn in bands")
        height, width = stream(*picture, target, **more, progress=progress_bar(desc=target.name, unit="band"))
    else:
        frame = render(*picture, **more, bounds=bounds is not None)
        height, width = frame.raster.shape
        shown = None
        if by and suffix != ".npz":
            (slope,) = frame.derivatives.values()
            shown = slope.astype(options.linear) if options.linear else views.derivative_view(slope, *by)
        if options.out == PIPE:
            sys.stdout.buffer.write(frame.to_png() if shown is None else files.png_of(shown))
        elif shown is None:
            frame.save(target, options.linear)
        else:
            (files.write_tiff if suffix in files.TIFF else files.write_png)(target, shown)
    told = sys.stderr if options.out == PIPE else sys.stdout
    print(f"wrote {target}: {width} x {height} pixels", file=told)
    if bounds:
        files.write_npz(bounds, {"bounds": frame.bounds, "open": frame.open} | frame.slope_arrays())
        largest, opened = frame.bounds.max(), frame.open.sum()
        print(f"wrote {bounds}: no colour is more than {largest:.2g} off, {opened} pixels are open", file=told)


def _drawn_again(options):
    """Return the Shot of a picture's file; say where another version or machine drew it."""
    beside = vars(options).keys() & {"scene", *OF_FIELD, *(field.name for field in fields(Scene))}
    beside |= {n for n in OF_RASTER if str(getattr(options, n)) != str(OF_IMAGE[f"--{n}"].get("default"))}
    if beside:
        raise not_allowed("again", options.again, f"no --{min(beside).replace('_', '-')} beside it")
    shot, version, drawn_by = record.read(options.again)
    for name, then, now in (("version", version, renderer.__version__), ("machine", drawn_by, machine().NAME)):
        if then != now:
            print(f"{options.again} was drawn by {name} {then}; this is {now}", file=sys.stderr)
    return shot


def _checked_out(out):
    """Return the Path that is written to; it is PIPE for standard output, which may not be a terminal."""
    if out != PIPE:
        return checked_target(out, files.PICTURE_SUFFIXES)
    if sys.stdout is None or sys.stdout.isatty():  # it was closed, or is one
        raise not_allowed("out", out, "a file, or standard output that is no terminal")
    return Path(out)


def draw_views(options: Namespace) -> None:
    """Draw both pipelines, their difference, and what is known of the exact one."""
    scene, size, method = scene_of(options), size_of(options, options.size), method_of(options)
    check_choice("gradient", method.name, DIFFERENCES)
    views.difference_linear(0.0, options.gain)
    with extra("plot"):
        import matplotlib  # noqa: F401  # that it is missing is said before anything is drawn
    folder = named("out", options.out)
    symbolic = render(scene, *size, threads=options.threads)
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
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise not_allowed("out", str(folder), str(error.strerror)) from None
    for name, picture in pictures.items():
        files.write_png(checked_target(folder / f"{name}.png", (".png",)), picture)
    print(f"wrote {folder}: {', '.join(f'{name}.png' for name in pictures)}")


def print_sweep(options: Namespace) -> None:
    """Print the table of eps: a difference against the exact gradient, step by step.

    Lists of values, such as --field sine,ridges --beta 0.1,0.35 --size 256,1024, make a grid of frames, a line each,
    computed by several workers.
    """
    from renderer.command_line import sweep_verb  # its imports would make the start of a picture longer

    sweep_verb.print_sweep(options)


def diagnose(options: Namespace) -> None:
    """Say what draws here: machine, lanes, threads, versions, and where compiled code is kept."""
    from renderer.command_line import doctor

    for name, value in doctor.report():
        print(f"{name + ' ':.<24} {value}")


VERBS: dict[str, tuple] = {
    "image": (draw_image, OF_IMAGE),
    "views": (draw_views, OF_VIEWS),
    "sweep": (print_sweep, OF_SWEEP),
    "doctor": (diagnose, {}),
}
EXAMPLES = {
    "image": """examples:
  %(prog)s --out bump.png
  %(prog)s --again bump.png --out again.png
  %(prog)s --field-expression "max(0, sin(8*pi*u)*sin(4*pi*v) - 1/2)" --beta 0.1 --out golf.png
  %(prog)s --field-expression "a*sin(8*pi*u)" --field-parameter a=0.3 --by a --out slope.png""",
    "views": """example:
  %(prog)s --field sine --eps 1e-2 --out views""",
    "sweep": """examples:
  %(prog)s --field sine --eps 1e-2 1e-4 --no-facts
  %(prog)s --field sine,ridges --beta 0.1,0.35 --size 64,128 --checkpoint kept.jsonl --csv table.csv""",
    "doctor": None,
}


def _parser(prog, arguments):
    """Return the parser of all verbs. Options take time: those of verbs that the arguments do not name are left out."""
    parser = OneLineParser(prog=prog, description=__doc__)
    version = f"%(prog)s {renderer.__version__}"
    parser.add_argument("--version", action="version", version=version, help="say the version, and end")
    verbs = parser.add_subparsers(dest="verb", required=True, metavar="|".join(VERBS))
    for name, (run, verb_options) in VERBS.items():
        told = cleandoc(str(run.__doc__))
        shown = {"description": told, "epilog": EXAMPLES[name], "formatter_class": RawDescriptionHelpFormatter}
        verb = verbs.add_parser(name, help=told.splitlines()[0], **shown)
        if verb_options and name in arguments:
            for option, of_argparse in verb_options.items():
                verb.add_argument(option, **of_argparse)
            add_scene(verb, lists=run is print_sweep)
    return parser


def main(arguments: Sequence[str] | None = None, prog: str = "symbolic-rendering") -> int:
    """Run the command line and return its exit status: 0; 2 with one line on stderr about the error;
    130 with one line after Ctrl-C, 143 after SIGTERM.

    prog: the command's name, with which usage and errors begin.
    """
    for pipe in (sys.stdout, sys.stderr):
        if hasattr(pipe, "reconfigure"):
            pipe.reconfigure(errors="backslashreplace")  # a letter that a terminal lacks is no reason to fail
    arguments = sys.argv[1:] if arguments is None else arguments
    options = _parser(prog, arguments).parse_args(arguments)
    prog = f"{prog} {options.verb}"
    try:
        if options.verb != "doctor":
            checked_threads(options.threads)
            if machine().NAME == "numpy":
                told = "NumPy draws, the same but slowly, since llvmlite is not installed (or too old)"
                print(f"{prog}: {told}", file=sys.stderr)
        with warnings.catch_warnings(), first_signal_stops():
            warnings.showwarning = lambda told, *place: print(f"{prog}: warning: {told}", file=sys.stderr)
            VERBS[options.verb][0](options)
        print(end="", flush=True)  # where there is a standard output
    except BrokenPipeError:  # the reader closed the pipe; Python would complain again at its end
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 141
    except (ValueError, OSError, MemoryError, ModuleNotFoundError) as error:
        # A number of --by by that name, and not by the argument's in Python.
        print(f"{prog}: error:", re.sub("^derivatives", "by", str(error)), file=sys.stderr)
        return 2
    except KeyboardInterrupt as stop:
        return say_stopped(prog, stop)
    return 0
