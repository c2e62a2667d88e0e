"""Draw one picture, whole in memory or streamed to a file."""

from argparse import Namespace

from renderer import files, views
from renderer.command_line.options import CROP, GRADIENT, RASTER, method_of, progress_bar, scene_of, size_of
from renderer.drawing import render
from renderer.stream import STREAM_SUFFIXES, stream

OUT = "a .png; a .npz with every buffer; of any size, drawn in bands: a .npy (float64) or a tiled .tif"
OPTIONS = {
    "--out": {"required": True, "metavar": "FILE", "help": OUT},
    "--crop": CROP | {"help": "draw this part of the raster alone"},
    **GRADIENT,
    **RASTER,
}


def run(options: Namespace) -> None:
    """Draw and write."""
    target = files.checked_target(options.out, (*files.PICTURE_SUFFIXES, *STREAM_SUFFIXES))
    picture = scene_of(options), *size_of(options)
    more = {"gradient": method_of(options), "crop": options.crop, "threads": options.threads}
    if target.suffix in STREAM_SUFFIXES:
        height, width = stream(*picture, target, **more, progress=progress_bar(desc=target.name, unit="block"))
    else:
        frame = render(*picture, **more)
        height, width = frame.raster.shape
        if target.suffix == ".npz":
            files.write_npz(target, frame)
        else:
            files.write_png(target, views.image_view(frame))
    print(f"wrote {target}: {width} x {height} pixels")
