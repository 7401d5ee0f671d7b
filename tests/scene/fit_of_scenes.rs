//! Source: `viscotack fit` (`program/src/plan/fit`), `scenes/fits/`, `studies::fit_coverage`.
//!
//! Goal: the shipped scene gives its stated truth, and the scene that is written runs; every key of [fit] is used or refused; bad data end in one clear error;
//! what the data cannot separate is said; models and further tests are compared; a better minimum is never missed.
//!
//! Oracle: the truth that `scenes/fits/make_data.py` and the study state.
//!
//! Tolerance: the truth lies within twice the 95 % interval.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, missing_docs)]

use crate::command_support;

use command_support::Folder;
use std::f64::consts::PI;
use std::path::{Path, PathBuf};
use viscotack::special::normal::Normal;
use viscotack_program::plan::fit::Setup;
use viscotack_program::scene::document::Document;
use viscotack_verification::studies::fit_coverage::drawn;

fn repository(name: &str) -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join(name)
}

/// A pull-off of few rows, with its data; `{}` stands for what is free and what else [fit] holds.
fn pull_off(fit: &str, data: &str) -> Folder {
    let scene = std::fs::read_to_string(repository("scenes/fits/pull_off.toml")).unwrap();
    let (before, _) = scene.split_once("[fit]").unwrap();
    let folder = Folder::with(&format!("{before}[fit]\n{fit}\n[[fit.test]]\ndata = \"data.csv\"\n"));
    folder.write("data.csv", data);
    folder
}

const FREE: &str = "compare = \"force\"\nfree = [\n\
    { key = \"adhesion.work_of_adhesion\", from = \"1 mJ/m²\", to = \"1 J/m²\" },\n\
    { key = \"indentation.frame_stiffness\", from = \"10 N/m\", to = \"10 kN/m\" } ]\n";

/// Every eighth row of the shipped data.
fn thinned() -> String {
    let text = std::fs::read_to_string(repository("scenes/fits/pull_off.csv")).unwrap();
    let (header, rows) = text.split_once('\n').unwrap();
    let rows: Vec<&str> = rows.lines().step_by(8).collect();
    format!("{header}\n{}\n", rows.join("\n"))
}

#[test]
fn the_shipped_fit_gives_its_truth_and_a_scene_that_runs() {
    let folder = Folder::new();
    let scene = repository("scenes/fits/pull_off.toml");
    folder.call(&["fit", scene.to_str().unwrap(), "--out", "found"]).ended(0);
    let summary: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(folder.path("found/summary.json")).unwrap()).unwrap();
    for (place, truth) in [0.055, 180.0].into_iter().enumerate() {
        let found = &summary["parameters"][place];
        let value = found["value"].as_f64().unwrap();
        let [low, high] = ["lower", "upper"].map(|end| found["interval_by_profile_95"][end]["value"].as_f64().unwrap());
        assert!((value - truth).abs() < high - low && high - low < 0.01 * truth, "{found}");
    }
    assert!(summary["moved_by_a_tighter_model_over_standard_error"].as_f64().unwrap() < 0.3);
    assert_eq!(summary["descents_to_this_minimum"], summary["descents"]);
    let run = folder.call(&["run", "found/fitted.toml"]).ended(0);
    assert!(run.stdout.contains("pull_off_force"), "{}", run.stdout);
    let rows = std::fs::read_to_string(folder.path("found/residuals.csv")).unwrap();
    // A header and 500 rows, but for the one beside the loss of contact.
    assert_eq!(rows.lines().count(), 500);
    if cfg!(feature = "plots") {
        let picture = std::fs::read_to_string(folder.path("found/fit_force_1.svg")).unwrap();
        assert!(picture.contains("class=\"residuals\"") && picture.contains("RMS"));
    }
}

