"""Fixtures: the harness and every comparison. A missing tool is a visible skip, and a failure where CI=true."""

import os
import sys

import pytest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.dont_write_bytecode = True

import collect
import tools


def needed(get):
    try:
        return get()
    except tools.Missing as missing:
        if tools.must_not_be_missing():
            pytest.fail(f"CI=true, and {missing}", pytrace=False)
        pytest.skip(str(missing))


@pytest.fixture(scope="session")
def harness():
    return needed(tools.harness)


@pytest.fixture(scope="session")
def need():
    """A Python module by name."""
    return lambda name: needed(lambda: tools.module(name))


@pytest.fixture(scope="session")
def everything(harness):
    return collect.everything(harness)


def pytest_terminal_summary(terminalreporter):
    for line in getattr(tools, "SUMMARY", []):
        terminalreporter.write_line(line)
