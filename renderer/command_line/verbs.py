"""The command line: image (one picture), views (all of them), sweep (the ε-table, or a grid of frames)."""

import argparse
import logging
import re
import signal
import sys
import threading
from argparse import Namespace
from collections.abc import Callable, Collection, Sequence
from concurrent.futures import BrokenExecutor, CancelledError, ThreadPoolExecutor
from contextlib import contextmanager, nullcontext
from dataclasses import fields
from functools import partial
from pathlib import Path
from typing import Any, NoReturn

from renderer.checks import extra, not_allowed
from renderer.command_line import grid
from renderer.files import pictures as files
from renderer.files.stream import STREAM_SUFFIXES, stream
from renderer.machines import machine
from renderer.picture import views
from renderer.picture.drawing import render
from renderer.picture.facts import facts
from renderer.picture.sweep import DECADES, MOVE_NO_BOUNDARY, Task, compared, table, write_csv
from renderer.picture.threads import checked_threads
from renderer.scene.methods import DIFFERENCES, METHODS, GradientMethod, exact
from renderer.scene.scene import Light, Scene
from renderer.whole_files import checked_target

Option = dict[str, Any]  # what argparse is told of one


class OneLineParser(argparse.ArgumentParser):
    """A parser that says what is wrong in one line, and takes -1e-3 and -6,2,8 for values, not for options."""

    def __init__(self, *arguments: Any, **options: Any):
        super().__init__(*arguments, **options)
        self._negative_number_matcher = re.compile(r"-(\d|\.|inf|nan)")  # argparse's own knows no exponent and no list

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
    return one | {"type": lambda text: [read(item) for item in text.split(",")], "metavar": one["metavar"] + ",…"}


def numbers(kind: Callable[[str], Any], lengths: Collection[int], form: str, metavar: str) -> Option:
    """Return argparse's options for a tuple of numbers, "a,b,c", of one of the lengths."""

    def read(text):
        found = tuple(kind(item) for item in text.split(","))
        if len(found) not in lengths:
            raise ValueError
        return found

    return value(read, form, metavar)


