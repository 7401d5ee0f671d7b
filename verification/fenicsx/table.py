#!/usr/bin/python3
"""The tables of docs/src/verification/finite_elements.md, from fenicsx.csv and the solver: prints Markdown.

    verification/harness/build.sh && /usr/bin/python3 verification/fenicsx/table.py
"""

import os
import sys

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(os.path.dirname(HERE), "crosscheck")]

import statistics

import elements
import tools


def errors(harness):
    """(row, error of the value, errors of the raw values), over the scale."""
    for own in elements.histories().values():
        found, places = elements.followed(harness, own[0], own)
        for row in own:
            exact, scale = elements.value_of(row, found, places), float(row["scale"])
            raw = [float(v) for v in row["by_mesh"].split()]
            steps = [float(v) for v in row["by_step"].split()]
            yield row, abs(float(row["value"]) - exact) / scale, [abs(v - exact) / scale for v in raw], [abs(v - exact) / scale for v in steps], raw, exact, scale


def worst_and_median(values):
    return f"{max(values):.0e} ({statistics.median(values):.0e})"


def main():
    found = list(errors(tools.harness()))
    print("| history | values | force | K | closure work | displacement |")
    print("|---|---|---|---|---|---|")
    names = dict.fromkeys((row["kind"], row["case"]) for row, *_ in found if row["kind"] in ("prescribed", "cycle"))
    for kind, case in names:
        own = [(row, error) for row, error, *_ in found if (row["kind"], row["case"]) == (kind, case)]
        cells = [f"{max(error for row, error in own if row['quantity'] == q):.0e}" for q in ("force", "stress_intensity_factor", "zone_work", "displacement")]
        print(f"| {case} | {len(own)} | " + " | ".join(cells) + " |")
    print()
    print("| elements a zone | force | K | closure work | displacement |")
    print("|---|---|---|---|---|")
    histories = [f for f in found if f[0]["kind"] in ("prescribed", "cycle")]
    for label, of in (("3", lambda f: f[2][0]), ("6", lambda f: f[2][1]), ("9", lambda f: f[2][2]),
                      ("3, 6", lambda f: abs(2 * f[4][1] - f[4][0] - f[5]) / f[6]), ("6, 9", lambda f: abs(3 * f[4][2] - 2 * f[4][1] - f[5]) / f[6]), ("3, 6, 9", lambda f: f[1])):
        cells = [worst_and_median([of(f) for f in histories if f[0]["quantity"] == q]) for q in ("force", "stress_intensity_factor", "zone_work", "displacement")]
        print(f"| {label} | " + " | ".join(cells) + " |")
    print()
    print("| punch: steps an octave | force | displacement |")
    print("|---|---|---|")
    punches = [f for f in found if f[0]["kind"] == "punch"]
    for index, label in enumerate(("4", "8", "16")):
        print(f"| {label} | " + " | ".join(worst_and_median([f[3][index] for f in punches if f[0]["quantity"] == q]) for q in ("force", "displacement")) + " |")
    print("| extrapolated | " + " | ".join(worst_and_median([f[1] for f in punches if f[0]["quantity"] == q]) for q in ("force", "displacement")) + " |")
    for index, label in enumerate(("P2", "P3", "P4")):
        print(f"| 16, {label} | " + " | ".join(worst_and_median([f[2][index] for f in punches if f[0]["quantity"] == q]) for q in ("force", "displacement")) + " |")
    print()
    print("| edge | by | P2 or coarse | | finest | value |")
    print("|---|---|---|---|---|---|")
    for row, error, raw, *_ in found:
        if row["kind"] in ("elastic", "increment"):
            print(f"| {row['case']}: {row['quantity'].replace('_', ' ')} | {row['place']} | " + " | ".join(f"{e:.0e}" for e in raw) + f" | {error:.0e} |")
    print()
    late = [f for f in found if f[1] > 1e-3]
    print(f"{len(found)} values, {sum(f[1] <= 1e-4 for f in found)} within 1e-4, {len(found) - len(late)} within 1e-3, worst {max(f[1] for f in found):.1e}")


if __name__ == "__main__":
    main()
