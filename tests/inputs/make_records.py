#!/usr/bin/env python3
"""Makes the inputs of `expected_records.json`: recorded histories and measured profiles, as instruments write them, with values from closed forms.

Source: Lee and Radok (1960) for a contact that grows, Ting (1966) for one that shrinks, Hertz and Sneddon for the elastic shapes; quadratures by SciPy.
Run it in this folder: `python3 make_records.py`. Numbers of noise come from a fixed seed.
"""
import json
import math
import random

from scipy.integrate import quad
from scipy.optimize import brentq
from scipy.special import gamma

random.seed(39)
RADIUS, POISSON = 100e-6, 0.5
RELAXED, TERMS = 6000.0, [(5000.0, 3.0), (6000.0, 0.2)]
SPHERE = """[material]
relaxed_modulus = 6000.0
poisson_ratio = 0.5
relaxation = [{ modulus = 5000.0, relaxation_time = 3.0 }, { modulus = 6000.0, relaxation_time = 0.2 }]
[indentation]
sphere = { radius = "100 µm" }
"""
ELASTIC = "[material]\nrelaxed_modulus = \"1 MPa\"\npoisson_ratio = 0.5\n[indentation]\n"
PLANE = 1e6 / (1 - POISSON**2)
cases = []


def modulus(t):
    return (RELAXED + sum(e * math.exp(-t / tau) for e, tau in TERMS)) / (1 - POISSON**2)


def case(name, text, values=None):
    """A scene and what is expected of it."""
    open(f"{name}.toml", "w", encoding="utf-8").write(text)
    entry = {"input": name, "outcome": "solved" if values else "refused", "values": values or []}
    cases.append(entry)


def value(column, time, right, tolerance, why):
    return {"column": column, "row": {"time": time}, "value": right, "tolerance": tolerance, "why": why}


def write(name, text, encoding="utf-8"):
    with open(name, "w", encoding=encoding, newline="") as file:
        file.write(text)


def ramp_force(depth, up, t):
    """The force of a straight ramp to a depth in `up` seconds, then held: 4/3 √R ∫ E*(t − s) d(δ^1.5)."""
    f = lambda s: modulus(t - s) * 1.5 * depth * math.sqrt(depth) / up * math.sqrt(s / up)
    return 4 / 3 * math.sqrt(RADIUS) * quad(f, 0, min(t, up), limit=200, epsabs=0, epsrel=1e-11)[0]


def unloading_force(depth, up, hold, down, t):
    """The force while the ramp goes back straight in `down` seconds (Ting)."""
    start = up + hold
    back = quad(lambda s: modulus(t - s) * depth / down, start, t, epsrel=1e-12)[0]
    gone = lambda t1: quad(lambda s: modulus(t - s) * depth / up, t1, up, epsrel=1e-12)[0] - back
    if gone(0) < 0:
        return 0.0
    t1 = brentq(gone, 0, up, xtol=1e-14)
    f = lambda s: modulus(t - s) * 1.5 * depth * math.sqrt(depth) / up * math.sqrt(s / up)
    return 4 / 3 * math.sqrt(RADIUS) * quad(f, 0, t1, limit=200, epsabs=0, epsrel=1e-11)[0]


def comma(number, digits=6):
    return f"{number:.{digits}f}".replace(".", ",")


# 1 A force curve: extend, pause, retract; the height falls while the tip goes in, contact at 1.2 µm.
def curve(with_series):
    depth, rate, lines, series = 1e-6, 400, [], 0
    parts = [("extend", [1.4e-6 - 1.2e-6 * i / 480 for i in range(481)]), ("pause", [0.2e-6] * 400), ("retract", [0.2e-6 + 1.0e-6 * i / 400 for i in range(1, 401)])]
    for number, (name, heights) in enumerate(parts):
        lines += [f"# segmentIndex: {number}", f"# segment: {name}", "# springConstant: 0.04", "# columns: vDeflection measuredHeight " + ("seriesTime segmentTime" if with_series else "time"), "# units: N m s" + (" s" if with_series else "")]
        for i, height in enumerate(heights):
            t = series / rate
            times = f"{t:.6f} {i / rate:.6f}" if with_series else f"{i / rate:.6f}"
            lines.append(f"{1e-9 * random.gauss(0, 1):.6e} {height:.9e} {times}")
            series += 1
        lines.append("")
    return "\n".join(lines)


