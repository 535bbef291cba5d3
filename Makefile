# pforms: one name per thing a person does. Everything built lands in git-ignored folders, and is
# built again only when its sources change.

PORT ?= 8017
export CHROMIUM ?= /usr/bin/chromium
export PLAYWRIGHT_SKIP_BROWSER_DOWNLOAD = 1
export PIP_DISABLE_PIP_VERSION_CHECK = 1
export CARGO_TERM_COLOR ?= auto

PYTHON := .tools/python/bin
BENCH := .tools/bench/bin
BOOK := .tools/book/bin

# A binding crate for Python links against no interpreter: it is tested from Python.
RUST_TESTED := --workspace --exclude pforms-python

engine := studio/src/engine/wasm/.built
modules := studio/node_modules/.installed
page := studio/dist/index.html
extension := .tools/python/pforms.built

rust_sources := $(shell find crates bindings xtask Cargo.toml Cargo.lock .cargo \
	-name '*.rs' -o -name 'Cargo.*' -o -name config.toml)
studio_sources := $(shell find studio cases/sheets cases/models -type f \
	-not -path '*/node_modules/*' -not -path '*/dist/*' -not -path '*/wasm/*' -not -path '*/e2e/*' 2>/dev/null)

.PHONY: help run studio test test-rust test-python test-studio bench bench-rust bench-studio lint lint-rust lint-arrows \
	lint-python lint-studio format book clean essentials components

help:
	@echo "make run     the studio on http://localhost:$(PORT)   (PORT=8018, NO_BROWSER=1)"
	@echo "make test    every test of every face                (test-rust, test-python, test-studio)"
	@echo "make lint    formatting, lints, types, import arrows (lint-rust, lint-python, …)"
	@echo "make format  what make lint would complain about, put right where a tool can"
	@echo "make bench   speed, beside other libraries           (bench-rust, bench-studio)"
	@echo "make book    the manual, into book/html"
	@echo "make clean   removes what was built"

# ---- the studio -------------------------------------------------------------------------------

run: studio
	@python3 tools/serve.py studio/dist --port $(PORT) $(if $(NO_BROWSER),--no-browser)

studio: $(page)

$(page): $(engine) $(modules) $(studio_sources)
	cd studio && npm run build
	@touch $@

$(engine): $(rust_sources) tools/wasm.sh tools/wasm-compile.sh | essentials
	tools/wasm.sh $(@D)
	@touch $@

$(modules): studio/package-lock.json studio/package.json
	cd studio && npm ci
	@touch $@

# ---- tests ------------------------------------------------------------------------------------

test: test-rust test-python test-studio

test-rust: | essentials
	tools/packages.sh povray
	cargo test --locked $(RUST_TESTED)

test-python: $(extension)
	$(PYTHON)/python -m pytest bindings/python
	$(PYTHON)/python -m pytest --quiet -p no:cacheprovider benches
	$(PYTHON)/python -m pytest book

test-studio: $(page)
	tools/packages.sh chromium
	cd studio && npm test
	cd studio && npm run e2e

# ---- Python -----------------------------------------------------------------------------------

.tools/%/ready: | essentials
	python3 -m venv .tools/$*
	.tools/$*/bin/pip install --quiet --requirement $<
	@touch $@

.tools/python/ready: tools/requirements.txt
.tools/book/ready: book/requirements.txt

.tools/bench/ready: benches/setup.sh benches/requirements.txt benches/peers/sisl.c | essentials
	benches/setup.sh .tools/bench
	@touch $@

$(extension): .tools/python/ready $(rust_sources) bindings/python/pyproject.toml
	VIRTUAL_ENV=$(CURDIR)/.tools/python $(PYTHON)/maturin develop --locked --release \
		--manifest-path bindings/python/Cargo.toml
	@touch $@

# ---- lints ------------------------------------------------------------------------------------

lint: lint-rust lint-arrows lint-python lint-studio

lint-rust: components
	cargo fmt --all --check
	cargo clippy --locked --workspace --all-targets -- --deny warnings

lint-arrows: | essentials
	cargo xtask arrows

lint-python: .tools/python/ready
	$(PYTHON)/ruff check
	$(PYTHON)/ruff format --check
	$(PYTHON)/mypy

lint-studio: $(engine) $(modules)
	cd studio && npm run typecheck

format: components .tools/python/ready
	cargo fmt --all
	$(PYTHON)/ruff check --fix
	$(PYTHON)/ruff format

# ---- speed, manual ----------------------------------------------------------------------------

# make bench ASK="grid immerse --peers scipy --threads 1"; without ASK, all questions.
bench: .tools/bench/ready .tools/python/ready target/works.wasm
	cargo build --locked --release --package pforms-benches --bins
	VIRTUAL_ENV=$(CURDIR)/.tools/bench $(PYTHON)/maturin develop --quiet --locked --release \
		--manifest-path bindings/python/Cargo.toml
	$(BENCH)/python benches/run.py $(ASK)
	@if test -x "$(CHROMIUM)"; then $(MAKE) --no-print-directory bench-studio; \
		else echo "The studio is left out: there is no $(CHROMIUM)."; fi

# One pole of a surface is dragged in the built page: what each stage of a frame costs.
bench-studio: $(page)
	@mkdir -p benches/results
	cd studio && JSON=../benches/results/studio.json npm run --silent bench

bench-rust:
	cargo bench --locked --package pforms-benches

target/works.wasm: $(rust_sources) $(shell find benches/native -type f) benches/Cargo.toml tools/wasm-compile.sh
	folder=$$(tools/wasm-compile.sh --package pforms-benches --example wasm) && cp $$folder/examples/wasm.wasm $@

.tools/book/operators.json: .tools/book/ready $(rust_sources)
	cargo run --quiet --locked --package pforms -- operators --json > $@

book: .tools/book/ready .tools/book/operators.json
	NO_MKDOCS_2_WARNING=1 $(BOOK)/mkdocs build --quiet --strict --config-file book/mkdocs.yml
	@echo "The manual: book/html/index.html"

# ---- ground -----------------------------------------------------------------------------------

essentials:
	@tools/packages.sh gcc libc6-dev python3-venv

components: essentials
	@cargo fmt --version >/dev/null 2>&1 && cargo clippy --version >/dev/null 2>&1 \
		|| timeout 300 rustup component add rustfmt clippy

clean:
	cargo clean
	rm -rf .tools book/html studio/dist studio/node_modules studio/src/engine/wasm
