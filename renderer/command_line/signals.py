"""What a command does when it is told to stop."""

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager


class Terminated(KeyboardInterrupt):
    """What SIGTERM does: the same as Ctrl-C, by its own name and exit status."""


@contextmanager
def sigterm_stops() -> Iterator[None]:
    """Let SIGTERM stop what is done here as Ctrl-C does: nothing half-written is left behind."""
    here = threading.current_thread() is threading.main_thread()
    if not here or signal.getsignal(signal.SIGTERM) != signal.SIG_DFL:  # somebody else's to say
        yield
        return

    def stop(number, frame):
        signal.signal(signal.SIGTERM, signal.SIG_IGN)  # one is enough; the next would hinder the cleaning up
        raise Terminated

    signal.signal(signal.SIGTERM, stop)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
