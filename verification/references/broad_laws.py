"""Complex modulus and relaxation of two laws with a continuous spectrum; writes or checks broad_laws.csv.

    power_law           g(z) = z e^z E_n(z),  z = iwT;  relaxation (1 + t/T)^-n
    fractional_zener    g(z) = z^a/(1 + z^a);           relaxation E_a(-(t/T)^a), Mittag-Leffler

    column              meaning
    law, exponent       which, and n or a (an exact double)
    argument            wT, and t/T of the relaxation (an exact double)
    storage, loss       Re g, Im g at z = i*argument
    relaxation          at t/T = argument

Method: mpmath's generalised exponential integral and complex powers at 60 digits; the Mittag-Leffler function by its
spectrum. Confirmed by Gauss panels over the spectrum, g = int h(x) z e^x/(1 + z e^x) dx and int h(x) exp(-t e^-x) dx,
x = ln(rho/T), h as in Williams (1964) and Cole and Cole (1941), at 42 digits.
"""

import sys

sys.dont_write_bytecode = True

import time

from mpmath import mp, mpc, mpf

from common import (Setting, arguments, confirmed, differences, exact, finish, number, panels, read, write)

NAME = "broad_laws.csv"
COMMAND = "python3 verification/references/broad_laws.py"
COLUMNS = ["law", "exponent", "argument", "storage", "loss", "relaxation", "confirmed_digits"]
ONCE = Setting("broad", 42, 30, 90)
TWICE = Setting("broad, finer", 50, 36, 110)

CASES = [("power_law", n) for n in (0.2, 0.5, 1.0, 2.3)] + [("fractional_zener", a) for a in (0.2, 0.5, 0.8)]
ARGUMENTS = [10.0 ** k for k in range(-8, 9, 2)] + [0.3, 0.7, 1.9, 5.3]


def spectrum(law, exponent, x):
    if law == "power_law":
        s = mp.exp(-x)
        return mp.exp(-exponent * x - s) / mp.gamma(exponent)
    return mp.sin(mp.pi * exponent) / (2 * mp.pi * (mp.cosh(exponent * x) + mp.cos(mp.pi * exponent)))


def by_spectrum(law, exponent, setting, kernel):
    """int h(x) kernel(x) dx over panels of length 1; the tails fall as exp(-exponent |x|)."""
    with mp.workdps(setting.dps):
        slow = int(setting.cutoff / exponent) + 20
        fast = 6 if law == "power_law" else slow
        wide = [mpf(x) for x in range(-fast, slow, 1)]
        return panels(setting, lambda x: spectrum(law, exponent, x) * kernel(x), wide)


def row(law, exponent, argument):
    with mp.workdps(60):
        n, x = exact(exponent), exact(argument)
        z = mpc(0, x)
        value = z * mp.exp(z) * mp.expint(n, z) if law == "power_law" else z ** n / (1 + z ** n)
        checked = by_spectrum(law, n, ONCE, lambda y: (x * mp.exp(y)) / mpc(x * mp.exp(y), -1))
        fall = lambda y: mp.exp(-x * mp.exp(-y))
        relaxation = (1 + x) ** -n if law == "power_law" else by_spectrum(law, n, TWICE, fall)
        digits = min(confirmed(checked.real, value.real), confirmed(checked.imag, value.imag),
                     confirmed(by_spectrum(law, n, ONCE, fall), relaxation))
        return dict(law=law, exponent=repr(exponent), argument=repr(argument), storage=number(value.real), loss=number(value.imag),
                    relaxation=number(relaxation), confirmed_digits=digits)


def main():
    options = arguments("Two laws with a continuous spectrum.")
    start = time.time()
    cases = [(law, exponent, x) for law, exponent in CASES for x in ARGUMENTS]
    rows = [row(*case) for case in (cases[5::13] if options.reduced else cases)]
    if options.self_check:
        finish([f"{r['law']} {r['exponent']} at {r['argument']}: only {r['confirmed_digits']} digits" for r in rows
                if r["confirmed_digits"] < 14], start, "self-check")
    if options.check:
        finish(differences(NAME, read(NAME), rows, ["law", "exponent", "argument"]), start, f"check of {len(rows)} rows")
    write(NAME, COMMAND, "complex modulus and relaxation of laws with a continuous spectrum, normalised", COLUMNS, rows,
          precision="60 digits; confirmed by Gauss panels over the spectrum at 42 digits; 32 digits printed")
    print(f"written in {time.time() - start:.1f} s")


if __name__ == "__main__":
    main()
