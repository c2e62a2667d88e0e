"""Draw from the command line:  python -m renderer image|views|sweep|doctor --help"""

import sys

from renderer.command_line.verbs import main

if __name__ == "__main__":  # a worker process imports this file too
    sys.exit(main(prog="python -m renderer"))