/// The data of the twelve-term scene are its truth with noise of 1 %: what its fit, which takes long, must find.
#[test]
fn the_shipped_data_of_twelve_terms_are_those_of_its_truth() {
    let file = repository("scenes/fits/twelve_terms.toml");
    let text = std::fs::read_to_string(&file).unwrap();
    let mut document = Document::parse("twelve_terms.toml", text, file.parent().unwrap()).unwrap();
    let model = Setup::new(&mut document).unwrap().simulated(&[0.08, 250.0], 1e-3).unwrap();
    let rows = std::fs::read_to_string(repository("scenes/fits/twelve_terms.csv")).unwrap();
    let data: Vec<f64> = rows.lines().skip(1).map(|row| 1e-6 * row.split_once(", ").unwrap().1.parse::<f64>().unwrap()).collect();
    // One row lies on the fall; behind the forces stands the place of it.
    let (_, forces) = model.split_last().unwrap();
    assert_eq!((data.len(), forces.len()), (500, 499));
    let largest = forces.iter().fold(0.0_f64, |most, force| most.max(-force));
    let lost = forces.iter().position(|force| force.abs() <= 0.0).unwrap();
    let misses = forces.iter().enumerate().map(|(row, force)| force - data[if row < lost { row } else { row + 1 }]);
    let rms = (misses.map(|miss| miss * miss).sum::<f64>() / forces.len() as f64).sqrt();
    // The root mean square of 499 normal numbers is known within 1/√998; three times that.
    assert!((rms / (0.01 * largest) - 1.0).abs() < 0.1, "{rms:e} beside {largest:e}");
}

#[test]
fn bad_data_end_in_one_clear_error() {
    let good = thinned();
    let with = |change: &dyn Fn(&str) -> String| change(&good);
    let cases: [(&str, String, &str); 7] = [
        ("a number that is none", with(&|data| data.replacen("509.184", "nan", 1)), "must be a finite number"),
        ("a wrong unit", with(&|data| data.replace("force (µN)", "force (µm)")), "wrong unit"),
        ("no unit", with(&|data| data.replace("force (µN)", "force")), "has no unit"),
        ("time in milliseconds", with(&|data| data.replace("time (s)", "time (ms)")), "check the unit in the header"),
        ("another column", with(&|data| data.replace("force (µN)", "push (µN)")), "has no column `force`"),
        ("three rows", good.lines().take(4).collect::<Vec<_>>().join("\n"), "at least four"),
        ("time that goes back", format!("{good}0.5, 1.0\n"), "does not increase"),
    ];
    for (name, data, says) in cases {
        let answer = pull_off(FREE, &data).call(&["fit", "scene.toml"]).ended(2);
        assert!(answer.stderr.contains(says), "{name}: {}", answer.stderr);
    }
    let reversed: Vec<String> = good
        .lines()
        .enumerate()
        .map(|(row, line)| match line.split_once(", ") {
            Some((time, force)) if row > 0 => format!("{time}, {}", -force.parse::<f64>().unwrap()),
            _ => line.to_owned(),
        })
        .collect();
    let answer = pull_off(FREE, &reversed.join("\n")).call(&["fit", "scene.toml"]).ended(2);
    assert!(answer.stderr.contains("its sign seems reversed"), "{}", answer.stderr);
}

#[test]
fn offsets_are_found_and_missing_ones_are_detected() {
    let moved: Vec<String> = thinned()
        .lines()
        .enumerate()
        .map(|(row, line)| match line.split_once(", ") {
            Some((time, force)) if row > 0 => {
                format!("{:.5}, {:.3}", time.parse::<f64>().unwrap() + 0.25, force.parse::<f64>().unwrap() + 80.0)
            }
            _ => line.to_owned(),
        })
        .collect();
    let data = moved.join("\n");
    let without = pull_off(FREE, &data).call(&["fit", "scene.toml"]);
    assert!(without.stdout.contains("free { key = \"fit.force_offset\" }"), "{}\n{}", without.stdout, without.stderr);
    let free = FREE.replace(" ]", ", { key = \"fit.force_offset\" }, { key = \"fit.time_offset\", from = -1, to = 1 } ]");
    let summary = pull_off(&free, &data).call(&["fit", "scene.toml", "--json"]).ended(0).json();
    for (place, truth) in [(0, 0.055), (1, 180.0), (2, 80e-6), (3, 0.25)] {
        let found = &summary["parameters"][place];
        let [low, high] = ["lower", "upper"].map(|end| found["interval_by_profile_95"][end]["value"].as_f64().unwrap());
        assert!((found["value"].as_f64().unwrap() - truth).abs() < high - low, "{found}");
    }
}

