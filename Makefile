# Every target works on a fresh clone with Python (3.11 or newer) and make alone.
PYTHON ?= python3
VENV ?= .venv
BIN := $(VENV)/bin
PIP := $(BIN)/python -m pip install --quiet --constraint constraints.txt

# Tests start Python anew many times: let it keep what it compiles.
unexport PYTHONDONTWRITEBYTECODE

# What solves no film, or few: for the inner loop.
FAST := src tests/case tests/characteristics tests/design tests/docs tests/files tests/fits tests/export \
	tests/infinitely_long_bearing tests/lubricants tests/materials tests/grooved_long_bearing tests/shaft tests/iso7902 tests/units

# Tests misspell on purpose, to see what is said of it.
SPELLED := *.md docs src scripts benchmarks validation examples Makefile pyproject.toml

.PHONY: demo test test-fast test-thorough minima lint docs bench clean

demo: $(VENV)/.demo  ## solve the marine reverse gear: table, PDF and JSON
	mkdir -p out
	$(BIN)/babbitt solve examples/marine_reverse_gear.yaml --report out/marine_reverse_gear.pdf --json out/marine_reverse_gear.json
	@ls -l out/marine_reverse_gear.pdf out/marine_reverse_gear.json

test: $(VENV)/.kernels  ## tests, doctests and published cases
	$(BIN)/python -m pytest -n auto --dist worksteal -m 'not thorough'

test-thorough: $(VENV)/.kernels  ## the longest tests, which make test leaves out
	$(BIN)/python -m pytest -n auto --dist worksteal -m thorough

test-fast: $(VENV)/.test  ## what solves no film, or few
	$(BIN)/python -m pytest -n auto --dist worksteal -m 'not slow and not thorough' $(FAST)

minima: $(VENV)-minima/.made  ## a smoke set on the lowest versions that pyproject.toml allows
	$(VENV)-minima/bin/babbitt check examples/*.yaml
	$(VENV)-minima/bin/babbitt solve examples/journal.yaml --report out/minima.pdf --json out/minima.json
	$(VENV)-minima/bin/babbitt solve examples/starved_journal.yaml --fields out/minima.nc
	$(VENV)-minima/bin/babbitt sweep examples/journal.yaml speed '1000 rpm:2000 rpm:3' --csv out/minima.xlsx
	$(VENV)-minima/bin/python -m pytest -p no:xdist tests/units tests/case/test_bad_files.py tests/case/test_build.py \
		tests/export tests/design tests/report/test_export.py

lint: $(VENV)/.lint  ## style, spelling, types, direction of imports
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/codespell $(SPELLED)
	$(BIN)/mypy
	$(BIN)/lint-imports

docs: $(VENV)/.docs  ## build the documentation into docs/_build/html
	$(BIN)/python -m sphinx -W -q -j auto docs docs/_build/html

bench: $(VENV)/.demo  ## measure what benchmarks/ promises
	for script in benchmarks/*.py; do $(BIN)/python $$script || exit 1; done

clean:
	rm -rf $(VENV) $(VENV)-minima out docs/_build docs/_generated

$(VENV)/.pip:
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --upgrade pip
	touch $@

$(VENV)/.demo: $(VENV)/.pip pyproject.toml constraints.txt
	$(PIP) --editable '.[report]'
	touch $@

$(VENV)/.test: $(VENV)/.demo
	$(PIP) --editable '.[report,files,studies,cluster,app]' --group test
	touch $@

$(VENV)-minima/.made: pyproject.toml constraints-minima.txt
	$(PYTHON) -m venv $(VENV)-minima
	$(VENV)-minima/bin/python -m pip install --quiet --upgrade pip
	$(VENV)-minima/bin/python -m pip install --quiet --constraint constraints-minima.txt --editable '.[report,files]' --group test
	mkdir -p out
	touch $@

# Compiled on two cores before anything asks for them.
$(VENV)/.kernels: $(VENV)/.test tests/compile_kernels.py $(shell find src/babbitt/reynolds -name '_*.py')
	$(BIN)/python tests/compile_kernels.py
	touch $@

$(VENV)/.lint: $(VENV)/.test
	$(PIP) --group lint
	touch $@

$(VENV)/.docs: $(VENV)/.test
	$(PIP) --group docs
	touch $@
