"""image: one picture, whole in memory or streamed to a file."""

from renderer import files, views
from renderer.command_line.options import (
    add_gradient,
    add_raster,
    add_scene,
    crop,
    method_of,
    progress_bar,
    scene_of,
    size_of,
)
from renderer.drawing import render
from renderer.stream import STREAM_SUFFIXES, stream

OUT = "a .png; a .npz with every buffer; of any size, drawn in bands: a .npy (float64) or a tiled .tif"


def add(verbs):
    """Add the verb's parser."""
    parser = verbs.add_parser("image", help="draw one picture", description="Draw one picture.")
    parser.add_argument("--out", required=True, metavar="FILE", help=OUT)
    parser.add_argument("--crop", type=crop, metavar="L,T,W,H", help="draw this part of the raster alone")
    add_gradient(parser, "exact")
    add_raster(parser)
    add_scene(parser)


def run(options):
    """Draw and write."""
    target = files.checked_target(options.out, (*files.PICTURE_SUFFIXES, *STREAM_SUFFIXES))
    scene, size, method = scene_of(options), size_of(options), method_of(options)
    if target.suffix in STREAM_SUFFIXES:

        def progress(blocks):
            return progress_bar(blocks, desc=target.name, unit="block")

        height, width = stream(scene, *size, target, method, options.crop, options.threads, progress)
    else:
        frame = render(scene, *size, method, crop=options.crop, threads=options.threads)
        height, width = frame.raster.shape
        if target.suffix == ".npz":
            files.write_npz(target, frame)
        else:
            files.write_png(target, views.image_view(frame))
    print(f"wrote {target}: {width} x {height} pixels")
