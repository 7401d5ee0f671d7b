"""What the cross-checks need and where it is: the built harness, reference scripts, and what to do where a tool is missing."""

import importlib
import os
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
REFERENCES = os.path.join(ROOT, "verification", "references")
FENICSX = os.path.join(ROOT, "verification", "fenicsx")
TARGET = os.environ.get("CARGO_TARGET_DIR", os.path.join(ROOT, "target"))
# Packages of Debian by the modules that they bring.
PACKAGES = {"numpy": "python3-numpy", "scipy": "python3-scipy", "mpmath": "python3-mpmath", "dolfinx": "python3-dolfinx"}
sys.dont_write_bytecode = True


class Missing(Exception):
    """A tool is not there; the message says how to get it."""


def harness():
    folder = os.path.join(TARGET, "harness")
    if folder not in sys.path:
        sys.path.insert(0, folder)
    module("numpy")
    try:
        return importlib.import_module("viscotack_harness")
    except ImportError as error:
        raise Missing(f"the harness is not built ({error}): verification/harness/build.sh") from error


def module(name):
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise Missing(f"no Python module {name}: apt-get install {PACKAGES.get(name, name)}") from error


def must_not_be_missing():
    return os.environ.get("CI") == "true"


# Lines that pytest prints before its closing line.
SUMMARY = []
