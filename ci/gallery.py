"""Makes the gallery of the book.

python3 ci/gallery.py target/release/viscotack [FOLDER/NAME ...] solves every scene of `scenes/`, or those named. It writes docs/src/gallery.md with a picture,
the command, the time and the sentence that heads the scene; the pictures go to docs/src/images/gallery. A scene of CHANGED is solved as changed there, and the
page says so. A scene that takes longer than LIMIT is listed without a picture. Of scenes that are not named, pictures and times stay as they are.
"""

import re
import shlex
import subprocess
import sys
import tempfile
import time
import tomllib
from pathlib import Path

LIMIT = 240.0
ROOT = Path(__file__).resolve().parent.parent
PICTURES = ROOT / "docs/src/images/gallery"
PAGE = ROOT / "docs/src/gallery.md"
FOLDERS = {
    "indentation": "Pressed on and pulled off",
    "published": "Beside published runs",
    "sliding": "Sliding",
    "surfaces": "Surfaces that attract at a distance",
    "cracks": "Cracks",
}
# Which picture shows a scene best, where it is not the first of PREFERRED.
CHOSEN = {
    "cracks/figure_5_2": "opening",
    "cracks/figure_5_4": "stress",
    "cracks/figure_5_7a": "delay_against_load",
    "cracks/figure_5_7b": "speed_against_time",
    "cracks/gel_strip": "growth_against_time",
    "cracks/pure_shear_strip": "speed_against_crack_strip_strain",
    "indentation/approach_at_a_distance": "surface_against_radius",
    "indentation/constant_tensile_force": "contact_radius_against_time",
    "indentation/creep_test": "penetration_against_time",
    "indentation/cyclic_pull": "penetration_against_time",
    "indentation/dynamic_stiffness": "stiffness_against_frequency",
    "indentation/dynamic_test": "stiffness_against_frequency",
    "indentation/fields": "pressure_against_radius",
    "indentation/frequency_sweep": "stiffness_against_frequency",
    "indentation/million_steps": "stiffness_against_cycle",
    "indentation/periodic_contact": "stiffness_against_frequency",
    "indentation/pull_off_at_five_ranges": "pull_off_against_sweep",
    "indentation/relaxation_test": "force_against_time",
    "published/edge": "pull_off_against_sweep",
    "published/finite_range": "pull_off_against_sweep",
    "sliding/elastic_wave": "pressure",
    "sliding/equilibrium_diagram": "mean_pressure_against_penetration",
    "sliding/folds_at_large_beta": "half_width_against_speed",
    "sliding/friction_map": "map_of_friction_coefficient",
    "sliding/isola": "half_width_against_speed",
    "sliding/negative_load": "surface",
    "sliding/regime_map": "regimes",
    "sliding/sensitivities": "sensitivity_of_friction_stress_against_speed",
    "surfaces/five_harmonics": "contact_fraction_against_mean_pressure",
    "surfaces/rough_surface": "pressure_map",
    "surfaces/wave_with_a_law": "surface",
    "surfaces/wave_with_an_edge": "surface",
}
# Scenes that are too long for a page, or draw nothing: what is set, and what the page says of it.
CHANGED = {
    "indentation/frequency_sweep": (
        ["history.0.oscillation.duration=350", "history.0.oscillation.to_frequency=0.33432"],
        "The picture is of a shorter run, up to ω = 2.1 in place of 3. The whole scene takes more than four minutes.",
    ),
    "indentation/million_steps": (
        ["history.0.oscillation.cycles=40"],
        "The picture is of a shorter run, 40 cycles in place of 4000. The whole scene takes an hour or more.",
    ),
    "indentation/vibrated_retraction": (
        ["accuracy=0.05", "history.0.oscillation.duration=600", "sweep.values=[0.0557]"],
        "The picture is of a shorter run: the lower frequency alone, a retraction 2.2 times as fast, a fifth of the accuracy. "
        "The whole scene takes more than four minutes.",
    ),
    "cracks/elastic_sheet": (
        ["sweep.key=crack.speed", 'sweep.from="1 µm/s"', 'sweep.to="1 m/s"', "sweep.points=25"],
        "The scene is one state and draws nothing. The picture is of a sweep of the speed.",
    ),
}
PREFERRED = [
    "energy_release_rate_against_speed",
    "growth_against_time",
    "force_against_penetration",
    "pull_off_against_sweep",
    "pull_off_against_speed",
    "friction_against_speed",
]


