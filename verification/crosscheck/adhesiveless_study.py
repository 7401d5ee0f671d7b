#!/usr/bin/env python3
"""Indentation without adhesion: random scenes through the command line, every value against the independent Ting–Graham program.

    verification/crosscheck/adhesiveless_study.py                   a few hundred scenes (seed 1)
    verification/crosscheck/adhesiveless_study.py --full            10 000 scenes (seed 2)
    verification/crosscheck/adhesiveless_study.py --only SEED NUMBER  one of them, row by row

    --scenes N, --seed S, --from N, --binary PATH, --save FOLDER (scenes that disagree), --jobs N, --truths FOLDER (what is right, kept), --no-runs
"""

import argparse
import collections
import concurrent.futures
import json
import math
import os
import resource
import signal
import subprocess
import sys
import tempfile
import time
import traceback
import zlib

import numpy as np

import tools

sys.path.insert(0, tools.REFERENCES)

import adhesiveless_scenes
import spring_bed
import ting_graham
from adhesiveless_scenes import Draw

BINARY = os.path.join(tools.TARGET, "release", "viscotack")
LIMIT = 20              # seconds of its processor after which a run counts as not ending
REDUCED, FULL = (300, 1), (10_000, 2)
# Events that the program may name when contact begins or ends.
ENDS, BEGINS = ("detachment",), ("touch", "first_touch", "jump_in")
# Rounding of the reference, over the largest value of the history.
ROUNDING = 2e-12
# In place of a folder: the bed of springs is the reference.
BLUNT = "springs"


def oscillation_of(leg, speed, duration):
    """The deviation as a function of the time in the leg, and the times of its extremes and zeros."""
    f0, f1, amplitude = leg["frequency"] * speed, leg["end_frequency"] * speed, leg["amplitude"]
    ratio = f1 / f0

    def cycles(x):
        if leg["sweep"] == "linear" or abs(ratio - 1.0) < 1e-9:
            return x * (f0 + 0.5 * (f1 - f0) * x / duration)
        return f0 * duration * np.expm1(x / duration * math.log(ratio)) / math.log(ratio)

    total = float(cycles(np.array(duration)))
    marks = np.arange(0.25, total, 0.25)
    low, high = np.zeros(len(marks)), np.full(len(marks), duration)
    times = ting_graham.bracketed(lambda x: cycles(x) - marks, low, high, iterations=200) if len(marks) else np.zeros(0)

    def deviation(x):
        n = cycles(np.asarray(x, dtype=float))
        return amplitude * np.sin(2.0 * np.pi * (n - np.round(n)))

    return deviation, list(times)


class TingBook:
    """The independent program's history, and the position of every instant that the scene asks for."""

    def __init__(self, scene):
        self.history = ting_graham.History(ting_graham.solid_of(scene["solid"]), ting_graham.shape_of(scene["shape"]), scene["stiffness"])
        self.expected = []

    here = property(lambda self: self.history.here)

    def _mark(self, position):
        self.expected.append((self.history.time_of(*position), position))

    def begin(self, quantity, value, relaxed):
        self.history.begin(quantity, value, relaxed)
        self._mark(self.history.now())

    def step(self, quantity, value):
        self.history.step(quantity, value)
        self._mark(self.history.now())

    def ramp(self, quantity, end, duration, parts=(1.0,), oscillation=None):
        self.history.ramp(quantity, end, duration, oscillation)
        # Whole cycles end at the mean itself.
        self.history.here = (quantity, end)
        for part in parts:
            self._mark(self.history.in_leg(-1, part))


