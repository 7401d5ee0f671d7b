//! Source: `program/src/scene/read/{until,repeat,relative,standard_test}.rs`, `program/src/plan/indentation/{locate,shift,protocol,repetitions}.rs`.
//!
//! Goal: a condition ends a segment where its quantity comes to the value, within the bounds; standard tests, groups that repeat and relative values are the
//! segments that they stand for, to the last bit; what cannot be is refused with what to type; dwells, retractions and repetitions have their numbers.
//!
//! Parameters: a sphere with an edge, without adhesion, with a law of attraction, and through a frame; forces, radii and depths as conditions, on ramps and on a hold.
//!
//! Oracle: the same history whose segment ends at a chosen place, a hundred times as accurate, gives the value that the condition then names; Hertz's and JKR's closed
//! forms; Boltzmann's integral of a punch; sums over many instants.
//!
//! Tolerance: the sum of both bounds.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, missing_docs)]

use crate::command_support;

use command_support::Folder;
use serde_json::Value;

const MATERIAL: &str =
    "[material]\nrelaxed_modulus = \"1 MPa\"\npoisson_ratio = 0.49\nrelaxation = [{ modulus = \"4 MPa\", relaxation_time = \"0.5 s\" }]\n";
const ELASTIC: &str = "[material]\nrelaxed_modulus = \"1 MPa\"\npoisson_ratio = 0.5\n";
const STICKY: &str = "[adhesion]\nwork_of_adhesion = \"50 mJ/m²\"\nprocess_zone = { length = \"1 µm\" }\n";
const DISTANT: &str = "[adhesion]\nwork_of_adhesion = \"50 mJ/m²\"\nlaw = \"lennard_jones\"\nrange = \"2 µm\"\n";
const SPHERE: &str = "[indentation]\nsphere = { radius = \"1 mm\" }\ninstants = 4\n";
const FRAME: &str = "frame_stiffness = \"500 N/m\"\n";

fn results(text: &str) -> Value {
    Folder::with(text).call(&["run", "scene.toml", "--json"]).ended(0).json()
}

/// The same of a truth, whose bounds count, not its accuracy.
fn truth_of(text: &str) -> Value {
    Folder::with(text).call(&["run", "scene.toml", "--json"]).json()
}

/// A number of the row of the state, and its bound.
fn of_state(summary: &Value, name: &str) -> (f64, f64) {
    of_row(&summary["results"][0], name)
}

fn of_row(row: &Value, name: &str) -> (f64, f64) {
    let value = &row["values"][name];
    (value["value"].as_f64().unwrap(), value["error"].as_f64().unwrap())
}

/// The rows of an event.
fn events<'s>(summary: &'s Value, word: &str) -> Vec<&'s Value> {
    summary["results"].as_array().unwrap().iter().filter(|row| row["event"] == word).collect()
}

fn near((one, error): (f64, f64), (other, bound): (f64, f64), what: &str) {
    println!("{what}: {one:e} ± {error:.1e}, {other:e} ± {bound:.1e}");
    assert!((one - other).abs() <= error + bound, "{what}: {one:e} ± {error:e} and {other:e} ± {bound:e}");
}

/// The numbers of all rows, but for those of repetitions.
fn values(summary: &Value) -> Vec<Value> {
    let of_repetitions = [
        "segment",
        "cycle",
        "cycle_start",
        "work_per_cycle",
        "smallest_penetration",
        "largest_penetration",
        "smallest_force",
        "largest_force",
        "smallest_contact_radius",
        "largest_contact_radius",
    ];
    let rows = summary["results"].as_array().unwrap().iter().filter(|row| row["row"] != "repetition");
    rows.map(|row| {
        let mut values = row["values"].as_object().unwrap().clone();
        of_repetitions.iter().for_each(|name| drop(values.remove(*name)));
        Value::Object(values)
    })
    .collect()
}

/// The rows of repetitions.
fn repetitions(summary: &Value) -> Vec<&Value> {
    summary["results"].as_array().unwrap().iter().filter(|row| row["row"] == "repetition").collect()
}

