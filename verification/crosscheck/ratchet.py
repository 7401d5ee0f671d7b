#!/usr/bin/python3
"""The ratchet: today's error of every value, and the budget that it may not outgrow.

    python3 verification/crosscheck/ratchet.py                      compare; exit 1 where an error outgrew its budget
    python3 verification/crosscheck/ratchet.py --record             the same, then lower the budgets of what became better and add what is new
    python3 verification/crosscheck/ratchet.py --record --worse WHY also raise the budgets of what became worse or drop what is gone; WHY goes into the table

ratchet.csv: group, file, row, quantity, reference, error, budget; errors over the scale of the value. A budget is FACTOR times the error of the day on which it
was recorded, or the noise of the value where that is more: some eps times its condition, or the accuracy asked of an iteration. The harness must be built
(verification/harness/build.sh).
"""

import argparse
import csv
import io
import os
import sys
from dataclasses import dataclass, field

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
TABLE = os.path.join(HERE, "ratchet.csv")
COLUMNS = ["group", "file", "row", "quantity", "reference", "error", "budget"]
FACTOR = 3.0
# An improvement of less than this is the weather.
BETTER = 0.5


@dataclass
class Assessment:
    worse: list = field(default_factory=list)       # (value, budget)
    unguarded: list = field(default_factory=list)   # values without a row
    gone: list = field(default_factory=list)        # rows without a value
    better: list = field(default_factory=list)      # (value, budget that would be recorded)

    @property
    def passes(self):
        return not (self.worse or self.unguarded or self.gone)

    def sentences(self):
        for value, budget in self.worse:
            yield f"{value.file}: {value.row} {value.quantity}: error {value.error:.2e} outgrew its budget {budget:.2e}"
        for value in self.unguarded:
            yield f"{value.file}: {value.row} {value.quantity}: no row in the ratchet; record it"
        for row in self.gone:
            yield f"{row['file']}: {row['row']} {row['quantity']}: in the ratchet, but no longer compared"


def budget_of(value):
    return max(FACTOR * value.error, value.noise)


def read(path=TABLE):
    """({key: row}, remarks of the header)."""
    if not os.path.exists(path):
        return {}, []
    with open(path, encoding="utf-8", newline="") as file:
        lines = file.read().splitlines(keepends=True)
    remarks = [line for line in lines if line.startswith("#")]
    table = csv.DictReader(io.StringIO("".join(line for line in lines if not line.startswith("#"))))
    return {(row["file"], row["row"], row["quantity"]): row for row in table}, remarks


def assess(values, table):
    assessment = Assessment()
    seen = set()
    for value in values:
        if value.key in seen:
            raise ValueError(f"two values of one name: {value.key}")
        seen.add(value.key)
        row = table.get(value.key)
        if row is None:
            assessment.unguarded.append(value)
            continue
        budget = float(row["budget"])
        if not value.error <= budget:       # NaN is worse
            assessment.worse.append((value, budget))
        elif budget_of(value) < BETTER * budget:
            assessment.better.append((value, budget_of(value)))
    assessment.gone = [row for key, row in table.items() if key not in seen]
    return assessment


def recorded(values, table, worse):
    """The new table: budgets only fall, unless `worse`."""
    out = {}
    for value in values:
        error, budget = value.error, budget_of(value)
        if value.key in table:
            old_error, old_budget = float(table[value.key]["error"]), float(table[value.key]["budget"])
            improved, raised = budget < BETTER * old_budget, worse and error > old_budget
            if not improved and not raised:
                error, budget = old_error, old_budget
        out[value.key] = dict(group=value.group, file=value.file, row=value.row, quantity=value.quantity, reference=f"{float(value.reference):.17g}", error=f"{error:.2e}",
                              budget=f"{budget:.3e}")
    return out


def write(table, remarks, path=TABLE):
    text = io.StringIO()
    text.writelines(remarks)
    writer = csv.DictWriter(text, COLUMNS, lineterminator="\n")
    writer.writeheader()
    writer.writerows(table.values())
    with open(path, "w", encoding="utf-8", newline="") as file:
        file.write(text.getvalue())


def run(values, arguments, path=TABLE):
    """The command on given values: (exit code, lines to print)."""
    table, remarks = read(path)
    assessment = assess(values, table)
    lines = [line for line in assessment.sentences() if not (arguments.record and "no row in the ratchet" in line)]
    late = [f"{v.file}: {v.row} {v.quantity}: error {v.error:.2e} misses its target {v.target:.0e}" for v in values if not v.error <= v.target]
    lines += late
    if not arguments.record:
        counts = f"{len(values)} values, {len(assessment.worse)} worse, {len(assessment.better)} better, {len(assessment.unguarded)} unguarded, {len(assessment.gone)} gone"
        return (0 if assessment.passes and not late else 1), [*lines, counts]
    if late:
        return 1, lines + ["nothing was recorded: a value misses its target"]
    if (assessment.worse or assessment.gone) and not arguments.worse:
        return 1, lines + ["nothing was recorded: say --worse WHY to record a worsening or a loss"]
    if assessment.worse or assessment.gone:
        remarks = remarks + [f"# {len(assessment.worse)} worse, {len(assessment.gone)} gone: {arguments.worse}\n"]
    write(recorded(values, table, bool(arguments.worse)), remarks, path)
    return 0, lines + [f"recorded {len(values)} values: {len(assessment.unguarded)} new, {len(assessment.better)} better, {len(assessment.worse)} worse, "
                       f"{len(assessment.gone)} gone"]


def parsed(words=None):
    parser = argparse.ArgumentParser(description="Errors against references, and their budgets.")
    parser.add_argument("--record", action="store_true", help="lower the budgets of what became better, add what is new")
    parser.add_argument("--worse", metavar="WHY", help="with --record: raise the budgets of what became worse, and say why")
    arguments = parser.parse_args(words)
    if arguments.worse and not arguments.record:
        parser.error("--worse needs --record")
    return arguments


def main():
    arguments = parsed()
    import collect
    import tools
    try:
        harness = tools.harness()
    except tools.Missing as missing:
        sys.exit(str(missing))
    code, lines = run(collect.everything(harness), arguments)
    print("\n".join(lines))
    sys.exit(code)


if __name__ == "__main__":
    main()