def go_through(scene, book):
    """Leg after leg of the scene into a book: TingBook or spring_bed.Bed."""
    book.begin(*scene["start"], scene["relaxed"])
    instants, speed = scene["instants"], scene["speed"]
    for leg in scene["legs"]:
        kind, quantity = leg["kind"], leg["quantity"]
        if kind == "step":
            book.step(quantity, leg["end"])
        elif kind == "ramp":
            known = book.here[0] == quantity
            book.ramp(quantity, leg["end"], leg["duration"] / speed, [k / instants for k in range(1, instants + 1)] if known else [1.0])
        elif kind == "hold":
            if leg["duration"] > 0.0:
                shares = [k / instants if k % 2 == instants % 2 else 10.0 ** (6.0 * (k / instants - 1.0)) for k in range(1, instants + 1)]
                book.ramp(quantity, book.here[1], leg["duration"] / speed, sorted(set(shares)))
        elif kind == "table":
            before = 0.0
            for row, (t, value) in enumerate(zip(leg["times"], leg["values"])):
                if row > 0:
                    book.ramp(quantity, value, (t - before) / speed)
                elif book.here != (quantity, value):
                    book.step(quantity, value)
                before = t
        elif kind == "cycles":
            half = 0.5 * leg["period"] / speed
            for _ in range(leg["cycles"]):
                ways = [(leg["lower"], leg["upper"]), (None, leg["lower"])] if leg["wave"] == "triangle" else [
                    (leg["upper"], leg["upper"]), (leg["lower"], leg["lower"])]
                for first, last in ways:
                    if first is not None and book.here != (quantity, first):
                        book.step(quantity, first)
                    book.ramp(quantity, last, half)
        else:
            duration = leg["duration"] / speed
            book.ramp(quantity, leg["end"], duration, oscillation=oscillation_of(leg, speed, duration))


def run(scene, binary, folder):
    """The program's summary, exit code and seconds; none where it does not end."""
    for name, content in scene["files"].items():
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(content)
    path = os.path.join(folder, "scene.toml")
    with open(path, "w", encoding="utf-8") as file:
        file.write(scene["toml"])
    start = time.perf_counter()
    try:
        done = subprocess.run([binary, "run", path, "--json"], capture_output=True, text=True, timeout=40 * LIMIT, check=False,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (LIMIT, LIMIT + 1)))
    except subprocess.TimeoutExpired:
        return None, None, LIMIT, ""
    if done.returncode == -signal.SIGXCPU:
        return None, None, LIMIT, ""
    seconds = time.perf_counter() - start
    try:
        return json.loads(done.stdout), done.returncode, seconds, done.stderr
    except ValueError:
        return {}, done.returncode, seconds, done.stderr


def truth(scene):
    """What is right at every instant that the scene asks for, and every event: numbers alone, of the independent program alone."""
    book = TingBook(scene)
    go_through(scene, book)
    history, expected = book.history, book.expected
    positions = [position for _, position in expected]
    depth, force, radius, error, edges = history.values(positions)
    events = [("end" if event[0] == "detachment" else "begin", history.time_of(event[1], event[2])) for event in history.contact.events]
    # An open indenter under a force is nowhere.
    afloat = [bool(not held and history.floating(position)) for held, position in zip(edges[1], positions)]
    own = history.tolerance("force")
    of_radius = (own * of_edge(scene, depth, radius)).tolist()
    return dict(time=[time for time, _ in expected], penetration=depth.tolist(), force=force.tolist(), contact_radius=radius.tolist(),
                off=dict(penetration=[0.0] * len(depth), force=error.tolist(), contact_radius=of_radius),
                afloat=afloat, events=events, end=history.time_of(*history.now()), own=own, of_events=0.0)


def blunt_truth(scene):
    """The same of the bed of springs, in milliseconds and to three digits."""
    solid, shape = ting_graham.solid_of(scene["solid"]), ting_graham.shape_of(scene["shape"])
    bed = spring_bed.Bed(solid, shape, scene["stiffness"], scene["radius_scale"])
    go_through(scene, bed)
    rows, off, events, rough = bed.solve(spring_bed.built(tools.TARGET))
    columns = {"penetration": 1, "force": 2, "contact_radius": 3}
    return dict(time=bed.wanted, **{name: rows[:, k].tolist() for name, k in columns.items()}, off={name: off[:, k].tolist() for name, k in columns.items()},
                afloat=[bool(x) for x in rows[:, 4]], events=[("begin", 0.0)] + [(word, t) for word, t, _ in events], end=max(bed.time, 1e-300), own=0.0,
                of_events=blur(events, rough), highest=bed.highest)


def blur(events, rough):
    """How far off its events may be: none where the two grids do not agree on how many there are."""
    if [word for word, _, _ in events] != [word for word, _, _ in rough]:
        return math.inf
    return max((2.0 * length + 4.0 * abs(t - other) for (_, t, length), (_, other, _) in zip(events, rough)), default=0.0)


