"""The command line: image (one picture), views (all of them), sweep (the ε-table, or a grid of frames)."""

import sys
from collections.abc import Sequence

from renderer.command_line import image, sweep, views
from renderer.command_line.options import OneLineParser, add_scene
from renderer.machines import machine
from renderer.threads import checked_threads

VERBS = {"image": image, "views": views, "sweep": sweep}


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit status: 0; 2 with one line on stderr about what is not allowed;
    130 with one line after Ctrl-C."""
    parser = OneLineParser(prog="python -m renderer", description=__doc__)
    verbs = parser.add_subparsers(dest="verb", required=True, metavar="|".join(VERBS))
    for name, verb in VERBS.items():
        own = verbs.add_parser(name, help=str(verb.__doc__).splitlines()[0], description=verb.__doc__)
        for option, of_argparse in verb.OPTIONS.items():
            own.add_argument(option, **of_argparse)
        add_scene(own, lists=verb is sweep)
    options = parser.parse_args(arguments)
    prog = f"python -m renderer {options.verb}"
    if machine().NAME == "numpy":
        print(
            f"{prog}: NumPy draws, the same but slowly, since llvmlite is not installed (or too old)", file=sys.stderr
        )
    try:
        checked_threads(options.threads)
        VERBS[options.verb].run(options)
    except (ValueError, OSError, MemoryError, ModuleNotFoundError) as error:
        print(f"{prog}: error: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt as interrupt:
        print(": ".join([f"{prog}: interrupted", *map(str, interrupt.args)]), file=sys.stderr)
        return 130
    return 0
