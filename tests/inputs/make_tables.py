#!/usr/bin/env python3
"""Tables of materials in the forms that instruments and spreadsheets write, with known values.

Writes table_*.{csv,txt,dat} and table_*.toml beside itself, and expected_tables.json. Every table is of one of the solids below, by closed
forms of the generalised Maxwell solid:  E'(w) = E0 + sum Ei (w ti)^2/(1 + (w ti)^2),  E'' = sum Ei w ti/(1 + (w ti)^2),
R(t) = E0 + sum Ei exp(-t/ti),  J of the Zener solid = 1/E0 - (1/E0 - 1/(E0 + E1)) exp(-t/(t1 (E0 + E1)/E0)).
"""
import json
import math
import pathlib

HERE = pathlib.Path(__file__).parent
E0 = 1.5e6
TERMS = [(8e6, 0.02), (4e6, 0.5), (2e6, 10.0)]  # Pa, s, at 20 °C
ZENER = [(4e6, 0.5)]
NU = 0.25
SHEAR = 1 / (2 * (1 + NU))


def decades(low, high, per):
    count = round((high - low) * per) + 1
    return [10 ** (low + k / per) for k in range(count)]


FREQUENCIES = decades(-2.5, 2, 6)
TIMES = decades(-3, 2.5, 6)


def moduli(w, terms=TERMS, slow=1.0):
    x = [(e, w * t * slow) for e, t in terms]
    return E0 + sum(e * y * y / (1 + y * y) for e, y in x), sum(e * y / (1 + y * y) for e, y in x)


def relaxation(t, terms=TERMS):
    return E0 + sum(e * math.exp(-t / tau) for e, tau in terms)


def compliance(t):
    (e, tau), = ZENER
    return 1 / E0 - (1 / E0 - 1 / (E0 + e)) * math.exp(-t / (tau * (E0 + e) / E0))


def slow(celsius):
    return 10 ** ((20 - celsius) / 20)


def comma(text):
    return text.replace(".", ",")


def number(x):
    """Six digits without an exponent where that is short."""
    return f"{x:.6g}" if 1e-4 <= abs(x) < 1e6 else f"{x:.5e}"


def fixed(x):
    return f"{x:.7f}" if x < 10 else f"{x:.4f}"


def rows(cells, separator=",", end="\n"):
    return "".join(separator.join(row) + end for row in cells)


SHIFT = """reference_temperature = "20 °C"
shift = { factors = [{ temperature = "0 °C", factor = 10 }, { temperature = "20 °C", factor = 1 }, { temperature = "40 °C", factor = 0.1 }] }
"""
CASES = []
W = [0.3, 20.0]


def case(name, why, text, values=None, scene="", notes=(), extension="csv", encoding="utf-8", refused=None, tolerance=2e-3):
    stem = f"table_{name}"
    data = text if isinstance(text, bytes) else text.encode(encoding)
    (HERE / f"{stem}.{extension}").write_bytes(data)
    (HERE / f"{stem}.toml").write_text(f'[material]\ndata = "{stem}.{extension}"\n{scene}', encoding="utf-8")
    if values is None:
        values = [v for w in W for v in ((f"storage_at", w, moduli(w)[0]), ("loss_at", w, moduli(w)[1]))]
    entry = {
        "input": stem,
        "outcome": "refused" if refused else "solved",
        "values": [{kind: at, "value": value, "tolerance": tolerance, "why": why} for kind, at, value in values],
    }
    if notes:
        entry["says"] = list(notes)
    if refused:
        entry["says"], entry["remedy"] = refused
    CASES.append(entry)


def complex_rows(f=FREQUENCIES, unit=1e-6, style=number, place=1.0, tangent=False, extra=(), stretch=1.0):
    table = []
    for x in f:
        storage, loss = moduli(2 * math.pi * x)
        second = loss / storage if tangent else loss * unit * stretch
        table.append([style(x * place), style(storage * unit * stretch), style(second), *extra])
    return table


