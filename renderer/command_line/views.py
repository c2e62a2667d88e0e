"""Draw both pipelines, their difference, and what is known of the exact one."""

from argparse import Namespace
from pathlib import Path

from renderer import files, views
from renderer.checks import not_allowed
from renderer.command_line.options import GRADIENT, NUMBER, RASTER, method_of, scene_of, size_of
from renderer.drawing import render
from renderer.sweep import Task

OPTIONS = {
    "--out": {"required": True, "metavar": "FOLDER", "help": "the folder to write to; it is made if need be"},
    "--gain": NUMBER | {"default": 100.0, "help": "of the linear map (default: 100)"},
    **GRADIENT,
    "--gradient": GRADIENT["--gradient"] | {"default": "central"},
    **RASTER,
}


def run(options: Namespace) -> None:
    """Draw and write."""
    scene, size, method = scene_of(options), size_of(options), method_of(options)
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
        files.write_png(files.checked_target(folder / f"{name}.png", (".png",)), picture)
    print(f"wrote {folder}: {', '.join(f'{name}.png' for name in pictures)}")
