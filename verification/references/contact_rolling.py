"""CONTACT's example `visc_cylindr` with CONTACT's own discretisation, which lands on every digit that it prints; writes or checks contact_rolling.csv.

The case of rolling_cylinders.py as it stands in that program's input (repository eve70a/CONTACT, examples/visc_cylindr.inp, and its reference output of 10 May 2023,
visc_cylindr.ref_out): no half-plane but a half-space with one row of 99 rectangles, 0.16 mm by 1000 mm, the first centred at -7.92 mm, so that the middle of the contact
is a rim and not a middle. The pressure is constant on a rectangle and the gap is closed at its centre (active set, the load given).

Independent of the solver and of rolling_cylinders.py. Boussinesq: under unit pressure on a rectangle from b to c the surfaces approach at a point x by
    (1 - nu)/(pi G) [P(x - b) - P(x - c)],      P(u) = 2 u asinh(h/|u|) + 2 h asinh(u/h),      h = 500 mm
and creep adds int e^{-s} of the same at x + v tau s. These integrals are why the printed pressure of slow creep, 85.31, is above the one without, 85.29, which no creep can do:
the program leaves the two terms of P at either rim of each strip to QUADPACK's QAGI at a relative tolerance of 1e-3 and then takes differences of neighbours.
SciPy's quad is QAGI too; with the same tolerance it gives 85.314, with 1e-10 85.299.

`value` is at 1e-3, `exact_integrals` at 1e-10, `endless` besides with strips of infinite length (half-planes; no approach, which is infinite); what is left to the values of
rolling_cylinders.csv is the strips. `printed` has four digits (strips: a count). Quantities: largest_pressure (N/mm2), approach (mm), strips. Double precision; needs numpy and scipy.
"""

import sys

sys.dont_write_bytecode = True

import math
import time as clock

from common import arguments, double, finish, read, write
from rolling_cylinders import LOAD, RADIUS, RATIO, SHEAR, SPEED, memory_logarithm, numpy

COMMAND = "python3 verification/references/contact_rolling.py"
FILE = "contact_rolling.csv"
COLUMNS = ["case", "creep_time", "quantity", "value", "printed", "exact_integrals", "endless"]
STRIP, STRIPS, FIRST, HALF_LENGTH = 0.16, 99, -7.92, 500.0
LOOSE, TIGHT = 1e-3, 1e-10
# Creep time; largest pressure, approach, strips in contact, as printed.
CASES = ((0.0, "60.32", "2.508", "80"), (0.009, "78.74", "2.367", "62"), (0.045, "84.72", "2.063", "57"), (2.0, "85.31", "1.455", "56"), (None, "85.29", "1.324", "56"))


def along(u):
    return 2.0 * u * math.asinh(HALF_LENGTH / abs(u)) if u else 0.0


def across(u):
    return 2.0 * HALF_LENGTH * math.asinh(u / HALF_LENGTH)


def influence(creep_time, tolerance):
    """Approach at distances of whole strips, -98 to 98, under a unit pressure on one; no tolerance: strips of infinite length."""
    np, *_ = numpy()
    from scipy.integrate import quad
    rims = (np.arange(-STRIPS, STRIPS) + 0.5) * STRIP
    if tolerance is None:
        at_once = np.array([-2.0 * (u * math.log(abs(u)) - u) for u in rims])
        length = SPEED * (creep_time or 0.0)
        remembered = at_once - 2.0 * length * memory_logarithm(rims, length) if length else at_once
    else:
        at_once = np.array([along(u) + across(u) for u in rims])
        length = SPEED * (creep_time or 0.0)

        def memory(part, u):
            return quad(lambda s: math.exp(-s) * part(u + length * s), 0.0, math.inf, epsabs=0.0, epsrel=tolerance, limit=500)[0]

        remembered = np.array([memory(along, u) + memory(across, u) for u in rims]) if length else at_once
    total = at_once if creep_time is None else at_once + remembered
    return np.diff(total) * (1.0 - RATIO) / (math.pi * SHEAR)


def contact(creep_time, tolerance):
    """(largest pressure, approach, strips in contact)."""
    np, *_ = numpy()
    column = influence(creep_time, tolerance)
    index = np.arange(STRIPS)
    matrix = column[index[:, None] - index[None, :] + STRIPS - 1]
    rise = (FIRST + STRIP * index) ** 2 / (2.0 * RADIUS)
    active = np.ones(STRIPS, dtype=bool)
    for _ in range(500):
        own = np.flatnonzero(active)
        system = np.zeros((len(own) + 1, len(own) + 1))
        system[:-1, :-1], system[:-1, -1], system[-1, :-1] = matrix[np.ix_(own, own)], -1.0, STRIP
        found = np.linalg.solve(system, np.concatenate([-rise[own], [LOAD]]))
        pressure = np.zeros(STRIPS)
        pressure[own] = found[:-1]
        fresh = active & (pressure >= 0.0)
        if (found[:-1] >= 0.0).all():
            fresh |= matrix @ pressure + rise - found[-1] < -1e-13
        if (fresh == active).all():
            return {"largest_pressure": float(pressure.max()), "approach": float(found[-1]), "strips": len(own)}
        active = fresh
    raise RuntimeError("the active set did not settle")


def rows():
    def text(value):
        return str(value) if isinstance(value, int) else f"{value:.9e}"

    for creep_time, pressure, approach, strips in CASES:
        loose, tight, endless = (contact(creep_time, tolerance) for tolerance in (LOOSE, TIGHT, None))
        case = "elastic" if creep_time is None else f"creep time {creep_time}"
        for quantity, printed in (("largest_pressure", pressure), ("approach", approach), ("strips", strips)):
            yield {"case": case, "creep_time": "" if creep_time is None else double(creep_time), "quantity": quantity, "value": text(loose[quantity]), "printed": printed,
                   "exact_integrals": text(tight[quantity]), "endless": "" if quantity == "approach" else text(endless[quantity])}


def main():
    options = arguments(__doc__.splitlines()[0])
    start = clock.time()
    *_, tool = numpy()
    fresh = list(rows())
    wrong = [f"{FILE}: {row['case']} {row['quantity']}: {row['value']} is not the printed {row['printed']}" for row in fresh
             if row["printed"] != (row["value"] if row["quantity"] == "strips" else f"{float(row['value']):.4g}")]
    if options.check or options.self_check:
        known = {(row["case"], row["quantity"]): row for row in read(FILE)}
        for row in fresh:
            for column in ("value", "exact_integrals", "endless"):
                a, b = known[row["case"], row["quantity"]][column], row[column]
                if a != b and not abs(float(a) - float(b)) <= 1e-7 * abs(float(a)):
                    wrong.append(f"{FILE}: {row['case']} {row['quantity']} {column}: file {a}, recomputed {b}")
        finish(wrong, start, "contact_rolling")
    if wrong:
        sys.exit("\n".join(wrong))
    write(FILE, COMMAND, "two viscoelastic cylinders in rolling contact, discretised as CONTACT does; columns in the opening of the script", COLUMNS, fresh,
          precision="double; strips of 0.16 mm, integrals over the memory at 1e-3 and 1e-10", tool=tool)


if __name__ == "__main__":
    main()
