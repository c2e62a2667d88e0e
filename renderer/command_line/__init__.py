"""The command line: image (one picture), views (all of them), sweep (the ε-table, or a grid of frames)."""

import sys

from renderer.command_line import image, sweep, views
from renderer.command_line.options import OneLineParser

VERBS = {"image": image, "views": views, "sweep": sweep}


def build_parser():
    """Return the argument parser."""
    parser = OneLineParser(prog="python -m renderer", description=__doc__)
    verbs = parser.add_subparsers(dest="verb", required=True, metavar="|".join(VERBS))
    for verb in VERBS.values():
        verb.add(verbs)
    return parser


def main(arguments=None):
    """Run the command line and return its exit status: 0; 2 with one line on stderr about what is not allowed;
    130 with one line after Ctrl-C."""
    options = build_parser().parse_args(arguments)
    prog = f"python -m renderer {options.verb}"
    try:
        VERBS[options.verb].run(options)
    except (ValueError, OSError, MemoryError) as error:
        print(f"{prog}: error: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt as interrupt:
        print(": ".join([f"{prog}: interrupted", *map(str, interrupt.args)]), file=sys.stderr)
        return 130
    return 0
