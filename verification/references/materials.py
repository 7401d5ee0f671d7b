"""The linear viscoelastic solids of the crack references: exact doubles, in two systems of units.

    symbol        key in the file       meaning
    E_inf         glassy_modulus        1/J(0); given for a creep series, the sum of the terms for a relaxation series
    E_0           relaxed_modulus       given for a relaxation series; 1/J(infinity) for a creep series, 0 if it flows
    J_j, tau_j    creep_strength, retardation_time           J(t) = 1/E_inf + sum J_j (1 - e^{-t/tau_j}) [+ t/eta]
    E_i, rho_i    relaxation_strength, relaxation_time       R(t) = E_0 + sum E_i e^{-t/rho_i}
    eta           flow_viscosity        steady flow of a creep series (0 or absent: a solid)

Every number is first rounded to a short decimal and then to a double, so it is the same on every machine. What a
material means is the double, not the decimal; derived moduli are sums at the working precision, never stored.
The length of a spectrum, its span and its strengths are irregular on purpose: no term is special.
"""

from dataclasses import dataclass

from mpmath import mpf

from common import double, exact


@dataclass(frozen=True)
class Material:
    name: str
    kind: str                 # "creep" or "relaxation"
    modulus: float            # glassy for creep, relaxed for relaxation
    series: tuple             # ((strength, time), ...)
    flow: float = 0.0
    units: str = "Pa m s"
    length: float = 1e-6      # a process-zone length typical in these units
    cohesive: float = 1e6     # a cohesive stress in these units
    adhesion: float = 0.1     # a work of adhesion in these units

    @property
    def strengths(self):
        return [exact(a) for a, _ in self.series]

    @property
    def times(self):
        return [exact(t) for _, t in self.series]

    @property
    def viscosity(self):
        return exact(self.flow)

    def instant_compliance(self):
        return 1 / self.glassy_modulus()

    def glassy_modulus(self):
        return exact(self.modulus) if self.kind == "creep" else exact(self.modulus) + sum(self.strengths, mpf(0))

    def relaxed_modulus(self):
        if self.kind == "relaxation":
            return exact(self.modulus)
        return mpf(0) if self.flow else 1 / (1 / exact(self.modulus) + sum(self.strengths, mpf(0)))

    def rows(self):
        """Rows of the material table."""
        out = [dict(material=self.name, key="kind", index="", value=self.kind),
               dict(material=self.name, key="units", index="", value=self.units)]
        creep = self.kind == "creep"
        out.append(dict(material=self.name, key="glassy_modulus" if creep else "relaxed_modulus", index="",
                        value=double(self.modulus)))
        if self.flow:
            out.append(dict(material=self.name, key="flow_viscosity", index="", value=double(self.flow)))
        for i, (strength, time) in enumerate(self.series):
            out.append(dict(material=self.name, key="creep_strength" if creep else "relaxation_strength",
                            index=i, value=double(strength)))
            out.append(dict(material=self.name, key="retardation_time" if creep else "relaxation_time",
                            index=i, value=double(time)))
        return out


COLUMNS = ["material", "key", "index", "value"]


def short(x):
    return float(f"{x:.7g}")


def spectrum(count, first, last, total, slope):
    """`count` terms with times from `first` to `last`, unevenly spaced, strengths ~ time^slope, sum about `total`."""
    wobble = [((7 * k * k + 3 * k) % 11) / 11 - 0.5 for k in range(count)]
    times = [first * (last / first) ** ((k + (0.5 * wobble[k] if 0 < k < count - 1 else 0)) / max(1, count - 1))
             for k in range(count)]
    raw = [(t / first) ** slope * (1 + 0.8 * wobble[(3 * k + 1) % count]) for k, t in enumerate(times)]
    return tuple((short(total * r / sum(raw)), short(t)) for r, t in zip(raw, times))


def rescaled(material, name, units, stress, length, time):
    """The same solid in other units: new unit = `stress` Pa, `length` m, `time` s."""
    power = -1 if material.kind == "creep" else 1
    return Material(
        name, material.kind, short(material.modulus / stress),
        tuple((short(a * stress ** -power), short(t / time)) for a, t in material.series),
        flow=short(material.flow / (stress * time)) if material.flow else 0.0, units=units,
        length=short(material.length / length), cohesive=short(material.cohesive / stress),
        adhesion=short(material.adhesion / (stress * length)))


