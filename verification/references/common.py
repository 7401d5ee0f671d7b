"""What every reference script shares: numbers, quadrature nodes, files with a header, the command line.

Numbers
    exact(x)        the mpf that equals the double x bit for bit; every input goes through it
    number(x)       32 significant digits, scientific notation; read back by any f64 or bignum parser
    confirmed(a,b)  whole digits in which two computations of one value agree, at most 32

Two settings, one value
    Every value is computed twice, with COARSE and with FINE. FINE has more digits, more nodes on each panel and a
    longer cut-off of the exponential memory. The file carries the FINE value; `confirmed_digits` is the agreement.

Files
    header lines "# key: value", then a CSV table. "sha256" is the hash of everything after the header.
"""

import argparse
import csv
import hashlib
import io
import os
import sys
import time
from dataclasses import dataclass

import mpmath
from mpmath import mp, mpf

VERSION = "1.0.0"
DIGITS = 32
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
DATA = os.path.join(ROOT, "reference_data")


# ---------------------------------------------------------------- numbers

def exact(x):
    """The double x as an mpf, with no decimal detour."""
    return mpf(float(x))


def number(x, digits=DIGITS):
    return mp.nstr(mpf(x), digits, min_fixed=0, max_fixed=0)


def double(x):
    """The shortest decimal that reads back as exactly the double x."""
    return repr(float(x))


def confirmed(coarse, fine):
    difference = abs(mpf(coarse) - mpf(fine))
    if difference == 0:
        return DIGITS
    if fine == 0:
        return 0
    return max(0, min(DIGITS, int(mp.floor(-mp.log10(difference / abs(mpf(fine)))))))


# ---------------------------------------------------------------- quadrature

@dataclass(frozen=True)
class Setting:
    """digits carried, Gauss nodes a panel, exponent at which e^{-x} is dropped."""
    name: str
    dps: int
    nodes: int
    cutoff: int


COARSE = Setting("coarse", 42, 38, 90)
FINE = Setting("fine", 60, 52, 132)
_NODES = {}


def gauss(setting):
    """Gauss-Legendre nodes and weights on (0, 1), by Newton iteration on the Legendre recurrence."""
    if setting in _NODES:
        return _NODES[setting]
    n, out = setting.nodes, []
    with mp.workdps(setting.dps + 15):
        for k in range(1, n + 1):
            x = mp.cos(mp.pi * (mpf(k) - mpf(1) / 4) / (n + mpf(1) / 2))
            while True:
                p0, p1 = mpf(1), x
                for m in range(2, n + 1):
                    p0, p1 = p1, ((2 * m - 1) * x * p1 - (m - 1) * p0) / m
                slope = n * (x * p1 - p0) / (x * x - 1)
                step = p1 / slope
                x -= step
                if abs(step) < mpf(10) ** (-setting.dps - 5):
                    break
            out.append(((1 + x) / 2, 1 / ((1 - x * x) * slope * slope)))
    _NODES[setting] = out
    return out


def panels(setting, function, breaks):
    """Sum of Gauss rules of `function` over the consecutive intervals of `breaks`."""
    total = mpf(0)
    rule = gauss(setting)
    for lower, upper in zip(breaks[:-1], breaks[1:]):
        width = upper - lower
        if width > 0:
            total += width * mp.fsum(w * function(lower + width * x) for x, w in rule)
    return total


def geometric(lower, upper, ratio):
    """Break points lower, lower*ratio, ... upper (the last interval is the short one)."""
    out = [lower]
    while out[-1] * ratio < upper:
        out.append(out[-1] * ratio)
    out.append(upper)
    return out


# ---------------------------------------------------------------- files

def table(columns, rows):
    text = io.StringIO()
    writer = csv.DictWriter(text, columns, lineterminator="\n", restval="")
    writer.writeheader()
    writer.writerows(rows)
    return text.getvalue()


def write(name, command, about, columns, rows, precision=None, tool=None):
    """Where no row says otherwise, its values are independent of the solver's reductions."""
    if "independence" not in columns:
        columns = [*columns, "independence"]
    rows = [{"independence": "independent", **row} for row in rows]
    body = table(columns, rows)
    header = [
        ("file", name),
        ("about", about),
        ("tool", tool or f"mpmath {mpmath.__version__}, generator version {VERSION}"),
        ("precision", precision or f"{FINE.dps} digits, {FINE.nodes} nodes a panel; confirmed against {COARSE.dps} digits, "
                                   f"{COARSE.nodes} nodes; {DIGITS} digits printed"),
        ("command", command),
        ("sha256", hashlib.sha256(body.encode()).hexdigest()),
    ]
    os.makedirs(DATA, exist_ok=True)
    with open(os.path.join(DATA, name), "w", encoding="utf-8", newline="") as file:
        file.write("".join(f"# {key}: {value}\n" for key, value in header) + body)
    print(f"{name}: {len(rows)} rows")


def read(name):
    """Rows of a reference file; refuses a file whose hash does not match its header."""
    with open(os.path.join(DATA, name), encoding="utf-8", newline="") as file:
        text = file.read()
    lines = text.splitlines(keepends=True)
    count = next(i for i, line in enumerate(lines) if not line.startswith("#"))
    header = dict(line[2:].rstrip("\n").split(": ", 1) for line in lines[:count])
    body = "".join(lines[count:])
    if hashlib.sha256(body.encode()).hexdigest() != header["sha256"]:
        sys.exit(f"{name}: the content does not match the sha256 in its header")
    return list(csv.DictReader(io.StringIO(body)))


def differences(name, stored, fresh, keys):
    """Compare rows found in both; `value` to the stored confirmed digits, every other column literally."""
    known = {tuple(row[k] for k in keys): row for row in stored}
    wrong = []
    for row in fresh:
        key = tuple(str(row.get(k, "")) for k in keys)
        old = known.get(key)
        if old is None:
            wrong.append(f"{name}: {key} is not in the file")
            continue
        for column, text in old.items():
            new = str(row.get(column, ""))
            if new == text or column == "confirmed_digits" or (column == "independence" and column not in row):
                continue
            digits = int(old.get("confirmed_digits") or DIGITS)
            try:
                with mp.workdps(60):
                    a, b = mpf(text), mpf(new)
                    same = abs(a - b) <= abs(b) * mpf(10) ** (1 - min(digits, DIGITS - 1))
            except ValueError:
                same = False
            if not same:
                wrong.append(f"{name}: {key} {column}: file {text}, recomputed {new}")
    return wrong


# ---------------------------------------------------------------- command line

def arguments(description):
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--check", action="store_true", help="recompute and compare, write nothing; exit 1 on a mismatch")
    parser.add_argument("--reduced", action="store_true", help="with --check or --self-check: a quick subset")
    parser.add_argument("--self-check", action="store_true", help="show that independent routes agree; write nothing")
    parser.add_argument("--jobs", type=int, default=1, help="processes (default 1)")
    options = parser.parse_args()
    if options.reduced and not (options.check or options.self_check):
        parser.error("--reduced needs --check or --self-check: a partial file is never written")
    return options


def finish(wrong, start, what):
    for line in wrong:
        print(line)
    print(f"{what}: {'FAILED, ' + str(len(wrong)) + ' differences' if wrong else 'passed'} "
          f"in {time.time() - start:.1f} s")
    sys.exit(1 if wrong else 0)