def assess(scene, right, summary, code, message, detail=None):
    """What is wrong, a sentence each, and (name, bound, difference, scale) of every value compared."""
    if not summary:
        return [f"refused, exit {code}: {first_line(message)}"], []
    if code not in (0, 4):
        reason = next((row.get("reason") for row in summary["results"] if row.get("reason")), "")
        if code == 3 and "beyond the last point of the table" in reason and right.get("highest", 0.0) > 0.99 * scene["shape"][1][-1][0]:
            return [], []
        return [f"refused, exit {code}: {reason or first_line(message)}"], []
    rows = summary["results"]
    if not rows:
        return [f"{summary['rows']['total']} rows: more than the summary holds"], []
    bad = [row for row in rows if row["status"] not in ("solved", "inaccurate")]
    if bad:
        return [f"{bad[0]['status']}: {bad[0].get('reason')}"], []
    wrong, compared = [], []
    instants, end = [row for row in rows if row["row"] == "instant"], right["end"]
    # Instants in order; the program may keep others between them.
    picked, wanted = [], 0
    for row in instants:
        if wanted < len(right["time"]) and abs(row["values"]["time"]["value"] - right["time"][wanted]) <= 1e-11 * end:
            picked.append(row)
            wanted += 1
    if wanted < len(right["time"]):
        wrong.append(f"{len(right['time']) - wanted} instants of {len(right['time'])} are missing, the first at {right['time'][wanted]:.6g}")
    instants, times = picked, right["time"]
    unit = 1.0 if scene["si"] else math.pi
    names = ("penetration", "force", "contact_radius")
    depth, force, radius = (np.array(right[name])[:wanted] for name in names)
    of_depth, of_force, of_radius = (np.array(right["off"][name])[:wanted] for name in names)
    values = {"penetration": (depth, of_depth), "force": (force / unit, of_force / unit), "contact_radius": (radius, of_radius)}
    if scene["stiffness"] is not None:
        values["frame_displacement"] = (depth + force / scene["stiffness"], of_depth + of_force / scene["stiffness"])
    for name, (assessed, own) in values.items():
        scale = float(np.max(np.abs(assessed)))
        for k, row in enumerate(instants):
            cell = row["values"].get(name)
            if cell is None or cell["value"] is None:
                wrong.append(f"{name} at {times[k]:.6g} is empty")
                continue
            if name in ("penetration", "frame_displacement") and right["afloat"][k]:
                continue
            value, bound = cell["value"], cell["error"] or 0.0
            if not isinstance(value, (float, int)) or not math.isfinite(value):
                wrong.append(f"{name} is {value}")
                continue
            difference = abs(value - assessed[k])
            allowed = bound + own[k] + (ROUNDING + right["own"]) * scale
            compared.append((name, bound, difference, scale))
            if detail is not None:
                detail.append((name, times[k], value, bound, float(assessed[k]), difference, allowed))
            if difference > allowed:
                wrong.append(f"{name} at {times[k]:.9g}: {value:.12g} ± {bound:.1e}, right {assessed[k]:.12g} ({difference / scale if scale else 0:.1e} of its largest)")
    wrong += assess_events(right, rows)
    if any(row.get("certificate") and row["certificate"].get("admissible") is False for row in rows):
        wrong.append("a row is not admissible and yet given out")
    return wrong, compared


def of_edge(scene, depth, radius):
    """What the largest penetration is to the slope of the shape at the edge: what is not known of the one is not known of the other."""
    shape = ting_graham.shape_of(scene["shape"])
    if math.isfinite(shape.rim) or not len(depth):
        return np.zeros(len(depth))
    step = 1e-4 * np.maximum(radius, 1e-300)
    slope = (shape.line(radius + step) - shape.line(np.maximum(radius - step, 0.0))) / (radius + step - np.maximum(radius - step, 0.0))
    return np.where(radius > 0.0, np.minimum(np.max(np.abs(depth)) / np.maximum(slope, 1e-300), np.max(radius) / max(ROUNDING, 1e-9)), 0.0)


def assess_events(right, rows):
    wrong, end = [], right["end"]
    # Where a load is found again the reference knows whether it touches no better than its collocation: a loss at once made good is none.
    events = [(of, t) for of, t in right["events"]]
    chatter = {k for k, (one, other) in enumerate(zip(events, events[1:])) if one[0] == "end" and other[0] == "begin" and right["own"] >= 1e-9 and other[1] - one[1] <= 1e-8 * end}
    events = [event for k, event in enumerate(events) if k not in chatter and (k - 1) not in chatter]
    found = [(row["event"], row["values"]["time"]["value"], row["values"]["time"]["error"] or 0.0) for row in rows if row["row"] == "event"]
    for word, t, bound in found:
        kind = "end" if word in ENDS else ("begin" if word in BEGINS else None)
        if kind is None:
            wrong.append(f"an event {word} at {t:.6g}")
            continue
        near = min((abs(t - own) for of, own in right["events"] if of == kind), default=math.inf)
        if near > bound + (ROUNDING + right["own"]) * end + right["of_events"]:
            wrong.append(f"{word} at {t:.9g} ± {bound:.1e}; the nearest that is right is {near:.2e} away")
    given = [t for word, t, _ in found if word in ENDS]
    for of, own in events:
        if of == "end" and not any(abs(t - own) <= 1e-3 * end + 1e-9 + right["of_events"] for t in given):
            wrong.append(f"no detachment at {own:.9g}")
    return wrong


