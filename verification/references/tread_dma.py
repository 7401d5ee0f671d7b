"""A tyre-tread-like table of dynamic moduli at many temperatures, with known truth and noise.

Truth at the reference temperature of 20 degrees Celsius (SI units): two fractional Zener branches beside a relaxed modulus,
    E(w) = E0 + sum_k D_k (i w T_k)^a_k / (1 + (i w T_k)^a_k),    log10 a_T = -C1 (T - Tref)/(C2 + T - Tref),
so that no series of exponentials is the truth. A filled rubber's soft tail and its glass transition are its models; the
numbers are invented. Every storage and loss modulus is multiplied by 1 + NOISE g with independent normal numbers g
of a generator with a fixed seed (Python's Mersenne Twister, stable across versions).

Writes `scenes/materials/tread_dma.csv` (four digits, as instruments print) and `reference_data/tread_dma_truth.csv`
(the truth at the reference temperature, mpmath, 30 digits). `--check` recomputes both and compares byte by byte.
"""

import hashlib
import pathlib
import random
import sys

from mpmath import mp, mpc, mpf, nstr

mp.dps = 40
ROOT = pathlib.Path(__file__).resolve().parents[2]
RELAXED = mpf("3.5e6")
BRANCHES = [(mpf("1.9e9"), mpf("2e-8"), mpf("0.62")), (mpf("7e6"), mpf("3e-3"), mpf("0.28"))]
C1, C2 = mpf(10), mpf(120)
TEMPERATURES = [-35, -30, -25, -20, -15, -10, -5, 0, 5, 10, 20, 30, 40, 50, 60, 70, 80]
FREQUENCIES = ["0.1", "0.2", "0.5", "1", "2", "5", "10", "20", "50", "100"]
NOISE = 0.02
SEED = 20


def modulus(w):
    """E(w) at the reference temperature."""
    total = mpc(RELAXED)
    for gained, time, exponent in BRANCHES:
        power = mpc(0, w * time) ** exponent
        total += gained * power / (1 + power)
    return total


def table():
    """The noisy table."""
    normal = random.Random(SEED).gauss
    lines = [
        "# Synthetic tread compound: dynamic moduli in tension at 17 temperatures, 2 % noise. No measurement.",
        "# Made by verification/references/tread_dma.py, which holds the truth: WLF c1 = 10, c2 = 120 K from 20 °C.",
        "temperature (°C), frequency (Hz), storage modulus (MPa), loss modulus (MPa)",
    ]
    for celsius in TEMPERATURES:
        shift = mpf(10) ** (-C1 * (celsius - 20) / (C2 + celsius - 20))
        for frequency in FREQUENCIES:
            value = modulus(2 * mp.pi * mpf(frequency) * shift)
            storage = float(value.real) * (1 + NOISE * normal(0, 1)) / 1e6
            loss = float(value.imag) * (1 + NOISE * normal(0, 1)) / 1e6
            lines.append(f"{celsius}, {frequency}, {storage:.4g}, {loss:.4g}")
    return "\n".join(lines) + "\n"


def truth():
    """The truth on the reference curve."""
    rows = ["angular_frequency,storage_modulus,loss_modulus,independence"]
    for index in range(-12, 45):
        w = mpf(10) ** (mpf(index) / 4)
        value = modulus(mpf(float(w)))
        rows.append(f"{float(w)!r},{nstr(value.real, 25)},{nstr(value.imag, 25)},independent")
    body = "\n".join(rows) + "\n"
    head = (
        "# file: tread_dma_truth.csv\n"
        "# about: truth of scenes/materials/tread_dma.csv at its reference temperature (rad/s, Pa)\n"
        "# tool: mpmath\n"
        "# precision: 40 digits; 25 digits printed\n"
        "# command: python3 verification/references/tread_dma.py\n"
        f"# sha256: {hashlib.sha256(body.encode()).hexdigest()}\n"
    )
    return head + body


def main():
    """Writes or checks both files."""
    files = {ROOT / "scenes/materials/tread_dma.csv": table(), ROOT / "reference_data/tread_dma_truth.csv": truth()}
    wrong = 0
    for path, text in files.items():
        if "--check" in sys.argv:
            same = path.read_text() == text
            wrong += not same
            print(path.relative_to(ROOT), "same" if same else "DIFFERS")
        else:
            path.write_text(text)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
