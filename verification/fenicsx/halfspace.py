"""The body: axisymmetric linear elements of a given degree, the far condition, and a factor of its stiffness.

    w = u_z > 0 into the body;   reaction of a surface node > 0 presses.   Forms carry 2 pi r, so reactions are forces.

    bulk   int div u div v        shear   int 2 dev e(u) : dev e(v) + far condition        stiffness = K bulk + G shear

Far condition (Boussinesq): a point force at the origin gives displacements U and tractions T at the far sides. There the traction of the
outside is T (T.u)/(T.U): symmetric, and exact for every multiple of U. It goes with G, at the Poisson ratio given; where that changes in time
it is no longer exact, but the far sides are thousands of contacts away.
"""

import logging

import numpy as np
import ufl
from dolfinx import fem, mesh as dmesh
from mpi4py import MPI
from petsc4py import PETSc
from scipy.sparse import csr_matrix

logging.disable(logging.INFO)      # the compiler of forms tells every call
QUADRATURE = 2      # degree of the quadrature over twice the degree of the elements


def boussinesq(x, ratio, normal):
    """Displacement (times 4 pi G/P) and traction (times 2 pi/P) of a point force, in UFL."""
    r, z = x[0], x[1]
    rho = ufl.sqrt(r * r + z * z)
    u = ufl.as_vector([r * z / rho**3 - (1 - 2 * ratio) * r / (rho * (rho + z)), z * z / rho**3 + 2 * (1 - ratio) / rho])
    rr = (1 - 2 * ratio) / (rho * (rho + z)) - 3 * r * r * z / rho**5
    rz, zz = -3 * r * z * z / rho**5, -3 * z**3 / rho**5
    return u, ufl.as_vector([rr * normal[0] + rz * normal[1], rz * normal[0] + zz * normal[1]])


def strain(u, r):
    """(rr, zz, theta theta, rz)."""
    return u[0].dx(0), u[1].dx(1), u[0] / r, 0.5 * (u[0].dx(1) + u[1].dx(0))


def contracted(e, f):
    return e[0] * f[0] + e[1] * f[1] + e[2] * f[2] + 2 * e[3] * f[3]


def deviator(e):
    mean = (e[0] + e[1] + e[2]) / 3
    return e[0] - mean, e[1] - mean, e[2] - mean, e[3]


def to_scipy(form):
    matrix = fem.petsc.assemble_matrix(form)
    matrix.assemble()
    rows, columns, values = matrix.getValuesCSR()
    out = csr_matrix((values, columns, rows), shape=matrix.getSize())
    matrix.destroy()
    return out


