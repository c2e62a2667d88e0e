"""Every measurement, one module a topic: `verify.checkers.measurements` finds them all."""
