#!/usr/bin/python3
"""What the elements take for granted, shown: /usr/bin/python3 verification/fenicsx/self_check.py

memory       Stresses of the branches kept at the points of the quadrature, and fields kept instead of them (contact.py), are one thing: residuals differ by rounding, 3e-11.
far sides    Clamped at L they cost a/L in force; Boussinesq's condition leaves less than 1e-5 at L = 30 a, and nothing that is seen at 200 a.
half-space   1/E* of an elastic bulk with viscoelastic shear: sum of creep terms against Laplace transforms, at complex arguments.
"""

import os
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import basix
import numpy as np
import ufl
from dolfinx import fem

import cases
import integration
import mesh
from contact import Contact
from halfspace import HalfSpace, contracted, deviator, strain
from maxwell import creep_of_half_space, plane_modulus


def memory():
    """Largest difference of the residual of a history: stress at the points, stepped by their own law, against the fields."""
    solid = cases.ELASTIC_BULK_TWO
    body, candidates = integration.graded_body(solid, 0.2, 1e-3, 2.0, 2)
    contact = Contact(body, solid, integration.sphere, candidates)
    contact.step(0.2, 0.01, 0.0)
    x, v = ufl.SpatialCoordinate(body.mesh), ufl.TestFunction(body.space)
    degree = 2 * body.degree + 2
    scalar = fem.FunctionSpace(body.mesh, ufl.FiniteElement("Quadrature", ufl.quadrilateral, degree, quad_scheme="default"))
    points, _ = basix.make_quadrature(basix.CellType.quadrilateral, degree)
    cells = np.arange(body.mesh.topology.index_map(2).size_local, dtype=np.int32)
    now = fem.Function(body.space)
    places = fem.Expression(ufl.as_vector(deviator(strain(now, x[0]))), points)

    def strains(field):
        """Deviator at every point of every cell."""
        now.x.array[:] = field
        return places.eval(cells).reshape(len(cells), len(points), 4)

    kept = [2.0 * branch[1] * strains(contact.u) for branch in solid.branches]
    stress = [fem.Function(scalar) for _ in range(4)]
    order = np.array([scalar.dofmap.cell_dofs(cell) for cell in cells])
    worst = 0.0
    for penetration, duration in ((0.02, 0.1), (0.015, 0.7), (0.03, 0.02)):
        before = strains(contact.u)
        contact.step(0.2, penetration, duration)
        change = strains(contact.u) - before
        _, fade, taken = solid.step(duration)
        for index, branch in enumerate(solid.branches):
            kept[index] = fade[index] * kept[index] + 2.0 * branch[1] * taken[index] * change
            for part in range(4):
                stress[part].x.array[order] = kept[index][:, :, part]
            test = deviator(strain(v, x[0]))
            form = contracted(stress, test) * 2 * np.pi * x[0] * ufl.dx(metadata={"quadrature_degree": degree, "quadrature_scheme": "default"})
            residual = fem.petsc.assemble_vector(fem.form(form)).getArray()
            # Without the far condition, which is no stress: rows of free nodes away from the far sides.
            field = branch[1] * (body.shear @ contact.histories[index])
            near = np.repeat(np.max(body.space.tabulate_dof_coordinates()[:, :2], axis=1) < 0.5 * body.far, 2)
            worst = max(worst, float(np.max(np.abs(residual - field)[near]) / np.max(np.abs(field))))
    return worst


def far_sides():
    solid, radius = cases.ONE, 0.2
    out = {}
    for kind in ("clamped", "boussinesq"):
        for layers in (4, 9, 16):
            surface = mesh.surface_of_edge(radius, 1e-5 * radius, 1.8, 4.0 * radius)
            grid = mesh.grid(surface, 1e-5 * radius, 1.8, layers, 1.5)
            body = HalfSpace(grid, 4, 0.3, kind)
            contact = Contact(body, solid, lambda r: 0.0 * r, int(np.searchsorted(body.radii, 1.1 * radius)))
            contact.start_relaxed(radius, 0.01)
            out[kind, round(grid.far / radius, 1)] = contact.force() / (2.0 * radius * 0.01) - 1.0
    return out


def half_space():
    worst = 0.0
    for solid in cases.SOLIDS.values():
        glassy, terms = creep_of_half_space(solid)
        for s in (0.01, 0.3 + 2.0j, 7.0j, 40.0):
            bulk = solid.bulk + sum(b[0] * s / (s + 1.0 / b[2]) for b in solid.branches)
            shear = solid.shear + sum(b[1] * s / (s + 1.0 / b[2]) for b in solid.branches)
            series = 1.0 / glassy + sum(j / (1.0 + s * tau) for j, tau in terms)
            worst = max(worst, abs(series * plane_modulus(bulk, shear) - 1.0))
    return worst


def main():
    found = memory()
    print(f"memory at points and in fields: {found:.1e}")
    assert found < 1e-9
    far = far_sides()
    for (kind, distance), error in far.items():
        print(f"far sides, {kind}, {distance} radii: force {error:+.1e}")
    clamped = [abs(error) * distance for (kind, distance), error in far.items() if kind == "clamped"]
    robin = [error for (kind, _), error in far.items() if kind == "boussinesq"]
    assert max(clamped) < 1.5 and min(clamped) > 0.5 and max(abs(e - robin[-1]) for e in robin) < 1e-5
    found = half_space()
    print(f"1/E* as creep terms: {found:.1e}")
    assert found < 1e-12
    print("passed")


if __name__ == "__main__":
    main()
