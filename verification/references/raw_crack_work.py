"""The closure work of a steady crack, straight from the double integral; trumpet and closing stress from the single one.

Source: Mandriota, Adhesion and friction in steady and unsteady viscoelastic contacts (doctoral thesis), chapter 5:
    opening   work 5.19 with tension 5.12, displacement 5.11, reference displacement 5.14
    closing   work 5.37 with stress 5.30, reference stress below 5.30, displacement 5.32
One deformable half-body against a rigid one, plane stress: G = K^2/(2 E0).

    symbol   meaning                                             unit
    delta    process-zone length                                 length
    v        speed of the tip                                    length/time
    T        transit time delta/v                                time
    s        distance from the tip (behind it when opening,      length
             inside the contact when closing)
    J_j, tau_j   strength and RETARDATION time of a creep term   1/modulus, time
    E_i, rho_i   strength and RELAXATION time of a term          modulus, time
    z        delta/(v tau_j) or delta/(v rho_i)                  1
    xi       distance in units of delta                          1

Nothing here uses the collapsed form of the closure (running means of J and R) or Dawson's function: the inner integral
is the memory integral over past time, the outer one the work over the process zone. Lengths are in units of delta, time
in units of delta/v, so one term of unit strength contributes

    opening   F(z) = int_0^1 dxi xi^{-1/2}    int_0^{s} z e^{-z t} (s - t)^{1/2}  dt,   s = 1 - xi
    closing   F(z) = int_0^1 ds (1 - s)^{1/2} int_0^{s} z e^{-z t} (s - t)^{-1/2} dt

Quadrature: Gauss panels. Inner: t = s p(2-p) removes the root at t = s without cancellation, panels of 30 in the exponent;
where the memory is much shorter than s, the panels sit in t itself. Outer: sqrt(s) is the variable up to s = 1/2, panels
growing by 4 from the memory length 1/z; sqrt(1-s) from there on. Distances to both ends are thus graded.
"""

from mpmath import mp, mpf

from common import gauss, geometric, panels

PANEL = 30  # range of the exponent on one inner panel; Gauss with n nodes errs by about exp(-(2n)^2/30) there


def memory(setting, z, s, power):
    """int_0^s z e^{-z t} (s - t)^power dt for power = +1/2 or -1/2."""
    reach = z * s
    root = mp.sqrt(s)
    if reach > 2 * setting.cutoff:
        total = mpf(0)
        for weight, shift in _short_memory(setting, z):
            gap = mp.sqrt(s - shift)
            total += weight * gap if power > 0 else weight / gap
        return total
    breaks, exponent = [mpf(0)], mpf(0)
    last = min(reach, mpf(setting.cutoff))
    while exponent < last:
        exponent = min(exponent + PANEL, last)
        q = exponent / reach
        breaks.append(q / (1 + mp.sqrt(1 - q)) if exponent < reach else mpf(1))
    if power > 0:
        return 2 * z * s * root * panels(setting, lambda p: (1 - p) ** 2 * mp.exp(-reach * p * (2 - p)), breaks)
    return 2 * z * root * panels(setting, lambda p: mp.exp(-reach * p * (2 - p)), breaks)


_SHORT = {}


def _short_memory(setting, z):
    """Nodes t and weights z e^{-z t} dt on 0 < z t < cutoff."""
    key = (setting, z)
    if key not in _SHORT:
        _SHORT.clear()
        nodes, start = [], 0
        while start < setting.cutoff:
            width = min(PANEL, setting.cutoff - start)
            for x, w in gauss(setting):
                e = start + width * x
                nodes.append((width * w * mp.exp(-e), e / z))
            start += width
        _SHORT[key] = nodes
    return _SHORT[key]


def _outer_breaks(z):
    half = mp.sqrt(mpf(1) / 2)
    first = min(half, mp.sqrt(8 / z))
    return [mpf(0)] + (geometric(first, half, 4) if first < half else [half]), [mpf(0), half]


