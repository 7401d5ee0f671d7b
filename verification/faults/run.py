#!/usr/bin/env python3
"""Deliberate faults: each is put into a copy of the source by itself, and its check must fail by an assertion.

    python3 verification/faults/run.py                 all of faults.toml (a third of an hour when built); those caught go into caught.csv
    python3 verification/faults/run.py NAME ...        these only, in this order
    python3 verification/faults/run.py --rest          those that caught.csv does not have as they stand in the list
    python3 verification/faults/run.py --list          what there is

First every check must pass on the source as it is. A fault that does not compile, or a check that hangs, is not caught. Exit code 1: a fault survived.
The copy and its build stay in target/faults, so that the next run is quicker. Needs Python 3.11 and Rust.
"""

import argparse
import csv
import datetime
import hashlib
import io
import os
import re
import shutil
import subprocess
import sys
import time

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from fault_list import CAUGHT, COLUMNS, ROOT, failures, faults, recorded, text_of

BASE = os.path.realpath(os.path.join(ROOT, "target", "faults"))
TREE, BUILD, PASSED, WRAPPER = (os.path.join(BASE, name) for name in ("tree", "build", "passed", "rustc"))
# Little optimisation of the solver itself, none across its parts: a fault is compiled in seconds. Dependencies are optimised as ever.
FLAGS = "-C opt-level=1 -C lto=off"
# A test that takes this long hangs.
PATIENCE = 900


def copied():
    """The tracked files and what is new beside them, as they are now; files that are the same keep their time, so that nothing is built twice."""
    listing = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "-z"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    wanted = {name for name in listing.split("\0") if name and os.path.isfile(os.path.join(ROOT, name))}
    for folder, _, names in os.walk(TREE):
        for name in names:
            path = os.path.join(folder, name)
            if os.path.relpath(path, TREE) not in wanted:
                os.remove(path)
    for name in wanted:
        source, target = os.path.join(ROOT, name), os.path.join(TREE, name)
        with open(source, "rb") as file:
            content = file.read()
        if os.path.exists(target):
            with open(target, "rb") as file:
                if file.read() == content:
                    continue
        os.makedirs(os.path.dirname(target), exist_ok=True)
        shutil.copy(source, target)


def run_check(test, name):
    """(result, what was said, seconds) of one test in the copy."""
    group, _, file = test.partition("/")
    where = ["--lib"] if test == "lib" else ["--test", group]
    command = ["cargo", "test", "--release", "--locked", "--no-default-features", *where, "--", name if test == "lib" else f"{file}::{name}"]
    # One fault touches one file: what does not depend on it is not compiled again. A random case that fails need not be made smaller.
    environment = dict(os.environ, CARGO_TARGET_DIR=BUILD, CARGO_INCREMENTAL="1", RUSTC_WORKSPACE_WRAPPER=WRAPPER, CARGO_TERM_COLOR="never", RUST_BACKTRACE="0",
                       PROPTEST_MAX_SHRINK_ITERS="0")
    start = time.time()
    build = subprocess.run([*command[:-2], "--no-run"], cwd=TREE, env=environment, capture_output=True, text=True, check=False)
    if build.returncode != 0:
        return "does not compile", first(r"^error.*", build.stderr), time.time() - start
    try:
        done = subprocess.run(command, cwd=TREE, env=environment, capture_output=True, text=True, timeout=PATIENCE, check=False)
    except subprocess.TimeoutExpired:
        return "hangs", f"no end after {PATIENCE} s", time.time() - start
    seconds = time.time() - start
    if done.returncode == 0:
        return ("passes" if re.search(r"test result: ok\. [1-9]", done.stdout) else "no such test"), "", seconds
    said = first(r"panicked at .*", done.stdout + done.stderr)
    # An assertion of a test: a panic in a file of tests, or in the tests inside a source.
    where = "src/" if test == "lib" else "tests/"
    if "test result: FAILED" in done.stdout and re.search(rf"panicked at (\S+/)?{where}", done.stdout + done.stderr):
        return "fails", said, seconds
    return "breaks", said or first(r"\S.*", done.stderr), seconds


def state_of(test):
    """A hash of all that a check depends on: the copy without the files of the other tests."""
    found = hashlib.sha256()
    for folder, folders, names in os.walk(TREE):
        folders.sort()
        for name in sorted(names):
            path = os.path.relpath(os.path.join(folder, name), TREE)
            if not (re.match("verification/(?!figures|baselines)", path) or re.fullmatch(r"tests/(?!support|command_support)\w+/\w+\.rs", path) and path != f"tests/{test}.rs"):
                with open(os.path.join(TREE, path), "rb") as file:
                    found.update(path.encode() + file.read() if not path.endswith(".svg") else b"")
    return found.hexdigest()