write("records-force-curve.txt", curve(True))
MAPPED = '[[history]]\ntable = "%s"\nquantity = "penetration"\ncontact_point = "1.2 µm"\ninvert = true\n[history.columns]\npenetration = "measuredHeight"\n'
# Contact begins after 0.2 s; the depth is 1 µm 1 s later, the pause ends at 881/400 s.
free, hold = 80 / 400, 400 / 400
case(
    "records-force-curve",
    SPHERE + MAPPED % "records-force-curve.txt",
    [
        value("force", 480 / 400, ramp_force(1e-6, 1.0, 1.0), 2e-3, "Lee-Radok at the end of the ramp"),
        value("force", 880 / 400, ramp_force(1e-6, 1.0, 2.0), 2e-3, "Lee-Radok at the end of the pause"),
        value("force", 920 / 400, unloading_force(1e-6, 1.0, 1.0, 1.0, 2.0 + 40 / 400), 5e-3, "Ting while it retracts"),
    ],
)
write("records-segment-times.txt", curve(False))
case("records-segment-times", SPHERE + MAPPED % "records-segment-times.txt")

# 2 Semicolons, decimal commas, a row of units, Windows-1252.
text = "Prüfung;Nr. 7\r\nProbe;Gel\r\nZeit;Eindringtiefe;Kraft;Temperatur\r\ns;µm;mN;°C\r\n"
text += "".join(f"{comma(t)};{comma(2.0 * min(t / 2, 1))};{comma(0.01 * t)};{comma(23.4, 1)}\r\n" for t in [0.05 * i for i in range(81)])
write("records-decimal-commas.csv", text, "cp1252")
case(
    "records-decimal-commas",
    SPHERE + '[[history]]\ntable = "records-decimal-commas.csv"\nquantity = "penetration"\n',
    [value("force", 4.0, ramp_force(2e-6, 2.0, 4.0), 1e-3, "Lee-Radok")],
)

# 3 Columns that only the scene can name.
text = "Time, Tip-sample separation, Deflection, Sum\n" + "".join(f"{t:.3f}, {-1.5e-6 * min(t, 1):.6e}, {0.1 * t:.4f}, 3.2\n" for t in [0.02 * i for i in range(101)])
write("records-named-columns.csv", text)
case(
    "records-named-columns",
    SPHERE + '[[history]]\ntable = "records-named-columns.csv"\nquantity = "penetration"\ninvert = true\n[history.columns]\ntime = "Time in s"\npenetration = "Tip-sample separation in m"\n',
    [value("force", 2.0, ramp_force(1.5e-6, 1.0, 2.0), 1e-3, "Lee-Radok")],
)
case(
    "records-misnamed-column",
    SPHERE + '[[history]]\ntable = "records-named-columns.csv"\nquantity = "penetration"\n[history.columns]\ntime = "Time in s"\npenetration = "Tip-sample seperation in m"\n',
)

# 4 UTF-16 with tabulators, from a spreadsheet.
text = "\ufeffTime (sec)\tPenetration depth (nm)\tLoad (uN)\r\n" + "".join(f"{t:.2f}\t{800 * min(t / 0.5, 1):.3f}\t{t:.3f}\r\n" for t in [0.01 * i for i in range(151)])
write("records-spreadsheet.txt", text, "utf-16-le")
case(
    "records-spreadsheet",
    SPHERE + '[[history]]\ntable = "records-spreadsheet.txt"\nquantity = "penetration"\n',
    [value("force", 1.5, ramp_force(0.8e-6, 0.5, 1.5), 1e-3, "Lee-Radok")],
)