#[test]
fn a_condition_is_met_where_a_finer_history_has_its_value() {
    let cases = [
        ("without adhesion", format!("{MATERIAL}{SPHERE}"), "penetration", 1e-4, 1e-6),
        ("an edge", format!("{MATERIAL}{STICKY}{SPHERE}"), "penetration", 1e-4, 1e-6),
        ("an edge in a frame", format!("{MATERIAL}{STICKY}{SPHERE}{FRAME}"), "frame", 1e-4, 1e-6),
        ("at a distance", format!("{MATERIAL}{DISTANT}{SPHERE}"), "penetration", 1e-3, 1e-5),
        ("at a distance in a frame", format!("{MATERIAL}{DISTANT}{SPHERE}{FRAME}"), "frame", 1e-3, 1e-5),
    ];
    for (name, head, moved, accuracy, finer) in cases {
        // The sides of both ways: down until something, a rest, and back until something.
        let down = "[[history]]\npenetration = 5e-6\nduration = 2\n".replace("penetration", moved);
        let truth = truth_of(&format!("accuracy = {finer:e}\n{head}{down}"));
        for quantity in ["force", "contact_radius", "penetration"] {
            let (value, bound) = of_state(&truth, &format!("end_{}", quantity.trim_start_matches("contact_")));
            let until = format!("[[history]]\n{moved} = 50e-6\nrate = 2.5e-6\nuntil = {{ {quantity} = {value:e} }}\n");
            let found = results(&format!("accuracy = {accuracy:e}\n{head}{until}"));
            let met = events(&found, "condition_met");
            assert_eq!(met.len(), 1, "{name} {quantity}");
            // The bound of the truth moves its place by as much as the value goes in that time, or less.
            let of_truth = 2.0 * 2.0 * bound / value.abs();
            near(of_row(met[0], "time"), (2.0, of_truth), &format!("{name} until {quantity}: time"));
            for end in ["end_penetration", "end_force", "end_radius"] {
                let (exact, error) = of_state(&truth, end);
                near(of_state(&found, end), (exact, error + of_truth * exact.abs()), &format!("{name} until {quantity}: {end}"));
            }
            let (time, error) = of_row(met[0], "time");
            assert!(error <= accuracy * time, "{name} {quantity}: the time is known to {error:e} s");
        }
        let hold = "[[history]]\nhold = 0.4\n";
        let truth = truth_of(&format!("accuracy = {finer:e}\n{head}{down}{hold}"));
        let (force, bound) = of_state(&truth, "end_force");
        let found = results(&format!(
            "accuracy = {accuracy:e}\n{head}{down}[[history]]\nhold = 9\nuntil = {{ force = {force:e} }}\n[[history]]\nquantity = {moved:?}\nby = -1e-6\nrate = 1e-6\n"
        ));
        let time = of_row(events(&found, "condition_met")[0], "time");
        near(time, (2.4, 4.0 * bound / force), &format!("{name}: hold until"));
        // What is controlled after a hold goes on from where it was held: 1 µm at 1 µm/s.
        let truth = truth_of(&format!("accuracy = {finer:e}\n{head}{down}{hold}[[history]]\n{moved} = 4e-6\nrate = 1e-6\n"));
        for end in ["end_penetration", "end_force"] {
            let (exact, error) = of_state(&truth, end);
            near(of_state(&found, end), (exact, error + 4.0 * bound / force * exact.abs()), &format!("{name} after the hold: {end}"));
        }
    }
}

#[test]
fn an_elastic_sphere_stops_at_the_depth_of_hertz() {
    let (modulus, radius, force) = (1e6 / 0.75, 1e-3_f64, 1e-3);
    let depth = (0.75 * force / (modulus * radius.sqrt())).powf(2.0 / 3.0);
    for condition in [format!("force = {force:e}"), format!("contact_radius = {:e}", (radius * depth).sqrt())] {
        let found = results(&format!(
            "accuracy = 1e-6\n{ELASTIC}{SPHERE}[[history]]\npenetration = 1e-3\nrate = 1e-6\nuntil = {{ {condition} }}\n"
        ));
        near(of_state(&found, "end_penetration"), (depth, 1e-15 * depth), &condition);
        near(of_row(events(&found, "condition_met")[0], "time"), (depth / 1e-6, 0.0), &condition);
    }
}

