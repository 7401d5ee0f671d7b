#!/usr/bin/env bash
# An archive of the program for machines without Rust: one static file, manual pages, completions, scenes, licences, and its SHA-256.
#   ci/release.sh [DIR]      DIR: where the archive goes, target/archives if none is named
# The C library is linked in (glibc, or musl where that target is installed), so that the archive runs on any Linux of this processor.
set -euo pipefail
cd "$(dirname "$0")/.."
out=${1:-target/archives}
machine=$(uname -m)
if [ -d "$(rustc --print sysroot)/lib/rustlib/$machine-unknown-linux-musl" ]; then target=$machine-unknown-linux-musl; else target=$machine-unknown-linux-gnu; fi
# With a target named, the flag holds for the program and not for the macros that the compiler loads.
RUSTFLAGS="-C target-feature=+crt-static" cargo build --release --locked --target "$target" -p viscotack-cli
program=${CARGO_TARGET_DIR:-target}/$target/release/viscotack
version=$("$program" --version | cut -d' ' -f2)
name=viscotack-$version-$target
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
folder=$work/$name
mkdir -p "$folder/man" "$folder/completions"
cp "$program" README.md CHANGELOG.md CITATION.cff LICENSE-* "$folder"
cp -r scenes "$folder/scenes"
"$program" man > "$folder/man/viscotack.1"
for shell in bash zsh fish; do "$program" completions "$shell" > "$folder/completions/viscotack.$shell"; done
mkdir -p "$out"
# The same sources give the same bytes.
tar --sort=name --owner=0 --group=0 --numeric-owner --mtime="@$(git log -1 --format=%ct)" -C "$work" -cf - "$name" | gzip -n -9 > "$out/$name.tar.gz"
(cd "$out" && sha256sum "$name.tar.gz" | tee "$name.tar.gz.sha256")
# What is in the archive runs.
tar -C "$work" -xzf "$out/$name.tar.gz" --one-top-level=again
"$work/again/$name/viscotack" run "$work/again/$name/scenes/cracks/rubber_tearing.toml" > /dev/null
if ldd "$program" 2>&1 | grep -qE 'not a dynamic|statically'; then echo "$out/$name.tar.gz: static, and runs"; else echo "the program needs shared libraries"; exit 1; fi
