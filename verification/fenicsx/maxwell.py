"""A generalised Maxwell solid with branches of its own in bulk and in shear, and what its half-space is for the solver.

    K(t) = K_0 + sum K_i e^(-t/rho_i),    G(t) = G_0 + sum G_i e^(-t/rho_i)        moduli; times rho_i are relaxation times

Constant Poisson ratio: K_i/G_i is one number for all i. Elastic bulk: all K_i = 0.

The surface of a half-space feels 1/E* alone, E* = E/(1 - nu^2) = 4G(3K + G)/(3K + 4G), or in partial fractions of G
    1/E* = (1/4) 1/G + (3/4) 1/(3K + G).
By correspondence the same holds for transforms. With an elastic bulk both parts are creep series, of G and of the solid with moduli 3K + G, so the
half-space has exactly twice as many retardation times as the shear has relaxation times, and all compliances are positive.
"""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Solid:
    name: str
    bulk: float             # K_0
    shear: float            # G_0
    branches: tuple         # (K_i, G_i, rho_i)

    @property
    def times(self):
        return np.array([branch[2] for branch in self.branches])

    @property
    def glassy(self):
        return self.bulk + sum(b[0] for b in self.branches), self.shear + sum(b[1] for b in self.branches)

    def step(self, duration):
        """(K, G) felt by a strain that grows linearly within a step, and of every branch the share kept and the share taken of the new strain."""
        fade = np.exp(-duration / self.times)
        # (1 - e^-x)/x, by its series where it cancels.
        x = duration / self.times
        taken = np.where(x > 1e-5, -np.expm1(-x) / np.where(x > 0.0, x, 1.0), 1.0 - x / 2.0 + x * x / 6.0)
        bulk = self.bulk + sum(t * b[0] for t, b in zip(taken, self.branches))
        shear = self.shear + sum(t * b[1] for t, b in zip(taken, self.branches))
        return (bulk, shear), fade, taken


def plane_modulus(bulk, shear):
    """E/(1 - nu^2)."""
    return 4.0 * shear * (3.0 * bulk + shear) / (3.0 * bulk + 4.0 * shear)


def poisson(bulk, shear):
    return (3.0 * bulk - 2.0 * shear) / (2.0 * (3.0 * bulk + shear))


def constant_poisson(name, ratio, relaxed, branches):
    """From the relaxation of E*: relaxed value and (modulus, relaxation time) of its branches, at one Poisson ratio."""
    shear = (1.0 - ratio) / 2.0          # G over E*
    bulk = shear * 2.0 * (1.0 + ratio) / (3.0 * (1.0 - 2.0 * ratio))
    return Solid(name, bulk * relaxed, shear * relaxed, tuple((bulk * e, shear * e, rho) for e, rho in branches))


def elastic_bulk(name, bulk, relaxed_shear, branches):
    return Solid(name, bulk, relaxed_shear, tuple((0.0, g, rho) for g, rho in branches))


def creep_of(relaxed, strengths, times):
    """(1/glassy, [(J_j, tau_j)]) of relaxed + sum strengths e^(-t/times), by the secular equation, bisected to the last bit.

    With rates r = 1/rho: the rates l_j of creep are the zeros of relaxed - sum E_i l/(r_i - l), one below each r_i;
    J_j = 1/(l_j sum E_i r_i/(r_i - l_j)^2).
    """
    rates = 1.0 / np.asarray(times, dtype=float)
    strengths = np.asarray(strengths, dtype=float)[np.argsort(rates)]
    rates = np.sort(rates)
    out = []
    for i, rate in enumerate(rates):
        low = rates[i - 1] if i else 0.0
        high = rate
        for _ in range(200):
            middle = 0.5 * (low + high)
            if relaxed - np.sum(strengths * middle / (rates - middle)) > 0.0:
                low = middle
            else:
                high = middle
        zero = 0.5 * (low + high)
        out.append((1.0 / (zero * np.sum(strengths * rates / (rates - zero) ** 2)), 1.0 / zero))
    return 1.0 / (relaxed + strengths.sum()), out


def creep_of_half_space(solid):
    """(glassy E*, [(J_j, tau_j)]) for the solver."""
    shears, times = [b[1] for b in solid.branches], solid.times
    if any(b[0] for b in solid.branches):
        scale = plane_modulus(solid.bulk, solid.shear) / solid.shear
        glassy, terms = creep_of(scale * solid.shear, [scale * g for g in shears], times)
        return 1.0 / glassy, terms
    first, of_shear = creep_of(solid.shear, shears, times)
    second, of_both = creep_of(3.0 * solid.bulk + solid.shear, shears, times)
    terms = [(0.25 * j, tau) for j, tau in of_shear] + [(0.75 * j, tau) for j, tau in of_both]
    return 1.0 / (0.25 * first + 0.75 * second), terms
