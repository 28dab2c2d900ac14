# make demo   the whole loop: runtime, simulated robot, editor, an example running
# make test   all tests, and every branch is taken; ARGS=tests/x.py only some
# make check  ruff, mypy, import-linter, then the tests
# make bench  measures ours beside what else there is; ARGS="-k fsm" only some
# make soak   the faults, long and often, with figures; SITU_SEED=N chooses other ones
# make fuzz   damaged files of each kind, SECONDS=60 long
# make pictures  makes the reference pictures of the studio anew: look at each, then commit
# make tutorial  makes the pictures of docs/tutorial.md and tutorial.ja.md anew
# make bare   what a robot gets, without Qt, in an environment of its own: installed and run
# make format rewrites the code's layout;  make clean removes what was made here

.DELETE_ON_ERROR:
.PHONY: demo test check lint bench soak fuzz pictures tutorial bare format clean

VENV := .venv
READY := $(VENV)/.ready
BIN := $(VENV)/bin
# The first Python that is new enough; one that can make virtual environments comes first.
ifndef PYTHON
PYTHON := $(shell for want in "import ensurepip, venv" ""; do \
	for python in python3.13 python3.12 python3.11 python3; do \
	$$python -c "import sys; sys.exit(sys.version_info < (3, 11))" 2>/dev/null && \
	$$python -c "$$want" 2>/dev/null && echo $$python && exit; done; done)
endif
WORKERS ?= auto
SECONDS ?= 60
# Random examples are the same each time, so that no run hangs on luck; with ARGS, and in make fuzz
# and make soak, they are others.
SEED := --hypothesis-seed=0
# Tests that take every branch of situ.document, situ.decide and situ.rehearse, or fail. Being
# counted takes longer.
COVERED := tests/document tests/decide tests/rehearse tests/examples
GATE := --cov -o timeout=300

demo: $(READY)
	@$(PYTHON) packaging/system_check.py demo
	@$(BIN)/situ demo

# The robots in Bullet's physics are 100 MB: only there where their tests must not be skipped.
ifeq ($(CI),true)
test: $(VENV)/.pybullet
endif

test: $(READY)
	@$(PYTHON) packaging/system_check.py test
ifdef ARGS
	@$(BIN)/pytest -q -n $(WORKERS) $(ARGS)
else
	@$(BIN)/pytest -q -n $(WORKERS) $(COVERED) $(SEED) $(GATE)
	@$(BIN)/pytest -q -n $(WORKERS) tests $(COVERED:%=--ignore=%) $(SEED)
endif

check: lint test

lint: $(READY)
	@$(BIN)/ruff check -q .
	@$(BIN)/ruff format -q --check .
	@$(BIN)/mypy
	@$(BIN)/lint-imports --no-logo

bench: $(VENV)/.bench
	@$(BIN)/python -m tests.benchmarks $(ARGS)

soak: $(READY)
	@SITU_SOAK=1 QT_QPA_PLATFORM=offscreen $(BIN)/pytest -q -s --timeout 3600 tests/faults \
		tests/gui/drawing/test_drawn_by_hand.py tests/vitals/test_two_weeks.py tests/vitals/test_a_day.py $(ARGS)

fuzz: $(READY)
	@SITU_FUZZ=$(SECONDS) $(BIN)/pytest -q -o timeout=0 -n $(WORKERS) tests/test_fuzz.py

pictures: $(READY)
	@SITU_PICTURES=1 QT_QPA_PLATFORM=offscreen $(BIN)/pytest -q -n $(WORKERS) tests/gui/test_looks.py

tutorial: $(READY)
	@SITU_PICTURES=1 QT_QPA_PLATFORM=offscreen $(BIN)/pytest -q tests/gui/tutorial

bare:
	@sh packaging/bare_check.sh $(PYTHON)

format: $(READY)
	@$(BIN)/ruff check -q --fix-only .
	@$(BIN)/ruff format -q .

clean:
	rm -rf $(VENV) dist .pytest_cache .mypy_cache .ruff_cache .import_linter_cache .hypothesis .coverage
	find app runtime tests packaging -name __pycache__ -type d -prune -exec rm -rf {} +

$(READY): pyproject.toml constraints.txt
	@if [ -z "$(PYTHON)" ]; then \
		echo "situ: Python 3.11 or newer is needed: sudo apt-get install python3 python3-venv" >&2; \
		exit 2; fi
	@$(PYTHON) packaging/system_check.py venv
	@echo "setting up $(VENV), once; this takes a minute or two"
	@[ -x $(BIN)/pip ] || $(PYTHON) -m venv --clear $(VENV)
	@$(BIN)/python -m pip install -qq --disable-pip-version-check \
		-e '.[studio,dev]' -c constraints.txt
	@touch $@

# Nothing where there is no wheel for this Python.
$(VENV)/.pybullet: $(READY)
	@$(BIN)/python -m pip install -qq --disable-pip-version-check \
		-e '.[pybullet]' -c constraints.txt
	@touch $@

# What is measured beside ours.
$(VENV)/.bench: $(READY)
	@$(BIN)/python -m pip install -qq --disable-pip-version-check \
		-e '.[bench]' -c constraints.txt
	@touch $@