# 5 Force control: a nanoindenter's load, thousands in quotation marks; a³ = 3/4 R F/E* of an elastic body.
text = "Depth (nm),Load (µN),Time (s)\n" + "".join(f'{900 * t:.1f},"{2500 * t:,.1f}",{t:.2f}\n' for t in [0.05 * i for i in range(21)])
write("records-load.csv", text)
radius = (0.75 * 50e-6 * 2.5e-3 / PLANE) ** (1 / 3)
case(
    "records-load",
    ELASTIC + 'sphere = { radius = "50 µm" }\n[[history]]\ntable = "records-load.csv"\nquantity = "force"\n',
    [value("penetration", 1.0, radius**2 / 50e-6, 1e-3, "Hertz"), value("contact_radius", 1.0, radius, 1e-3, "Hertz")],
)

# 6 20 000 noisy rows (27-record.csv) with the noise left out, and with a tolerance far below it.
steps = {"table": '[[history]]\ntable = "27-record.csv"\nquantity = "penetration"\n'}
case(
    "records-noise-left-out",
    "accuracy = 1e-2\n" + SPHERE + steps["table"] + 'noise = "left_out"\n',
    [value("force", 15.0, 2.775519227304854e-07, 0.01, "MDR, of the record without its noise")],
)
case("records-tolerance-below-the-noise", "accuracy = 1e-2\n" + SPHERE + steps["table"] + 'tolerance = "0.05 nm"\n')
case("records-unit-of-a-voltage", SPHERE + '[[history]]\ntable = "records-voltage.csv"\nquantity = "penetration"\n')
write("records-voltage.csv", "time (s), penetration (V)\n0, 0\n1, 2.5\n2, 2.5\n")
case("records-two-loads", SPHERE + '[[history]]\ntable = "records-two-loads.csv"\nquantity = "force"\n')
write("records-two-loads.csv", "time (s), force (µN), load (µN)\n0, 0, 0\n1, 2.5, 2.6\n2, 2.5, 2.6\n")

# Profiles: force at a depth reached in one second.
PRESS = '[[history]]\npenetration = "%s"\nduration = "1 s"\n'


def hertz(radius, depth):
    return 4 / 3 * PLANE * math.sqrt(radius) * depth**1.5


def power(c, m, depth):
    """Of z = c r^m: f = κ c s^m, F = 2E* m/(m + 1) Δ a."""
    kappa = 0.5 * math.sqrt(math.pi) * m * gamma(m / 2) / gamma(m / 2 + 0.5)
    a = (depth / (kappa * c)) ** (1 / m)
    return 2 * PLANE * m / (m + 1) * depth * a


# 7 A stylus over a lens that points up: preamble, µm and Å, offset, tilt, noise.
text = "Dektak 150\r\nData File:,C:\\scan 12.csv\r\nScan Length (um),2000\r\nStylus Force (mg),3.0\r\n\r\nLateral(um),Total Profile(A),\r\n"
for i in range(1001):
    x = 2.0 * i
    z = -((x - 930.0) ** 2) / (2 * 20000.0) * 1e4 + 53000 + 3.0 * x + random.gauss(0, 200)
    text += f"{x:.3f},{z:.1f},\r\n"
write("records-stylus.csv", text)
case(
    "records-stylus",
    ELASTIC + 'profile = "records-stylus.csv"\nscan = { apex = "highest" }\n' + PRESS % "5 µm",
    [value("force", 1.0, hertz(20e-3, 5e-6), 0.02, "Hertz, R = 20 mm, noise of 20 nm, a tilt that shifts the apex by 6 µm")],
)

# 8 A cone with a tilt and noise, semicolons and decimal commas.
text = "x/µm;Höhe/µm\n" + "".join(f"{comma(x, 3)};{comma(0.25 * abs(x - 21.3) + 0.015 * x + 4.0 + random.gauss(0, 0.01), 4)}\n" for x in [0.1 * i for i in range(401)])
write("records-cone.csv", text)
case(
    "records-cone",
    ELASTIC + 'profile = "records-cone.csv"\nscan.columns = { z = "Höhe in µm" }\n' + PRESS % "2 µm",
    [value("force", 1.0, 2 / math.pi * PLANE * (2e-6) ** 2 / 0.25, 0.03, "Sneddon, slope 0.25")],
)

