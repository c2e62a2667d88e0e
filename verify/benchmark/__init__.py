"""Run time, measured on one machine and kept with its name: `make bench`. Nothing here is a test."""