def creep_with_ratio(name, glassy, beta, count, first, last, slope, **more):
    return Material(name, "creep", glassy, spectrum(count, first, last, (beta - 1) / glassy, slope), **more)


def relaxation_with_ratio(name, relaxed, beta, count, first, last, slope, **more):
    return Material(name, "relaxation", relaxed, spectrum(count, first, last, (beta - 1) * relaxed, slope), **more)


_CREEP = [
    creep_with_ratio("creep_1_beta2", 3.1e6, 2, 1, 0.0137, 0.0137, 0, length=2.3e-6, cohesive=1.7e6, adhesion=0.31),
    creep_with_ratio("creep_1_beta1e3", 1.9e9, 1e3, 1, 4.7e-3, 4.7e-3, 0, length=7.1e-7, cohesive=4.3e6, adhesion=0.053),
    creep_with_ratio("creep_1_beta1e6", 2.7e9, 1e6, 1, 61.0, 61.0, 0, length=3.3e-5, cohesive=2.9e4, adhesion=1.9),
    creep_with_ratio("creep_2_beta50", 8.3e7, 50, 2, 3.1e-5, 0.29, 0.06, length=1.3e-6, cohesive=9.7e5, adhesion=0.17),
    creep_with_ratio("creep_3_beta100", 2.2e8, 100, 3, 2.9e-6, 1.7e-2, 0.2, length=5.9e-6, cohesive=6.1e5, adhesion=0.77),
    creep_with_ratio("creep_6_beta1e3", 1.4e9, 1e3, 6, 7.7e-7, 3.9, 0.15, length=4.1e-7, cohesive=3.7e6, adhesion=0.043),
    creep_with_ratio("creep_12_beta1e3", 2.1e9, 1e3, 12, 1.3e-8, 1.3e4, 0.21, length=1.1e-6, cohesive=1.3e6, adhesion=0.11),
    creep_with_ratio("creep_20_beta1e6", 3.7e9, 1e6, 20, 2.3e-9, 2.3e3, 0.4, length=6.7e-6, cohesive=3.1e4, adhesion=0.23),
    Material("creep_2_viscous", "creep", 5.3e8, ((2.7e-8, 1.9e-4), (4.1e-7, 0.083)), flow=3.3e7,
             length=2.9e-6, cohesive=2.3e5, adhesion=0.37),
]
_CREEP.append(rescaled(_CREEP[3], "creep_2_beta50_mpa_mm_ms", "MPa mm ms", 1e6, 1e-3, 1e-3))

_RELAXATION = [
    relaxation_with_ratio("relaxation_1_beta2", 1.6e6, 2, 1, 0.0211, 0.0211, 0, length=1.9e-6, cohesive=1.1e6, adhesion=0.29),
    relaxation_with_ratio("relaxation_1_beta100", 7.3e5, 100, 1, 3.7e-4, 3.7e-4, 0, length=8.3e-7, cohesive=2.3e6, adhesion=0.061),
    relaxation_with_ratio("relaxation_1_beta1e6", 2.9e3, 1e6, 1, 5.3, 5.3, 0, length=2.1e-5, cohesive=3.7e4, adhesion=1.3),
    relaxation_with_ratio("relaxation_2_beta50", 1.7e6, 50, 2, 8.9e-6, 0.031, -0.08, length=1.7e-6, cohesive=1.9e6, adhesion=0.19),
    relaxation_with_ratio("relaxation_3_beta100", 2.3e6, 100, 3, 4.3e-7, 6.1e-3, -0.2, length=4.7e-6, cohesive=5.9e5, adhesion=0.83),
    relaxation_with_ratio("relaxation_6_beta1e3", 1.1e6, 1e3, 6, 6.7e-8, 0.41, -0.15, length=3.7e-7, cohesive=2.9e6, adhesion=0.047),
    relaxation_with_ratio("relaxation_12_beta1e3", 1.9e6, 1e3, 12, 1.7e-9, 1.7e3, -0.21, length=1.3e-6, cohesive=1.9e6, adhesion=0.13),
    relaxation_with_ratio("relaxation_20_beta1e6", 3.1e3, 1e6, 20, 3.1e-10, 3.1e2, -0.4, length=7.9e-6, cohesive=4.1e4, adhesion=0.27),
]
_RELAXATION.append(rescaled(_RELAXATION[3], "relaxation_2_beta50_mpa_mm_ms", "MPa mm ms", 1e6, 1e-3, 1e-3))

MATERIALS = {material.name: material for material in _CREEP + _RELAXATION}