#[test]
fn every_key_of_fit_is_read_or_refused() {
    let data = thinned();
    let cases = [
        (FREE.replace("force\"", "colour\""), "`fit.compare` = \"colour\""),
        (format!("{FREE}against = \"frame\"\n"), "has no column `frame`"),
        (format!("{FREE}against = \"colour\"\n"), "`fit.against` = \"colour\" is not a key"),
        (FREE.replace("\"10 N/m\"", "\"10 kN/m\""), "is not below"),
        (FREE.replace("from = \"10 N/m\", ", ""), "from` is missing"),
        (FREE.replace("\"10 N/m\"", "\"10 m\""), "wrong unit"),
        (
            FREE.replace("indentation.frame_stiffness", "adhesion.work_of_adhesion")
                .replace("10 N/m", "1 J/m²")
                .replace("10 kN/m", "2 J/m²"),
            "is free twice",
        ),
        (
            FREE.replace("indentation.frame_stiffness", "fit.depth_offset").replace("\"10 N/m\"", "0").replace("\"10 kN/m\"", "1"),
            "free fit.time_offset",
        ),
        (FREE.replace("indentation.frame_stiffness", "fit.colour"), "known are: fit.depth_offset"),
        (FREE.replace("indentation.frame_stiffness", "indentation.frame_stifness"), "did you mean"),
        ("compare = \"force\"\n".to_owned(), "names no number to find"),
        (format!("{FREE}starts = 0\n"), "must be a whole number from 1"),
        (format!("{FREE}loss = \"cubes\"\n"), "allowed: \"squares\", \"huber\""),
        (format!("{FREE}errors = \"relative\"\n"), "has no logarithm"),
        (format!("{FREE}colour = 1\n"), "`fit.colour` is not a key"),
    ];
    for (fit, says) in cases {
        let answer = pull_off(&fit, &data).call(&["fit", "scene.toml"]).ended(2);
        assert!(answer.stderr.contains(says), "{says}: {}", answer.stderr);
    }
    let folder = pull_off(FREE, &data);
    let run = folder.call(&["run", "scene.toml"]).ended(2);
    assert!(run.stderr.contains("viscotack fit SCENE --out DIR"), "{}", run.stderr);
    folder.call(&["fit", "scene.toml", "--set", "sweep.key=adhesion.work_of_adhesion"]).ended(2);
    // What changes the result: the loss, the rows that a test sets, the number of starts.
    let numbers = |fit: &str| pull_off(fit, &data).call(&["fit", "scene.toml", "--json"]).ended(0).json();
    let plain = numbers(FREE);
    assert_ne!(plain["parameters"], numbers(&format!("{FREE}loss = \"huber\"\n"))["parameters"]);
    assert_ne!(plain["descents"], numbers(&format!("{FREE}starts = 1\n"))["descents"]);
    let folder = Folder::with(&format!("{}set = \"indentation.force = '1 mN'\"\n", folder.read("scene.toml")));
    folder.write("data.csv", &data);
    assert_ne!(plain["parameters"], folder.call(&["fit", "scene.toml", "--json"]).json()["parameters"]);
}

#[test]
fn columns_that_are_called_otherwise_can_be_named() {
    let folder = pull_off(FREE, &thinned().replace("force (µN)", "Channel 3"));
    let scene = format!("{}columns = {{ force = \"Channel 3 in µN\" }}\n", folder.read("scene.toml"));
    folder.write("scene.toml", &scene);
    folder.call(&["fit", "scene.toml"]).ended(0);
}

