#!/usr/bin/env bash
# A sweep in shards through Snakemake and through HyperQueue on this machine: a shard is killed in the middle, the work goes on, and the files at the end are those
# of one run, byte by byte. About a minute on two cores.
#   ci/workflow.sh [PROGRAM]      PROGRAM: target/release/viscotack, if none is named
# Snakemake and HyperQueue are installed from PyPI into target/workflow, unless they are there.
set -euo pipefail
cd "$(dirname "$0")/.."
repository=$PWD
program=$(realpath "${1:-${CARGO_TARGET_DIR:-target}/release/viscotack}")
environment=${CARGO_TARGET_DIR:-target}/workflow
if ! "$environment/bin/python" -c 'import hyperqueue, snakemake, snakemake_executor_plugin_slurm' 2>/dev/null; then
  python3 -m venv "$environment"
  "$environment/bin/pip" install --quiet "snakemake>=9,<10" snakemake-executor-plugin-slurm "hyperqueue>=0.20"
fi
python=$(realpath -s "$environment/bin/python")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
scene=$repository/scenes/sliding/rubber_wave.toml
points=(sweep.points=120)

"$program" run "$scene" --set "${points[0]}" --out WHOLE > /dev/null
same() {
  diff -r WHOLE "$1" || { echo "$1 differs from one run"; exit 1; }
  echo "$1: the bytes of one run"
}
# Kills the process that solves a shard, once some of its states are finished. Only one whose command names this folder.
kill_shard() {
  local journal=$1.shards/1.partial/journal.jsonl pid
  for _ in $(seq 600); do
    if [ -f "$journal" ] && [ "$(wc -l < "$journal")" -ge 4 ]; then
      for pid in $(pgrep -x "$(basename "$program")" || true); do
        if [ "$(readlink "/proc/$pid/cwd")" = "$work" ] && tr '\0' ' ' < "/proc/$pid/cmdline" | grep -q -- "--shard 1/6 "; then
          kill -9 "$pid" && { echo "killed shard 1 after $(($(wc -l < "$journal") - 1)) states"; return; }
        fi
      done
    fi
    sleep 0.05
  done
  echo "shard 1 was never seen at work"
  exit 1
}

echo "== Snakemake"
snakemake() {
  "$python" -m snakemake --quiet all --snakefile "$repository/workflow/Snakefile" --directory "$work" --profile "$repository/workflow/profiles/local" --cores 2 \
    --config scene="$scene" shards=6 out=SNAKE retries="$1" program="$program" "sets=['${points[0]}']"
}
snakemake 0 > snake.log 2>&1 & run=$!
kill_shard SNAKE
if wait $run; then echo "it did not notice that a shard was killed"; exit 1; fi
test ! -e SNAKE/summary.json
snakemake 1 > snake2.log 2>&1 || { cat snake2.log; exit 1; }
same SNAKE

echo "== Slurm: its profile is read, and no job is given"
"$python" -m snakemake --dry-run --quiet rules --snakefile "$repository/workflow/Snakefile" --directory "$work" --profile "$repository/workflow/profiles/slurm" \
  --config scene="$scene" shards=6 out=SLURM > slurm.log 2>&1 || { cat slurm.log; exit 1; }
grep -qE '^shard +6$' slurm.log || { cat slurm.log; exit 1; }

echo "== HyperQueue"
"$python" "$repository/workflow/on_hyperqueue.py" "$scene" --set "${points[0]}" --shards 6 --out HYPER --program "$program" --cores 2 > hyper.log 2>&1 & run=$!
kill_shard HYPER
wait $run || { cat hyper.log; exit 1; }
grep -q "some shards failed" hyper.log || { echo "it did not notice that a shard was killed"; exit 1; }
same HYPER
echo "workflows: all passed"