def first_line(message):
    lines = [line for line in (message or "").splitlines() if line.strip()]
    return lines[0][:200] if lines else ""


def stored(seed, number, truths):
    """The scene and what is right of it; kept in a folder, if there is one (empty it when the reference changes)."""
    scene = Draw(seed, number).scene()
    if truths == BLUNT:
        return scene, blunt_truth(scene)
    if truths is None:
        return scene, truth(scene)
    path = os.path.join(truths, f"{seed}_{number}.json")
    mark = zlib.crc32(repr(scene).encode())
    if os.path.exists(path):
        with open(path, encoding="utf-8") as file:
            kept = json.load(file)
        if kept["mark"] == mark:
            return scene, kept
    right = dict(truth(scene), mark=mark)
    with open(path + ".part", "w", encoding="utf-8") as file:
        json.dump(right, file)
    os.replace(path + ".part", path)
    return scene, right


def one(task):
    seed, number, binary, save, truths = task
    result = dict(number=number, seed=seed, kind={}, wrong=[], compared=[], skipped=None, seconds=[0.0, 0.0])
    started = time.process_time()
    try:
        scene, right = stored(seed, number, truths)
    except NotImplementedError as error:
        result["skipped"] = f"the reference does not treat {error}"
        return result
    except Exception as error:  # noqa: BLE001
        result["skipped"] = f"the reference failed: {type(error).__name__} {error} {traceback.format_exc().splitlines()[-3].strip()}"
        return result
    result["seconds"][1] = time.process_time() - started
    result["kind"] = scene["kind"]
    if binary is None:
        result["class"] = "right"
        return result
    with tempfile.TemporaryDirectory() as folder:
        summary, code, result["seconds"][0], message = run(scene, binary, folder)
    if summary is None:
        result["wrong"], result["class"] = [f"no end within {LIMIT} s of the processor"], "endless"
    else:
        result["wrong"], result["compared"] = assess(scene, right, summary, code, message)
        if result["wrong"] and truths == BLUNT:
            settle(scene, summary, code, message, result)
        result["class"] = "refused" if result["wrong"] and not result["compared"] else ("wrong" if result["wrong"] else "right")
    if save and result["wrong"]:
        keep(scene, result, save)
    return result


def settle(scene, summary, code, message, result):
    """Where the bed of springs disagrees, times of equal radius decide: they share nothing with it and have all digits."""
    try:
        wrong, compared = assess(scene, truth(scene), summary, code, message)
    except Exception as error:  # noqa: BLE001
        result["wrong"].append(f"not settled: {type(error).__name__} {error}")
        return
    result["settled"] = not wrong
    result["wrong"], result["compared"] = wrong, compared


def keep(scene, result, save):
    folder = os.path.join(save, f"{scene['seed']}_{scene['number']}")
    os.makedirs(folder, exist_ok=True)
    for name, content in [*scene["files"].items(), ("scene.toml", scene["toml"])]:
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(content)
    with open(os.path.join(folder, "why.txt"), "w", encoding="utf-8") as file:
        file.write("\n".join([json.dumps(scene["kind"]), result["skipped"] or ""] + result["wrong"]) + "\n")


def percentile(values, part):
    return float(np.percentile(values, part)) if len(values) else math.nan


