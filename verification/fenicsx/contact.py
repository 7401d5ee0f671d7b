"""A rigid indenter on the body, its edge where it is told to be, stepped in time with internal variables in the bulk.

Every branch keeps the strain of its spring. The update is linear and the same everywhere, so those strains are the strains of a field h of the space of
the displacements, one per branch, and nothing is lost by keeping the field instead of its strain at each quadrature point (self_check.py does both):
    h <- e^(-dt/rho) h + (1 - e^(-dt/rho))/(dt/rho) (u_new - u_old),      exact for u linear within the step
    stress = K_0 tr e(u) + 2 G_0 dev e(u) + sum over branches of K_i tr e(h) + 2 G_i dev e(h)
In the contact u_z = penetration - shape(r) at the nodes; beyond, no force. No friction. Unknown reactions come from the compliance of the surface nodes, a
Schur complement of the same stiffness; the displacement field of the body is then solved for, and the history is taken from that field.
"""

import numpy as np


class Contact:
    def __init__(self, body, solid, shape, candidates):
        self.body, self.solid, self.candidates = body, solid, candidates
        self.radii = body.radii[:candidates]
        self.rise = shape(self.radii)
        self.u = np.zeros(body.count)
        self.histories = [np.zeros(body.count) for _ in solid.branches]
        self.reactions, self.penetration = np.zeros(0), 0.0

    def nodes_within(self, radius):
        """How many surface nodes the contact of a radius holds; its edge must be one of them."""
        count = int(np.searchsorted(self.radii, radius * (1.0 + 1e-9)))
        assert abs(self.radii[count - 1] - radius) < 1e-7 * radius, "the edge is not at a node"
        return count

    def start_relaxed(self, radius, penetration):
        """Held for ever: the springs of all branches have let go."""
        bulk, shear = self.solid.bulk, self.solid.shear
        count = self.nodes_within(radius)
        self.reactions = np.linalg.solve(self.body.compliance(bulk, shear, self.candidates)[:count, :count], penetration - self.rise[:count])
        self.u = self._displaced(bulk, shear, self.reactions, 0.0)
        self.penetration = penetration

    def step(self, radius, penetration, duration):
        """At the end of the step the contact has this radius and penetration. A duration of 0 is a glassy increment."""
        (bulk, shear), fade, taken = self.solid.step(duration)
        kept = [f * h - t * self.u for f, t, h in zip(fade, taken, self.histories)]
        force = 0.0
        for branch, field in zip(self.solid.branches, kept):
            force = force - branch[0] * (self.body.bulk @ field) - branch[1] * (self.body.shear @ field)
        base = self.body.factor(bulk, shear)(force) if len(kept) else np.zeros(self.body.count)
        count = self.nodes_within(radius)
        wanted = penetration - self.rise[:count] - base[self.body.surface[:count]]
        self.reactions = np.linalg.solve(self.body.compliance(bulk, shear, self.candidates)[:count, :count], wanted)
        self.u = base + self._displaced(bulk, shear, self.reactions, 0.0)
        self.histories = [k + t * self.u for k, t in zip(kept, taken)]
        self.penetration = penetration

    def _displaced(self, bulk, shear, reactions, base):
        force = np.zeros(self.body.count)
        force[self.body.surface[:len(reactions)]] = reactions
        return base + self.body.factor(bulk, shear)(force)

    def force(self):
        return float(self.reactions.sum())

    def surface(self):
        """Displacement of the candidates into the body."""
        return self.u[self.body.surface[:self.candidates]]

    def gap(self):
        return self.surface() - self.penetration + self.rise
