"""views: every picture of both pipelines, and of their difference."""

from pathlib import Path

from renderer import files, views
from renderer.command_line.options import add_gradient, add_raster, add_scene, method_of, number, scene_of, size_of
from renderer.drawing import render
from renderer.methods import exact
from renderer.raster import Raster


def add(verbs):
    """Add the verb's parser."""
    parser = verbs.add_parser("views", help="draw every view", description="Draw both pipelines and their difference.")
    parser.add_argument("--out", required=True, metavar="FOLDER", help="the folder to write to; it is made if need be")
    parser.add_argument("--gain", type=number, default=100.0, metavar="X", help="of the linear map (default: 100)")
    add_gradient(parser, "central")
    add_raster(parser)
    add_scene(parser)


def run(options):
    """Draw and write."""
    scene, size, method = scene_of(options), size_of(options), method_of(options)
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
