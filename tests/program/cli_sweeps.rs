//! Source: the rule that every row of a run arrives, one row a state, and the keys `latin_hypercube` and `plots`.
//!
//! Goal: the table of states has the answer of each state, the table of the path what lies on its way; a long sweep is given as a short one is; states at
//! random fill their parts; pictures are those that are wanted, and say what they leave out.
//!
//! Oracle: closed forms (the pull-off of a flat punch, Kendall 1971, and the work of its separation; JKR's force), the definition of a Latin hypercube, the
//! same sweep in parts.
//!
//! Tolerance: the stated error bounds, and the process zone over the radius (1e-4) where the closed form has none; none for what is counted.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use crate::command_support;

use command_support::{Folder, GOOD, SINGLE};
use std::collections::HashMap;
use std::f64::consts::PI;

/// The columns of a CSV by the name without the unit.
fn table(text: &str) -> HashMap<String, Vec<String>> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let headers: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
    let mut columns: Vec<Vec<String>> = vec![Vec::new(); headers.len()];
    for record in reader.records() {
        columns.iter_mut().zip(record.unwrap().iter()).for_each(|(column, cell)| column.push(cell.to_owned()));
    }
    headers.iter().map(|name| name.split(" [").next().unwrap().to_owned()).zip(columns).collect()
}

fn numbers(columns: &HashMap<String, Vec<String>>, name: &str) -> Vec<f64> {
    let column = columns.get(name).unwrap_or_else(|| panic!("no column {name}"));
    column.iter().map(|cell| cell.parse().unwrap_or(f64::NAN)).collect()
}

/// An elastic flat punch that is pulled off: F = 2E*aΔ up to F² = 8πE*a³Δγ, and the work of separation is 2πa²Δγ.
#[test]
fn a_state_has_one_row_with_its_answer() {
    for (young, poisson, radius, work) in [(3.1e6, 0.41, 2.3e-4, 0.07), (0.8e9, 0.3, 1.7e-5, 1.9)] {
        let modulus = young / (1.0 - poisson * poisson);
        let force = (8.0 * PI * modulus * radius * radius * radius * work).sqrt();
        let depth = force / (2.0 * modulus * radius);
        let folder = Folder::with(&format!(
            "accuracy = 1e-2\n[material]\nrelaxed_modulus = {young:e}\npoisson_ratio = {poisson}\n[adhesion]\nwork_of_adhesion = {work}\nprocess_zone = {{ length = {:e} }}\n\
             [indentation]\nflat_punch = {{ radius = {radius:e} }}\ninstants = 1\n[[history]]\npenetration = {:e}\n[[history]]\npenetration = {:e}\nduration = 1.0\n\
             [[sweep]]\nkey = \"indentation.speed_factor\"\nvalues = [1.0, 4.0]\n",
            1e-4 * radius,
            0.5 * depth,
            -2.0 * depth,
        ));
        let said = folder.call(&["run", "scene.toml", "--out", "DIR"]).ended(0);
        let states = table(&folder.read("DIR/states.csv"));
        assert_eq!(states["sweep_state"], ["1", "2"]);
        assert_eq!(states["status"], ["solved"; 2]);
        for (name, right) in
            [("pull_off_force", force), ("pull_off_penetration", -depth), ("work_of_separation", 2.0 * PI * radius * radius * work)]
        {
            for (found, bound) in numbers(&states, name).into_iter().zip(numbers(&states, &format!("{name}_error"))) {
                println!("{name}: {found:e} ± {bound:e}, right {right:e}");
                // The closed form has no process zone; this one is 1e-4 of the radius.
                assert!((found - right).abs() <= bound + 1e-4 * right.abs(), "{name}: {found:e} ± {bound:e}, right {right:e}");
                assert!(bound <= 1e-2 * right.abs() || name == "pull_off_penetration", "{name}: {bound:e} says nothing");
            }
        }
        let largest = numbers(&states, "largest_radius");
        assert!(largest.iter().all(|found| (found / radius - 1.0).abs() < 1e-9), "{largest:?}");
        // What lies on the way has its own table, by state.
        let path = table(&folder.read("DIR/path.csv"));
        assert!(path["row"].iter().all(|row| row != "summary") && path["event"].iter().filter(|event| *event == "detachment").count() == 2);
        assert!(["1", "2"].iter().all(|state| path["sweep_state"].iter().filter(|own| own == state).count() > 4));
        assert!(!path.contains_key("work_of_separation") && !states.contains_key("penetration"));
        // The screen shows the states.
        assert!(said.stdout.contains("pull_off_force [N]") && said.stdout.contains("path.csv has the"), "{}", said.stdout);
        assert!(!said.stdout.contains("instant  "), "{}", said.stdout);
    }
}

