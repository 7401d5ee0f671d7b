"""The list of deliberate faults: each can still be put into the source, names a check that is there, and was caught as it stands in the list.

`python3 verification/faults/run.py` puts them in and runs the checks; that takes a third of an hour, this a moment.
"""

import os
import subprocess
import sys

import tools

sys.path.insert(0, os.path.join(tools.ROOT, "verification", "faults"))
import fault_list


def test_every_fault_fits_the_source_and_names_a_check():
    wrong = list(fault_list.failures())
    assert not wrong, "\n".join(wrong)


def test_every_fault_was_caught_as_it_stands():
    caught = {row["fault"]: row for row in fault_list.recorded()}
    there = {fault.name: fault for fault in fault_list.faults()}
    assert set(caught) == set(there), f"run python3 verification/faults/run.py --rest: {sorted(set(caught) ^ set(there))}"
    stale = [name for name, fault in there.items() if caught[name]["sha256"] != fault.hash]
    assert not stale, f"changed since they were caught; run python3 verification/faults/run.py --rest: {stale}"
    assert all("panicked at" in row["said"] for row in caught.values())
    tools.SUMMARY.append(f"faults: {len(there)} in the list, all caught")


def test_the_list_is_printed_by_the_program_that_puts_faults_in():
    runner = os.path.join(tools.ROOT, "verification", "faults", "run.py")
    listed = subprocess.run([sys.executable, runner, "--list"], capture_output=True, text=True, check=True).stdout
    assert all(fault.name in listed for fault in fault_list.faults())
