"""Energy release rate of an elastic field by a domain integral (J), on rings of any size around the edge.

The edge, and what is near it, is carried outwards by q(r, z): 1 within a distance `inner` of the edge, 0 beyond `outer`. The derivative of the energy is
    2 pi int [W (q,r + q/r) - sigma_ij u_i,r q,j - sigma_tt u_r q/r^2] r dr dz  -  sum of reactions times shape'(r) q
(the last because a carried place of the contact lies lower on the indenter), over 2 pi a. For an elastic solid it does not depend on the ring; with a memory that stays
where it is, it would. So it serves elastic states, and the difference of the fields before and after a glassy increment.
"""

import numpy as np
import ufl
from dolfinx import fem

from halfspace import contracted, deviator, strain


def energy_release_rate(body, bulk, shear, field, reactions, slope, radius, inner, outer):
    """Per area of the contact; `slope` is the slope of the indenter, 0 for an increment of depth."""
    u = fem.Function(body.space)
    u.x.array[:] = field
    x = ufl.SpatialCoordinate(body.mesh)
    k, g = (fem.Constant(body.mesh, float(c)) for c in (bulk, shear))

    def share(r, z):
        part = np.clip((outer - np.hypot(r - radius, z)) / (outer - inner), 0.0, 1.0)
        return part**2 * (3.0 - 2.0 * part)

    # Interpolated: whole elements have a polynomial q, so no kink of it falls between the points of the quadrature.
    q = fem.Function(fem.FunctionSpace(body.mesh, ("Lagrange", body.degree)))
    q.interpolate(lambda places: share(places[0], places[1]))
    e = strain(u, x[0])
    d = deviator(e)
    trace = e[0] + e[1] + e[2]
    energy = 0.5 * k * trace**2 + g * contracted(d, d)
    rr, zz, tt, rz = k * trace + 2 * g * d[0], k * trace + 2 * g * d[1], k * trace + 2 * g * d[2], 2 * g * d[3]
    qr, qz = q.dx(0), q.dx(1)
    density = energy * (qr + q / x[0]) - (rr * u[0].dx(0) * qr + rz * u[0].dx(0) * qz + rz * u[1].dx(0) * qr + zz * u[1].dx(0) * qz) - tt * u[0] * q / x[0] ** 2
    form = density * 2 * np.pi * x[0] * ufl.dx(metadata={"quadrature_degree": 3 * body.degree + 4})
    total = fem.assemble_scalar(fem.form(form))
    radii = body.radii[:len(reactions)]
    total -= float(np.sum(reactions * slope(radii) * share(radii, 0.0)))
    return total / (2.0 * np.pi * radius)
