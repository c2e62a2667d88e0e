"""The theorems, one module a topic: every `Theorem` at the top level of a module is found."""
