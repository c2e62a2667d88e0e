"""Signals that stop a command, and its last line and exit status after one."""

import signal
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager


class Terminated(KeyboardInterrupt):
    """SIGTERM as an exception: it stops a command as Ctrl-C does, with another word and exit status."""


STOPS = {signal.SIGINT: (signal.default_int_handler, KeyboardInterrupt), signal.SIGTERM: (signal.SIG_DFL, Terminated)}


def disregard(number: int, frame: object) -> None:
    """Do nothing. Unlike SIG_IGN, Python takes it in its stride where a signal has come and not yet been looked at."""


@contextmanager
def first_signal_stops() -> Iterator[None]:
    """Let SIGTERM stop the block as Ctrl-C does: nothing half-written is left behind.

    The first of them is enough; the next would hinder the cleaning up, and is ignored.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    usual = {number: before for number, (before, _) in STOPS.items() if signal.getsignal(number) == before}

    def stop(number, frame):
        for other in usual:
            signal.signal(other, disregard)
        raise STOPS[number][1]

    try:
        for number in usual:  # others are somebody else's to say
            signal.signal(number, stop)
        yield
    finally:
        for number, before in usual.items():
            signal.signal(number, before)


def say_stopped(prog: str, stop: KeyboardInterrupt) -> int:
    """Print in one line on stderr which signal stopped a command, and return its exit status: 130 after Ctrl-C, 143
    after SIGTERM.
    """
    told, status = ("terminated", 143) if isinstance(stop, Terminated) else ("interrupted", 130)
    print(": ".join([f"{prog}: {told}", *map(str, stop.args)]), file=sys.stderr)
    return status
