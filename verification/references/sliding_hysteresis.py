"""Steady sliding contacts whose edges take different works of adhesion; writes or checks sliding_hysteresis.csv.

The method is that of sliding_wave.py: the integral equation itself, collocated, nothing inverted in closed form. Half-width, eccentricity, mean pressure and
process zone are given, and the work of each edge, (1/2 zone) int tension gap with the contact collocated anew with that edge moved out, is what an interface
would have to take there for these edges to be in equilibrium. No equation is solved for the edges, so no root is picked. The releases are differences of
1/2 int p w over the work of their own edge. Every value is computed with N points and with a quarter more and finer panels; `confirmed_digits` is their
agreement relative to the `scale` of the quantity (at most 11).
    terms      j_j:zeta_j separated by blanks (1/beta is what is left of one), exact doubles; none of the elastic solid
    a, e, mean_pressure, zone   exact doubles
    quantity   trailing_work, leading_work (reduced), penetration, friction_stress, trailing_release, leading_release

Command: python3 verification/references/sliding_hysteresis.py [--check]
"""

import sys

sys.dont_write_bytecode = True

import math
import time

from common import arguments, differences, double, finish, read, write
from sliding_wave import PI, SOLIDS, Solved, agreement, gauss

COMMAND = "python3 verification/references/sliding_hysteresis.py"
FILE = "sliding_hysteresis.csv"
COLUMNS = ["case", "terms", "a", "e", "mean_pressure", "zone", "quantity", "value", "scale", "confirmed_digits"]
# name, solid, a, e, mean pressure, zone, N, additional nodes in the window (where a layer is thinner than it)
CASES = [
    ("elastic", None, 0.9, -0.07, 0.105, 0.005, 60, 0),
    ("elastic, wide", None, 1.7, -0.11, 0.37, 0.01, 80, 0),
    ("one", "one", 1.0, 0.03, 0.22, 0.005, 60, 0),
    ("two", "two", 0.9, -0.08, 0.18, 0.002, 66, 0),
    ("one, slow", "one, slow", 0.7, -0.13, 0.05, 0.02, 110, 18),
]


def values_of(terms, a, e, mean, zone, count, nodes, more):
    here = Solved(terms, a, e, count, nodes, mean=mean)
    works, releases = [], []
    for side in (-1, 1):
        moved = Solved(terms, a + 0.5 * zone, e + 0.5 * side * zone, count, nodes, penetration=here.penetration)
        total = []
        for node, weight in gauss(nodes + more):
            theta = 0.5 * PI * node
            sine, cosine = math.sin(theta), math.cos(theta)
            tension = -moved.pressure_near(side, zone * sine * sine)
            total.append(0.5 * PI * weight * tension * here.gap_near(side, zone * cosine * cosine) * sine * cosine)
        work = math.fsum(total)
        works.append(work / (2.0 * PI))
        releases.append((moved.energy() - here.energy()) / zone / work)
    friction = here.contact.integral(here.c, lambda y: math.sin(y + e)) / (2.0 * PI)
    return {
        "trailing_work": (works[0], works[0]),
        "leading_work": (works[1], works[1]),
        "penetration": (here.penetration, 1.0),
        "friction_stress": (friction, 1.0),
        "trailing_release": (releases[0], max(1.0, releases[0])),
        "leading_release": (releases[1], max(1.0, releases[1])),
    }


def rows_of(case):
    name, solid, a, e, mean, zone, count, more = case
    terms = SOLIDS[solid] if solid else []
    coarse, fine = (values_of(terms, a, e, mean, zone, n, q, more) for n, q in ((count, 10), (count + count // 4, 14)))
    text = " ".join(f"{double(j)}:{double(z)}" for j, z in terms)
    return [
        {
            "case": name, "terms": text, "a": double(a), "e": double(e), "mean_pressure": double(mean), "zone": double(zone),
            "quantity": quantity, "value": f"{value:.14e}", "scale": f"{scale:.3e}",
            "confirmed_digits": agreement(coarse[quantity][0], value, scale),
        }
        for quantity, (value, scale) in fine.items()
    ]


def self_check():
    """Elastic: as the process zone shrinks the works are the squares of the edge amplitudes over 8 sin a, which for equal works is Johnson's wave."""
    wrong = []
    for a, e, mean in ((0.9, -0.07, 0.105), (1.7, -0.11, 0.37)):
        c = Solved([], a, e, 60, 10, mean=mean).c
        amplitudes = [math.fsum(value * side ** n for n, value in enumerate(c)) for side in (-1, 1)]
        # p dy = sum c_n T_n dt/sqrt(1 - t^2): at the edge p ~ k/sqrt(2 sin a d), k = sum (+-1)^n c_n, as 1 - t ~ d/sin a.
        limits = [k * k / (8.0 * math.sin(a)) for k in amplitudes]
        first, second = (values_of([], a, e, mean, zone, 60, 10, 0) for zone in (2e-4, 1e-4))
        for name, limit in zip(("trailing_work", "leading_work"), limits):
            extrapolated = 2.0 * second[name][0] - first[name][0]
            if abs(extrapolated - limit) > 1e-6 * limit:
                wrong.append(f"{name} at a = {a}: {extrapolated} tends to {limit}")
    return wrong


def main():
    options = arguments("Steady sliding contacts with different works of adhesion at both edges.")
    start = time.time()
    if options.self_check:
        finish(self_check(), start, "self-check")
    rows = [row for case in (CASES[:1] if options.reduced else CASES) for row in rows_of(case)]
    if options.check:
        wrong = differences(FILE, read(FILE), rows, ["case", "quantity"])
        finish(wrong, start, f"check of {len(rows)} rows")
    write(FILE, COMMAND, "steady sliding contacts on a wave with different works of adhesion at both edges, by collocation", COLUMNS, rows,
          precision="double precision, Chebyshev collocation; confirmed with a quarter more points and finer panels")
    print(f"fewest confirmed digits {min(row['confirmed_digits'] for row in rows)}, written in {time.time() - start:.1f} s")


if __name__ == "__main__":
    main()
