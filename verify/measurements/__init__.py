"""Every measurement, one module a topic: `verify.checkers.measured` finds them all."""
