# Everything runs in .venv, which is made from requirements.lock when first needed.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
PIP := $(BIN)/python -m pip --disable-pip-version-check
# Tests run in parallel; say PYTEST_ARGS= to run them in one process.
PYTEST_ARGS ?= -n auto

# As the command line does: threads of BLAS take cores from other tests.
export OPENBLAS_NUM_THREADS ?= 1
export OMP_NUM_THREADS ?= 1
# Each of the tests' processes would compile all modules anew, and each suite rewrite all tests.
unexport PYTHONDONTWRITEBYTECODE

.PHONY: help plan test test-slow test-browser lint lock viewer viewer-check docs lock-docs clean
help:
	@echo "make plan       set up, plan scenario-a, print its verdict, write plans/scenario-a"
	@echo "make test       set up, then lint, types, layers and the quick tests"
	@echo "make test-slow  set up, then the slow tests"
	@echo "make test-browser  set up, then the tests of the page; needs chromium"
	@echo "make lock       resolve requirements.lock again"
	@echo "make docs       build the documentation into site/, which opens from disk"
	@echo "make viewer     build the page's script and style from viewer/; needs node and npm"
	@echo "make viewer-check  compare them with what is committed"

$(VENV)/.ready: requirements.lock pyproject.toml
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' \
		|| { echo "berthing needs Python 3.11 or later (say PYTHON=...)"; exit 1; }
	@echo "setting up $(VENV) (about 1 GB)"
	@$(PYTHON) -m venv --clear $(VENV)
	@$(PIP) install --quiet --require-hashes -r requirements.lock
	@$(PIP) install --quiet --no-deps --no-build-isolation -e .
	@touch $@

plan: $(VENV)/.ready
	@$(BIN)/berthing plan scenario-a --force

lint: $(VENV)/.ready
	$(BIN)/ruff check
	$(BIN)/mypy
	$(BIN)/lint-imports

test: lint
	$(BIN)/pytest $(PYTEST_ARGS)

test-slow: $(VENV)/.ready
	$(BIN)/pytest $(PYTEST_ARGS) -m slow

# One browser serves them all.
test-browser: $(VENV)/.ready
	$(BIN)/pytest -m browser tests/browser

# viewer/ is the source of the script and style in src/berthing/report/offline/assets, which are
# committed: users need no node. Packages are checked against the hashes of the lock, which has no addresses.
viewer/node_modules/.ready: viewer/package.json viewer/package-lock.json
	cd viewer && npm ci --ignore-scripts --no-audit --no-fund
	@touch $@

viewer: viewer/node_modules/.ready
	cd viewer && npm run --silent types && npm run --silent build

viewer-check: viewer/node_modules/.ready
	cd viewer && npm run --silent types && npm run --silent build -- --check

# The documentation's builder has an environment and a lock of its own: no plan needs it.
build/docs/.ready: requirements-docs.lock
	@$(PYTHON) -m venv --clear build/docs
	@build/docs/bin/python -m pip --disable-pip-version-check install --quiet --require-hashes \
		-r requirements-docs.lock
	@touch $@

# Warnings are errors. The variable silences the theme's advertisement alone.
docs: build/docs/.ready
	NO_MKDOCS_2_WARNING=1 build/docs/bin/mkdocs build --strict
	@echo "site/index.html"

# Versions and hashes only: no index addresses, no file paths. The public index is asked, whatever
# this machine is set to use.
lock:
	$(PYTHON) -m venv --clear build/lock
	build/lock/bin/python -m pip install --quiet pip-tools
	env -u PIP_FIND_LINKS -u PIP_EXTRA_INDEX_URL PIP_CONFIG_FILE=/dev/null \
		build/lock/bin/pip-compile --quiet --upgrade --extra dev --generate-hashes --allow-unsafe \
		--strip-extras --no-header --no-annotate --no-emit-index-url --no-emit-find-links \
		--no-emit-trusted-host --output-file requirements.lock pyproject.toml

lock-docs:
	$(PYTHON) -m venv --clear build/lock
	build/lock/bin/python -m pip install --quiet pip-tools
	env -u PIP_FIND_LINKS -u PIP_EXTRA_INDEX_URL PIP_CONFIG_FILE=/dev/null \
		build/lock/bin/pip-compile --quiet --upgrade --generate-hashes --allow-unsafe \
		--strip-extras --no-header --no-annotate --no-emit-index-url --no-emit-find-links \
		--no-emit-trusted-host --output-file requirements-docs.lock requirements-docs.in

clean:
	rm -rf $(VENV) viewer/node_modules site build .pytest_cache .mypy_cache .ruff_cache .import_linter_cache