def passes_unharmed(test, name):
    """Whether a check passes on the source as it is; what passed before on the same source is not run again."""
    line = f"{state_of(test)} {test}::{name}"
    if os.path.exists(PASSED):
        with open(PASSED, encoding="utf-8") as file:
            if line in file.read().splitlines():
                return True
    result, said, seconds = run_check(test, name)
    print(f"{test}::{name}: {result} ({seconds:.0f} s) {said if result != 'passes' else ''}".rstrip(), flush=True)
    if result == "passes":
        with open(PASSED, "a", encoding="utf-8") as file:
            file.write(line + "\n")
    return result == "passes"


def first(pattern, text):
    found = re.search(pattern, text, re.MULTILINE)
    if not found:
        return ""
    rest = text[found.end():].strip().splitlines()[:2]
    return " ".join([found.group(0), *rest])[:160]


def written(path, text):
    with open(os.path.join(TREE, path), "w", encoding="utf-8", newline="") as file:
        file.write(text)


def record(row):
    """Puts one caught fault into the table, at once: a run that is cut short loses nothing."""
    names = {fault.name for fault in faults()}
    rows = {old["fault"]: old for old in (recorded() if os.path.exists(CAUGHT) else []) if old["fault"] in names} | {row["fault"]: row}
    text = io.StringIO()
    text.write("# about: deliberate faults, each put into the source by itself, and the assertion that failed for it\n# command: python3 verification/faults/run.py\n")
    writer = csv.DictWriter(text, COLUMNS, lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows[name] for name in sorted(rows))
    with open(CAUGHT, "w", encoding="utf-8", newline="") as file:
        file.write(text.getvalue())


def commit():
    command = ["git", "describe", "--always", "--dirty", "--abbrev=12", "--exclude=*"]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False).stdout.strip() or "unknown"


def main():
    parser = argparse.ArgumentParser(description="Deliberate faults, each of which a check must catch.")
    parser.add_argument("name", nargs="*", help="these faults only")
    parser.add_argument("--rest", action="store_true", help="only those that caught.csv does not have as they are now")
    parser.add_argument("--list", action="store_true", help="say what there is and end")
    arguments = parser.parse_args()
    everything = faults()
    wrong = list(failures())
    if wrong:
        sys.exit("\n".join(wrong))
    unknown = set(arguments.name) - {fault.name for fault in everything}
    if unknown:
        sys.exit(f"no fault is called {', '.join(sorted(unknown))}")
    chosen = [fault for fault in everything if not arguments.name or fault.name in arguments.name]
    if arguments.rest:
        chosen = [fault for fault in chosen if fault.hash not in {row["sha256"] for row in recorded()}]
    if arguments.list:
        for fault in chosen:
            print(f"{fault.name:40} {fault.solver:20} {fault.check}\n{'':40} {fault.why}")
        return
    # By test and file: fewer links, smaller builds. Names that are given are taken in their order.
    chosen.sort(key=lambda fault: arguments.name.index(fault.name) if arguments.name else (fault.test, fault.file))
    os.makedirs(TREE, exist_ok=True)
    copied()
    with open(WRAPPER, "w", encoding="utf-8") as file:
        file.write(f'#!/bin/sh\nexec "$@" {FLAGS}\n')
    os.chmod(WRAPPER, 0o755)
    print(f"the source as it is: {len({fault.check for fault in chosen})} checks", flush=True)
    failing = sum(not passes_unharmed(test, name) for test, name in sorted({(fault.test, fault.filter) for fault in chosen}))
    if failing:
        sys.exit(f"{failing} checks do not pass on the source as it is")
    survivors = []
    version, today = commit(), datetime.date.today().isoformat()
    for count, fault in enumerate(chosen, 1):
        source = text_of(fault.file, TREE)
        written(fault.file, source.replace(fault.find, fault.replace))
        try:
            result, said, seconds = run_check(fault.test, fault.filter)
        finally:
            written(fault.file, source)
        result = "caught" if result == "fails" else f"SURVIVED: the check {result}"
        print(f"{count}/{len(chosen)} {fault.name:40} {result:8} {seconds:5.0f} s  {said}", flush=True)
        if result == "caught":
            record(dict(zip(COLUMNS, [fault.name, fault.solver, fault.file, fault.check, said, f"{seconds:.0f}", version, today, fault.hash])))
        else:
            survivors.append(fault.name)
    print(f"{len(chosen)} faults, {len(chosen) - len(survivors)} caught" + (f"; SURVIVED: {', '.join(survivors)}" if survivors else ""))
    sys.exit(1 if survivors else 0)


if __name__ == "__main__":
    main()
