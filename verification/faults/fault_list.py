"""The committed list of faults: read, and checked against the tree without building anything."""

import csv
import hashlib
import os
import re
import tomllib
from dataclasses import dataclass

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
CAUGHT = os.path.join(HERE, "caught.csv")
COLUMNS = ["fault", "solver", "file", "check", "said", "seconds", "commit", "date", "sha256"]
LEAST = 30
# Every room of the solver has a fault at least.
SOLVERS = {"material", "special functions", "closure", "crack, steady", "crack, delayed", "sliding", "sliding, branches", "layers", "indentation", "oscillation",
           "energies", "elastic forms", "scenes and units", "figures"}


@dataclass(frozen=True)
class Fault:
    name: str
    solver: str
    file: str
    find: str
    replace: str
    test: str       # a file of tests/ without its ending, or `lib` for the tests inside src/
    filter: str     # a test of that file
    why: str

    @property
    def check(self):
        return f"{self.test}::{self.filter}"

    @property
    def hash(self):
        """Of all that decides the result."""
        parts = (self.file, self.find, self.replace, self.test, self.filter)
        return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:16]


def faults():
    with open(os.path.join(HERE, "faults.toml"), "rb") as file:
        return [Fault(**entry) for entry in tomllib.load(file)["fault"]]


def text_of(path, root=ROOT):
    with open(os.path.join(root, path), encoding="utf-8", newline="") as file:
        return file.read()


def test_of(fault, root=ROOT):
    """The file that holds the check."""
    return fault.file if fault.test == "lib" else f"tests/{fault.test}.rs"


def failures(root=ROOT):
    """What is wrong with the list, sentence by sentence."""
    everything, names = faults(), set()
    if len(everything) < LEAST:
        yield f"{len(everything)} faults, {LEAST} were promised"
    for fault in everything:
        if fault.name in names:
            yield f"{fault.name}: two faults of one name"
        names.add(fault.name)
        if fault.solver not in SOLVERS:
            yield f"{fault.name}: no solver is called {fault.solver}"
        if fault.find == fault.replace or not fault.why:
            yield f"{fault.name}: changes nothing, or says not why it is wrong"
        if not fault.file.startswith(("src/", "program/src/", "cli/src/", "verification/src/")):
            yield f"{fault.name}: {fault.file} is no source of the solver or of its program"
        count = text_of(fault.file, root).count(fault.find)
        if count != 1:
            yield f"{fault.name}: {count} places in {fault.file} read as the text to replace, not one"
        if not re.search(rf"#\[test\]\s*(?:#\[[^\n]*\]\s*)*fn {re.escape(fault.filter)}\(", text_of(test_of(fault, root), root)):
            yield f"{fault.name}: {test_of(fault, root)} has no test {fault.filter}"
    for solver in sorted(SOLVERS - {fault.solver for fault in everything}):
        yield f"no fault in: {solver}"


def recorded():
    """The rows of caught.csv."""
    with open(CAUGHT, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))