NAME, WHOLE, NUMBER = value(str, "", "NAME"), value(int, "a whole number", "N"), value(float, "a number", "X")
TRIPLE = numbers(float, (3,), "X,Y,Z", "X,Y,Z")
LIGHT = numbers(float, (3, 6), "X,Y,Z or X,Y,Z,R,G,B", "X,Y,Z[,R,G,B]")
KINDS: dict[Any, Option] = {str: NAME, float: NUMBER, tuple: TRIPLE, bool: {"action": "store_false"}}
RASTER = {
    "--size": WHOLE | {"default": "256", "help": "width and height (default: %(default)s)"},
    "--width": WHOLE | {"help": "width, if it is not --size"},
    "--height": WHOLE | {"help": "height, if it is not --size"},
    "--threads": WHOLE | {"help": "threads for a frame (default: all cores)"},
}
GRADIENT = {
    "--gradient": NAME | {"default": "exact", "help": f"{', '.join(METHODS)} (default: %(default)s)"},
    "--eps": NUMBER | {"default": 1e-3, "help": "step of a difference (default: 1e-3)"},
}
OUT = "a .png; a .npz with every buffer; of any size, drawn in bands: a .npy (float64) or a tiled .tif"
OF_IMAGE: dict[str, Option] = {
    "--out": {"required": True, "metavar": "FILE", "help": OUT},
    "--bounds": {"metavar": "FILE", "help": "write how far off each colour is at most, and what is open, to a .npz"},
    "--crop": numbers(int, (4,), "LEFT,TOP,WIDTH,HEIGHT", "L,T,W,H") | {"help": "draw this part of the raster alone"},
    **GRADIENT,
    **RASTER,
}
OF_VIEWS = {
    "--out": {"required": True, "metavar": "FOLDER", "help": "the folder to write to; it is made if need be"},
    "--gain": NUMBER | {"default": 100.0, "help": "of the linear map (default: 100)"},
    **GRADIENT,
    "--gradient": GRADIENT["--gradient"] | {"default": "central"},
    **RASTER,
}
OF_SWEEP = {
    "--eps": several(NUMBER) | {"nargs": "+", "default": [DECADES], "help": "steps (default: 1e-1 … 1e-6)"},
    "--gradient": several(NAME) | {"default": "central", "help": f"{', '.join(DIFFERENCES)} (default: central)"},
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
    for field in fields(Scene):
        option, kind, what = field.name.replace("_", "-"), KINDS[field.type], field.metadata["help"]
        if field.name == "lights":
            option, kind = "light", LIGHT | {"action": "append"}
        elif field.type is bool:
            option = f"no-{option}"
        else:
            what += f" (default: {field.default})"
        if lists and field.name in MOVE_NO_BOUNDARY:
            kind = several(kind)
        group.add_argument(f"--{option}", dest=field.name, help=what, **kind)


def scene_of(options: Namespace) -> Scene:
    """Return the Scene of the options."""
    given = {field.name: getattr(options, field.name) for field in fields(Scene) if field.name in options}
    if "lights" in given:
        given["lights"] = [Light(light[:3], light[3:] or (1.0, 1.0, 1.0)) for light in given["lights"]]
    return Scene(**given)


def size_of(options: Namespace, size: int) -> tuple[int, int]:
    """Return (width, height): `size` where --width and --height are not given."""
    width, height = (size if side is None else side for side in (options.width, options.height))
    return width, height


def method_of(options: Namespace) -> GradientMethod:
    """Return the gradient method."""
    is_exact = options.gradient == "exact"
    difference = GradientMethod("central" if is_exact else options.gradient, options.eps)  # a bad step is never let by
    return exact() if is_exact else difference


def progress_bar(**options: Any) -> Callable:
    """Return what wraps an iterable with a bar on stderr, where that is a terminal, if it takes more than a second."""
    from tqdm import tqdm

    return partial(tqdm, delay=1.0, disable=not sys.stderr.isatty(), leave=False, **options)


def draw_image(options: Namespace) -> None:
    """Draw one picture, whole in memory or streamed to a file."""
    target = checked_target(options.out, (*files.PICTURE_SUFFIXES, *STREAM_SUFFIXES))
    bounds = checked_target(options.bounds, (".npz",), "bounds") if options.bounds else None
    picture = scene_of(options), *size_of(options, options.size)
    more = {"gradient": method_of(options), "crop": options.crop, "threads": options.threads}
    if target.suffix in STREAM_SUFFIXES:
        if bounds:
            raise not_allowed("bounds", options.bounds, "no --out that is drawn in bands")
        height, width = stream(*picture, target, **more, progress=progress_bar(desc=target.name, unit="block"))
    else:
        frame = render(*picture, **more, bounds=bounds is not None)
        height, width = frame.raster.shape
        if target.suffix == ".npz":
            files.write_npz(target, frame)
        else:
            files.write_png(target, views.image_view(frame))
    print(f"wrote {target}: {width} x {height} pixels")
    if bounds:
        files.write_bounds(bounds, frame)
        largest, opened = frame.bounds.max(), frame.open.sum()
        print(f"wrote {bounds}: no colour is more than {largest:.2g} off, {opened} pixels are open")


def draw_views(options: Namespace) -> None:
    """Draw both pipelines, their difference, and what is known of the exact one."""
    scene, size, method = scene_of(options), size_of(options, options.size), method_of(options)
    Task(scene, method, *size)  # which is of a difference
    views.difference_linear(0.0, options.gain)
    folder = Path(options.out)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise not_allowed("out", options.out, str(error.strerror)) from None
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
    for name, picture in pictures.items():
        files.write_png(checked_target(folder / f"{name}.png", (".png",)), picture)
    print(f"wrote {folder}: {', '.join(f'{name}.png' for name in pictures)}")


def print_sweep(options: Namespace) -> None:
    """Print the table of eps: a difference against the exact gradient, step by step.

    Lists of values, such as --field sine,ridges --beta 0.1,0.35 --size 256,1024, make a grid of frames, a line each,
    computed by several workers.
    """
    target = checked_target(options.csv, (".csv",), "csv") if options.csv else None
    lists = {name: vars(options).pop(name) for name in MOVE_NO_BOUNDARY if name in options}
    sizes = [size_of(options, size) for size in options.size]
    steps = [step for steps in options.eps for step in steps]
    tasks = grid.grid(scene_of(options), sizes, options.gradient, steps, **lists)
    of_one = len(tasks) == len(set(steps)) and {options.checkpoint, options.workers, options.dask} == {None}
    if of_one:
        scene, method, width, height = vars(tasks[0]).values()
        results = list(compared(progress_bar(desc="eps")(tasks), options.threads))
        print(f"{scene.field}, {scene.model}, {width} x {height}: {method.name} difference against the exact gradient")
    else:
        results = _of_grid(tasks, options)
    print(table(results))
    if target:
        write_csv(target, results)
        print(f"wrote {target}")
    if of_one and not options.no_facts:
        print()
        for what, found in facts(scene, width, height):
            print(f"{what + ' ':.<60} {found}")


def _of_grid(tasks, options):
    """Return the {Task: SweepRow} of a grid of frames, by workers."""
    with grid.Checkpoint(options.checkpoint) if options.checkpoint else nullcontext() as checkpoint:
        return _run_grid(tasks, options, checkpoint)


def _run_grid(tasks, options, checkpoint):
    """Return the same; where it cannot go on, the error says what the checkpoint keeps."""

    def kept():
        if checkpoint is None:
            return "nothing is kept without --checkpoint"
        done = f"{len(checkpoint.kept(tasks))} of {len(tasks)} frames are in {checkpoint.path}"
        return f"{done}, and the same command goes on from there"

    try:
        with _workers(options) as executor:
            progress = progress_bar(desc="frames", total=len(tasks), unit="frame")
            return grid.run(tasks, executor, checkpoint, options.threads or 1, progress)
    except KeyboardInterrupt as stop:
        raise type(stop)(kept()) from None
    except (BrokenExecutor, CancelledError):
        raise OSError(f"the workers are gone; {kept()}") from None


@contextmanager
def _workers(options):
    """Yield the executor that the options ask for: threads here, or a Dask cluster.

    What Dask would log is said in one line when it is the end of the sweep.
    """
    if options.dask is None:
        with ThreadPoolExecutor(checked_threads(options.workers, "workers")) as executor:
            yield executor
        return
    if options.workers is not None:
        raise not_allowed("dask", options.dask, "no --workers beside it")
    try:
        with extra("dask"):
            from distributed import Client, KilledWorker
        logging.getLogger("distributed.client").setLevel(logging.CRITICAL)
        client = Client(options.dask, timeout=10, set_as_default=False)
    except (ValueError, OSError) as error:
        raise not_allowed("dask", options.dask, f"the address of a scheduler that answers ({error})") from None
    with client:
        try:
            yield client.get_executor()
        except KilledWorker as error:
            raise BrokenExecutor from error


class Terminated(KeyboardInterrupt):
    """What SIGTERM does: the same as Ctrl-C, by its own name and exit status."""


@contextmanager
def _sigterm_stops():
    """Let SIGTERM stop what is done here as Ctrl-C does: nothing half-written is left behind."""
    here = threading.current_thread() is threading.main_thread()
    if not here or signal.getsignal(signal.SIGTERM) != signal.SIG_DFL:  # somebody else's to say
        yield
        return

    def stop(number, frame):
        signal.signal(signal.SIGTERM, signal.SIG_IGN)  # one is enough; the next would hinder the cleaning up
        raise Terminated

    signal.signal(signal.SIGTERM, stop)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, signal.SIG_DFL)