#[test]
fn a_segment_ends_right_after_the_contact_is_lost() {
    for (name, head, accuracy) in [
        ("without adhesion", format!("{MATERIAL}{SPHERE}"), 1e-4),
        ("an edge", format!("{MATERIAL}{STICKY}{SPHERE}"), 1e-4),
        ("at a distance", format!("{MATERIAL}{DISTANT}{SPHERE}"), 1e-3),
    ] {
        let head = format!("accuracy = {accuracy:e}\n{head}[[history]]\npenetration = 4e-6\nrate = 2e-6\n");
        let whole = results(&format!("{head}[[history]]\npenetration = -2e-5\nrate = 2e-6\n"));
        let found = results(&format!("{head}[[history]]\npenetration = -2e-5\nrate = 2e-6\nuntil = {{ event = \"detachment\" }}\n"));
        let stopped = of_row(events(&found, "condition_met")[0], "time");
        for name in ["detachment_time", "detachment_penetration"] {
            near(of_state(&found, name), of_state(&whole, name), name);
        }
        let detached = of_state(&found, "detachment_time");
        assert!(stopped.0 >= detached.0 && stopped.0 - detached.0 <= stopped.1, "{name}: {stopped:?} after {detached:?}");
        assert!(of_state(&found, "end_radius").0 == 0.0, "{name}");
    }
}

/// A recorded curve after a segment with a condition begins where and when that segment has ended: an elastic stop is exact, so both histories are one.
#[test]
fn a_table_follows_the_end_of_a_condition() {
    let (modulus, radius, force): (f64, f64, f64) = (1e6 / 0.75, 1e-3, 1e-3);
    let depth = (0.75 * force / (modulus * radius.sqrt())).powf(2.0 / 3.0);
    let measured = |step: f64| (4.0 / 3.0 * modulus * radius.sqrt() * (depth - step).powf(1.5), depth - step);
    let lines: Vec<String> = [0.0, 1e-6, 5e-7]
        .into_iter()
        .zip(0..)
        .map(|(step, second)| format!("{second},{:e},{:e}", measured(step).1, measured(step).0))
        .collect();
    let table = "[[history]]\ntable = \"after.csv\"\nquantity = \"penetration\"\ntolerance = 0\n";
    for press in
        [format!("penetration = 1e-3\nrate = 1e-6\nuntil = {{ force = {force:e} }}"), format!("penetration = {depth:e}\nrate = 1e-6")]
    {
        let folder = Folder::with(&format!("accuracy = 1e-6\n{ELASTIC}{SPHERE}[[history]]\n{press}\n{table}"));
        folder.write("after.csv", format!("time [s],penetration [m],force [N]\n{}\n", lines.join("\n")));
        let found = folder.call(&["run", "scene.toml", "--json"]).ended(0).json();
        let results = found["results"].as_array().unwrap();
        let with_force: Vec<&Value> = results.iter().filter(|row| row["values"]["force_deviation"]["value"].is_f64()).collect();
        for second in [1.0, 2.0] {
            let time = depth / 1e-6 + second;
            let row = with_force.iter().find(|row| (of_row(row, "time").0 - time).abs() < 1e-6 * time).unwrap();
            let (deviation, error) = of_row(row, "force_deviation");
            assert!(deviation.abs() <= error + 1e-9 * force && error < 1e-5 * force, "{press} at {second}: {deviation:e} ± {error:e}");
        }
        assert!(of_state(&found, "coefficient_of_determination").0 > 1.0 - 1e-9, "{press}");
    }
}