# ---- English -------------------------------------------------------------------------------------------------------------------------
case("plain", "three terms", "frequency (Hz),storage modulus (MPa),loss modulus (MPa)\n" + rows(complex_rows()))

trios = "Filename\tC:\\data\\adhesive 7.tri\nInstrument serial number\t5343-0042\nOperator\tab\nSample name\tfilm 12.5 mm\nrundate\t3/14/2021\nGeometry name\t8 mm plate\n\n[step]\nFrequency sweep - 1\n"
head = "Angular frequency\tStep time\tTemperature\tStorage modulus\tLoss modulus\tTan(delta)\tTorque\nrad/s\ts\t°C\tMPa\tMPa\t\tµN.m\n"


def trios_rows(celsius, wander=0.0):
    found = []
    for k, f in enumerate(FREQUENCIES):
        t = celsius + wander * (k % 5 - 2)
        storage, loss = moduli(2 * math.pi * f, slow=slow(t))
        found.append([number(2 * math.pi * f), number(10.0 * k), f"{t:.3f}", number(storage / 1e6), number(loss / 1e6), number(loss / storage), number(5.0 + k)])
    return rows(found, "\t")


case("trios", "one step of a rheometer", trios + head + trios_rows(20.0), extension="txt", notes=["`Torque`", "they agree", "passed over"])
steps = trios.replace("[step]\nFrequency sweep - 1\n", "") + "".join(
    f"[step]\nFrequency sweep - {k + 1}\n{head}{trios_rows(t, 0.02)}\n" for k, t in enumerate([0.0, 20.0, 40.0])
)
case("trios_steps", "three steps at wandering temperatures", steps, scene=SHIFT, extension="txt", notes=["are one isotherm"], tolerance=6e-3)
case("quoted_thousands", "thousands in quotation marks", "Frequency (Hz),Storage Modulus (kPa),Loss Modulus (kPa)\n" + rows([[number(f), f'"{moduli(2 * math.pi * f)[0] / 1e3:,.3f}"', f'"{moduli(2 * math.pi * f)[1] / 1e3:,.3f}"'] for f in FREQUENCIES]), notes=["group thousands"])
case("units_row", "units below the names", "f;E';E\"\n[Hz];[MPa];[MPa]\n" + rows(complex_rows(), ";"))
case("tangent", "tan(delta) in place of the loss modulus", "Frequency (Hz), E' (MPa), tan(delta)\n" + rows(complex_rows(tangent=True), ", "))
both = [[number(f), number(moduli(2 * math.pi * f)[0] / 1e6), number(moduli(2 * math.pi * f)[1] / 1e6), f"{moduli(2 * math.pi * f)[1] / moduli(2 * math.pi * f)[0]:.3f}"] for f in FREQUENCIES]
case("both", "loss modulus and loss tangent agree", "Frequency (Hz),E' (MPa),E'' (MPa),tan δ\n" + rows(both), notes=["they agree"])
case("both_off", "the loss modulus is right, the loss tangent is of another column", "Frequency (Hz),E' (MPa),E'' (MPa),tan δ\n" + rows([[*row[:3], number(2 * float(row[3]))] for row in both]), notes=["is off E″/E′"])
case("two_frequencies", "frequency and angular frequency", "Frequency [Hz]\tAng. frequency [rad/s]\tE' [Pa]\tE'' [Pa]\n" + rows([[number(f), number(2 * math.pi * f), *map(number, moduli(2 * math.pi * f))] for f in FREQUENCIES], "\t"), extension="txt", notes=["the angular frequency is used"])
case("shear", "E = 2(1 + nu)G", "ω [rad/s], G' [Pa], G\" [Pa]\n" + rows(complex_rows(unit=1.0, place=2 * math.pi, stretch=SHEAR)), scene=f"poisson_ratio = {NU}\n")
case("shear_words", "the header says shear", "Angular Frequency (rad/s);Shear storage modulus G' (kPa);Shear loss modulus G'' (kPa)\n" + rows(complex_rows(unit=1e-3, place=2 * math.pi, stretch=SHEAR), ";"), scene=f"poisson_ratio = {NU}\n")
absolute = [(f, math.hypot(*moduli(2 * math.pi * f)), math.atan2(moduli(2 * math.pi * f)[1], moduli(2 * math.pi * f)[0])) for f in FREQUENCIES]
case("phase", "|E*| and phase in degrees", "f (Hz), |E*| (MPa), Phase angle (°)\n" + rows([[number(f), number(e / 1e6), f"{math.degrees(d):.5f}"] for f, e, d in absolute]))
case("phase_named", "the same, named by the scene", "a,b,c\n" + rows([[number(f), number(e / 1e6), f"{d:.7f}"] for f, e, d in absolute]), scene='[material.columns]\nfrequency = "a in Hz"\ncomplex_modulus = "b in MPa"\nphase_angle = "c in rad"\n')
case("fahrenheit", "three isotherms in °F, moduli in psi", "Temp. (°F),Frequency (Hz),Storage Modulus (psi),Loss Modulus (psi)\n" + rows([[f"{1.8 * t + 32:.1f}", number(f), *(number(m / 6894.757293168361) for m in moduli(2 * math.pi * f, slow=slow(t)))] for t in (0, 20, 40) for f in FREQUENCIES]), scene=SHIFT)
blocks = "".join(f"Temperature: {t}.0 °C\nFrequency (Hz),E' (MPa),E'' (MPa)\n" + rows([[number(f), *(number(m / 1e6) for m in moduli(2 * math.pi * f, slow=slow(t)))] for f in FREQUENCIES]) + "\n" for t in (0, 20, 40))
case("blocks", "a header for each temperature", "Sample: film 7\n\n" + blocks, scene=SHIFT)
case("comment_blocks", "temperatures in comments, blanks between columns", "# f/Hz E'/MPa E''/MPa\n" + "".join(f"# T = {t} °C\n" + rows([[number(f), *(number(m / 1e6) for m in moduli(2 * math.pi * f, slow=slow(t)))] for f in FREQUENCIES], "  ") for t in (0, 20, 40)), scene=SHIFT, extension="dat")
case("dynes", "CGS", "ang. frequency (rad/s)\tG' (dyn/cm²)\tG'' (dyn/cm²)\n" + rows(complex_rows(unit=10.0, place=2 * math.pi, stretch=SHEAR), "\t"), scene=f"poisson_ratio = {NU}\n", extension="txt")
case("rpm", "cycles a minute", "Frequency (rpm),Storage modulus (MPa),Loss modulus (MPa)\n" + rows(complex_rows(place=60.0)))
case("per_second", "angular by its name", "Angular frequency (1/s),Storage modulus (N/mm2),Loss modulus (N/mm^2)\n" + rows(complex_rows(place=2 * math.pi)))
case("aligned", "columns aligned by blanks, names with blanks", "Frequency (Hz)   Storage modulus (MPa)   Loss modulus (MPa)\n" + rows([[f"{c:>14}" for c in row] for row in complex_rows()], "   "), extension="txt")
case("quoted_header", "names over two lines, a byte-order mark", '\ufeff"Frequency\n(Hz)","Storage modulus\n(MPa)","Loss modulus\n(MPa)"\n' + rows(complex_rows()))
case("old_mac", "line ends of one CR", "frequency (Hz)\tstorage modulus (MPa)\tloss modulus (MPa)\r" + rows(complex_rows(), "\t", "\r"), extension="txt")
case("ends", "text below, rows without values", "frequency (Hz);storage modulus (MPa);loss modulus (MPa);remark\n" + rows([[*row, "ok"] for row in complex_rows()], ";") + ";;;\n300;;;aborted\nEnd of measurement\n", notes=["below the rows are passed over", "rows without a value", "`remark`"])
case("index", "an index with no unit, units by their place", "Index   t        E(t)\n        [s]      [MPa]\n" + rows([[f"{k:<6}", f"{t:<10.6g}", f"{relaxation(t) / 1e6:.6f}"] for k, t in enumerate(TIMES)], "  "), [("relaxation_at", t, relaxation(t)) for t in (0.05, 2.0)], extension="txt")

