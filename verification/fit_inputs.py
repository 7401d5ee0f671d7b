"""Tables of known materials as people measure them, and what must come out: tests/inputs/fits-*.csv, fits-*.toml and expected_fits.json.

Every table is made from closed forms with NumPy; no code of the solver is used. Noise is normal and relative, from a seed for each table.
    python3 verification/fit_inputs.py            writes all files
    python3 verification/fit_inputs.py --check    only compares them with what is there
"""

import json
import sys
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parents[1] / "tests" / "inputs"
GAS = 8.31446261815324
CASES = []


def put(name, text):
    if "--check" in sys.argv:
        assert (FOLDER / name).read_text(encoding="utf-8") == text, name
    else:
        (FOLDER / name).write_text(text, encoding="utf-8")


def noisy(values, part, seed):
    return values * (1.0 + part * np.random.default_rng(seed).standard_normal(np.shape(values)))


def table(name, header, columns, digits=7):
    lines = [", ".join(header)]
    lines += [", ".join(f"{value:.{digits}g}" for value in row) for row in zip(*columns)]
    put(f"{name}.csv", "\n".join(lines) + "\n")


def case(name, why, values=None, material="", outcome="solved"):
    text = f'# {why}\n[material]\ndata = "{name}.csv"\n{material}'
    put(f"{name}.toml", text)
    listed = [{"pointer": pointer, **({"is": value} if isinstance(value, bool) else {"value": value[0], "tolerance": value[1]}), "why": why}
              for pointer, value in (values or {}).items()]
    CASES.append({"input": name, "outcome": outcome, "command": "material", "values": listed})


def creep(name, compliance, times, part, seed, why, values=None, **rest):
    table(name, ["time (s)", "creep compliance (1/Pa)"], [times, noisy(compliance(times), part, seed)])
    case(name, why, values, **rest)


def modulus(terms, relaxed, omega):
    """E(ω) of (modulus, time) terms."""
    total = np.full(np.shape(omega), relaxed, dtype=complex)
    for strength, time in terms:
        total = total + strength * 1j * omega * time / (1 + 1j * omega * time)
    return total


def log_space(low, high, per_decade):
    return np.logspace(np.log10(low), np.log10(high), round(np.log10(high / low) * per_decade) + 1)


def sweeps(name, of, celsius, part, seed, why, values=None, material='shift = "automatic"\n', **rest):
    """Frequency sweeps from 0.1 to 10 Hz; `of` gives the complex modulus at (temperature, angular frequency)."""
    rng = np.random.default_rng(seed)
    rows = []
    for degrees in celsius:
        for frequency in log_space(0.1, 10.0, 6):
            value = of(degrees + 273.15, 2 * np.pi * frequency)
            rows.append([degrees, frequency, value.real / 1e6 * (1 + part * rng.standard_normal()), value.imag / 1e6 * (1 + part * rng.standard_normal())])
    table(name, ["temperature (°C)", "frequency (Hz)", "E' (MPa)", "E'' (MPa)"], list(np.array(rows).T))
    case(name, why, values, material=material, **rest)


# Creep.
MAXWELL = lambda t: 1 / 2e9 + t / 3e11
BURGERS = lambda t: 1 / 2e9 + t / 8e12 + (1 - np.exp(-t / 40.0)) / 0.9e9
STANDARD = lambda t: 1 / 2e9 + (1 - np.exp(-t / 40.0)) / 0.9e9
VOIGT = lambda t: (1 - np.exp(-t / 40.0)) / 0.9e9
LONG = log_space(0.1, 1e4, 8)
LIQUID = {"/relaxed_modulus": (0.0, 0.0), "/origin/at_rest/liquid": True}
creep("fits-maxwell-creep", MAXWELL, LONG, 0.01, 11, "Maxwell's liquid: E = 2 GPa, eta = 300 GPa s, 1 % noise",
      {**LIQUID, "/origin/at_rest/decided": True, "/glassy_modulus": (2e9, 0.02), "/steady_viscosity": (3e11, 0.02)})
creep("fits-maxwell-creep-exact", MAXWELL, LONG, 0.0, 0, "the same, printed to seven digits",
      {**LIQUID, "/glassy_modulus": (2e9, 1e-5), "/steady_viscosity": (3e11, 1e-5)})
creep("fits-burgers-creep", BURGERS, LONG, 0.01, 12, "Burgers' liquid, 1 % noise",
      {**LIQUID, "/origin/at_rest/decided": True, "/glassy_modulus": (2e9, 0.03), "/steady_viscosity": (8e12, 0.05), "/creep/0/compliance": (1 / 0.9e9, 0.05),
       "/creep/0/retardation_time": (40.0, 0.1)})
creep("fits-burgers-creep-noisy", BURGERS, log_space(0.1, 1e5, 12), 0.05, 13, "Burgers' liquid, 5 % noise",
      {**LIQUID, "/glassy_modulus": (2e9, 0.06), "/steady_viscosity": (8e12, 0.06)})
creep("fits-standard-solid-creep", STANDARD, LONG, 0.01, 14, "standard solid, 1 % noise",
      {"/origin/at_rest/liquid": False, "/origin/at_rest/decided": True, "/relaxed_modulus": (1 / (1 / 2e9 + 1 / 0.9e9), 0.02), "/glassy_modulus": (2e9, 0.03)})
creep("fits-creep-too-short", STANDARD, log_space(0.01, 4.0, 10), 0.02, 15, "standard solid over a tenth of its time: flow looks the same",
      {"/origin/at_rest/decided": False, "/glassy_modulus": (2e9, 0.03)})
creep("fits-kelvin-voigt-creep", VOIGT, LONG, 0.01, 16, "Kelvin and Voigt's solid has no glassy modulus", outcome="refused")

