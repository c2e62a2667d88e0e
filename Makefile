# Everything here also works without make, in an activated environment: see `make help`.
PYTHON ?= python3
BIN := .venv/bin
RUN := $(BIN)/python

.PHONY: help python environment environment-book book watch test verify formal figures single pdf release-notes release same-bytes bench evidence clean
.DEFAULT_GOAL := help

help: ## list these targets
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-16s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

book: environment-book ## check the theorems, draw the figures, build the book, say where it is  (python -m book)
	@$(RUN) -m book

watch: environment-book ## show the book at localhost:8000, and each edited page as soon as it is saved  (python -m book watch)
	@$(RUN) -m book watch

# The book's run of the theorems, which is kept while no source changes, is that of the tests. Three workers keep two
# cores busy: a third of a worker's time it waits, for a browser by most.
test: environment ## run every test, the proofs' included  (python -m book; pytest verify tests)
	@$(RUN) -m book
	@BOOK_BUILT=yes $(RUN) -m pytest verify tests --ignore=verify/test_theorems.py -q -n 3 --dist loadfile --no-loadscope-reorder --durations=10

verify: environment ## run the proofs' checker alone  (pytest verify)
	@$(RUN) -m pytest verify -q -n 2

formal: environment-book ## let Coq check proofs/formal/, and record what it accepted  (python -m verify.coq)
	@$(RUN) -m verify.coq

figures: environment-book ## draw the figures that changed  (python -m book figures)
	@$(RUN) -m book figures

single: environment-book ## the whole chapter as one HTML file that can be mailed  (python -m book single)
	@$(RUN) -m book single

pdf: environment-book ## the chapter for printing, by the installed Chromium  (python -m book pdf)
	@$(RUN) -m book pdf

release-notes: environment-book ## say what moved since the last release  (python -m book release-notes)
	@$(RUN) -m book release-notes

release: environment-book ## write releases/VERSION.json and its pictures  (python -m book release)
	@$(RUN) -m book release

same-bytes: environment-book ## build from a clean clone elsewhere and compare every byte  (python -m book same-bytes)
	@$(RUN) -m book same-bytes

bench: environment-book ## measure times on this machine and write them with its name  (python -m verify.benchmark)
	@$(RUN) -m verify.benchmark
	@$(RUN) -m verify.benchmark.work_precision

evidence: environment book ## measure anew every record whose code has changed, hours if need be  (python -m verify.evidence)
	@$(RUN) -m verify.evidence

clean: ## remove what was built; the environment stays
	@rm -rf book/_build book/_generated .stamps .jupyter_cache .pytest_cache .ruff_cache .benchmarks .hypothesis
	@find . -path ./.venv -prune -o -name __pycache__ -type d -prune -exec rm -rf {} +
	@echo "removed what was built"

environment: python ## create .venv and install what requirements.lock names: all that the tests need, too
	@$(call install,requirements.lock,requirements.lock)

environment-book: python ## the same of requirements-book.lock, which is a part of it: enough for the book
	@$(call install,requirements-book.lock,requirements.lock requirements-book.lock)

# The environment keeps a copy of the lock that it was installed from, so that there is nothing to do while they agree.
define install
for lock in $(2); do cmp -s $$lock .venv/requirements.lock && exit; done; \
echo "Installing what $(1) names (a minute the first time)"; \
$(RUN) -m pip install --quiet --disable-pip-version-check --require-hashes -r $(1) && cp $(1) .venv/requirements.lock
endef

# A Python that is named is the environment's: one that another Python made is made anew.
python:
	@asked='import sys; print(sys.version)'; there=$$($(RUN) -c "$$asked" 2>/dev/null); \
	if [ -z "$$there" ] || { [ "$(origin PYTHON)" != file ] && [ "$$there" != "$$($(PYTHON) -c "$$asked" 2>/dev/null)" ]; }; then \
	  $(PYTHON) -c "import sys; sys.exit(sys.version_info < (3, 11))" 2>/dev/null || { \
	    echo "This needs Python 3.11 or newer; '$(PYTHON)' is $$($(PYTHON) --version 2>&1 || true)." >&2; \
	    echo "Name another one: make PYTHON=python3.12 $(MAKECMDGOALS)" >&2; exit 1; }; \
	  echo "Creating .venv with $$($(PYTHON) --version)"; \
	  $(PYTHON) -m venv --clear .venv; \
	fi