#[test]
fn a_condition_that_is_never_met_leaves_the_segment_as_it_is() {
    for head in [format!("{MATERIAL}{STICKY}{SPHERE}"), format!("{MATERIAL}{DISTANT}{SPHERE}")] {
        let ramp = "[[history]]\npenetration = 4e-6\nrate = 2e-6\n";
        let found = results(&format!("accuracy = 1e-3\n{head}{ramp}until = {{ force = 1 }}\n"));
        let plain = results(&format!("accuracy = 1e-4\n{head}{ramp}"));
        let limit = events(&found, "limit_reached");
        assert_eq!((limit.len(), of_row(limit[0], "time")), (1, (2.0, 0.0)));
        assert!(events(&found, "condition_met").is_empty());
        for name in ["end_force", "end_radius"] {
            near(of_state(&found, name), of_state(&plain, name), name);
        }
    }
}

#[test]
fn times_and_controlled_quantities_need_no_search() {
    let head = format!("accuracy = 1e-4\n{MATERIAL}{STICKY}{SPHERE}");
    let plain = results(&format!("{head}[[history]]\npenetration = 3e-6\nduration = 1.5\n"));
    for condition in ["penetration = 3e-6", "time = 1.5"] {
        let found = results(&format!("{head}[[history]]\npenetration = 8e-6\nduration = 4\nuntil = {{ {condition} }}\n"));
        for name in ["end_penetration", "end_force", "end_radius"] {
            near(of_state(&found, name), of_state(&plain, name), name);
        }
        assert_eq!(of_row(events(&found, "condition_met")[0], "time"), (1.5, 0.0));
    }
}

#[test]
fn a_group_that_repeats_is_its_segments_written_out() {
    let group = "[[history]]\npenetration = 4e-6\nrate = 4e-6\nuntil = { force = 5e-4 }\n[[history]]\nquantity = \"penetration\"\nby = -1e-6\nrate = 4e-6\n[[history]]\nhold = 0.1\n";
    // With energies in both: the account of energies, which repetitions ask for, moves last digits.
    let head = format!("accuracy = 1e-3\n{MATERIAL}{SPHERE}energies = {{}}\n");
    let short = results(&format!("{head}{group}[[history]]\nrepeat = 3\nsegments = 3\n"));
    let long = results(&format!("{head}{}", group.repeat(3)));
    assert_eq!(values(&short), values(&long));
    // A group of a group: the hold twice, and all of it twice.
    let nested = format!("{head}{group}[[history]]\nrepeat = 2\n[[history]]\nrepeat = 2\nsegments = 4\n");
    let hold = "[[history]]\nhold = 0.1\n";
    assert_eq!(values(&results(&nested)), values(&results(&format!("{head}{group}{hold}{group}{hold}"))));
    let crack = |history: &str| {
        let head = command_support::DELAYED.split("[[history]]").next().unwrap().to_owned();
        values(&results(&format!("{head}{history}")))
    };
    let steps = "[[history]]\nstress_intensity = \"2 kPa √m\"\n[[history]]\nby = \"0.5 kPa √m\"\nrate = \"1 kPa √m/s\"\n[[history]]\nhold = \"1 s\"\n[[history]]\nrepeat = 2\nsegments = 2\n";
    let plain = "[[history]]\nstress_intensity = 2e3\n[[history]]\nstress_intensity = 2.5e3\nrate = 1e3\n[[history]]\nhold = 1\n[[history]]\nstress_intensity = 3e3\nrate = 1e3\n[[history]]\nhold = 1\n";
    assert_eq!(crack(steps), crack(plain));
}

