#!/usr/bin/env python3
"""Takes the work counters of a report over into verification/study_counters.csv, after a look at what changed.

    viscotack verify --out DIR && python3 verification/update_study_counters.py DIR

Prints every counter that changed. Counters of runs that the report does not have, as those of `--full`, stay.
"""

import csv
import pathlib
import sys

FILE = pathlib.Path(__file__).with_name("study_counters.csv")
COLUMNS = ["problem", "run", "counted", "count"]


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    with open(FILE, encoding="utf-8", newline="") as file:
        counters = {(row["problem"], row["run"], row["counted"]): row["count"] for row in csv.DictReader(file)}
    for path in sorted(pathlib.Path(sys.argv[1]).glob("*_counters.csv")):
        with open(path, encoding="utf-8", newline="") as file:
            for row in csv.DictReader(file):
                key = (row["problem"], row["run"], row["counted"])
                if counters.get(key) != row["count [1]"]:
                    print(*key, counters.get(key, "new"), "->", row["count [1]"])
                counters[key] = row["count [1]"]
    with open(FILE, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        writer.writerows([*key, count] for key, count in counters.items())


if __name__ == "__main__":
    main()
