"""What a comparison is: a value of the solver, a value of a reference, and on what scale they are assessed.

error      |value - reference|/scale, the difference taken exactly in decimals, so that 32-digit references lose nothing
target     the error that the group promises; none where the reference serves another purpose
noise      what a change of machine or of the last step may move the value by, over its scale: some eps times the condition, or the
           accuracy that was asked of an iterative solution. A budget is never below it.
"""

import csv
import hashlib
import io
import os
from dataclasses import dataclass
from decimal import Decimal, getcontext

getcontext().prec = 60
EPS = 2.0 ** -52
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
DATA = os.path.join(ROOT, "reference_data")


@dataclass(frozen=True)
class Value:
    group: str          # special, cracks, sliding, sphere, ...
    file: str
    row: str            # what distinguishes the row in its file
    quantity: str
    value: float
    reference: str      # the decimal of the file, or its product with an exact factor
    scale: float        # > 0
    target: float
    noise: float
    state: str = ""     # values of one state or history share it
    independent: bool = True

    @property
    def key(self):
        return self.file, self.row, self.quantity

    @property
    def error(self):
        if self.value != self.value or self.value in (float("inf"), float("-inf")):
            return float("inf")
        return float(abs(Decimal(self.value) - Decimal(self.reference)) / Decimal(self.scale))


def relative(group, file, row, quantity, value, reference, target, condition=1.0, **more):
    """A value assessed against itself: the usual case."""
    size = abs(float(Decimal(reference)))
    return Value(group, file, row, quantity, float(value), reference, size if size > 0.0 else 1.0, target, 4.0 * EPS * condition, **more)


def rows(name):
    """Rows of a reference file; one whose content does not have the hash in its header is refused."""
    with open(os.path.join(DATA, name), encoding="utf-8", newline="") as file:
        text = file.read()
    lines = text.splitlines(keepends=True)
    count = next(i for i, line in enumerate(lines) if not line.startswith("#"))
    header = dict(line[2:].rstrip("\n").split(": ", 1) for line in lines[:count])
    body = "".join(lines[count:])
    if hashlib.sha256(body.encode()).hexdigest() != header["sha256"]:
        raise ValueError(f"{name}: the content does not match the sha256 in its header")
    return list(csv.DictReader(io.StringIO(body)))


def made_independently(row):
    """Whether the file says that the value shares no reduction with the solver."""
    return row["independence"] == "independent"


def headers():
    """{file: header} of every reference file."""
    out = {}
    for name in sorted(os.listdir(DATA)):
        if name.endswith(".csv"):
            with open(os.path.join(DATA, name), encoding="utf-8") as file:
                out[name] = dict(line[2:].rstrip("\n").split(": ", 1) for line in file if line.startswith("# "))
    return out


def floats(text, separator=None):
    return [float(part) for part in text.split(separator)]
