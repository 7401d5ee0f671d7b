"""A sweep in shards on HyperQueue, which runs inside one allocation of a cluster, or on one machine: pip install hyperqueue.

python workflow/on_hyperqueue.py scene.toml --shards 64 --out result                 a server and a worker on this machine
python workflow/on_hyperqueue.py scene.toml --shards 64 --out result --server DIR    a server that runs already (`hq server start`, `hq alloc add slurm`)

A job is a shard, and a shard a chunk of states: handing a job over takes milliseconds, starting the program some more. A job that was killed is given again
and goes on where it was.
"""

from __future__ import annotations

import argparse
import shutil
import subprocess
import sys
from pathlib import Path

from hyperqueue import Job, LocalCluster
from hyperqueue.client import Client, FailedJobsException
from hyperqueue.cluster import WorkerConfig


def missing(parts: Path, shards: int) -> list[int]:
    """The shards that are not finished."""
    return [part for part in range(shards) if not (parts / str(part) / "shard.json").exists()]


def submit(client: Client, command: list[str], parts: Path, shards: int, only: list[int], logs: Path) -> None:
    """Solves some shards, each a task."""
    job = Job(name="viscotack")
    for part in only:
        arguments = [*command, "--shard", f"{part}/{shards}", "--jobs", "1", "--out", str(parts / str(part))]
        job.program(arguments, stdout=str(logs / f"{part}.out"), stderr=str(logs / f"{part}.err"))
    client.wait_for_jobs([client.submit(job)])


def main() -> int:
    """Solves the shards that are missing, a few times where jobs are killed, then brings all together."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("scene", type=Path)
    parser.add_argument("--shards", type=int, default=8)
    parser.add_argument("--out", type=Path, default=Path("result"))
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE")
    parser.add_argument("--program", default="viscotack")
    parser.add_argument("--server", type=Path, help="folder of a HyperQueue server that runs already")
    parser.add_argument("--cores", type=int, help="of the worker on this machine")
    parser.add_argument("--attempts", type=int, default=3)
    given = parser.parse_args()
    program = shutil.which(given.program)
    if program is None:
        print(f"the program `{given.program}` is not there", file=sys.stderr)
        return 2
    sets = [argument for value in given.set for argument in ("--set", value)]
    command = [program, "run", str(given.scene.absolute()), *sets]
    parts = Path(f"{given.out.absolute()}.shards")
    logs = parts / "logs"
    logs.mkdir(parents=True, exist_ok=True)
    cluster = None if given.server else LocalCluster(worker_config=WorkerConfig(cores=given.cores))
    try:
        client = Client(given.server) if cluster is None else cluster.client()
        for _ in range(given.attempts):
            only = missing(parts, given.shards)
            if not only:
                break
            try:
                submit(client, command, parts, given.shards, only, logs)
            except FailedJobsException as error:
                print(f"some shards failed; what they have finished is kept\n{error}", file=sys.stderr)
    finally:
        if cluster is not None:
            cluster.stop()
    if missing(parts, given.shards):
        return 1
    folders = [str(parts / str(part)) for part in range(given.shards)]
    return subprocess.run([program, "gather", *folders, "--out", str(given.out.absolute())], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