def report(results, seconds):
    """The counts as text, and how many scenes are not right."""
    lines = []
    done = [r for r in results if not r["skipped"]]
    classes = collections.Counter(r["class"] for r in done)
    values = [c for r in done for c in r["compared"]]
    lines.append(f"{len(results)} scenes, {len(done)} assessed, {len(values)} values: " + ", ".join(f"{classes[c]} {c}" for c in ("right", "wrong", "refused", "endless")))
    settled = [f"{r['seed']}:{r['number']}" for r in done if r.get("settled")]
    if settled:
        lines.append(f"  of the right ones {len(settled)} against the bed of springs, by times of equal radius: {' '.join(settled)}")
    skipped = collections.Counter(r["skipped"][:90] for r in results if r["skipped"])
    for why, count in skipped.most_common(12):
        lines.append(f"  not assessed {count}: {why}")
    ratios = [b / d for _, b, d, s in values if d > 0.0 and d > 1e-12 * s]
    exact = sum(1 for _, b, d, s in values if d <= 1e-12 * s)
    lines.append(f"bound over error: median {percentile(ratios, 50):.3g}, 95th percentile {percentile(ratios, 95):.3g} of {len(ratios)} values; {exact} agree to 1e-12")
    for key in ("shape", "control", "start", "terms", "turns", "special", "units", "liquid"):
        table = collections.defaultdict(collections.Counter)
        for r in done:
            table[str(r["kind"].get(key))][r["class"]] += 1
        lines.append(f"{key}: " + "; ".join(f"{word} {sum(c.values())} ({', '.join(f'{n} {k}' for k, n in c.items() if k != 'right') or 'all right'})" for word, c in sorted(table.items())))
    times = np.array([r["seconds"] for r in results]) if results else np.zeros((1, 2))
    lines.append(f"seconds a scene: program {times[:, 0].mean():.3f}, reference {times[:, 1].mean():.3f} (median {np.median(times[:, 1]):.3f}, largest {times[:, 1].max():.2f}); {seconds:.0f} s in all")
    return "\n".join(lines), sum(classes[c] for c in ("wrong", "refused", "endless")) + sum(skipped.values())


def study(scenes, seed, binary=BINARY, save=None, jobs=1, first=0, truths=None):
    start = time.perf_counter()
    if truths and truths != BLUNT:
        os.makedirs(truths, exist_ok=True)
    tasks = [(seed, number, binary, save, truths) for number in range(first, first + scenes)]
    if jobs > 1:
        with concurrent.futures.ProcessPoolExecutor(jobs) as pool:
            results = list(pool.map(one, tasks, chunksize=4))
    else:
        results = [one(task) for task in tasks]
    return results, time.perf_counter() - start


def show(seed, number, binary, truths):
    scene, right = stored(seed, number, truths)
    print(scene["toml"], *(f"{name}:\n{content}" for name, content in scene["files"].items()))
    with tempfile.TemporaryDirectory() as folder:
        summary, code, seconds, message = run(scene, binary, folder)
    print(f"exit {code}, {seconds:.3f} s", message[:500])
    if summary is None:
        return
    detail = []
    wrong, _ = assess(scene, right, summary, code, message, detail)
    for name, t, value, bound, assessed, difference, allowed in detail:
        print(f"{'   ' if difference <= allowed else '!! '}{name:18} t={t:<14.8g} {value:<22.14g} ± {bound:<9.1e} reference {assessed:<22.14g} off {difference:.1e}")
    print("events", right["events"])
    print(*wrong, sep="\n")


def main():
    parser = argparse.ArgumentParser(description="Indentation without adhesion against the independent Ting–Graham program.")
    parser.add_argument("--full", action="store_true", help="10 000 scenes")
    parser.add_argument("--scenes", type=int)
    parser.add_argument("--seed", type=int)
    parser.add_argument("--from", type=int, default=0, dest="first")
    parser.add_argument("--binary", default=BINARY)
    parser.add_argument("--save")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--limit", type=int, default=LIMIT, help="seconds of a run")
    parser.add_argument("--springs", action="store_const", const=BLUNT, dest="truths", help="the bed of springs is the reference: milliseconds, three digits")
    parser.add_argument("--truths", help="a folder that keeps what is right: scenes are assessed anew only where it is not there")
    parser.add_argument("--no-runs", action="store_true", help="fill that folder, run no scene")
    parser.add_argument("--only", type=int, nargs=2, metavar=("SEED", "NUMBER"))
    options = parser.parse_args()
    globals()["LIMIT"] = options.limit
    if options.only:
        show(*options.only, options.binary, options.truths)
        return
    count, seed = FULL if options.full else REDUCED
    results, seconds = study(options.scenes or count, options.seed or seed, None if options.no_runs else options.binary, options.save,
                             options.jobs, options.first, options.truths)
    text, failed = report(results, seconds)
    print(text)
    for r in results[:]:
        if r["wrong"]:
            print(f"{r['seed']} {r['number']} {r['kind'].get('shape')}/{r['kind'].get('control')}: {r['wrong'][0]}")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
