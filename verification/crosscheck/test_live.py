"""References recomputed now, at reduced size, by their own scripts: what is committed is what they give.

The scripts run two at a time beside the other tests; `ci/test.sh --full` recomputes everything instead.
"""

import concurrent.futures
import os
import subprocess
import sys

import pytest

import tools

# Script: what it needs. The longest first.
SCRIPTS = {
    "indentation": ["mpmath"],
    "steady_crack": ["mpmath"],
    "broad_laws": ["mpmath"],
    "isotropic_solid": ["mpmath"],
    "memory_clausen": ["mpmath"],
    "cohesive_kernel": ["mpmath"],
    "periodic_green": ["mpmath"],
    "sphere_annuli": ["mpmath", "numpy", "scipy"],
    "elliptic": ["mpmath"],
    "delayed_fracture": ["mpmath"],
    "line_panels": ["mpmath", "numpy"],
    "rolling_cylinders": ["mpmath", "numpy", "scipy"],
    "contact_rolling": ["mpmath", "numpy", "scipy"],
    "indentation_shape": ["mpmath"],
    "sliding_held_loads": ["mpmath", "numpy", "scipy"],
    "adhesiveless": ["mpmath"],
    "delayed_events": ["numpy"],
    "punch_rim": [],
    "edge_speed": [],
    "sliding_hysteresis": ["mpmath"],
    "sliding_wave": ["mpmath"],
    "material_conversion": ["mpmath"],
    "dawson": ["mpmath"],
    "exponential_mean": ["mpmath"],
    "tread_dma": ["mpmath"],
}
# The elastic references know no subset: only the full run.
FULL_ONLY = {"elastic"}
HELPERS = {"spring_bed", "common", "condition", "crack_cases", "materials", "cohesive_zone", "persson_brener", "raw_crack_work", "self_check", "ting_graham"}
HELPERS |= {f"ting_graham_{part}" for part in ("chebyshev", "roots", "solid", "shapes", "pieces", "runs", "line", "edge", "contact", "levels", "equations", "radius",
                                               "load", "step", "history", "self_check")}


def run(script):
    command = [sys.executable, os.path.join(tools.REFERENCES, f"{script}.py"), "--check", "--reduced"]
    environment = dict(os.environ, PYTHONDONTWRITEBYTECODE="1", OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
    return subprocess.run(command, capture_output=True, text=True, timeout=900, env=environment, check=False)


@pytest.fixture(scope="module")
def runs():
    available = [script for script, modules in SCRIPTS.items() if all(installed(name) for name in modules)]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        yield {script: pool.submit(run, script) for script in available}


def installed(name):
    try:
        tools.module(name)
        return True
    except tools.Missing:
        return False


@pytest.mark.parametrize("script", SCRIPTS)
def test_reference_is_what_its_script_gives(script, runs, need):
    for name in SCRIPTS[script]:
        need(name)
    found = runs[script].result()
    assert found.returncode == 0, found.stdout[-2000:] + found.stderr[-2000:]


def test_no_script_is_forgotten():
    there = {name[:-3] for name in os.listdir(tools.REFERENCES) if name.endswith(".py")}
    assert there == set(SCRIPTS) | FULL_ONLY | HELPERS
