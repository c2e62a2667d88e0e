"""Every measurement, one module a topic: `verify.checkers.registry` finds them all."""