#[test]
fn what_the_data_cannot_separate_is_said_and_a_further_test_is_named() {
    // G of a crack follows the retardation time times the speed over the process zone: only the ratio of the two is seen.
    let scene = "[material]\nglassy_modulus = 1e8\ncreep = [{ compliance = 9e-7, retardation_time = 1e-3 }]\n\
        [adhesion]\nwork_of_adhesion = 10\nprocess_zone = { length = 1e-7 }\n\
        [crack]\nmotion = \"opening\"\nbody = \"two_halves\"\nplane = \"stress\"\ntheories = [\"virtual_work\"]\nspeed = 1e-3\n\
        [fit]\ncompare = \"energy_release_rate\"\nagainst = \"crack.speed\"\nfree = [\n\
        { key = \"adhesion.process_zone.length\", from = 1e-9, to = 1e-5 },\n\
        { key = \"material.creep.0.retardation_time\", from = 1e-5, to = 0.1 } ]\n[[fit.test]]\ndata = \"data.csv\"\n";
    let run = scene.split_once("[fit]").unwrap().0;
    let swept = Folder::with(&format!("{run}[sweep]\nkey = \"crack.speed\"\nfrom = 1e-7\nto = 1e-1\npoints = 20\n"))
        .call(&["run", "scene.toml", "--json"])
        .json();
    let rows: Vec<String> = swept["results"]
        .as_array()
        .unwrap()
        .iter()
        .enumerate()
        .map(|(row, result)| {
            let noise = 1.0 + 0.02 * (1.3 * row as f64).sin();
            let speed = 1e-7 * 10f64.powf(6.0 * row as f64 / 19.0);
            format!("{speed:e}, {:e}", noise * result["values"]["energy_release_rate"]["value"].as_f64().unwrap())
        })
        .collect();
    let folder = Folder::with(scene);
    folder.write("data.csv", format!("speed (m/s), energy_release_rate (J/m²)\n{}\n", rows.join("\n")));
    let answer = folder.call(&["fit", "scene.toml", "--plan"]).ended(0);
    println!("{}", answer.stdout);
    assert!(answer.stdout.contains("are nearly one parameter in these data"), "{}", answer.stdout);
    assert!(answer.stdout.contains("adhesion.process_zone.length · material.creep.0.retardation_time^-1.0"), "{}", answer.stdout);
    assert!(answer.stdout.contains("further tests, best first") && answer.stdout.contains("a decade below"), "{}", answer.stdout);
}

#[test]
fn models_that_leave_memory_or_adhesion_out_are_excluded_by_the_data() {
    let answer = pull_off(FREE, &thinned()).call(&["fit", "scene.toml", "--models"]).ended(0);
    println!("{}", answer.stdout);
    let line =
        |name: &str| answer.stdout.lines().find(|line| line.starts_with(name)).unwrap_or_else(|| panic!("{name}: {}", answer.stdout));
    assert!(line("the scene as it is").contains("possible"));
    for name in ["viscoelastic, without adhesion", "elastic, adhesion at the edge (JKR)", "elastic, without adhesion (Hertz)"] {
        let line = line(name);
        assert!(line.contains("excluded by these data") || line.contains("no fit"), "{line}");
    }
}

#[test]
fn curves_across_states_are_fitted_and_no_better_minimum_is_missed() {
    for family in [2, 3] {
        let (fit, truth, there) = drawn(family, 1).unwrap();
        let found = fit.fitted();
        assert!(there > found.misfit - 0.1, "{there} {}", found.misfit);
        for ((value, interval), truth) in found.values.iter().zip(&found.by_profile).zip(&truth) {
            assert!((value - truth).abs() < interval.upper.value() - interval.lower.value(), "{value} {truth}");
        }
    }
}

