"""What an edge does, from the fields of the body: closure work, energy released, stress intensity.

closure     (1/2 delta) int tension(a - d) gap(a - d + delta) dd, both the current fields, time frozen (thesis 4.9). The pressure of elements is a distribution:
            its reactions are int p phi 2 pi r dr. So the work is the sum of reaction times (gap one zone further out)/(2 pi r) over the nodes of the zone.
release     of the body with its memory frozen: the edge gives up a stretch, and the released reactions do work on the gap that opens. Half of that product is
            the energy difference exactly, as the frozen body is linear. (To close the next stretch is another matter: the gap of an edge at rest crept.)
intensity   K with K^2 = 2 E*_glassy G, sign of the tension: frozen, the body is glassy. A moving edge gives up one element. An edge at rest has grown old on one element,
            and where the Poisson ratio changes the elements around it do not share the singularity as a glassy body would: 0.2 % of K on any
            mesh. There the stretches are one, two and three of the coarsest elements, extrapolated to none: the share of the last element falls with the mesh.
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
    """Energy released per area where the edge opens by some elements, memory frozen."""
    bulk, shear = contact.solid.glassy
    compliance = contact.body.compliance(bulk, shear, contact.candidates)
    n = len(contact.reactions)
    kept = n - contact.body.degree * elements
    # The forces on the last nodes go to zero, those further in keep their place.
    freed = contact.reactions[kept:]
    change = np.linalg.solve(compliance[:kept, :kept], compliance[:kept, kept:n] @ freed)
    opened = compliance[kept:n, :kept] @ change - compliance[kept:n, kept:n] @ freed
    return -0.5 * float(freed @ opened) / (np.pi * (contact.radii[n - 1] ** 2 - contact.radii[kept - 1] ** 2))


def intensity(contact, resting_on=0):
    """K; at rest with the number of elements in a coarsest one."""
    if resting_on:
        one, two, three = (release(contact, count * resting_on) for count in (1, 2, 3))
        rate = 3.0 * one - 3.0 * two + three
    else:
        rate = release(contact)
    return float(np.sqrt(2.0 * plane_modulus(*contact.solid.glassy) * rate) * -np.sign(contact.reactions[-1]))