def opening_term(setting, z):
    """F(z) of an opening crack."""
    inner, outer = _outer_breaks(z)

    def near_tip(q):      # s = q^2
        return 2 * q / mp.sqrt(1 - q * q) * memory(setting, z, q * q, 0.5)

    def near_edge(r):     # xi = r^2, xi^{-1/2} dxi = 2 dr
        return 2 * memory(setting, z, 1 - r * r, 0.5)

    return panels(setting, near_tip, inner) + panels(setting, near_edge, outer)


def closing_term(setting, z):
    """F(z) of a closing crack."""
    inner, outer = _outer_breaks(z)

    def near_tip(q):      # s = q^2
        return 2 * q * mp.sqrt(1 - q * q) * memory(setting, z, q * q, -0.5)

    def near_edge(r):     # 1 - s = r^2
        return 2 * r * r * memory(setting, z, 1 - r * r, -0.5)

    return panels(setting, near_tip, inner) + panels(setting, near_edge, outer)


def instant_term(setting):
    """The memoryless part of either work, int_0^1 xi^{-1/2} (1 - xi)^{1/2} dxi, by the same panels."""
    inner, outer = _outer_breaks(mpf(1))
    return (panels(setting, lambda q: 2 * q * q / mp.sqrt(1 - q * q), inner)
            + panels(setting, lambda r: 2 * mp.sqrt(1 - r * r), outer))


def flow_term(setting):
    """Steady flow, J' = 1/eta: int_0^1 dxi xi^{-1/2} int_0^s (s - t)^{1/2} dt (times T/eta)."""
    inner, outer = _outer_breaks(mpf(1))

    def past(s):          # t = s (1 - y^2)
        return 2 * s * mp.sqrt(s) * panels(setting, lambda y: y * y, [mpf(0), mpf(1)])

    return (panels(setting, lambda q: 2 * q / mp.sqrt(1 - q * q) * past(q * q), inner)
            + panels(setting, lambda r: 2 * past(1 - r * r), outer))


# sigma * u has the factor (2 pi)^{-1/2} (8/pi)^{1/2} = 2/pi; the work is half the integral.

def opening_work(setting, material, transit_time):
    """Work 5.19 divided by K^2 delta."""
    with mp.workdps(setting.dps):
        total = material.instant_compliance() * instant_term(setting)
        for strength, time in zip(material.strengths, material.times):
            total += strength * opening_term(setting, transit_time / time)
        if material.viscosity:
            total += transit_time / material.viscosity * flow_term(setting)
        return total / mp.pi


def closing_work(setting, material, transit_time):
    """Work 5.37 divided by (K1/E0)^2 delta."""
    with mp.workdps(setting.dps):
        total = material.glassy_modulus() * instant_term(setting)
        for strength, time in zip(material.strengths, material.times):
            total -= strength * closing_term(setting, transit_time / time)
        return total / mp.pi


def trumpet(setting, material, speed, distance):
    """u - u0 per unit K at `distance` behind an opening tip, from 5.11 and 5.14."""
    with mp.workdps(setting.dps):
        total = material.instant_compliance() * mp.sqrt(distance)
        for strength, time in zip(material.strengths, material.times):
            reach = distance / (speed * time)
            total += strength * mp.sqrt(distance) * memory(setting, reach, mpf(1), 0.5)
        if material.viscosity:
            past = 2 * panels(setting, lambda y: y * y, [mpf(0), mpf(1)])
            total += distance / speed / material.viscosity * mp.sqrt(distance) * past
        return mp.sqrt(8 / mp.pi) * total


def closing_stress(setting, material, speed, distance):
    """Stress per unit K1 at `distance` inside a closing contact, from 5.30; and the sum of its parts' magnitudes."""
    with mp.workdps(setting.dps):
        instant = material.glassy_modulus() / mp.sqrt(distance)
        relaxed = mpf(0)
        for strength, time in zip(material.strengths, material.times):
            reach = distance / (speed * time)
            relaxed += strength / mp.sqrt(distance) * memory(setting, reach, mpf(1), -0.5)
        unit = material.relaxed_modulus() * mp.sqrt(2 * mp.pi)
        return (instant - relaxed) / unit, (instant + relaxed) / unit