# ---- German, French --------------------------------------------------------------------------------------------------------------------
german = complex_rows()
case("german", "decimal commas, Windows-1252", "Probe;Folie Nr. 12\nPrüfer;Müller\n\nFrequenz [Hz];Speichermodul [MPa];Verlustmodul [MPa];Länge [µm]\n" + rows([[*map(comma, row), "12,5"] for row in german], ";", "\r\n"), encoding="cp1252", notes=["decimal commas", "Windows-1252", "`Länge [µm]`"])
case("rheometer_utf16", "UTF-16 with a mark, units in brackets below, an empty first column", "Projekt:\tKleber\n\n\tMesspunkt\tKreisfrequenz\tSpeichermodul\tVerlustmodul\tVerlustfaktor\n\t\t[rad/s]\t[Pa]\t[Pa]\t[1]\n" + rows([["", str(k + 1), comma(number(2 * math.pi * f)), *(comma(number(m)) for m in moduli(2 * math.pi * f)), comma(f"{moduli(2 * math.pi * f)[1] / moduli(2 * math.pi * f)[0]:.4f}")] for k, f in enumerate(FREQUENCIES)], "\t", "\r\n"), extension="txt", encoding="utf-16", notes=["UTF-16", "decimal commas", "they agree"])
case("utf16_bare", "UTF-16, high byte first, without a mark", "f [Hz];E' [MPa];E'' [MPa]\r\n" + rows([[*map(comma, row)] for row in german], ";", "\r\n"), encoding="utf-16-be", notes=["UTF-16"])
case("netzsch", "names behind ##, unit behind a stroke", "#EXPORTTYPE:DATA ALL\n#FILE:C:\\probe.ndg\n#DECIMAL:COMMA\n##Temp./°C;Time/min;f/Hz;E'/MPa;E''/MPa;tan d\n" + rows([[comma(f"{20.0:.2f}"), comma(number(0.5 * k + 0.25)), comma(number(f)), *(comma(number(m / 1e6)) for m in moduli(2 * math.pi * f)), comma(f"{moduli(2 * math.pi * f)[1] / moduli(2 * math.pi * f)[0]:.4f}")] for k, f in enumerate(FREQUENCIES)], ";"), notes=["they agree", "`Time/min`"])
case("german_blocks", "temperature lines, one header", "Frequenz (Hz);Speichermodul (MPa);Verlustmodul (MPa)\n" + "".join(f"Temperatur;{t},0;°C\n" + rows([[comma(number(f)), *(comma(number(m / 1e6)) for m in moduli(2 * math.pi * f, slow=slow(t)))] for f in FREQUENCIES], ";") for t in (0, 20, 40)), scene=SHIFT)
case("german_thousands", "points group thousands", "Frequenz (mHz);Komplexer Modul (kPa);Verlustfaktor\n" + rows([[comma(f"{f * 1e3:.4f}"), f"{e / 1e3:,.2f}".replace(",", "x").replace(".", ",").replace("x", "."), comma(f"{math.tan(d):.6f}")] for f, e, d in absolute], ";"), notes=["points group thousands"])
case("swiss", "apostrophes group thousands", "Frequenz [Hz];Speichermodul [kPa];Verlustmodul [kPa]\n" + rows([[number(f), *(f"{m / 1e3:,.3f}".replace(",", "'") for m in moduli(2 * math.pi * f))] for f in FREQUENCIES], ";"))
case("french", "French words, blanks group thousands", "Fréquence (Hz);Module de conservation (kPa);Module de perte (kPa)\n" + rows([[comma(fixed(f)), *(comma(f"{m / 1e3:,.3f}".replace(",", "\u00a0")) for m in moduli(2 * math.pi * f))] for f in FREQUENCIES], ";"), encoding="cp1252", notes=["decimal commas"])
case("exponents", "decimal commas and exponents, blanks between columns", "f/Hz E'/Pa E''/Pa\n" + rows([[comma(f"{f:.6E}"), *(comma(f"{m:.6E}") for m in moduli(2 * math.pi * f))] for f in FREQUENCIES], " "), extension="dat")

