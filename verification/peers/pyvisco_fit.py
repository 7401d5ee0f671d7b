"""pyvisco and viscotack fit series to the same dynamic moduli: error, number of terms, time.

    python3 verification/peers/pyvisco_fit.py PROGRAM        writes verification/peers/pyvisco_fit.csv

Needs pyvisco (2.1.3 on PyPI, with numpy, scipy, pandas, matplotlib) in an environment of its own, and PROGRAM, a built viscotack.
Data: (rubber) the twelve terms of scenes/materials/rubber_12_terms.toml without noise, ten frequencies a decade; (noisy) the
same with 2 % noise; (tread) scenes/materials/tread_dma.csv shifted to 20 degrees Celsius by its own WLF constants.
Methods: pyvisco as its documentation runs it (one term a decade, `prony.fit_freq`), its reduction (`opt.nprony`, L-BFGS-B), and
viscotack at its default. Errors: root mean square and largest relative residual of E' and E'', each relative to itself; against
the truth, the same for the curve without noise. Times are wall seconds on one machine, process start included for viscotack:
an order of magnitude, no more. pyvisco minimises absolute residuals (relative to the glassy modulus), so a relative measure of a
soft tail is not what it was made for; the absolute measure, residuals over the largest E', stands beside it.
"""

import csv
import hashlib
import io
import json
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import time
import warnings

import matplotlib

matplotlib.use("Agg")
import numpy as np
import pandas as pd
import pyvisco
from pyvisco import load, master, opt, prony

ROOT = pathlib.Path(__file__).resolve().parents[2]
TWO_PI = 2 * math.pi


def series(constant, terms, omega):
    x = np.outer(omega, [time for _, time in terms])
    strengths = np.array([strength for strength, _ in terms])
    return constant + (x**2 / (1 + x**2)) @ strengths, (x / (1 + x**2)) @ strengths


def rubber_terms():
    text = (ROOT / "scenes/materials/rubber_12_terms.toml").read_text()
    unit = {"s": 1, "ms": 1e-3, "µs": 1e-6, "ns": 1e-9}
    found = re.findall(r'modulus = "([\d.]+) MPa", relaxation_time = "([\d.]+) (\S+)"', text)
    return 1.1e6, [(float(e) * 1e6, float(t) * unit[u]) for e, t, u in found]


def data_sets():
    constant, terms = rubber_terms()
    f = np.logspace(-4, 10.5, 146)
    truth = series(constant, terms, TWO_PI * f)
    normal = random.Random(1).gauss
    noise = np.array([[1 + 0.02 * normal(0, 1) for _ in f] for _ in range(2)])
    yield "rubber", f, truth, truth
    yield "noisy", f, (truth[0] * noise[0], truth[1] * noise[1]), truth
    rows = []
    for line in (ROOT / "scenes/materials/tread_dma.csv").read_text().splitlines()[3:]:
        celsius, frequency, storage, loss = map(float, line.split(","))
        rows.append((frequency * 10 ** (-10 * (celsius - 20) / (120 + celsius - 20)), storage * 1e6, loss * 1e6))
    rows.sort()
    f, storage, loss = map(np.array, zip(*rows))
    w = TWO_PI * f
    value = 3.5e6 + sum(d * (1j * w * t) ** a / (1 + (1j * w * t) ** a) for d, t, a in [(1.9e9, 2e-8, 0.62), (7e6, 3e-3, 0.28)])
    yield "tread", f, (storage, loss), (value.real, value.imag)


def errors(model, data):
    relative = np.concatenate([m / d - 1 for m, d in zip(model, data)])
    absolute = np.concatenate([(m - d) / data[0].max() for m, d in zip(model, data)])
    return math.sqrt(np.mean(relative**2)), np.abs(relative).max(), math.sqrt(np.mean(absolute**2))


def by_pyvisco(f, data, reduce):
    text = "f,E_stor,E_loss\nHz,MPa,MPa\n" + "".join(f"{a:.17g},{b / 1e6:.17g},{c / 1e6:.17g}\n" for a, b, c in zip(f, *data))
    frame, _ = load.user_master(text.encode(), "freq", 20, "E")
    frame = master.smooth(frame, 1)
    start = time.perf_counter()
    found = prony.fit_freq(prony.discretize(frame), frame, opt=False)
    if reduce:
        many, best, _ = opt.nprony(frame, found)
        found = many[best]
    seconds = time.perf_counter() - start
    table = found["df_terms"]
    whole = found["E_0"]
    terms = [(whole * a * 1e6, t) for a, t in zip(table["alpha_i"], table["tau_i"]) if a > 0]
    return whole * 1e6 * (1 - table["alpha_i"].sum()), terms, seconds


def by_viscotack(program, f, data):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "data.csv"
        path.write_text("frequency (Hz), storage modulus (Pa), loss modulus (Pa)\n" + "".join(f"{a:.17g},{b:.17g},{c:.17g}\n" for a, b, c in zip(f, *data)))
        start = time.perf_counter()
        answer = subprocess.run([program, "material", str(path), "--json"], capture_output=True, text=True, check=True)
        seconds = time.perf_counter() - start
    found = json.loads(answer.stdout)
    return found["relaxed_modulus"], [(t["modulus"], t["relaxation_time"]) for t in found["relaxation"]], seconds


def main():
    program = sys.argv[1]
    warnings.filterwarnings("ignore")
    rows = []
    for name, f, data, truth in data_sets():
        for method, solve in [("viscotack", lambda: by_viscotack(program, f, data)), ("pyvisco", lambda: by_pyvisco(f, data, False)),
                              ("pyvisco reduced", lambda: by_pyvisco(f, data, True))]:
            constant, terms, seconds = solve()
            model = series(constant, terms, TWO_PI * f)
            rms, largest, absolute = errors(model, data)
            rows.append([name, method, len(terms), f"{rms:.3e}", f"{largest:.3e}", f"{absolute:.3e}", f"{errors(model, truth)[0]:.3e}", f"{seconds:.2f}"])
            print(*rows[-1], flush=True)
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["data", "method", "terms", "rms_relative", "largest_relative", "rms_of_largest_modulus", "rms_relative_to_truth", "seconds"])
    writer.writerows(rows)
    body = text.getvalue()
    version = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout.strip()
    head = [
        "# about: series fitted to the same dynamic moduli by two programs",
        "# command: python3 verification/peers/pyvisco_fit.py PROGRAM",
        f"# tool: pyvisco {pyvisco.__version__ if hasattr(pyvisco, '__version__') else '2.1.3'}, numpy {np.__version__}, pandas {pd.__version__}; {version}",
        f"# sha256: {hashlib.sha256(body.encode()).hexdigest()}",
    ]
    (ROOT / "verification/peers/pyvisco_fit.csv").write_text("\n".join(head) + "\n" + body)


if __name__ == "__main__":
    main()