VERBS = {"image": (draw_image, OF_IMAGE), "views": (draw_views, OF_VIEWS), "sweep": (print_sweep, OF_SWEEP)}


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit status: 0; 2 with one line on stderr about what is not allowed;
    130 with one line after Ctrl-C, 143 after SIGTERM."""
    parser = OneLineParser(prog="python -m renderer", description=__doc__)
    verbs = parser.add_subparsers(dest="verb", required=True, metavar="|".join(VERBS))
    for name, (run, own) in VERBS.items():
        verb = verbs.add_parser(name, help=str(run.__doc__).splitlines()[0], description=run.__doc__)
        for option, of_argparse in own.items():
            verb.add_argument(option, **of_argparse)
        add_scene(verb, lists=run is print_sweep)
    options = parser.parse_args(arguments)
    prog = f"python -m renderer {options.verb}"
    if machine().NAME == "numpy":
        told = "NumPy draws, the same but slowly, since llvmlite is not installed (or too old)"
        print(f"{prog}: {told}", file=sys.stderr)
    try:
        checked_threads(options.threads)
        with _sigterm_stops():
            VERBS[options.verb][0](options)
    except (ValueError, OSError, MemoryError, ModuleNotFoundError) as error:
        print(f"{prog}: error: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt as stop:
        told, status = ("terminated", 143) if isinstance(stop, Terminated) else ("interrupted", 130)
        print(": ".join([f"{prog}: {told}", *map(str, stop.args)]), file=sys.stderr)
        return status
    return 0