# ---- relaxation and creep ----------------------------------------------------------------------------------------------------------------
case("relaxation", "R(t), decimal commas", "Zeit/s;E(t)/MPa\n" + rows([[comma(fixed(t)), comma(f"{relaxation(t) / 1e6:.7f}")] for t in TIMES], ";"), [("relaxation_at", t, relaxation(t)) for t in (0.05, 2.0)])
case("relaxation_shear", "G(t) named in a comment", "# t(s) G(t)(kPa)\n" + rows([[number(t), number(relaxation(t) * SHEAR / 1e3)] for t in TIMES], "\t"), [("relaxation_at", t, relaxation(t)) for t in (0.05, 2.0)], scene=f"poisson_ratio = {NU}\n", extension="dat")
creep = [("creep_at", t, compliance(t)) for t in (0.2, 3.0)]
case("creep", "Zener solid", "time (min), creep compliance (1/MPa)\n" + rows([[f"{t / 60:.8e}", f"{compliance(t) * 1e6:.8f}"] for t in TIMES], ", "), creep)
case("creep_cgs", "Zener solid, cm²/dyn", "t (s), creep compliance (cm²/dyn)\n" + rows([[number(t), f"{compliance(t) / 10:.7e}"] for t in TIMES], ", "), creep)
case("creep_percent", "Zener solid, % per MPa", "Temps (s);Complaisance (%/MPa)\n" + rows([[comma(fixed(t)), comma(f"{compliance(t) * 1e8:.6f}")] for t in TIMES], ";"), creep)