/// Approach and retraction of an elastic sphere by JKR's closed form: a gel of 10 kPa, 50 µJ/m², a bead of 5 µm, to 0.5 µm, with noise of 0.02 nN. On the way out the
/// depth lags by so many nm.
fn jkr_curve(lag: f64, noisy: u64) -> String {
    let (modulus, work, radius) = (10e3 / 0.75, 50e-6, 5e-6_f64);
    let depth = |a: f64| a * a / radius - (2.0 * PI * a * work / modulus).sqrt();
    let force = |a: f64| 4.0 * modulus * a.powi(3) / (3.0 * radius) - (8.0 * PI * a.powi(3) * modulus * work).sqrt();
    let touch = (radius * radius * 2.0 * PI * work / modulus).cbrt();
    let lost = (PI * work * radius * radius / (8.0 * modulus)).cbrt();
    let deepest = {
        let (mut low, mut high) = (touch, 10.0 * touch);
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if depth(middle) < 0.5e-6 { low = middle } else { high = middle }
        }
        low
    };
    let mut noise = Normal::of(noisy, 1);
    let mut rows = vec!["penetration (nm), force (nN)".to_owned()];
    let mut row = |depth: f64, force: f64| rows.push(format!("{:.4}, {:.5}", 1e9 * depth, 1e9 * force + 0.02 * noise.sample()));
    let part = |row: i32| f64::from(row) / 150.0;
    (1..=150).for_each(|k| row(depth(touch + (deepest - touch) * part(k)), force(touch + (deepest - touch) * part(k))));
    (1..=150).for_each(|k| {
        let a = deepest - (deepest - 1.01 * lost) * part(k);
        row(depth(a) + 1e-9 * lag * part(k).min(0.1) * 10.0, force(a));
    });
    let end = depth(lost);
    (1..=40).for_each(|k| row(end - 5e-9 * f64::from(k), 0.0));
    rows.join("\n")
}

const GEL: &str = "accuracy = 1e-3\n[material]\nrelaxed_modulus = \"15 kPa\"\npoisson_ratio = 0.5\n\
    [adhesion]\nwork_of_adhesion = \"100 µJ/m²\"\nprocess_zone = { length = \"5 nm\" }\n\
    [indentation]\nsphere = { radius = \"5 µm\" }\n\
    [[history]]\npenetration = \"0.5 µm\"\nduration = \"1 s\"\n[[history]]\npenetration = \"-0.5 µm\"\nduration = \"1.5 s\"\n\
    [fit]\ncompare = \"force\"\nagainst = \"penetration\"\nfree = [\n\
    { key = \"material.relaxed_modulus\", from = \"1 kPa\", to = \"1 MPa\" },\n\
    { key = \"adhesion.work_of_adhesion\", from = \"1 µJ/m²\", to = \"10 mJ/m²\" } ]\n\
    [[fit.test]]\ndata = \"data.csv\"\n";

/// What programs for contact without adhesion make of an adhesive curve: another modulus. The fit says that this model fails, by how much, and why.
#[test]
fn an_adhesive_curve_excludes_hertz_and_says_why() {
    let folder = Folder::with(GEL);
    folder.write("data.csv", jkr_curve(0.0, 5));
    let answer = folder.call(&["fit", "scene.toml", "--models", "--json"]).ended(0);
    let summary = answer.json();
    for (place, truth) in [(0, 10e3), (1, 50e-6)] {
        let found = &summary["parameters"][place];
        let [low, high] = ["lower", "upper"].map(|end| found["interval_by_profile_95"][end]["value"].as_f64().unwrap());
        assert!((found["value"].as_f64().unwrap() - truth).abs() < high - low && high - low < 0.05 * truth, "{found}");
    }
    let cautions = summary["cautions"].to_string();
    assert!(!cautions.contains("hysteresis of the stage"), "{cautions}");
    let hertz = summary["models"].as_array().unwrap().iter().find(|model| model["name"].as_str().unwrap().contains("Hertz")).unwrap();
    println!("{hertz}");
    assert_eq!(hertz["excluded"], true);
    let modulus = hertz["parameters"]["material.relaxed_modulus"].as_f64().unwrap();
    assert!((modulus / 10e3 - 1.0).abs() > 0.05, "{modulus}");
    let why = hertz["fails"].to_string();
    assert!(why.contains("without adhesion nothing pulls") && why.contains("its material.relaxed_modulus is"), "{why}");
}

