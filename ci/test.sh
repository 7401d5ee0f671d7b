#!/usr/bin/env bash
# Everything that must pass: format, lints, documentation, tests, cross-checks against references.
#   ci/test.sh           about twenty minutes on two cores from nothing, ten when built
#   ci/test.sh --full    also regenerates every reference at full precision and compares (an hour of one core), and puts deliberate faults into the
#                        source that the tests must catch (a third of an hour)
# Needs Rust. The cross-checks need Debian's python3 with NumPy, SciPy, mpmath and pytest, some of them dolfinx: as root, or where CI=true, they are installed;
# otherwise, if they are missing, the line to run is printed and the cross-checks are skipped in plain words, which is a failure where CI=true.
set -euo pipefail
cd "$(dirname "$0")/.."
full=${1:-}
packages="python3 python3-numpy python3-scipy python3-mpmath python3-pytest"
elements="python3-dolfinx"      # finite elements beside the solver; large, so installed by itself

# What comes next, and how long it has been since the beginning.
step() { printf '\n== %s (after %d s)\n' "$*" "$SECONDS"; }

# A python3 that has everything, Debian's first.
find_python() {
  python=""
  for candidate in /usr/bin/python3 python3; do
    if "$candidate" -c 'import mpmath, numpy, scipy, pytest, sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null; then python=$candidate; break; fi
  done
}

step "tools of the cross-checks"
find_python
if [ -z "$python" ] && command -v apt-get >/dev/null && { [ "$(id -u)" = 0 ] || [ "${CI:-}" = true ]; }; then
  # Another installation may be under way: wait for it.
  apt-get -o DPkg::Lock::Timeout=300 update -qq
  DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 install -y -qq --no-install-recommends $packages >/dev/null
  find_python
fi
if [ -n "$python" ]; then
  "$python" -c 'import mpmath, numpy, pytest, scipy, sys
print("python", sys.version.split()[0], *(f"{m.__name__} {m.__version__}" for m in (numpy, scipy, mpmath, pytest)))'
else
  echo "missing; to install: apt-get install $packages"
  [ "${CI:-}" != true ] || { echo "CI=true, so this is a failure"; exit 1; }
fi

if [ -n "$python" ] && ! "$python" -c 'import dolfinx' 2>/dev/null; then
  if command -v apt-get >/dev/null && { [ "$(id -u)" = 0 ] || [ "${CI:-}" = true ]; }; then
    apt-get -o DPkg::Lock::Timeout=300 update -qq || true
    DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 install -y -qq --no-install-recommends $elements >/dev/null || true
  fi
  "$python" -c 'import dolfinx; print("dolfinx", dolfinx.__version__)' 2>/dev/null || {
    echo "no finite elements, their tests are skipped; to install: apt-get install $elements"
    [ "${CI:-}" != true ] || { echo "CI=true, so this is a failure"; exit 1; }
  }
fi

# The Python package and the workflow are tested in virtual environments of their own, filled from PyPI.
environments=""
if ! python3 -c 'import ensurepip' 2>/dev/null && command -v apt-get >/dev/null && { [ "$(id -u)" = 0 ] || [ "${CI:-}" = true ]; }; then
  DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 install -y -qq --no-install-recommends python3-venv >/dev/null || true
fi
if python3 -c 'import ensurepip, sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null; then
  environments=yes
else
  echo "no virtual environments, tests of the Python package are skipped; to install: apt-get install python3-venv"
  [ "${CI:-}" != true ] || { echo "CI=true, so this is a failure"; exit 1; }
fi

# Completions are tested in the shells that are there; bash always is.
if [ "${CI:-}" = true ] && ! { command -v zsh && command -v fish; } >/dev/null; then
  DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 install -y -qq --no-install-recommends zsh fish >/dev/null
fi

step "format"
cargo fmt --all --check
step "lints: warnings are errors"
cargo clippy --release --locked --all-targets --workspace -- -D warnings
cargo clippy --release --locked --no-default-features -- -D warnings
step "documentation: warnings are errors"
RUSTDOCFLAGS="-D warnings" cargo doc --release --locked --no-deps --quiet
step "book: build, links, pictures, places"
ci/book.sh
step "tests"
cargo test --release --locked --workspace

step "examples of the library"
# Those of the solver; the ones that draw belong to the command line, and are compiled with the tests.
for name in $(sed -n '/^\[\[example\]\]/{n;s/^name = "\(.*\)"/\1/p}' Cargo.toml); do
  cargo run --release --locked --quiet -p viscotack --example "$name"
done

step "studies: convergence, cost, hard cases, effects (viscotack verify)"
studies=$(mktemp -d)
trap 'rm -rf "$studies"' EXIT
# Fails if an order, a counter or a hard case gets worse; times are printed, never compared.
if cargo run --release --locked --quiet -- verify --out "$studies/report" > "$studies/log"; then grep '^verify' "$studies/log"; else cat "$studies/log"; exit 1; fi

step "cargo install: the installed program solves a scene"
# The same profile and features as the run before, so that nothing is compiled again: about a second.
cargo install --path cli --locked --quiet --root "$studies/installed"
"$studies/installed/bin/viscotack" run scenes/sliding/equilibrium_diagram.toml --out "$studies/result" > "$studies/log" || { cat "$studies/log"; exit 1; }
grep -q ',solved,' "$studies/result/states.csv"
echo "installed: $("$studies/installed/bin/viscotack" --version); $(ls "$studies/result" | tr '\n' ' ')"

if [ -z "$environments" ]; then
  step "sweeps in shards, Python package"
  echo "SKIPPED: no python3 with venv; to install: apt-get install python3-venv"
else
  step "shards by Snakemake and HyperQueue, one of them killed"
  ci/workflow.sh
  step "Python package: linter, types, tests, notebooks"
  ci/python.sh
fi

step "cross-checks against references"
if [ -z "$python" ]; then
  echo "SKIPPED: no python3 (3.11 or later) with NumPy, SciPy, mpmath and pytest; to install: apt-get install $packages"
else
  verification/harness/build.sh --with-tests
  PYTHONDONTWRITEBYTECODE=1 "$python" -m pytest verification/crosscheck
  if [ "$full" = --full ]; then
    ci/references.sh "$python"
    "$python" verification/fenicsx/self_check.py
    OMP_NUM_THREADS=1 "$python" verification/fenicsx/run.py --check
    step "deliberate faults"
    "$python" verification/faults/run.py
  fi
fi
step "all passed"
