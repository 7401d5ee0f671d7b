#!/usr/bin/env bash
# Recomputes the reference data and compares it with what is committed: ci/references.sh PYTHON [--reduced]
set -euo pipefail
cd "$(dirname "$0")/.."
python=$1; shift
"$python" verification/references/steady_crack.py --check "$@"