def heading(text: str) -> str:
    """The comment at the head of a scene, as one paragraph."""
    lines = []
    for line in text.splitlines():
        if not line.startswith("#"):
            break
        lines.append(line.lstrip("# ").rstrip())
    return " ".join(lines)


def picture(name: str, folder: Path) -> Path | None:
    drawn = {path.stem: path for path in sorted(folder.glob("*.svg"))}
    if name in CHOSEN and CHOSEN[name] not in drawn:
        raise SystemExit(f"{name}: no picture {CHOSEN[name]}, but {', '.join(drawn)}")
    for stem in [CHOSEN.get(name, ""), *PREFERRED, *drawn]:
        if stem in drawn:
            return drawn[stem]
    return None


def command_of(name: str) -> str:
    """The command that the page shows, and that the picture comes from."""
    sets, _ = CHANGED.get(name, ([], ""))
    return " ".join(["viscotack", "run", f"scenes/{name}.toml", *(f"--set {shlex.quote(value)}" for value in sets), "--out", "DIR"])


def solve(program: str, name: str) -> str:
    """Runs a scene and keeps its picture; what it took, in words."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "out"
        begun = time.monotonic()
        try:
            command = [program, *shlex.split(command_of(name))[1:-1], str(out)]
            code = subprocess.run(command, cwd=ROOT, capture_output=True, timeout=LIMIT, check=False).returncode
        except subprocess.TimeoutExpired:
            return f"more than {LIMIT / 60:.0f} minutes"
        seconds = time.monotonic() - begun
        if code not in (0, 4):
            raise SystemExit(f"{name}: exit code {code}")
        found = picture(name, out)
        if found:
            target = PICTURES / f"{name.replace('/', '_')}.svg"
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(found.read_bytes())
        note = "; some values miss the wanted accuracy, so the exit code is 4" if code == 4 else ""
        return f"{seconds:.1f} s{note}" if seconds < 9.95 else f"{seconds:.0f} s{note}"


def kept_times() -> dict[str, str]:
    if not PAGE.exists():
        return {}
    return dict(re.findall(r"^`viscotack run scenes/(\S+)\.toml (?:--set .*)?--out DIR` \((.*)\)$", PAGE.read_text(), re.MULTILINE))


def main() -> None:
    program, named = str(Path(sys.argv[1]).resolve()), set(sys.argv[2:])
    times = kept_times()
    page = [
        "# Gallery of scenes",
        "",
        "<!-- Made by ci/gallery.py; do not edit. -->",
        "",
        "Each scene runs as it is. Copy one that is near to your case and change its numbers. The times are those of two cores of a shared machine.",
        "Scenes for `viscotack fit` are in the guide on [fitting](guides/fitting.md), scenes with a comment at each line come from `viscotack new`.",
    ]
    for folder, title in FOLDERS.items():
        page += ["", f"## {title}"]
        for path in sorted((ROOT / "scenes" / folder).glob("*.toml")):
            name = f"{folder}/{path.stem}"
            if not named or name in named or name not in times:
                print(name, flush=True)
                times[name] = solve(program, name)
            text = path.read_text()
            drawn = f"images/gallery/{name.replace('/', '_')}.svg"
            page += ["", f"### {tomllib.loads(text)['title']}", "", heading(text), ""]
            if (PAGE.parent / drawn).exists():
                page += [f"![{name}]({drawn})", ""]
            if name in CHANGED:
                page += [CHANGED[name][1], ""]
            page += [f"`{command_of(name)}` ({times[name]})"]
    PAGE.write_text("\n".join(page) + "\n")


if __name__ == "__main__":
    main()
