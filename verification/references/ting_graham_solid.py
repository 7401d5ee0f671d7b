"""The solid: relaxation and creep as sums of exponentials, the conversion of one into the other, and the maps between the states of both.

Moduli are E* = E/(1 - nu^2). The rates of both series alternate, so that each rate of one is the only root between two rates of the other.
"""

import numpy as np

from ting_graham_roots import poles_between


class Solid:
    """E0 + sum E_i exp(-r_i t) and its compliance: moduli E* = E/(1 - nu^2); `gap[i, j]` = r_i - l_j without cancellation."""

    def __init__(self, relaxed, moduli, rates):
        order = np.argsort(rates)
        self.relaxed = float(relaxed)
        self.moduli = np.asarray(moduli, dtype=float)[order]
        self.rates = np.asarray(rates, dtype=float)[order]
        self.glassy = self.relaxed + self.moduli.sum()
        n = len(self.rates)
        if n == 0:
            self.slow = self.charge = np.zeros(0)
            self.gap = np.zeros((0, 0))
            return
        poles = np.concatenate([[0.0], self.rates]) if self.relaxed > 0.0 else self.rates

        def stiffness(base, distance):
            # E0 - sum E_i l/(r_i - l) at l = pole + distance
            l = poles[base] + distance
            gaps = (self.rates - poles[base]) - distance
            return self.relaxed - np.sum(self.moduli * l / gaps)

        if self.relaxed > 0.0:
            nearest, distance = poles_between(stiffness, poles, 1.0, False)
            # l in (0, r_1): E0 at zero, -inf at r_1; elsewhere +inf right of a pole.
            self.slow = poles[nearest] + distance
            self.gap = (self.rates[:, None] - poles[nearest][None, :]) - distance[None, :]
        else:
            nearest, distance = poles_between(stiffness, self.rates, 1.0, False)
            self.slow = np.concatenate([[0.0], self.rates[nearest] + distance])
            gap = (self.rates[:, None] - self.rates[nearest][None, :]) - distance[None, :]
            self.gap = np.concatenate([self.rates[:, None], gap], axis=1)
        # J_j l_j of a term, 1/viscosity of the flow (l = 0).
        self.charge = 1.0 / np.sum(self.moduli[:, None] * self.rates[:, None] / self.gap ** 2, axis=0)
        self.to_springs = -(self.slow[None, :] / self.gap)
        self.to_voigt = self.charge[:, None] * self.moduli[None, :] / self.gap.T

    @classmethod
    def from_compliance(cls, glassy, compliances, slow, flow=0.0):
        """1/glassy + sum J_j (1 - exp(-l_j t)) + flow t."""
        order = np.argsort(slow)
        compliances, slow = np.asarray(compliances, dtype=float)[order], np.asarray(slow, dtype=float)[order]
        poles = np.concatenate([[0.0], slow]) if flow > 0.0 else slow
        weights = np.concatenate([[flow], compliances * slow]) if flow > 0.0 else compliances * slow
        if len(poles) == 0:
            return cls(glassy, [], [])

        def softness(base, distance):
            # 1/glassy + sum J_j l_j/(l_j - r)
            gaps = (poles - poles[base]) - distance
            return 1.0 / glassy + np.sum(weights / gaps)

        nearest, distance = poles_between(softness, poles, -1.0, True)
        rates = poles[nearest] + distance
        gap = (poles[None, :] - poles[nearest][:, None]) - distance[:, None]
        moduli = 1.0 / (rates * np.sum(weights[None, :] / gap ** 2, axis=1))
        relaxed = 0.0 if flow > 0.0 else 1.0 / (1.0 / glassy + compliances.sum())
        return cls(relaxed, moduli, rates)

    def relaxation(self, t):
        return self.relaxed + np.exp(-np.multiply.outer(t, self.rates)) @ self.moduli


def solid_of(description):
    """("relaxation", relaxed, moduli, rates) or ("creep", glassy, compliances, rates, flow)."""
    kind, *rest = description
    return Solid(*rest) if kind == "relaxation" else Solid.from_compliance(*rest)
