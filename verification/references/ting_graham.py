"""Indentation without adhesion: the contact of Lee and Radok, Ting, and Graham, by times of equal radius. A program that is independent of the solver.

A place of the line, at the depth h = f(s) of the indenter's line profile, is in contact from the time at which the edge passes it outwards to the time at
which the edge passes it inwards, and so on. With these times of equal radius t1(h) < t2(h) < ... (Ting, J. Appl. Mech. 33 (1966) 845 and 35 (1968) 248;
Graham, Q. Appl. Math. 26 (1968) 167; Argatov & Popov, ZAMM 96 (2016) 956, for any number of turns on the line)
    in contact   W(h, t) = D(t) - h,         free   q(h, t) = 0,           q = int R(t - t') dW(h, t')
    a contact without adhesion carries no tension and no overlap: a place lets go when q comes down to zero and is met when the free surface is.
    F(t) = 2 int_0^a q(f(s), t) ds,          a(t) the radius with q = 0 there
All places follow one penetration D(t) independently of each other, and in h they know nothing of the shape, which only enters the force.

What is computed
    passage times   at double-exponential nodes between the turning radii, by bracketed roots, first sign change from the start of each leg
    q               the hereditary integral over the intervals of contact of that place; R and J are sums of exponentials, so that each interval is closed
    F               double-exponential quadrature between the turning radii; its error from every second node
    force, frame and contact radius   the penetration is a polynomial on each piece of a leg, by collocation
The program's own error: of the quadrature by every second node, for each force; of the collocation 3e-9 of the largest value under loads and 2e-11 under
radii.

The solver (Rust) follows the edge and keeps segments of a line in Maxwell and Voigt state. Shared with it is that Sneddon's transform makes the places
independent of each other. Routes that share less are compared by
    python3 verification/references/ting_graham.py --self-check

This file holds the names that other scripts use. The program itself (left column first; each file rests only on files before it):
    ting_graham_chebyshev   Chebyshev series                      ting_graham_levels      areas below a level, for imposed forces
    ting_graham_roots       bracketed roots                       ting_graham_equations   equations on one piece for an imposed quantity
    ting_graham_solid       relaxation, creep, conversion         ting_graham_radius      ramps of the contact radius
    ting_graham_shapes      line profiles of indenters            ting_graham_load        ramps of the force and the frame
    ting_graham_pieces      pieces of the penetration             ting_graham_step        sudden steps
    ting_graham_runs        when the edge passes a place          ting_graham_history     histories, and values at any instant
    ting_graham_line        state of every place                  ting_graham_self_check  comparisons with other routes
    ting_graham_edge        the edge follows the penetration
    ting_graham_contact     edge and force at an instant
"""

import sys

sys.dont_write_bytecode = True

from ting_graham_contact import Contact
from ting_graham_history import History
from ting_graham_roots import bracketed
from ting_graham_shapes import Power, Punch, Table, cone, power_law, shape_of, sphere
from ting_graham_solid import Solid, solid_of

__all__ = ["Contact", "History", "Power", "Punch", "Solid", "Table", "bracketed", "cone", "power_law", "shape_of", "solid_of", "sphere"]


if __name__ == "__main__":
    if "--self-check" not in sys.argv:
        sys.exit(__doc__)
    from ting_graham_self_check import self_check
    self_check()
