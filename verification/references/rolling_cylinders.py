"""Two viscoelastic cylinders rolling without friction, by collocation on equal strips; writes or checks rolling_cylinders.csv.

The case of CONTACT's example `visc_cylindr` after Wang and Knothe, J. Appl. Mech. 60 (1993) 310: two cylinders R = 100 mm, glassy G = 1143 N/mm2, nu = 0.4,
compliance doubled in the end (creep ratio 1), 600 N/mm, 1000 mm/s, creep times 0, 0.009, 0.045, 2 s, and the stiff elastic case.

Independent of the solver: no reduction to an elastic contact, no periodic kernel. With the pressure constant on strips of width h, the approach of both
surfaces under a strip [b, c] is -(2/(pi E)) [Phi(x - b) - Phi(x - c)], Phi(x) = x ln|x| - x, 1/E = 2 (1 - nu)/(2 G); a creep time tau adds the same with
    int e^{-s} ln|x + v tau s| ds = ln|x| + e^y E1(y) (y = x/(v tau) > 0),   ln|x| - e^y Ei(-y) (y < 0)
in place of ln|x| (the leading edge is at positive x; a point has seen what is ahead of it). Collocated at the middles, the gap closed where p > 0 and open
elsewhere (active set), the load given. Strips of 0.16 mm, CONTACT's own, then a third, a ninth, a 27th of that.

`value` is that of the finest strips; for the widths, which are whole strips, the coarser ones say how good it is. `printed` is what CONTACT's published reference output
prints (version of 10 May 2023): PMAX in N/mm2, and the number of strips in contact times 0.16 mm. Double precision; needs numpy and scipy.
"""

import sys

sys.dont_write_bytecode = True

import math
import time as clock

from common import arguments, double, finish, read, write

COMMAND = "python3 verification/references/rolling_cylinders.py"
FILE = "rolling_cylinders.csv"
COLUMNS = ["case", "creep_time", "quantity", "value", "printed", "by_mesh", "confirmed_digits", "independence"]
SHEAR, RATIO, LOAD, SPEED, RADIUS = 1143.0, 0.4, 600.0, 1000.0, 50.0      # N/mm2, -, N/mm, mm/s, mm (both cylinders as one)
STRIP, STRIPS = 0.16, 99
FINER = (1, 3, 9, 27)
CASES = ((0.0, "60.32", 80), (0.009, "78.74", 62), (0.045, "84.72", 57), (2.0, "85.31", 56), (None, "85.29", None))


def numpy():
    try:
        import numpy as np
        import scipy
        from scipy.special import exp1, expi
    except ImportError:
        sys.exit("rolling_cylinders.py needs numpy and scipy (Debian: apt-get install python3-numpy python3-scipy)")
    return np, exp1, expi, f"numpy {np.__version__}, scipy {scipy.__version__}, generator version 1.0.0"


def memory_logarithm(x, length):
    """int_0^inf e^{-s} ln|x + length s| ds."""
    np, exp1, expi, _ = numpy()
    y = x / length
    near = np.clip(y, -500.0, 500.0)
    with np.errstate(all="ignore"):
        ahead = np.exp(near) * exp1(np.where(near > 0.0, near, 1.0))
        behind = -np.exp(near) * expi(np.where(near < 0.0, -near, 1.0))
        # Asymptotic: four terms, 1e-10 beyond |y| = 500.
        far = 1.0 / y - 1.0 / y**2 + 2.0 / y**3 - 6.0 / y**4
    return np.log(np.abs(x)) + np.where(np.abs(y) >= 500.0, far, np.where(y > 0.0, ahead, behind))


def kernel(middles, rims, creep_time):
    """Approach of the surfaces at the middles under unit pressures on the strips."""
    np, *_ = numpy()
    glassy = 2.0 * SHEAR / (1.0 - RATIO) / 2.0
    far, near = middles[:, None] - rims[None, :-1], middles[:, None] - rims[None, 1:]
    primitive = lambda x: x * np.log(np.abs(x)) - x
    instant = primitive(far) - primitive(near)
    total = instant
    if creep_time is not None:
        total = total + instant
        if creep_time > 0.0:
            length = SPEED * creep_time
            total = total + length * (memory_logarithm(far, length) - memory_logarithm(near, length))
    return -2.0 / (math.pi * glassy) * total


def contact(finer, creep_time):
    """(largest pressure, width) on strips `finer` times finer than CONTACT's."""
    np, *_ = numpy()
    width, count = STRIP / finer, STRIPS * finer
    middles = (np.arange(count) - 0.5 * (count - 1)) * width
    # No contact reaches beyond 6.5 mm.
    middles = middles[np.abs(middles) < 6.6]
    rims = np.concatenate([middles - 0.5 * width, [middles[-1] + 0.5 * width]])
    matrix, rise = kernel(middles, rims, creep_time), middles**2 / (2.0 * RADIUS)
    active = np.abs(middles) < 5.0
    for _ in range(500):
        own = np.flatnonzero(active)
        system = np.zeros((len(own) + 1, len(own) + 1))
        system[:-1, :-1], system[:-1, -1], system[-1, :-1] = matrix[np.ix_(own, own)], -1.0, width
        found = np.linalg.solve(system, np.concatenate([-rise[own], [LOAD]]))
        pressure = np.zeros(len(middles))
        pressure[own] = found[:-1]
        fresh = active.copy()
        fresh[pressure < 0.0] = False
        if (found[:-1] >= 0.0).all():
            fresh |= matrix @ pressure + rise - found[-1] < -1e-13
        if (fresh == active).all():
            return float(pressure.max()), float(len(own) * width)
        active = fresh
    raise RuntimeError("the active set did not settle")


def rows(finest):
    for creep_time, pressure, strips in CASES:
        found = [contact(finer, creep_time) for finer in FINER[:finest]]
        case = "elastic" if creep_time is None else f"creep time {creep_time}"
        for index, (quantity, printed) in enumerate((("largest_pressure", pressure), ("contact_width", f"{strips * STRIP:.2f}" if strips else ""))):
            raw = [f[index] for f in found]
            # A width is no better than a strip.
            change = max(abs(raw[-1] - raw[-2]), STRIP / FINER[finest - 1] if index else 0.0) / raw[-1]
            yield {"case": case, "creep_time": "" if creep_time is None else double(creep_time), "quantity": quantity, "value": f"{raw[-1]:.9e}", "printed": printed,
                   "by_mesh": " ".join(f"{r:.9e}" for r in raw), "confirmed_digits": int(-math.log10(max(change, 1e-15)))}


def main():
    options = arguments(__doc__.splitlines()[0])
    start = clock.time()
    *_, tool = numpy()
    if options.check or options.self_check:
        finest = 3 if options.reduced else len(FINER)
        known = {(row["case"], row["quantity"]): row for row in read(FILE)}
        wrong = []
        for row in rows(finest):
            old = known[row["case"], row["quantity"]]
            wrong += [f"{FILE}: {row['case']} {row['quantity']}: file {a}, recomputed {b}" for a, b in zip(old["by_mesh"].split(), row["by_mesh"].split())
                      if not abs(float(a) - float(b)) <= 1e-7 * float(a)]
        finish(wrong, start, "rolling_cylinders")
    write(FILE, COMMAND, "two viscoelastic cylinders in rolling contact, by strips; columns in the opening of the script", COLUMNS, list(rows(len(FINER))),
          precision="double; strips of four widths", tool=tool)


if __name__ == "__main__":
    main()
