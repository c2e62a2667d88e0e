"""Print the table of eps: a difference against the exact gradient, step by step.

Lists of values, such as --field sine,ridges --beta 0.1,0.35 --size 256,1024, make a grid of frames, a line each,
computed by several workers.
"""

from argparse import Namespace
from concurrent.futures import BrokenExecutor, CancelledError

from renderer import grid
from renderer.checkpoint import Checkpoint
from renderer.command_line.options import NAME, NUMBER, RASTER, WHOLE, progress_bar, scene_of, several, size_of
from renderer.command_line.workers import executor_of
from renderer.facts import facts
from renderer.files import checked_target
from renderer.methods import DIFFERENCES
from renderer.sweep import DECADES, MOVE_NO_BOUNDARY, compared, table, write_csv

OPTIONS = {
    "--eps": several(NUMBER) | {"nargs": "+", "default": [DECADES], "help": "steps (default: 1e-1 … 1e-6)"},
    "--gradient": several(NAME) | {"default": "central", "help": f"{', '.join(DIFFERENCES)} (default: central)"},
    "--csv": {"metavar": "FILE", "help": "write the table to a .csv too"},
    "--no-facts": {"action": "store_true", "help": "print the table alone"},
    "--checkpoint": {"metavar": "FILE", "help": "a .jsonl that keeps every result: a killed sweep goes on from it"},
    "--executor": {"choices": ("threads", "processes"), "help": "workers here, of a grid (default: threads)"},
    "--workers": WHOLE | {"help": "how many of them (default: all cores), each --threads 1, unless you say"},
    "--dask": {"metavar": "ADDRESS", "help": "workers of the Dask scheduler there, such as tcp://host:8786"},
    **RASTER,
    "--size": several(RASTER["--size"]),
}


def run(options: Namespace) -> None:
    """Compute, print, and write."""
    target = checked_target(options.csv, (".csv",), "csv") if options.csv else None
    lists = {name: vars(options).pop(name) for name in MOVE_NO_BOUNDARY if name in options}
    sizes = [size_of(options, size) for size in options.size]
    steps = [step for steps in options.eps for step in steps]
    tasks = grid.grid(scene_of(options), sizes, options.gradient, steps, **lists)
    asked = (options.checkpoint, options.executor, options.workers, options.dask)
    of_one = len(tasks) == len(set(steps)) and asked == (None,) * len(asked)
    if of_one:
        scene, method, width, height = vars(tasks[0]).values()
        results = list(compared(progress_bar(desc="eps")(tasks), options.threads))
        print(f"{scene.field}, {scene.model}, {width} x {height}: {method.name} difference against the exact gradient")
    else:
        results = _results(tasks, options)
    print(table(results))
    if target:
        write_csv(target, results)
        print(f"wrote {target}")
    if of_one and not options.no_facts:
        print()
        for what, value in facts(scene, width, height):
            print(f"{what + ' ':.<60} {value}")


def _results(tasks, options):
    """Return the {Task: SweepRow} of a grid of frames, by workers."""
    checkpoint = Checkpoint(options.checkpoint) if options.checkpoint else None

    def kept():
        if checkpoint is None:
            return "nothing is kept without --checkpoint"
        done = f"{len(checkpoint.kept(tasks))} of {len(tasks)} frames are in {checkpoint.path}"
        return f"{done}, and the same command goes on from there"

    try:
        with executor_of(options) as executor:
            progress = progress_bar(desc="frames", total=len(tasks), unit="frame")
            return grid.run(tasks, executor, checkpoint, options.threads or 1, progress)
    except KeyboardInterrupt:
        raise KeyboardInterrupt(kept()) from None
    except (BrokenExecutor, CancelledError):
        raise OSError(f"the workers are gone; {kept()}") from None