#[test]
fn hysteresis_of_the_stage_is_found() {
    let folder = Folder::with(GEL);
    folder.write("data.csv", jkr_curve(12.0, 5));
    let answer = folder.call(&["fit", "scene.toml"]);
    assert!(answer.stdout.contains("hysteresis of the stage"), "{}\n{}", answer.stdout, answer.stderr);
}

/// Force with a noise of 1 % and contact radius with one of 4 %, of one test: each column has its own noise, and both count.
#[test]
fn two_columns_have_each_their_noise() {
    let scene = std::fs::read_to_string(repository("scenes/fits/pull_off.toml")).unwrap();
    let (before, _) = scene.split_once("[fit]").unwrap();
    let truth =
        before.replace("\"100 mJ/m²\"", "\"55 mJ/m²\"").replace("\"100 N/m\"", "\"180 N/m\"").replace("start =", "instants = 60\nstart =");
    let found = Folder::with(&truth).call(&["run", "scene.toml", "--json"]).json();
    let number = |row: &serde_json::Value, name: &str| row["values"][name]["value"].as_f64().unwrap();
    let rows: Vec<[f64; 3]> = found["results"]
        .as_array()
        .unwrap()
        .iter()
        .filter(|row| row["row"] == "instant")
        .map(|row| ["time", "force", "contact_radius"].map(|name| number(row, name)))
        .collect();
    let scale = |place: usize| rows.iter().map(|row| row[place].abs()).fold(0.0, f64::max);
    let sigmas = [0.01 * scale(1), 0.04 * scale(2)];
    let mut normal = Normal::of(21, 1);
    let lines: Vec<String> = rows
        .iter()
        .map(|[time, force, radius]| {
            format!("{time},{:e},{:e}\n", force + sigmas[0] * normal.sample(), radius + sigmas[1] * normal.sample())
        })
        .collect();
    let folder = pull_off(
        &FREE.replace("\"force\"", "[\"force\", \"contact_radius\"]"),
        &format!("time [s],force [N],contact radius [m]\n{}", lines.concat()),
    );
    let summary = folder.call(&["fit", "scene.toml", "--json"]).ended(0).json();
    println!("{}", summary["data"]);
    for (place, truth) in [0.055, 180.0].into_iter().enumerate() {
        let found = &summary["parameters"][place];
        let [low, high] = ["lower", "upper"].map(|end| found["interval_by_profile_95"][end]["value"].as_f64().unwrap());
        assert!((found["value"].as_f64().unwrap() - truth).abs() < high - low && high - low < 0.05 * truth, "{found}");
    }
    for (group, sigma) in summary["data"].as_array().unwrap().iter().zip(sigmas) {
        let noise = group["root_mean_square"].as_f64().unwrap();
        // 60 rows: 9 % is one standard deviation.
        assert!((noise / sigma - 1.0).abs() < 0.35, "{group} {sigma:e}");
    }
}

/// A small stiff bead with an attraction of 200 nm (Tabor number 1.2 relaxed, 0.4 glassy) and 50 mJ/m², pressed and pulled off; `{}` stands for the adhesion.
const BEAD: &str = "[material]\nrelaxed_modulus = \"1 MPa\"\npoisson_ratio = 0.5\nrelaxation = [{ modulus = \"4 MPa\", relaxation_time = \"0.5 s\" }]\n\
    [adhesion]\n{}\n\
    [indentation]\nsphere = { radius = \"10 µm\" }\ninstants = 20\n\
    [[history]]\npenetration = \"1 µm\"\nrate = \"1 µm/s\"\n\
    [[history]]\npenetration = \"-1.5 µm\"\nrate = \"1 µm/s\"\n";