# Relaxation and moduli of liquids.
times = log_space(0.01, 300.0, 8)
table("fits-two-maxwell-relaxation", ["time (s)", "relaxation modulus (MPa)"],
      [times, noisy(30 * np.exp(-times / 0.4) + 5 * np.exp(-times / 60.0), 0.01, 17)])
case("fits-two-maxwell-relaxation", "two Maxwell elements, 1 % noise", {**LIQUID, "/glassy_modulus": (35e6, 0.02), "/steady_viscosity": (30e6 * 0.4 + 5e6 * 60, 0.03)})
omega = log_space(1e-2, 1e3, 6)
liquid = modulus([(2e6, 0.02), (5e5, 1.0), (8e4, 20.0)], 0.0, omega)
table("fits-liquid-moduli", ["angular frequency (rad/s)", "E' (Pa)", "E'' (Pa)"], [omega, noisy(liquid.real, 0.02, 18), noisy(liquid.imag, 0.02, 19)])
case("fits-liquid-moduli", "three Maxwell elements, 2 % noise", {**LIQUID, "/steady_viscosity": (4e4 + 5e5 + 1.6e6, 0.04)})

# Isotherms to be shifted.
BROAD = [(1e6 * 10 ** (0.3 * (8 - k)), 10.0 ** (k - 5)) for k in range(9)]
WLF = lambda kelvin: 10 ** (-9.0 * (kelvin - 293.15) / (110.0 + kelvin - 293.15))
ARRHENIUS = lambda kelvin, energy=1.2e5: np.exp(energy / GAS * (1 / kelvin - 1 / 293.15))
DEGREES = [-10, 0, 10, 20, 30, 40, 50]
ten = lambda kelvin: (float(np.log10(WLF(kelvin))), 0.03)
sweeps("fits-sweeps-wlf", lambda kelvin, w: modulus(BROAD, 1e6, w * WLF(kelvin)), DEGREES, 0.02, 20, "nine terms, WLF, 2 % noise",
       {"/origin/shifts/superposition_holds": True, "/origin/shifts/factors/0/log10_factor": ten(263.15), "/origin/shifts/factors/2/log10_factor": ten(283.15),
        "/origin/shifts/factors/6/log10_factor": ten(323.15), "/origin/shifts/wlf/c1": (9.0, 0.1), "/origin/shifts/reference_temperature": (293.15, 1e-9)})
sweeps("fits-sweeps-between", lambda kelvin, w: modulus(BROAD, 1e6, w * ARRHENIUS(kelvin)), DEGREES, 0.01, 21,
       "nine terms, Arrhenius, used at 25 °C, between measured temperatures",
       {"/shift_factor": (float(ARRHENIUS(298.15)), 0.03), "/origin/shifts/arrhenius/activation_energy": (1.2e5, 0.02), "/origin/shifts/superposition_holds": True},
       material='shift = "automatic"\nreference_temperature = "20 °C"\ntemperature = "25 °C"\n')
sweeps("fits-sweeps-vertical", lambda kelvin, w: modulus(BROAD, 1e6, w * WLF(kelvin)) * (kelvin / 293.15) ** 2, DEGREES, 0.005, 22,
       "nine terms, WLF, moduli that grow as the square of the temperature",
       {"/origin/shifts/superposition_holds": True, "/origin/shifts/factors/6/vertical_factor": ((293.15 / 323.15) ** 2, 0.05),
        "/origin/shifts/factors/6/log10_factor": (float(np.log10(WLF(323.15))), 0.04)},
       material='shift = "automatic_with_vertical"\nreference_temperature = "20 °C"\n')
FAST, SLOW = [(3e8, 1e-4), (1e8, 1e-3), (5e7, 1e-2)], [(2e7, 1e-1), (8e6, 1.0), (3e6, 10.0)]
sweeps("fits-sweeps-two-processes", lambda kelvin, w: modulus(FAST, 0.0, w * ARRHENIUS(kelvin, 6e4)) + modulus(SLOW, 1e6, w * ARRHENIUS(kelvin, 2.2e5)), DEGREES, 0.01, 23,
       "two processes with different activation energies: superposition fails", {"/origin/shifts/superposition_holds": False})
sweeps("fits-sweeps-no-overlap", lambda kelvin, w: modulus(BROAD, 1e6, w * WLF(kelvin)), [-10, 50], 0.02, 24, "isotherms 60 K apart have no value in common",
       outcome="refused")
rows = []
generator = np.random.default_rng(25)
for degrees in [10, 20, 30, 40]:
    for time in log_space(1.0, 300.0, 8):
        reduced = time / ARRHENIUS(degrees + 273.15)
        value = 5e-10 + 2e-9 * (1 - np.exp(-reduced / 3)) + 6e-9 * (1 - np.exp(-reduced / 40)) + 9e-9 * (1 - np.exp(-reduced / 700))
        rows.append([degrees, time, value * (1 + 0.01 * generator.standard_normal())])
table("fits-creep-isotherms", ["temperature (°C)", "time (s)", "J (1/Pa)"], list(np.array(rows).T))
case("fits-creep-isotherms", "creep at four temperatures, Arrhenius, 1 % noise",
     {"/origin/shifts/superposition_holds": True, "/origin/shifts/factors/3/log10_factor": (float(np.log10(ARRHENIUS(313.15))), 0.03),
      "/origin/shifts/arrhenius/activation_energy": (1.2e5, 0.03)}, material='shift = "automatic"\nreference_temperature = "20 °C"\n')

put("expected_fits.json", "[\n" + ",\n".join(json.dumps(one, ensure_ascii=False) for one in CASES) + "\n]\n")
print(len(CASES), "inputs")
