#!/usr/bin/env bash
# The Python package in a clean virtual environment: `pip install .`, linter, types, tests, the three notebooks. Two minutes where the program is built.
#   ci/python.sh           builds the program as for a release
#   ci/python.sh --dev     with Cargo's dev profile, for work
# The Rust program is built in the usual target folder, so that nothing is compiled twice. Python packages come from PyPI.
set -euo pipefail
cd "$(dirname "$0")/.."
[ "${1:-}" != --dev ] || export MATURIN_PEP517_ARGS="--profile=dev"
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$PWD/target}
environment=$(mktemp -d)
trap 'rm -rf "$environment"' EXIT
python3 -m venv "$environment"
"$environment/bin/pip" install --quiet ".[notebooks]"
"$environment/bin/pip" install --quiet pytest "mypy>=1.10" "ruff>=0.6" pandas-stubs
echo "== linter and types"
"$environment/bin/ruff" check .
"$environment/bin/ruff" format --check .
"$environment/bin/mypy"
echo "== tests"
# With -P Python does not look into the working folder: what is installed is tested.
"$environment/bin/python" -P -c 'import viscotack; print(viscotack.version(), viscotack.__file__)'
"$environment/bin/python" -P -m pytest -q -p no:cacheprovider python/tests
echo "== notebooks"
PATH="$environment/bin:$PATH" "$environment/bin/python" -P ci/notebooks.py
echo "python: all passed"