/// The values of a sweep at two accuracies: each within its bound of the finer one.
#[test]
fn the_answers_of_pull_off_tests_are_within_their_bounds() {
    let scene = |accuracy: &str| {
        format!(
            "accuracy = {accuracy}\n[material]\nrelaxed_modulus = 1.3e6\nglassy_modulus = 9e6\npoisson_ratio = 0.47\nrelaxation = [{{ fraction = 1, relaxation_time = 0.2 }}]\n\
             [adhesion]\nwork_of_adhesion = 0.08\nprocess_zone = {{ length = 4e-6 }}\n[indentation]\nsphere = {{ radius = 2.1e-3 }}\nstart = \"relaxed\"\npenetration = 1e-5\ninstants = 4\n\
             [[history]]\npenetration = -6e-5\nduration = 3.0\n[[sweep]]\nkey = \"indentation.speed_factor\"\nfrom = 0.1\nto = 10\npoints = 2\n"
        )
    };
    let of = |accuracy: &str| {
        let folder = Folder::with(&scene(accuracy));
        let code = folder.call(&["run", "scene.toml", "--out", "DIR"]).code;
        assert!(code == 0 || code == 4);
        table(&folder.read("DIR/states.csv"))
    };
    let (coarse, fine) = (of("1e-2"), of("1e-3"));
    for name in ["pull_off_force", "pull_off_time", "pull_off_penetration", "work_of_separation", "largest_radius", "detachment_time"] {
        let bounded = |of: &HashMap<String, Vec<String>>| -> Vec<(f64, f64)> {
            numbers(of, name).into_iter().zip(numbers(of, &format!("{name}_error"))).collect()
        };
        for ((one, bound), (other, finer)) in bounded(&coarse).into_iter().zip(bounded(&fine)) {
            println!("{name}: {one:e} ± {bound:e}, {other:e} ± {finer:e}");
            assert!((one - other).abs() <= bound + finer, "{name}: {one:e} ± {bound:e}, {other:e} ± {finer:e}");
            assert!(other.abs() > 0.0);
        }
    }
}