class HalfSpace:
    def __init__(self, grid, degree, ratio, far="boussinesq"):
        # What Python has let go PETSc keeps until it is told: the factors of earlier bodies, 19 GB by the end of a whole run.
        PETSc.garbage_cleanup(MPI.COMM_SELF)
        cell = ufl.Cell("quadrilateral", geometric_dimension=2)
        domain = ufl.Mesh(ufl.VectorElement("Lagrange", cell, 1))
        self.mesh = dmesh.create_mesh(MPI.COMM_SELF, grid.cells.astype(np.int64), grid.points, domain)
        self.space = fem.VectorFunctionSpace(self.mesh, ("Lagrange", degree))
        self.degree, self.far = degree, grid.far
        u, v = ufl.TrialFunction(self.space), ufl.TestFunction(self.space)
        x = ufl.SpatialCoordinate(self.mesh)
        weight = 2 * np.pi * x[0]
        dx = ufl.dx(metadata={"quadrature_degree": 2 * degree + QUADRATURE})
        e, f = strain(u, x[0]), strain(v, x[0])
        bulk = (e[0] + e[1] + e[2]) * (f[0] + f[1] + f[2]) * weight * dx
        shear = 2 * contracted(deviator(e), deviator(f)) * weight * dx
        tag = self._far_sides(grid.far)
        if far == "boussinesq":
            ratio = fem.Constant(self.mesh, float(ratio))        # no form of its own for every ratio
            normal = ufl.FacetNormal(self.mesh)
            side = ufl.Measure("ds", domain=self.mesh, subdomain_data=tag)(1, metadata={"quadrature_degree": 2 * degree + 6})
            du, dt = boussinesq(x, ratio, normal)
            # T/(2 pi) over U/(4 pi G): a factor 2 G.
            shear += -2 * ufl.dot(dt, u) * ufl.dot(dt, v) / ufl.dot(dt, du) * weight * side
        self.bulk, self.shear = to_scipy(fem.form(bulk)), to_scipy(fem.form(shear))
        self._dofs(clamped=far == "clamped")
        self._factors = {}

    def _far_sides(self, far):
        facets = dmesh.locate_entities_boundary(self.mesh, 1, lambda x: np.isclose(x[0], far) | np.isclose(x[1], far))
        return dmesh.meshtags(self.mesh, 1, np.sort(facets), np.ones(len(facets), dtype=np.int32))

    def _dofs(self, clamped):
        places = self.space.tabulate_dof_coordinates()
        r, z = places[:, 0], places[:, 1]
        self.count = 2 * len(r)
        held = 2 * np.flatnonzero(r < 1e-12 * self.far)
        if clamped:
            out = np.flatnonzero((r > self.far * (1 - 1e-9)) | (z > self.far * (1 - 1e-9)))
            held = np.unique(np.concatenate([held, 2 * out, 2 * out + 1]))
        self.free = np.setdiff1d(np.arange(self.count), held)
        top = np.flatnonzero(z < 1e-13 * self.far)
        top = top[np.argsort(r[top])]
        self.surface, self.radii = 2 * top + 1, r[top]          # dofs of u_z along the surface, their radii

    def factor(self, bulk, shear):
        """A solver of (K bulk + G shear) u = f; one factor serves all multiples."""
        key = round(bulk / shear, 10)
        if key not in self._factors:
            scaled = (key * self.bulk + self.shear)[self.free][:, self.free].tocsr()
            matrix = PETSc.Mat().createAIJ(scaled.shape, csr=(scaled.indptr, scaled.indices, scaled.data), comm=MPI.COMM_SELF)
            matrix.assemble()
            solver = PETSc.KSP().create(MPI.COMM_SELF)
            solver.setOperators(matrix)
            solver.setType("preonly")
            solver.getPC().setType("lu")
            solver.getPC().setFactorSolverType("mumps")
            solver.setUp()
            self._factors[key] = (solver, matrix)
        solver, matrix = self._factors[key]

        def solve(force):
            f = np.asarray(force)
            if f.ndim == 2:
                return self._solve_many(solver, f, shear)
            right, left = matrix.createVecs()
            right.setArray(f[self.free] / shear)
            solver.solve(right, left)
            out = np.zeros(self.count)
            out[self.free] = left.getArray()
            return out

        return solve

    def _solve_many(self, solver, forces, shear):
        out = np.zeros_like(forces)
        size = len(self.free)
        for start in range(0, forces.shape[1], 64):
            block = forces[self.free, start:start + 64] / shear
            right = PETSc.Mat().createDense((size, block.shape[1]), array=np.asfortranarray(block), comm=MPI.COMM_SELF)
            left = PETSc.Mat().createDense((size, block.shape[1]), comm=MPI.COMM_SELF)
            right.assemble()
            left.setUp()
            solver.getPC().getFactorMatrix().matSolve(right, left)
            out[self.free, start:start + 64] = left.getDenseArray()
        return out

    def compliance(self, bulk, shear, count):
        """Displacements of the first `count` surface nodes under unit forces on each of them."""
        key = (round(bulk / shear, 10), count)
        if not hasattr(self, "_compliances"):
            self._compliances = {}
        if key not in self._compliances:
            solve = self.factor(bulk, shear)
            out = np.zeros((count, count))
            for start in range(0, count, 64):
                own = self.surface[start:min(start + 64, count)]
                forces = np.zeros((self.count, len(own)))
                forces[own, np.arange(len(own))] = shear
                out[:, start:start + len(own)] = solve(forces)[self.surface[:count]]
            self._compliances[key] = 0.5 * (out + out.T)
        return self._compliances[key] / shear
