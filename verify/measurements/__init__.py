"""The chapter's measurements, one module a topic: `verify.checkers.measurements` finds them all."""