/// A sweep whose rows are not all held: the same rows as in parts, counts over all, pictures with a note, memory as before.
#[test]
fn a_long_sweep_is_given_whole() {
    let sweep = |from: usize, to: usize| {
        let value = |index: usize| 1e-6 * 1e6_f64.powf(index as f64 / 24_999.0);
        let values: Vec<String> = (from..to).map(|index| format!("{:e}", value(index))).collect();
        format!("{SINGLE}\n[sweep]\nkey = \"crack.speed\"\nvalues = [{}]\n", values.join(", "))
    };
    let folder = Folder::new();
    folder.write("whole.toml", sweep(0, 25_000));
    let streamed = folder.call(&["run", "whole.toml", "--json"]).ended(0).json();
    let said = folder.call(&["run", "whole.toml", "--out", "DIR"]).ended(0).stdout;
    assert!(said.contains("… 24976 more") && said.contains("without its 25000 rows, which are in states.csv"), "{said}");
    let picture = folder.read("DIR/energy_release_rate_against_speed.svg").replace('\u{a0}', " ");
    assert!(picture.contains("of 25000 states are drawn"), "the picture says what it leaves out");
    let stored = folder.call(&["run", "whole.toml", "--json", "--out", "DIR", "--force", "--no-plots"]).ended(0).json();
    assert_eq!(streamed, stored, "before or after the rows were written to a file");
    assert_eq!((streamed["rows"]["solved"].as_u64(), streamed["states"]["total"].as_u64()), (Some(25_000), Some(25_000)));
    assert!(!folder.path("DIR/energy_release_rate_against_speed.svg").exists(), "--no-plots");
    let whole = table(&folder.read("DIR/states.csv"));
    assert_eq!(whole["status"].len(), 25_000);
    // A part, held as a whole, has the same rows.
    folder.write("part.toml", sweep(12_000, 12_100));
    folder.call(&["run", "part.toml", "--out", "PART"]).ended(0);
    let part = table(&folder.read("PART/states.csv"));
    assert_eq!(part["energy_release_rate"], whole["energy_release_rate"][12_000..12_100]);
    let results = streamed["results"].as_array().unwrap();
    assert_eq!(results.len(), 25_000);
    // The worst number of an assumption is that of all rows, drawn or not.
    let worst = |name: &str| {
        streamed["validity"].as_array().unwrap().iter().find(|entry| entry["name"] == name).unwrap()["value"].as_f64().unwrap()
    };
    let zones = results.iter().map(|row| row["values"]["process_zone"]["value"].as_f64().unwrap());
    assert_eq!(worst("process zone (m)").to_bits(), zones.fold(f64::INFINITY, f64::min).to_bits());
}

/// Each of as many equal parts of a number as there are states is taken once.
#[test]
fn states_at_random_are_a_latin_hypercube() {
    let scene = |head: &str, rest: &str| {
        format!(
            "{SINGLE}\n[latin_hypercube]\n{head}\n[[sweep]]\nkey = \"crack.speed\"\nfrom = 1e-5\nto = 1e-1\n{rest}\n\
             [[sweep]]\nkey = \"adhesion.work_of_adhesion\"\nfrom = 2.0\nto = 0.5\nspacing = \"linear\"\n"
        )
    };
    let run = |head: &str| {
        let folder = Folder::with(&scene(head, ""));
        folder.call(&["run", "scene.toml", "--out", "DIR"]).ended(0);
        for picture in ["energy_release_rate_against_crack_speed.svg", "energy_release_rate_against_adhesion_work_of_adhesion.svg"] {
            assert!(folder.path("DIR").join(picture).is_file(), "{picture}");
        }
        table(&folder.read("DIR/states.csv"))
    };
    let states = run("states = 37\nseed = 11");
    let parts = |values: Vec<f64>, of: &dyn Fn(f64) -> f64| {
        let mut parts: Vec<usize> = values.into_iter().map(|value| (37.0 * of(value)) as usize).collect();
        let ordered = parts.is_sorted();
        parts.sort_unstable();
        assert_eq!(parts, (0..37).collect::<Vec<_>>());
        assert!(!ordered, "in no order");
    };
    parts(numbers(&states, "crack.speed"), &|speed| (speed / 1e-5).log10() / 4.0);
    parts(numbers(&states, "adhesion.work_of_adhesion"), &|work| (2.0 - work) / 1.5);
    assert_eq!(run("states = 37\nseed = 11"), states, "the same seed");
    assert_ne!(run("states = 37")["crack.speed"], states["crack.speed"], "another seed");
    // What cannot be read is refused.
    for (head, rest, says) in [
        ("seed = 1", "", "`latin_hypercube.states` is missing"),
        ("states = 1", "", "out of range"),
        ("states = 9\nseed = -1", "", "out of range"),
        ("states = 9", "points = 9", "`sweep.points` has no place beside [latin_hypercube]"),
        ("states = 9\nstate = 9", "", "`latin_hypercube.state`"),
    ] {
        let said = Folder::with(&scene(head, rest)).call(&["run", "scene.toml"]).ended(2);
        assert!(said.stderr.contains(says), "{head} {rest}\n{}", said.stderr);
    }
    let alone = Folder::with(&format!("{SINGLE}\n[latin_hypercube]\nstates = 4\n")).call(&["run", "scene.toml"]).ended(2);
    assert!(alone.stderr.contains("nothing to vary") && alone.stderr.contains("[[sweep]]"), "{}", alone.stderr);
}

