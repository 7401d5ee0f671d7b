#!/usr/bin/env bash
# An environment with the peers, outside this repository: verification/peers/setup.sh [FOLDER]     (default ~/.cache/viscotack-peers)
# Then: FOLDER/bin/python verification/peers/elastic_wave.py and so on. Nothing here is linked with the solver: Tamaas is AGPL, and is only run.
# Needs Python 3.11 to 3.13 and a network; only wheels are taken, so that nothing is compiled.
set -euo pipefail
cd "$(dirname "$0")"
folder=${1:-$HOME/.cache/viscotack-peers}
[ -e "$folder/bin/python" ] || "${PYTHON:-python3}" -m venv "$folder"
"$folder/bin/python" -m pip install --quiet --only-binary :all: --requirement requirements.txt
if "$folder/bin/python" -c 'import muFFT' 2>/dev/null; then
  echo "muFFT is there: ContactMechanics and Adhesion do not work beside it; use another folder"
  exit 1
fi
"$folder/bin/python" -c 'import Adhesion, ContactMechanics, tamaas; print("peers are ready, Tamaas", tamaas.__version__)'
echo "$folder/bin/python"