# 9 A map of a tip that points up, in blanks, noise of 2 nm.
text = "# tip characteriser\nx y z\nµm µm nm\n"
for row in range(41):
    for column in range(41):
        x, y = 0.05 * column, 0.05 * row
        z = 600 - 1e3 * (((x - 1.07) ** 2 + (y - 0.94) ** 2) / (2 * 4.0)) + random.gauss(0, 2)
        text += f"{x:.3f} {y:.3f} {z:.3f}\n"
write("records-map.xyz", text)
case(
    "records-map",
    ELASTIC + 'profile = "records-map.xyz"\n' + PRESS % "50 nm",
    [value("force", 1.0, hertz(4e-6, 50e-9), 0.03, "Hertz, R = 4 µm, noise of 2 nm at a depth of 50 nm")],
)

# 10 A worn tip, z = r⁴/c, both sides, the scan from right to left.
text = "distance (µm)\theight (nm)\n" + "".join(f"{x:.2f}\t{((x - 5.25) / 5) ** 4 * 400 + random.gauss(0, 0.5):.3f}\n" for x in [10 - 0.05 * i for i in range(201)])
write("records-worn.txt", text)
case(
    "records-worn",
    ELASTIC + 'profile = "records-worn.txt"\n' + PRESS % "100 nm",
    [value("force", 1.0, power(400e-9 / (5e-6) ** 4, 4, 100e-9), 0.02, "Sneddon, fourth power")],
)

# 11 The shape itself over r, decimal commas and a row of units.
text = "r;z\n[µm];[nm]\n" + "".join(f"{comma(0.5 * i, 2)};{comma((0.5 * i) ** 2 / (2 * 30) * 1e3, 3)}\n" for i in range(21))
write("records-shape.csv", text)
case("records-shape", ELASTIC + 'profile = "records-shape.csv"\n' + PRESS % "0.5 µm", [value("force", 1.0, hertz(30e-6, 0.5e-6), 2e-3, "Hertz, R = 30 µm")])

# 12 A cap on a flat base: refused as a whole, solved to where the cap ends.
text = "x (µm), z (nm)\n" + "".join(f"{x:.2f}, {max(0.0, 1000 - (x - 10.4) ** 2 / 20 * 1e3) + random.gauss(0, 1):.3f}\n" for x in [0.05 * i for i in range(441)])
write("records-cap.csv", text)
case("records-cap-with-base", ELASTIC + 'profile = "records-cap.csv"\n' + PRESS % "0.2 µm")
case(
    "records-cap-alone",
    ELASTIC + 'profile = "records-cap.csv"\nscan = { to = "4.3 µm" }\n' + PRESS % "0.2 µm",
    [value("force", 1.0, hertz(10e-6, 0.2e-6), 0.02, "Hertz, R = 10 µm")],
)

# 13 One side only; noise as large as the shape.
write("records-one-side.csv", "x (µm), z (nm)\n" + "".join(f"{x:.1f}, {x**2 / 60 * 1e3:.3f}\n" for x in [0.5 * i for i in range(21)]))
case("records-one-side", ELASTIC + 'profile = "records-one-side.csv"\n' + PRESS % "0.5 µm")
write("records-rough.csv", "x (µm), z (nm)\n" + "".join(f"{x:.1f}, {(x - 10) ** 2 / 60 * 1e3 + random.gauss(0, 900):.3f}\n" for x in [0.2 * i for i in range(101)]))
case("records-rough", ELASTIC + 'profile = "records-rough.csv"\n' + PRESS % "0.5 µm")

with open("expected_records.json", "w", encoding="utf-8") as file:
    file.write("[\n" + ",\n".join(json.dumps(entry, ensure_ascii=False) for entry in cases) + "\n]\n")