#[test]
fn a_standard_test_is_the_segments_that_explain_prints() {
    let tests = [
        "kind = \"pull_off\"\napproach_speed = 5e-6\npreload = 5e-4\ndwell = 0.5\nretraction_speed = 1e-5",
        "kind = \"tack\"\napproach_speed = 5e-6\npreload = 5e-4\ndwell = 0.5",
        "kind = \"creep\"\npreload = 5e-4\nrise = 0.1\ndwell = 0.5",
        "kind = \"relaxation\"\napproach_speed = 5e-6\ndepth = 4e-6\ndwell = 0.5",
        "kind = \"dynamic\"\napproach_speed = 5e-6\npreload = 5e-4\namplitude = 1e-7\nfrequency = 1\nto_frequency = 10\nfrequencies = 3\ncycles = 3",
        "kind = \"cyclic\"\napproach_speed = 5e-6\ndepth = 4e-6\nretract_to = 1e-6\ncycles = 2",
    ];
    let heads = [format!("{MATERIAL}{SPHERE}"), format!("{MATERIAL}{STICKY}{SPHERE}{FRAME}"), format!("{MATERIAL}{DISTANT}{SPHERE}")];
    for head in heads {
        for test in tests {
            let head = format!("accuracy = 1e-2\n{head}");
            let scene = format!("{head}[test]\n{test}\n");
            let explained = Folder::with(&scene).call(&["explain", "scene.toml", "--json"]).ended(0).json();
            let segments: Vec<String> = explained["history"]
                .as_array()
                .unwrap()
                .iter()
                .map(|segment| format!("[[history]]\n{}\n", segment.as_str().unwrap()))
                .collect();
            let written = format!("{head}{}", segments.concat());
            let run = |text: &str| Folder::with(text).call(&["run", "scene.toml", "--json"]).json();
            let (short, long) = (run(&scene), run(&written));
            assert!(short["results"].as_array().unwrap().len() > 4, "{test}");
            assert_eq!(short["results"], long["results"], "{head}{test}");
        }
    }
}

#[test]
fn what_cannot_be_says_what_to_type() {
    let head = format!("{MATERIAL}{SPHERE}");
    let crack = command_support::DELAYED.replace("hold = \"2 s\"", "hold = \"2 s\"\nuntil = { time = \"1 s\" }");
    let cases = [
        (format!("{head}[[history]]\npenetration = 1e-6\nuntil = {{ force = 1 }}\n"), "add rate = \"1 µm/s\", or a duration"),
        (format!("{head}[[history]]\npenetration = 1e-6\nrate = 1\nuntil = {{}}\n"), "give exactly one of them"),
        (format!("{head}[[history]]\npenetration = 1e-6\nrate = 1\nuntil = {{ force = 1, time = 1 }}\n"), "exclude each other"),
        (format!("{head}[[history]]\npenetration = 1e-6\nrate = 1\nuntil = {{ frame = 1 }}\n"), "add indentation.frame_stiffness"),
        (format!("{head}[[history]]\nby = 1e-6\nrate = 1\n"), "history.0.quantity"),
        (format!("{head}[[history]]\nrepeat = 2\n"), "put it behind the tables"),
        (format!("{head}[[history]]\nhold = 1\n[[history]]\nrepeat = 2\nsegments = 3\n"), "only 1 [[history]] tables"),
        (
            format!("{head}[[history]]\nhold = 1\n[[history]]\nrepeat = 10000\n[[history]]\nrepeat = 10000\nsegments = 2\n"),
            "at most 20000 segments",
        ),
        (format!("{head}[test]\nkind = \"creep\"\npreload = 1e-3\ndwell = 1\ndepth = 1e-6\n"), "does not belong to a test of the kind"),
        (format!("{head}[test]\nkind = \"relaxation\"\napproach_speed = 1\ndepth = 1e-6\n"), "test.dwell"),
        (format!("{head}[test]\nkind = \"tack\"\napproach_speed = 1\npreload = 1\n[[history]]\nhold = 1\n"), "leave one of the two out"),
        (crack, "only the history of an indenter has conditions"),
        (command_support::SLIDING.to_owned() + "\n[test]\nkind = \"creep\"\n", "belongs to an indenter"),
    ];
    for (text, wanted) in cases {
        let answer = Folder::with(&text).call(&["run", "scene.toml"]).ended(2);
        assert!(answer.stderr.contains(wanted), "{wanted}\n{text}\n{}", answer.stderr);
    }
    // A cone has no size to go to.
    let cone = format!("{MATERIAL}[indentation]\ncone = {{ slope = 0.2 }}\n[test]\nkind = \"tack\"\napproach_speed = 1\npreload = 1\n");
    let answer = Folder::with(&cone).call(&["run", "scene.toml"]).ended(2);
    assert!(answer.stderr.contains("test.approach_to"), "{}", answer.stderr);
    // What only a solution shows is a row with its reason.
    let late = format!("{head}[[history]]\npenetration = 1e-6\nduration = 2\n[[history]]\nhold = 1\nuntil = {{ time = 1 }}\n");
    let answer = Folder::with(&late).call(&["run", "scene.toml"]);
    assert!(format!("{}{}", answer.stdout, answer.stderr).contains("give a later `until.time`"), "{}{}", answer.stdout, answer.stderr);
}

