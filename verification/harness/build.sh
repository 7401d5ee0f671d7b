#!/usr/bin/env bash
# Builds the harness and puts it where Python finds it by name: target/harness/viscotack_harness.abi3.so.
#   verification/harness/build.sh               by itself
#   verification/harness/build.sh --with-tests  with the features of the Rust tests, so that after `cargo test --workspace`
#                                               the solver is not compiled again
# One file serves every Python from 3.11 on. (`maturin build --release` in this folder makes a wheel of the same; nothing here needs that.)
set -euo pipefail
cd "$(dirname "$0")/../.."
if [ "${1:-}" = --with-tests ]; then
  cargo build --release --locked --lib --tests --workspace
else
  cargo build --release --locked -p viscotack-harness
fi
target=${CARGO_TARGET_DIR:-target}
mkdir -p "$target/harness"
# By a rename: a Python that has the old one open keeps it.
cp "$target/release/libviscotack_harness.so" "$target/harness/new.so"
mv "$target/harness/new.so" "$target/harness/viscotack_harness.abi3.so"
echo "built $target/harness/viscotack_harness.abi3.so"
