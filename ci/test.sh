#!/usr/bin/env bash
# Everything that must pass: format, lints, documentation, tests, the reduced cross-check of the references.
#   ci/test.sh           about fifteen minutes on two cores from nothing, six when built
#   ci/test.sh --full    also regenerates every reference at full precision and compares (about an hour)
# Needs Rust. The cross-check needs python3 with mpmath: without it, it is skipped in plain words, and fails where CI=true.
set -euo pipefail
cd "$(dirname "$0")/.."
full=${1:-}

step() { printf '\n== %s\n' "$*"; }

step "format"
cargo fmt --check
step "lints: warnings are errors"
cargo clippy --release --locked --all-targets -- -D warnings
cargo clippy --release --locked --lib --bins --no-default-features -- -D warnings
step "documentation: warnings are errors"
RUSTDOCFLAGS="-D warnings" cargo doc --release --locked --no-deps --quiet
step "tests"
cargo test --release --locked

step "cross-check of the references"
python=""
for candidate in /usr/bin/python3 python3; do
  if "$candidate" -c 'import mpmath' 2>/dev/null; then python=$candidate; break; fi
done
if [ -z "$python" ]; then
  echo "SKIPPED: no python3 with mpmath (Debian: apt-get install python3-mpmath)"
  [ "${CI:-}" != true ] || { echo "CI=true, so this is a failure"; exit 1; }
else
  if [ "$full" = --full ]; then ci/references.sh "$python"; else ci/references.sh "$python" --reduced; fi
fi
step "all passed"
