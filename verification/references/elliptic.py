"""Complete elliptic integrals in the modulus, up to 1 - 2^-53: writes or checks elliptic.csv.

    first_of_modulus   K = int_0^(pi/2) dx / sqrt(1 - argument^2 sin^2 x)
    second_of_modulus  E = int_0^(pi/2) sqrt(1 - argument^2 sin^2 x) dx
Two routes: by definition, with t = ln tan(x/2 + pi/4) = gd^-1(x), in which the peak of width 1 - argument at pi/2 is a wide step,
    K = int_0^inf sech t dt / sqrt(1 - k^2 tanh^2 t),   E = int_0^inf sech t sqrt(1 - k^2 tanh^2 t) dt,
    1 - k^2 tanh^2 = (1 - k^2) + k^2 sech^2, nothing cancels, and mpmath's ellipk, ellipe of 1 - (1 - k)(1 + k). Arguments are exact doubles.
"""

import sys

sys.dont_write_bytecode = True

import time

from mpmath import mp, mpf

from common import COARSE, FINE, arguments, confirmed, differences, double, exact, finish, number, panels, read, write

COMMAND = "python3 verification/references/elliptic.py"
FILE = "elliptic.csv"
COLUMNS = ["argument", "first_of_modulus", "second_of_modulus", "confirmed_digits"]
MODULI = [0.0, 1e-9, 1e-4, 0.03, 0.2, 0.5, 0.7, 0.9, 0.99, 0.999] + [1.0 - 10.0 ** -k for k in range(4, 16)] + [
    1.0 - 2.0 ** -40, 1.0 - 2.0 ** -50, 1.0 - 2.0 ** -52, 1.0 - 2.0 ** -53]


def by_definition(setting, modulus):
    left = (1 - modulus) * (1 + modulus)
    root = lambda t: mp.sqrt(left + (modulus * mp.sech(t)) ** 2)
    # The step of K is at e^-t = sqrt(left)/2; both integrands fall as e^-t beyond it.
    breaks = [mpf(k) / 2 for k in range(int(2 * (setting.dps * mp.log(10) - mp.log(left) / 2)) + 2)]
    first = panels(setting, lambda t: mp.sech(t) / root(t), breaks)
    second = panels(setting, lambda t: mp.sech(t) * root(t), breaks)
    return first, second


def rows(reduced):
    out = []
    for modulus in MODULI[::5] if reduced else MODULI:
        with mp.workdps(FINE.dps + 10):
            parameter = exact(modulus) ** 2
            closed = mp.ellipk(parameter), mp.ellipe(parameter)
        with mp.workdps(COARSE.dps):
            raw = by_definition(COARSE, exact(modulus))
        with mp.workdps(FINE.dps):
            digits = min(confirmed(a, b) for a, b in zip(raw, closed))
            out.append(dict(argument=double(modulus), first_of_modulus=number(closed[0]), second_of_modulus=number(closed[1]), confirmed_digits=digits))
    return out


def main():
    options = arguments("Complete elliptic integrals.")
    start = time.time()
    fresh = rows(options.reduced)
    low = [f"{row['argument']}: only {row['confirmed_digits']} digits confirmed" for row in fresh if row["confirmed_digits"] < 20]
    if options.self_check:
        finish(low, start, "elliptic.py --self-check")
    if options.check:
        finish(low + differences(FILE, read(FILE), fresh, ["argument"]), start, f"elliptic.py --check of {len(fresh)} rows")
    write(FILE, COMMAND, "complete elliptic integrals K and E in the modulus", COLUMNS, fresh,
          precision=f"{FINE.dps + 10} digits; confirmed by the definition, {COARSE.dps} digits, {COARSE.nodes} nodes a panel")


if __name__ == "__main__":
    main()