/// An elastic sphere: at the end of the dwell it has JKR's (Hertz's) radius, and it lets go where JKR's curve ends.
#[test]
fn the_radius_of_a_dwell_and_the_time_to_detach_are_those_of_closed_forms() {
    use viscotack::elastic::{Control, EquilibriumBranch, JkrSphere};
    let history = |depth: f64| {
        format!(
            "[[history]]\npenetration = {depth:e}\nrate = 4e-6\n[[history]]\nhold = 3\n[[history]]\npenetration = {:e}\nrate = 2e-6\n[[history]]\npenetration = -1e-4\nrate = 5e-6\n",
            0.5 * depth
        )
    };
    let (radius, depth) = (1e-3_f64, 4e-6);
    // Two rates of one retraction: from its beginning on.
    let time = |off: f64| 0.5 * depth / 2e-6 + (0.5 * depth - off) / 5e-6;
    let found = results(&format!("accuracy = 1e-6\n{ELASTIC}{SPHERE}{}", history(depth)));
    near(of_state(&found, "dwell_radius"), ((radius * depth).sqrt(), 1e-12), "Hertz: radius");
    near(of_state(&found, "time_to_detach"), (time(0.0), 1e-12), "Hertz: time");
    let sphere = JkrSphere::new(radius, 1e6 / 0.75, 0.05).unwrap();
    let held = sphere.state_by_penetration(depth, EquilibriumBranch::Stable).unwrap().contact_radius;
    let off = sphere.pull_off(Control::Penetration).unwrap().penetration;
    // The zone is as short as JKR's is none: what it changes goes with its length, 4e-7 of the radius and 2 µs here.
    let sticky = STICKY.replace("1 µm", "1 nm");
    let found = results(&format!("accuracy = 1e-5\n{ELASTIC}{sticky}{SPHERE}{}", history(depth)));
    near(of_state(&found, "dwell_radius"), (held, 1e-6 * held), "JKR: radius");
    near(of_state(&found, "time_to_detach"), (time(off), 5e-6), "JKR: time");
}

/// After a preload by force, in both theories: the loss less the end of the hold; nothing without a hold or a loss; of a dead load from where it begins to pull.
#[test]
fn a_retraction_begins_where_what_is_imposed_begins_to_fall() {
    for (name, head) in
        [("an edge", format!("{MATERIAL}{STICKY}{SPHERE}{FRAME}")), ("at a distance", format!("{MATERIAL}{DISTANT}{SPHERE}{FRAME}"))]
    {
        let test = "[test]\nkind = \"pull_off\"\napproach_speed = 5e-6\npreload = 5e-4\ndwell = 0.5\n";
        let found = results(&format!("accuracy = 1e-3\n{head}{test}"));
        let (preload, _) = of_row(events(&found, "condition_met")[0], "time");
        let (lost, bound) = of_state(&found, "detachment_time");
        near(of_state(&found, "time_to_detach"), (lost - preload - 0.5, bound), name);
        let end = found["results"]
            .as_array()
            .unwrap()
            .iter()
            .rfind(|row| row["row"] == "instant" && (of_row(row, "time").0 - preload - 0.5).abs() < 1e-9);
        near(of_state(&found, "dwell_radius"), of_row(end.unwrap(), "contact_radius"), name);
        let found = results(&format!("accuracy = 1e-3\n{head}[[history]]\npenetration = 5e-6\nrate = 5e-6\n"));
        for column in ["dwell_radius", "time_to_detach"] {
            assert!(found["results"][0]["values"][column].is_null(), "{name}: {column}");
        }
    }
    // Pulled at once by a force that the relaxed contact does not carry: the time to detach is the delay.
    let pull = "[[history]]\nforce = 1e-3\n[[history]]\nhold = 1\n[[history]]\nforce = -5e-4\n[[history]]\nhold = 100\n";
    let found = results(&format!("accuracy = 1e-3\n{MATERIAL}{STICKY}{SPHERE}{pull}"));
    let (lost, bound) = of_state(&found, "detachment_time");
    assert!(lost > 1.0 + 1e-3, "{lost:e}");
    near(of_state(&found, "time_to_detach"), (lost - 1.0, bound), "dead load");
}