# ---- refused, with what to type -------------------------------------------------------------------------------------------------------
ambiguous = "".join(f"{10 ** (k / 6):.3f};{moduli(2 * math.pi * 10 ** (k / 6))[0] / 1e6:.3f};{max(moduli(2 * math.pi * 10 ** (k / 6))[1] / 1e6, 1.001):.3f}\n" for k in range(6)).replace(".", ",")
first = ambiguous.split(";")[0]
case("open_comma", "three decimals, no number below one: nothing settles the comma", "f (Hz);E' (MPa);E'' (MPa)\n" + ambiguous, [("storage_at", 10.0, moduli(10.0)[0])], refused=([f"`{first}0`", "can be 1.000 or 1000"], {"in": "csv", "replace": [first, first + "0"]}), tolerance=0.05)
case("open_frequency", "1/s may be cycles or radians", "frequency (1/s),storage modulus (MPa),loss modulus (MPa)\n" + rows(complex_rows()), refused=(['frequency = "frequency (1/s) in Hz"'], {"in": "toml", "add": '[material.columns]\nfrequency = "frequency (1/s) in Hz"\n'}))
case("open_temperature", "C is no unit of temperature", "Temp (C),frequency (Hz),storage modulus (MPa),loss modulus (MPa)\n" + rows([["20", *row] for row in complex_rows()]), refused=(['temperature = "Temp (C) in °C"'], {"in": "toml", "add": '[material.columns]\ntemperature = "Temp (C) in °C"\n'}))

(HERE / "expected_tables.json").write_text("[\n" + ",\n".join(json.dumps(entry, ensure_ascii=False) for entry in CASES) + "\n]\n", encoding="utf-8")
print(len(CASES), "tables")
