"""What an edge does, from the fields of the body: closure work, energy released, stress intensity.

closure     (1/2 delta) int tension(a - d) gap(a - d + delta) dd, both the current fields, time frozen (thesis 4.9). The pressure of elements is a distribution:
            its reactions are int p phi 2 pi r dr. So the work is the sum of reaction times (gap one zone further out)/(2 pi r) over the nodes of the zone.
release     of the body with its memory frozen: the edge moves by one element, the released reactions do work on the gap that opens. Half of that product is
            the energy difference exactly, as the frozen body is linear. Forwards and backwards are averaged.
intensity   K with K^2 = 2 E*_glassy G, sign of the tension: frozen, the body is glassy.
"""

import numpy as np

from maxwell import plane_modulus


def closure(contact, zone):
    """Work per area; the zone is a whole number of elements."""
    n, radii = len(contact.reactions), contact.radii
    first = int(np.searchsorted(radii, (radii[n - 1] - zone) * (1.0 + 1e-9))) - 1
    shift = n - 1 - first
    inside = np.arange(first + 1, n)
    assert np.allclose(radii[inside + shift] - radii[inside], zone, rtol=1e-6), "the zone is no number of elements"
    return -float(np.sum(contact.reactions[inside] * contact.gap()[inside + shift] / (2.0 * np.pi * radii[inside]))) / (2.0 * zone)


def release(contact, elements=1):
    """(energy released per area, where the edge opens; the same where it closes), memory frozen."""
    bulk, shear = contact.solid.glassy
    compliance = contact.body.compliance(bulk, shear, contact.candidates)
    n, move = len(contact.reactions), contact.body.degree * elements
    area = lambda low, high: np.pi * (contact.radii[high] ** 2 - contact.radii[low] ** 2)
    # Opening: the forces on the last nodes go to zero, those further in keep their place.
    kept = n - move
    change = np.linalg.solve(compliance[:kept, :kept], compliance[:kept, kept:n] @ contact.reactions[kept:])
    opened = compliance[kept:n, :kept] @ change - compliance[kept:n, kept:n] @ contact.reactions[kept:]
    opening = -0.5 * float(contact.reactions[kept:] @ opened) / area(kept - 1, n - 1)
    # Closing: the next nodes are drawn to the indenter.
    wide = n + move
    wanted = np.zeros(wide)
    wanted[n:] = -contact.gap()[n:wide]
    added = np.linalg.solve(compliance[:wide, :wide], wanted)
    closing = -0.5 * float(added[n:] @ contact.gap()[n:wide]) / area(n - 1, wide - 1)
    return opening, closing


def intensity(contact):
    opening, closing = release(contact)
    squared = 2.0 * plane_modulus(*contact.solid.glassy) * 0.5 * (opening + closing)
    return float(np.sqrt(abs(squared)) * -np.sign(contact.reactions[-1]))