/// A recorded curve: from the largest displacement before the loss on, whatever its noise.
#[test]
fn the_retraction_of_a_recorded_curve_begins_at_its_largest_value() {
    let depths = [0.0, 2e-6, 1.999e-6, 4e-6, 4.001e-6, 4e-6, 2e-6, 2.001e-6, -1e-6];
    let rows: Vec<String> = depths.iter().zip(0..).map(|(depth, second)| format!("{second},{depth:e}\n")).collect();
    let folder = Folder::with(&format!(
        "accuracy = 1e-4\n{ELASTIC}{SPHERE}[[history]]\ntable = \"curve.csv\"\nquantity = \"penetration\"\ntolerance = 0\n"
    ));
    folder.write("curve.csv", format!("time [s],penetration [m]\n{}", rows.concat()));
    let found = folder.call(&["run", "scene.toml", "--json"]).ended(0).json();
    // It crosses zero in the last second.
    near(of_state(&found, "time_to_detach"), (3.0 + 2.001 / 3.001, 1e-9), "a table");
}

/// A rigid punch is linear: F = 2a∫E*(t − s) dΔ, of one relaxation term in closed form from corner to corner; the work of each cycle by many points.
#[test]
fn the_work_of_a_cycle_of_a_punch_is_that_of_boltzmanns_integral() {
    let (relaxed, term, tau, radius) = (1e6 / (1.0 - 0.49_f64.powi(2)), 4e6 / (1.0 - 0.49_f64.powi(2)), 0.5, 1e-3);
    let (lower, upper, half, count) = (3e-6, 4e-6, 0.4, 3);
    let punch = "[indentation]\nflat_punch = { radius = \"1 mm\" }\ninstants = 2\n";
    let cycles = format!(
        "[[history]]\nquantity = \"penetration\"\ncycles = {count}\nperiod = {}\nlower = {lower:e}\nupper = {upper:e}\nwave = \"triangle\"\n",
        2.0 * half
    );
    let ramps = format!(
        "[[history]]\npenetration = {lower:e}\nduration = 2\n[[history]]\npenetration = {upper:e}\nduration = {half}\n[[history]]\npenetration = {lower:e}\nduration = {half}\n[[history]]\nrepeat = {count}\nsegments = 2\n"
    );
    let first = format!("[[history]]\npenetration = {lower:e}\nduration = 2\n");
    // Work of each half, with ε of the term at its start: F = 2a(E0*Δ + E1*ε), ε' = Δ' − ε/τ.
    let half_work = |from: f64, to: f64, epsilon: f64| {
        let rate = (to - from) / half;
        let (points, mut sum, mut extremes) = (20_000, 0.0, [f64::INFINITY, f64::NEG_INFINITY]);
        let force = |time: f64| {
            let memory = rate * tau + (epsilon - rate * tau) * (-time / tau).exp();
            2.0 * radius * (relaxed * (from + rate * time) + term * memory)
        };
        for point in 0..points {
            sum += force((f64::from(point) + 0.5) * half / f64::from(points)) * (to - from) / f64::from(points);
        }
        for end in [force(0.0), force(half)] {
            extremes = [extremes[0].min(end), extremes[1].max(end)];
        }
        (sum, rate * tau + (epsilon - rate * tau) * (-half / tau).exp(), extremes)
    };
    for history in [format!("{first}{cycles}"), ramps] {
        let found = results(&format!("accuracy = 1e-6\n{MATERIAL}{punch}{history}"));
        let rows = repetitions(&found);
        assert_eq!(rows.len(), count);
        let mut epsilon = lower / 2.0 * tau * (1.0 - (-2.0 / tau).exp());
        for (row, number) in rows.iter().zip(1..) {
            let (up, top, high) = half_work(lower, upper, epsilon);
            let (down, end, low) = half_work(upper, lower, top);
            epsilon = end;
            near(of_row(row, "cycle"), (f64::from(number), 0.0), "which");
            near(of_row(row, "work_per_cycle"), (up + down, 1e-9 * up), "work");
            let (work, bound) = of_row(row, "work_per_cycle");
            assert!(bound < 1e-5 * work, "the work {work:e} is known to {bound:e}");
            near(of_row(row, "largest_force"), (high[1], 1e-9 * high[1]), "largest force");
            near(of_row(row, "smallest_force"), (low[0], 1e-9 * low[0].abs()), "smallest force");
            near(of_row(row, "largest_penetration"), (upper, 1e-12 * upper), "penetration");
        }
        near(of_state(&found, "work_per_cycle"), of_row(rows[count - 1], "work_per_cycle"), "of the state");
    }
}

