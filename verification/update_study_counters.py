#!/usr/bin/env python3
"""Takes the work counters of reports over into verification/study_counters.csv, after a look at what changed.

    viscotack verify --out DIR && python3 verification/update_study_counters.py DIR
    python3 verification/update_study_counters.py DIR FULL           both efforts; FULL is a report of `verify --full`
    python3 verification/update_study_counters.py --drop DIR FULL    counters that no report has go

Prints every counter that changed. Without --drop counters that no report has stay. Where two reports count the same run differently nothing is written: the name of
the run lacks what its work depends on.
"""

import csv
import pathlib
import sys

FILE = pathlib.Path(__file__).with_name("study_counters.csv")
COLUMNS = ["problem", "run", "counted", "count"]


def counted(folders):
    found = {}
    for path in [path for folder in folders for path in sorted(folder.glob("*_counters.csv"))]:
        with open(path, encoding="utf-8", newline="") as file:
            for row in csv.DictReader(file):
                key, count = (row["problem"], row["run"], row["counted"]), row["count [1]"]
                if found.setdefault(key, count) != count:
                    sys.exit(f"{path}: {' '.join(key)} is {count}, and {found[key]} in another report; nothing written")
    return found


def main():
    arguments = sys.argv[1:]
    drop = "--drop" in arguments
    folders = [pathlib.Path(name) for name in arguments if name != "--drop"]
    found = counted(folders)
    if not found:
        sys.exit(__doc__)
    with open(FILE, encoding="utf-8", newline="") as file:
        counters = {(row["problem"], row["run"], row["counted"]): row["count"] for row in csv.DictReader(file)}
    for key, count in found.items():
        if counters.get(key) != count:
            print(*key, counters.get(key, "new"), "->", count)
        counters[key] = count
    others = [key for key in counters if key not in found]
    for key in others if drop else []:
        print(*key, counters.pop(key), "-> dropped")
    if others and not drop:
        print(len(others), "stored counters are in no report and stay")
    with open(FILE, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        writer.writerows([*key, count] for key, count in counters.items())


if __name__ == "__main__":
    main()