#[test]
fn pictures_are_those_that_are_wanted() {
    let endings = |head: &str, more: &[&str]| {
        let folder = Folder::with(&format!("{head}\n{GOOD}"));
        folder.call(&[&["run", "scene.toml", "--out", "DIR"], more].concat()).ended(0);
        let files = folder.files("DIR");
        ["svg", "png"].map(|ending| files.keys().filter(|name| name.ends_with(ending)).count())
    };
    let [svg, png] = endings("", &[]);
    assert!(svg > 0 && png == 0);
    assert_eq!(endings("plots = [\"png\"]", &[]), [0, svg]);
    assert_eq!(endings("plots = [\"svg\", \"png\"]", &[]), [svg, svg]);
    assert_eq!(endings("plots = [\"svg\", \"png\"]", &["--no-plots"]), [0, 0]);
    let wrong = Folder::with(&format!("plots = [\"pdf\"]\n{GOOD}")).call(&["run", "scene.toml"]).ended(2);
    assert!(wrong.stderr.contains("svg") && wrong.stderr.contains("png"), "{}", wrong.stderr);
}

/// Two swept numbers are a grid: its map has a cell for each state, and its curves are drawn in order of colour.
#[test]
fn two_swept_numbers_are_a_map() {
    let folder = Folder::with(&format!(
        "{SINGLE}\n[[sweep]]\nkey = \"adhesion.work_of_adhesion\"\nfrom = 1.0\nto = 3.0\npoints = 13\nspacing = \"linear\"\n\
         [[sweep]]\nkey = \"crack.speed\"\nfrom = 1e-5\nto = 1e-1\npoints = 7\n"
    ));
    folder.call(&["run", "scene.toml", "--out", "DIR"]).ended(0);
    let map = folder.read("DIR/map_of_energy_release_rate.svg").replace('\u{a0}', " ");
    let group = map.split("<g class=\"map\"").nth(1).unwrap().split("</g>").next().unwrap();
    assert_eq!(group.matches("<path").count(), 13 * 7);
    assert!(map.contains("energy release rate"), "the scale of the colours has its quantity");
    let curves = folder.read("DIR/energy_release_rate_against_speed.svg").replace('\u{a0}', " ");
    assert_eq!(curves.matches("<g class=\"curve\">").count(), 10);
    assert!(curves.contains("10 of 13 values of the outer sweep are drawn"), "{curves}");
}

/// A sweep goes on where a state misses the accuracy, and its exit code says so.
#[test]
fn a_sweep_with_states_that_miss_the_accuracy_ends_with_4() {
    let sweep = "sweep={ key = \"crack.energy_release_rate\", values = [1.0000001, 2, 3] }";
    let folder = Folder::with(&SINGLE.replace("speed = \"1 mm/s\"", "energy_release_rate = 2"));
    let said = folder.call(&["run", "scene.toml", "--set", sweep, "--set", "accuracy=1e-13", "--json"]);
    let json = said.json();
    let inaccurate = json["states"]["inaccurate"].as_u64().unwrap();
    assert!(inaccurate > 0 && said.code == 4 && json["exit_code"] == 4, "{json}");
    assert!(said.stderr.contains(&format!("exit code 4: of 3 states, {inaccurate} inaccurate")), "{}", said.stderr);
}