/// With adhesion: an elastic contact gives back all that it took, in both theories; of a lossy one the path and the account of energies agree.
#[test]
fn the_work_of_a_repetition_is_what_is_lost() {
    let group = "[[history]]\npenetration = 4e-6\nrate = 4e-6\n[[history]]\npenetration = 2e-6\nrate = 4e-6\n[[history]]\nrepeat = 3\nsegments = 2\n";
    for sticky in [STICKY, DISTANT] {
        let found = results(&format!("accuracy = 1e-3\n{ELASTIC}{sticky}{SPHERE}[[history]]\npenetration = 2e-6\nrate = 1e-6\n{group}"));
        let rows = repetitions(&found);
        assert_eq!(rows.len(), 3);
        for row in rows {
            let ((work, bound), (_, force)) = (of_row(row, "work_per_cycle"), (0.0, of_row(row, "largest_force").0));
            assert!(work.abs() <= bound && bound <= 1e-2 * force * 2e-6, "{work:e} ± {bound:e}");
        }
        let head = format!("accuracy = 1e-3\n{MATERIAL}{sticky}{SPHERE}");
        let (plain, counted) = (results(&format!("{head}{group}")), results(&format!("{head}energies = {{}}\n{group}")));
        let fine = truth_of(&format!("{}instants = 400\n{group}", head.replace("instants = 4\n", "").replace("1e-3", "1e-5")));
        let path: Vec<[f64; 3]> = fine["results"]
            .as_array()
            .unwrap()
            .iter()
            .filter(|row| row["row"] == "instant")
            .map(|row| ["time", "penetration", "force"].map(|name| of_row(row, name).0))
            .collect();
        for (one, other) in repetitions(&plain).into_iter().zip(repetitions(&counted)) {
            near(of_row(one, "work_per_cycle"), of_row(other, "work_per_cycle"), "two accounts");
            let [from, to] = ["cycle_start", "time"].map(|name| of_row(one, name).0);
            let within: Vec<&[f64; 3]> = path.iter().filter(|point| point[0] >= from - 1e-9 && point[0] <= to + 1e-9).collect();
            let sum: f64 = within.windows(2).map(|pair| 0.5 * (pair[0][2] + pair[1][2]) * (pair[1][1] - pair[0][1])).sum();
            near(of_row(other, "work_per_cycle"), (sum, 3e-5 * of_row(one, "largest_force").0 * 4e-6), "many instants");
        }
    }
}
