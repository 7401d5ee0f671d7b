"""How strongly a value reacts to its argument: |d ln value / d ln v| (d ln T for a mean), three digits.

This is advice to whoever compares in double precision, not a reference value, so it may use the closed forms.

A closing crack whose process zone grows with G is nearly vertical in a plot of G over v: where G is proportional to T,
delta is too, and v = delta/T stands still. The factor is (<R> - R(T))/R(T), up to about beta/ln(beta): at beta = 1e6 a
speed rounded to double fixes G to eleven digits only. Opening cracks have factors below 1.
"""

from mpmath import mp, mpf

from common import FINE, number


def _report(slope, power, law):
    """slope = d ln value/d ln T; delta is proportional to value^power."""
    return number(abs(slope) if law != "growing" else abs(slope / (power * slope - 1)), 3)


def of_energy_closure(material, time, law):
    """T d<f>/dT = f(T) - <f> for the running mean <f> of f = J or R."""
    with mp.workdps(FINE.dps):
        instant = material.instant_compliance() if material.kind == "creep" else material.relaxed_modulus()
        sign = -1 if material.kind == "creep" else 1
        mean, now = instant, instant
        for strength, t in zip(material.strengths, material.times):
            z = time / t
            left, forgotten = mp.exp(-z), -mp.expm1(-z) / z
            mean += strength * (forgotten if sign > 0 else 1 - forgotten)
            now += strength * (left if sign > 0 else 1 - left)
        if material.viscosity:
            mean, now = mean + time / (2 * material.viscosity), now + time / material.viscosity
        slope = (now - mean) / mean
        if law == "none":
            return _report(slope, 1, law)
        return _report(-slope / 2, 2, law) if material.viscosity else _report(-slope, 1, law)


def of_persson_brener(material, time, law):
    with mp.workdps(FINE.dps):
        loss, change = mpf(0), mpf(0)
        for strength, t in zip(material.strengths, material.times):
            c = 2 * mp.pi * t / time
            root = mp.sqrt(1 + c * c)
            kappa = c / (1 + root)
            loss += strength * kappa
            change -= strength * kappa / root      # T d kappa/dT = -kappa/sqrt(1 + c^2)
        relaxed = material.relaxed_modulus()
        inverse = 1 - relaxed * loss if material.kind == "creep" else 1 + loss / relaxed
        slope = (relaxed * change if material.kind == "creep" else -change / relaxed) / inverse
        return _report(slope, 1, law)