/// Its forces with 1 % noise, and a fit of two numbers to them by a theory of adhesion.
fn bead(adhesion: &str, second: &str) -> Folder {
    let truth = BEAD.replace("{}", "work_of_adhesion = \"50 mJ/m²\"\nlaw = \"lennard_jones\"\nrange = \"200 nm\"");
    let found = Folder::with(&format!("accuracy = 1e-3\n{truth}")).call(&["run", "scene.toml", "--json"]).ended(0).json();
    let number = |row: &serde_json::Value, name: &str| row["values"][name]["value"].as_f64();
    let rows: Vec<(f64, f64)> = found["results"]
        .as_array()
        .unwrap()
        .iter()
        .filter(|row| row["row"] == "instant")
        .filter_map(|row| number(row, "time").zip(number(row, "force")))
        .collect();
    let largest = rows.iter().map(|row| row.1.abs()).fold(0.0, f64::max);
    let mut normal = Normal::of(11, 1);
    let lines: Vec<String> = rows.iter().map(|(time, force)| format!("{time},{:e}\n", force + 0.01 * largest * normal.sample())).collect();
    let fit = format!(
        "[fit]\ncompare = \"force\"\nfree = [\n{{ key = \"adhesion.work_of_adhesion\", from = \"5 mJ/m²\", to = \"500 mJ/m²\" }},\n{second} ]\n[[fit.test]]\ndata = \"data.csv\"\n"
    );
    let folder = Folder::with(&format!("{}{fit}", BEAD.replace("{}", adhesion)));
    folder.write("data.csv", format!("time [s],force [N]\n{}", lines.concat()));
    folder
}

#[test]
fn a_law_of_attraction_is_fitted_along_a_history() {
    let folder = bead(
        "work_of_adhesion = \"80 mJ/m²\"\nlaw = \"lennard_jones\"\nrange = \"100 nm\"",
        "{ key = \"adhesion.range\", from = \"50 nm\", to = \"1 µm\" }",
    );
    let summary = folder.call(&["fit", "scene.toml", "--json"]).ended(0).json();
    for (place, truth) in [0.05, 2e-7].into_iter().enumerate() {
        let found = &summary["parameters"][place];
        let [low, high] = ["lower", "upper"].map(|end| found["interval_by_profile_95"][end]["value"].as_f64().unwrap());
        println!("{found}");
        assert!((found["value"].as_f64().unwrap() - truth).abs() < high - low && high - low < 0.2 * truth, "{found}");
    }
}

/// An edge with a process zone does not describe such a bead: the range of the attraction is found beside it, with the right numbers.
#[test]
fn a_bead_that_attracts_at_a_distance_excludes_the_theory_of_an_edge() {
    let folder = bead(
        "work_of_adhesion = \"50 mJ/m²\"\nprocess_zone = { length = \"100 nm\" }",
        "{ key = \"adhesion.process_zone.length\", from = \"10 nm\", to = \"1 µm\" }",
    );
    let summary = folder.call(&["fit", "scene.toml", "--models", "--json"]).json();
    let model = |name: &str| {
        let models = summary["models"].as_array().unwrap();
        models.iter().find(|model| model["name"].as_str().unwrap().contains(name)).unwrap().clone()
    };
    let (edge, range) = (model("as it is"), model("finite range"));
    println!("{edge}\n{range}");
    assert_eq!((&edge["excluded"], &range["excluded"]), (&true.into(), &false.into()));
    for (key, truth, part) in [("adhesion.work_of_adhesion", 0.05, 0.05), ("adhesion.range", 2e-7, 0.15)] {
        let value = range["parameters"][key].as_f64().unwrap();
        assert!((value - truth).abs() < part * truth, "{key} = {value:e}");
    }
}
