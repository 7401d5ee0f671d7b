"""Random scenes of indentation without adhesion, over everything that [indentation] lets one type, and what they mean to the reference.

A scene is a dictionary with the TOML text, the files it names, and `legs`: what is done, in coherent units (SI, or reduced with forces over pi).
"""

import math
import os

import numpy as np

SHAPES = ("sphere", "cone", "flat_punch", "power_law", "profile")
CONTROLS = ("penetration", "force", "contact_radius", "frame", "mixed")
HOLD_DECADES = 6.0


def text(value):
    return repr(float(value))


class Draw:
    """One scene from a generator of random numbers."""

    def __init__(self, seed, number):
        self.seed, self.number = seed, number
        self.random = np.random.default_rng([seed, number])
        self.files = {}

    def log(self, low, high):
        return float(math.exp(self.random.uniform(math.log(low), math.log(high))))

    def pick(self, *words, p=None):
        return words[int(self.random.choice(len(words), p=p))]

    def chance(self, part):
        return self.random.random() < part

    # ---- material

    def material(self, si, liquid, poisson):
        """Lines of [material], and (relaxed, [(modulus, rate)]) or a compliance, in E*."""
        unit = self.log(1e3, 1e10) if si else 1.0
        terms = 0 if self.chance(0.06) and not liquid else int(self.random.choice([1, 1, 2, 3, 4, 6, 8, 12]))
        stiffening = 1.0 / (1.0 - poisson * poisson) if si else 1.0
        lines = [f"poisson_ratio = {text(poisson)}"]
        self.terms = terms
        if terms == 0:
            if si:
                lines.append(f"relaxed_modulus = {text(unit)}")
            return lines, ("relaxation", unit * stiffening, [], [])
        decades = min(self.random.uniform(0.3, 1.2) * (terms - 1), 11.0)
        exponents = np.sort(self.random.uniform(-0.5, 0.5, terms)) * decades
        if terms > 1:
            # No two times so near that they are one.
            exponents = np.linspace(-0.5, 0.5, terms) * decades + self.random.uniform(-0.35, 0.35, terms) * decades / (terms - 1)
            exponents = np.sort(exponents)
        times = self.clock * 10.0 ** exponents
        shares = self.random.dirichlet(np.full(terms, 1.5)) + 1e-3
        shares = shares / shares.sum()
        beta = self.log(1.2, 1000.0)
        if liquid:
            if terms == 1 or self.chance(0.5):
                moduli = unit * shares
                lines.append("relaxed_modulus = 0.0")
                lines.append(series("relaxation", [dict(modulus=m, relaxation_time=t) for m, t in zip(moduli, times)]))
                return lines, ("relaxation", 0.0, list(moduli * stiffening), list(1.0 / times))
            # A Burgers body and its like: glassy modulus, Voigt terms, viscosity.
            compliances = shares[: terms - 1] * (beta - 1.0) / unit
            viscosity = unit * self.clock * self.log(0.1, 10.0)
            lines += [f"glassy_modulus = {text(unit)}", f"viscosity = {text(viscosity)}"]
            if terms > 1:
                lines.append(series("creep", [dict(compliance=j, retardation_time=t) for j, t in zip(compliances, times)]))
            return lines, ("creep", unit * stiffening, list(compliances / stiffening), list(1.0 / times[: terms - 1]), 1.0 / viscosity / stiffening)
        relaxed, glassy = unit, unit * beta
        if self.chance(0.5):
            moduli = (glassy - relaxed) * shares
            if self.chance(0.5):
                if si:
                    lines.append(f"relaxed_modulus = {text(relaxed)}")
                lines.append(series("relaxation", [dict(modulus=m, relaxation_time=t) for m, t in zip(moduli, times)]))
            else:
                if si:
                    lines.append(f"relaxed_modulus = {text(relaxed)}")
                lines.append(f"glassy_modulus = {text(glassy)}")
                shares = exact_shares(shares)
                moduli = (glassy - relaxed) * shares
                lines.append(series("relaxation", [dict(fraction=s, relaxation_time=t) for s, t in zip(shares, times)]))
            return lines, ("relaxation", relaxed * stiffening, list(moduli * stiffening), list(1.0 / times))
        shares = exact_shares(shares)
        compliances = (1.0 / relaxed - 1.0 / glassy) * shares
        if si:
            lines.append(f"relaxed_modulus = {text(relaxed)}")
        lines.append(f"glassy_modulus = {text(glassy)}")
        lines.append(series("creep", [dict(fraction=s, retardation_time=t) for s, t in zip(shares, times)]))
        return lines, ("creep", glassy * stiffening, list(compliances / stiffening), list(1.0 / times), 0.0)

    # ---- shape

    def indenter(self, si):
        """Lines of [indentation] for the shape, its description, and a depth that suits it."""
        kind = self.pick(*SHAPES, p=[0.36, 0.18, 0.12, 0.2, 0.14])
        size = self.log(1e-6, 1e-2) if si else 1.0
        self.shape = kind
        if kind == "sphere":
            return (f"sphere = {{ radius = {text(size)} }}" if si else "sphere = {}"), (kind, size), size * self.log(1e-4, 2e-2)
        if kind == "cone":
            slope = self.log(0.01, 0.6)
            return f"cone = {{ slope = {text(slope)} }}", (kind, slope), size * self.log(1e-4, 1e-1)
        if kind == "flat_punch":
            return (f"flat_punch = {{ radius = {text(size)} }}" if si else "flat_punch = {}"), (kind, size), size * self.log(1e-4, 1e-1)
        if kind == "power_law":
            exponent = float(self.pick(1.5, 3.0, 4.0, 6.0, 8.0, 20.0)) if self.chance(0.5) else self.log(0.51, 20.0)
            body = (f"radius = {text(size)}, " if si else "") + f"exponent = {text(exponent)}"
            return f"power_law = {{ {body} }}", (kind, size, exponent), size * self.log(1e-4, 2e-2)
        # A table: a blunted or worn shape, 5 to 12 points.
        count = int(self.random.integers(5, 13))
        r = np.linspace(0.0, 1.0, count) ** self.random.uniform(1.0, 1.4)
        flat = self.random.uniform(0.0, 0.4)
        exponent = self.random.uniform(1.6, 3.0)
        z = 0.05 * (r ** exponent + 2.0 * np.maximum(r - flat, 0.0) ** 2)
        r, z = r * size, z * size * self.log(0.2, 2.0)
        points = [(float(x), float(y)) for x, y in zip(r, z)]
        header = "r (m), z (m)" if si else "r, z"
        self.files["shape.csv"] = header + "\n" + "".join(f"{text(x)}, {text(y)}\n" for x, y in points)
        return 'profile = "shape.csv"', (kind, points), float(z[-1]) * self.log(2e-2, 0.5)

    # ---- history

    def level(self, quantity, part):
        """A value of a quantity, coherent: `part` 1 is about the deepest that suits the shape."""
        if quantity == "force":
            return part * self.force_scale
        if quantity == "contact_radius":
            return max(part, 0.0) * self.radius_scale
        if quantity == "frame":
            return part * self.frame_scale
        return part * self.depth

    def value(self, quantity, coherent):
        """As the scene writes it."""
        return coherent / math.pi if quantity == "force" and not self.si else coherent

    def coherent(self, quantity, written):
        return written * math.pi if quantity == "force" and not self.si else written

    def quantities(self):
        if self.control != "mixed":
            return [self.control]
        return ["penetration", "force", "frame"] + ([] if self.shape == "flat_punch" else ["contact_radius"])

    def history(self):
        lines, legs = [], []
        turns = int(self.random.integers(1, 6))
        present, part, rising = self.start_quantity, self.start_part, True
        here = self.start_value
        count = {"penetration": 0}
        special = self.random.random()
        self.turns = 0
        total = 0.0
        quantity = self.pick(*self.quantities())
        for number in range(turns + 1):
            if self.control == "mixed" and number and self.chance(0.6):
                quantity = self.pick(*self.quantities())
            least = -0.4 if quantity != "contact_radius" and self.chance(0.3) else 0.02
            if rising:
                part = self.random.uniform(max(part, 0.1), max(part, 0.1) + 0.6) if part < 1.3 else part + 0.1
            else:
                part = self.random.uniform(least, max(part, 0.1))
            rising = not rising
            self.turns += number > 0
            written = self.value(quantity, self.level(quantity, part))
            target = self.coherent(quantity, written)
            known = present == quantity
            if self.chance(0.1):
                lines.append(f"[[history]]\n{quantity} = {text(written)}\n")
                legs.append(dict(kind="step", quantity=quantity, end=target))
            else:
                duration = self.clock * 10.0 ** self.random.uniform(-3.0, 2.5)
                if known and self.chance(0.4) and target != here:
                    rate = abs(target - here) / duration
                    rate_written = self.value(quantity, rate)
                    duration = abs(target - here) / self.coherent(quantity, rate_written)
                    lines.append(f"[[history]]\n{quantity} = {text(written)}\nrate = {text(rate_written)}\n")
                else:
                    lines.append(f"[[history]]\n{quantity} = {text(written)}\nduration = {text(duration)}\n")
                legs.append(dict(kind="ramp", quantity=quantity, end=target, duration=duration, known=known))
            present, here = quantity, target
            if self.chance(0.4):
                duration = 0.0 if self.chance(0.05) else self.clock * 10.0 ** self.random.uniform(-2.0, HOLD_DECADES)
                lines.append(f"[[history]]\nhold = {text(duration)}\n")
                legs.append(dict(kind="hold", quantity=quantity, end=here, duration=duration))
            if special < 0.1 and number == turns // 2:
                # A table from the present value on.
                rows = int(self.random.integers(2, 8))
                times = np.concatenate([[0.0], np.cumsum(self.clock * 10.0 ** self.random.uniform(-2.0, 1.5, rows))])
                parts = self.random.uniform(0.05, 1.2, rows + 1)
                values = [self.value(quantity, self.level(quantity, p)) for p in parts]
                if self.chance(0.7):
                    values[0] = self.value(quantity, here)
                unit = {"force": "N"}.get(quantity, "m")
                header = f"time (s), {quantity} ({unit})" if self.si else f"time, {quantity}"
                self.files["table.csv"] = header + "\n" + "".join(f"{text(t)}, {text(v)}\n" for t, v in zip(times, values))
                lines.append(f'[[history]]\ntable = "table.csv"\nquantity = "{quantity}"\n')
                coherent = [self.coherent(quantity, v) for v in values]
                legs.append(dict(kind="table", quantity=quantity, times=list(times), values=coherent))
                here, part = coherent[-1], float(parts[-1])
            elif special < 0.2 and number == turns // 2:
                low, high = sorted(self.random.uniform(0.05, 1.2, 2))
                low, high = (self.value(quantity, self.level(quantity, p)) for p in (low, high))
                cycles, period = int(self.random.integers(1, 4)), self.clock * 10.0 ** self.random.uniform(-2.0, 2.0)
                wave = self.pick("triangle", "square")
                lines.append(f'[[history]]\nquantity = "{quantity}"\ncycles = {cycles}\nperiod = {text(period)}\nlower = {text(low)}\nupper = {text(high)}\nwave = "{wave}"\n')
                low, high = self.coherent(quantity, low), self.coherent(quantity, high)
                legs.append(dict(kind="cycles", quantity=quantity, cycles=cycles, period=period, lower=low, upper=high, wave=wave))
                here = low
                part = 0.5
            elif special < 0.32 and number == turns // 2 and quantity != "contact_radius":
                amplitude = self.value(quantity, abs(self.level(quantity, self.log(1e-3, 0.6))))
                frequency = self.log(1e-2, 1e2) / self.clock
                cycles = int(self.random.integers(1, 5))
                extra, to, end_frequency, sweep = "", None, None, "linear"
                if self.chance(0.3):
                    to = self.value(quantity, self.level(quantity, self.random.uniform(0.1, 1.0)))
                    extra += f", to = {text(to)}"
                if self.chance(0.3):
                    end_frequency = frequency * self.log(0.2, 5.0)
                    sweep = self.pick("linear", "logarithmic")
                    extra += f', to_frequency = {text(end_frequency)}, frequency_sweep = "{sweep}"'
                if end_frequency is None:
                    duration = cycles / frequency
                elif sweep == "linear":
                    duration = cycles / (0.5 * (frequency + end_frequency))
                else:
                    ratio = math.log(end_frequency / frequency)
                    duration = cycles * ratio / (frequency * math.expm1(ratio))
                lines.append(f'[[history]]\noscillation = {{ quantity = "{quantity}", amplitude = {text(amplitude)}, frequency = {text(frequency)}, cycles = {cycles}{extra} }}\n')
                if to is not None:
                    here = self.coherent(quantity, to)
                legs.append(dict(kind="oscillation", quantity=quantity, end=here, duration=duration, amplitude=self.coherent(quantity, amplitude),
                                 frequency=frequency, end_frequency=end_frequency or frequency, sweep=sweep))
                part = 0.6
        return lines, legs

    # ---- the whole

    def scene(self):
        si = self.si = self.chance(0.5)
        self.clock = self.log(1e-3, 1e3) if si else 1.0
        poisson = float(self.pick(0.0, 0.3, 0.49, 0.5)) if self.chance(0.8) else float(self.random.uniform(-0.9, 0.5))
        self.liquid = si and self.chance(0.15)
        material, solid = self.material(si, self.liquid, poisson)
        shape_line, shape, self.depth = self.indenter(si)
        self.control = self.pick(*CONTROLS, p=[0.38, 0.2, 0.12, 0.16, 0.14])
        if self.shape == "flat_punch" and self.control == "contact_radius":
            self.control = "penetration"
        accuracy = float(self.pick(1e-3, 1e-4, 1e-5, 1e-6, 1e-8))
        import ting_graham
        body = ting_graham.solid_of(solid)
        form = ting_graham.shape_of(shape)
        modulus = math.sqrt(max(body.relaxed, 1e-3 * body.glassy) * body.glassy)
        if self.shape == "flat_punch":
            self.radius_scale = form.rim
            elastic = 2.0 * form.rim * self.depth
        else:
            self.radius_scale = float(form.radius(np.array(self.depth)))
            elastic = float(form.elastic(np.array(self.radius_scale)))
        self.force_scale = 0.5 * modulus * elastic
        stiffness = None
        if self.control in ("frame", "mixed") or self.chance(0.05):
            written = 2.0 * modulus * self.radius_scale * self.log(0.03, 30.0) / (1.0 if si else math.pi)
            stiffness = written * (1.0 if si else math.pi)
        self.frame_scale = self.depth + (self.force_scale / stiffness if stiffness else 0.0)
        # The start.
        relaxed = not self.liquid and self.chance(0.35)
        first = [self.pick("penetration", "force", "contact_radius")] if relaxed or self.chance(0.15) else []
        if first == ["contact_radius"] and self.shape == "flat_punch":
            first = ["penetration"]
        start = None
        if first:
            self.start_part = self.random.uniform(0.1, 1.0)
            scale = self.level(first[0], self.start_part) * (0.2 if first[0] == "force" and relaxed else 1.0)
            written = self.value(first[0], scale)
            self.start_quantity, self.start_value = first[0], self.coherent(first[0], written)
            start = f"{first[0]} = {text(written)}"
        else:
            self.start_part, self.start_value = 0.0, 0.0
            self.start_quantity = None
        self.start = "relaxed" if relaxed else ("untouched_pressed" if first else "untouched")
        history, legs = self.history()
        if self.start_quantity is None:
            # First touch is the zero of what is controlled first.
            self.start_quantity = legs[0]["quantity"]
            if legs[0]["kind"] == "ramp":
                legs[0]["known"] = True
        speed = self.log(1e-2, 1e2) if self.chance(0.15) else 1.0
        wanted = sum(1 for leg in legs if leg["kind"] in ("ramp", "hold"))
        fixed = 2 + sum({"step": 1, "table": 9, "cycles": 13, "oscillation": 6}.get(leg["kind"], 0) for leg in legs)
        fixed += 3
        oscillates = any(leg["kind"] == "oscillation" for leg in legs)
        room = (60 - fixed) // max(wanted + oscillates, 1)
        instants = max(1, min(12 if oscillates else 8, room))
        lines = [] if si else ['units = "reduced"']
        lines.append(f"accuracy = {text(accuracy)}")
        lines += ["[material]"] + material + ["[indentation]", shape_line]
        if relaxed:
            lines.append('start = "relaxed"')
        if start:
            lines.append(start)
        if stiffness is not None:
            lines.append(f"frame_stiffness = {text(written_stiffness(stiffness, si))}")
        if speed != 1.0:
            lines.append(f"speed_factor = {text(speed)}")
        lines.append(f"instants = {instants}")
        if self.chance(0.1):
            lines.append("energies = {}")
        return dict(toml="\n".join(lines + history) + "\n", files=self.files, solid=solid, shape=shape, stiffness=stiffness, relaxed=relaxed,
                    start=(self.start_quantity, self.start_value), legs=legs, speed=speed, instants=instants, si=si, accuracy=accuracy,
                    number=self.number, seed=self.seed, radius_scale=self.radius_scale,
                    kind=dict(shape=self.shape, control=self.control, start=self.start, terms=self.terms, turns=self.turns,
                              units="si" if si else "reduced", liquid=self.liquid,
                              special=next((leg["kind"] for leg in legs if leg["kind"] in ("table", "cycles", "oscillation")), "none")))


def written_stiffness(stiffness, si):
    return stiffness if si else stiffness / math.pi


def exact_shares(shares):
    """Fractions that add up to one within what a scene lets pass."""
    shares = np.array(shares)
    shares[-1] = 1.0 - shares[:-1].sum()
    return shares


def series(name, items):
    rows = ", ".join("{ " + ", ".join(f"{key} = {text(value)}" for key, value in item.items()) + " }" for item in items)
    return f"{name} = [{rows}]"
