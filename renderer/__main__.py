"""Draw from the command line:  python -m renderer image|views|sweep|doctor --help"""

import signal
import sys

from renderer.command_line.signals import first_signal_stops, say_stopped


def main(prog: str = "symbolic-rendering") -> int:
    """Run the command line and return its exit status, of a process that ends with it.

    prog: the command's name. The imports are a part of the work: Ctrl-C stops them in the same words. Nothing breaks
    off Python's own end after it.
    """
    try:
        with first_signal_stops():
            from renderer.command_line.verbs import main as run

            return run(prog=prog)
    except KeyboardInterrupt as stop:
        return say_stopped(prog, stop)
    finally:
        signal.signal(signal.SIGINT, signal.SIG_IGN)


if __name__ == "__main__":  # a worker process imports this file too
    sys.exit(main("python -m renderer"))
