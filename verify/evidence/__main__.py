"""Measure anew the records that are stale, and no others:

    python -m verify.evidence [NAME …]                  (hours if need be, on a machine that does nothing else)
    python -m verify.evidence --list                    only says which are stale, and why

Each is measured by its own command. Where one ends early, or Ctrl-C stops them all, the records written before stay,
and the one that was being measured is unchanged.
"""

import argparse
import subprocess
import sys
from collections.abc import Iterable
from importlib.util import find_spec

from tqdm import tqdm

from verify.evidence.records import RECORDS, ROOT, read, why_stale


def stale(names: Iterable[str] = ()) -> dict[str, str]:
    """Return {record: why it is stale} of the named records, or of all."""
    return {name: why for name in names or RECORDS if (why := why_stale(name))}


def renew(name: str) -> str | None:
    """Measure a record; return why that cannot be done here, or None where it was."""
    record = RECORDS[name]
    if missing := [library for library in record.needs if find_spec(library) is None]:
        return f"it needs {missing[0]}, which is not installed"
    status = subprocess.run([sys.executable, *record.command.split()], cwd=ROOT, check=False).returncode
    why = why_stale(name)
    return f"its run ended with status {status}; what went wrong is above" if why and status else why


def main(arguments: list[str] | None = None) -> int:
    """Say what is stale, measure it, say what is left; return 1 if anything is."""
    formatter = argparse.RawDescriptionHelpFormatter
    parser = argparse.ArgumentParser("python -m verify.evidence", description=__doc__, formatter_class=formatter)
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"only these: {', '.join(RECORDS)}")
    parser.add_argument("--list", action="store_true", help="measure nothing")
    options = parser.parse_args(arguments)
    if unknown := set(options.names) - RECORDS.keys():
        parser.error(f"no record is called {', '.join(sorted(unknown))}; there are: {', '.join(RECORDS)}")
    waiting = stale(options.names)
    for name in options.names or RECORDS:
        age = f"stale: {waiting[name]}: python {RECORDS[name].command}" if name in waiting else "the code is the same"
        print(f"{name:16} measured at {read(name)['label']['commit']:9} {age}", flush=True)
    if options.list:
        return 0
    left = dict.fromkeys(waiting, "it was not begun")
    try:
        for name in (bar := tqdm(list(waiting), desc="records", unit="record")):
            left[name] = "its run was stopped"
            bar.set_postfix_str(name)
            print(file=sys.stderr)  # its own bars come below
            if why := renew(name):
                left[name] = why
            else:
                del left[name]
    except KeyboardInterrupt:
        print("\nstopped", file=sys.stderr)
    print(f"measured anew: {', '.join(name for name in waiting if name not in left) or 'nothing'}")
    for name, why in left.items():
        print(f"still stale: {name}: {why}")
    return 1 if left else 0


if __name__ == "__main__":
    sys.exit(main())
