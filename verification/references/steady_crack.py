"""Reference values for steady viscoelastic cracks: writes or checks steady_crack.csv and steady_crack_materials.csv.

    python3 verification/references/steady_crack.py                 regenerate both files
    python3 verification/references/steady_crack.py --check         recompute all, compare to the confirmed digits
    python3 verification/references/steady_crack.py --check --reduced     the quick subset
    python3 verification/references/steady_crack.py --self-check    the closed forms against the raw integrals

Columns of steady_crack.csv and the sources of each quantity: README.md in this folder.
"""

import sys

sys.dont_write_bytecode = True

import multiprocessing
import time

import crack_cases
import materials
from common import arguments, differences, finish, read, write

COMMAND = "python3 verification/references/steady_crack.py"


def rows_of(index):
    task = crack_cases.tasks()[index]
    return task["rows"](task)


def compute(indices, jobs):
    if jobs == 1:
        parts = [rows_of(i) for i in indices]
    else:
        with multiprocessing.Pool(jobs) as pool:
            parts = pool.map(rows_of, indices, chunksize=1)
    return [row for part in parts for row in part]


def main():
    options = arguments("Reference values for steady viscoelastic cracks.")
    start = time.time()
    if options.self_check:
        import self_check
        finish(self_check.run(options.reduced), start, "self-check")
    tasks = crack_cases.tasks()
    indices = [i for i, task in enumerate(tasks) if task["reduced"] or not options.reduced]
    rows = compute(indices, options.jobs)
    material_rows = [row for material in materials.MATERIALS.values() for row in material.rows()]
    if options.check:
        stored = read("steady_crack.csv")
        wrong = differences("steady_crack.csv", stored, rows, ["case", "process_zone", "quantity"])
        wrong += differences("steady_crack_materials.csv", read("steady_crack_materials.csv"), material_rows,
                             ["material", "key", "index"])
        if not options.reduced and len(stored) != len(rows):
            wrong.append(f"steady_crack.csv: {len(stored)} rows in the file, {len(rows)} computed")
        finish(wrong, start, f"check of {len(rows)} rows")
    write("steady_crack_materials.csv", COMMAND, "linear viscoelastic solids as exact doubles",
          materials.COLUMNS, [dict(row, independence="input") for row in material_rows])
    write("steady_crack.csv", COMMAND, "steady viscoelastic cracks; columns in verification/references/README.md",
          crack_cases.COLUMNS, rows)
    print(f"written in {time.time() - start:.1f} s")


if __name__ == "__main__":
    main()
