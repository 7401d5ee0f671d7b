#!/usr/bin/env bash
# Builds the book of docs/ into target/book with mdBook and checks the pages that come out: each link, each picture and each place in a page is there.
# Under a minute on two cores where mdBook is compiled first, which it is once, into target/tools; seconds after that.
set -euo pipefail
cd "$(dirname "$0")/.."
version=0.4.52
target=${CARGO_TARGET_DIR:-$PWD/target}
mdbook=$target/tools/bin/mdbook
if [ "$("$mdbook" --version 2>/dev/null || true)" != "mdbook v$version" ]; then
  # A small book is built quickly by any build; one without optimisation takes a third of the time to compile.
  CARGO_PROFILE_RELEASE_OPT_LEVEL=0 CARGO_PROFILE_RELEASE_DEBUG=0 \
    cargo install mdbook --quiet --locked --version "$version" --no-default-features --features search --root "$target/tools" --target-dir "$target/tools/build"
  rm -rf "$target/tools/build"
fi
rm -rf "$target/book"
"$mdbook" build docs --dest-dir "$target/book"
python3 ci/book_links.py "$target/book"
