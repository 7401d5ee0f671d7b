//! Each command of the program does what its line in the help says, and ends with the exit code that the design promises.
//!
//! Contract: the design's list of commands and exit codes (0 solved, 2 wrong, 3 no such state, 4 accuracy not reached).
//! Goal: outputs are complete (values with errors, certificate, work, effects, validity, provenance), reproducible to the byte, and typed.
//! Parameters: a good scene, its single states, every template, every shipped scene.
//! Oracle: the scene itself (its keys, its sweep), the limits G = Δγ and βΔγ, and a second run.
//! Tolerance: none, but for limits read out of messages (1e-12, decimal output).
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use crate::command_support;

use command_support::{Folder, GOOD, SINGLE, SLIDING, answer, shipped_scenes, shortened};
use serde_json::Value;
use viscotack_program::scene::document::{Node, Value as Written};
use viscotack_program::scene::template::TEMPLATES;
use viscotack_program::scene::{Document, catalogue};

fn single_under_load(load: &str) -> Folder {
    Folder::with(&SINGLE.replace("speed = \"1 mm/s\"", &format!("energy_release_rate = {load}")))
}

/// The columns of a CSV by header, each with its cells.
fn table(text: &str) -> Vec<(String, Vec<String>)> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let mut columns: Vec<(String, Vec<String>)> = reader.headers().unwrap().iter().map(|name| (name.to_owned(), Vec::new())).collect();
    for record in reader.records() {
        for (column, cell) in columns.iter_mut().zip(record.unwrap().iter()) {
            column.1.push(cell.to_owned());
        }
    }
    columns
}

fn cells<'a>(columns: &'a [(String, Vec<String>)], name: &str) -> &'a [String] {
    &columns.iter().find(|column| column.0 == name).unwrap_or_else(|| panic!("no column {name}")).1
}

#[test]
fn run_prints_values_with_their_errors() {
    let folder = Folder::with(SINGLE);
    let said = folder.call(&["run", "scene.toml"]).ended(0);
    assert!(said.stderr.is_empty(), "{}", said.stderr);
    for words in [
        "virtual_work: solved",
        "energy_release_rate ",
        " ± ",
        "J/m²",
        "certificate: admissible",
        "simulated",
        "left out",
        "validity",
        "work ",
    ] {
        assert!(said.stdout.contains(words), "{words:?} is missing in\n{}", said.stdout);
    }
    assert!(said.stdout.lines().all(|line| line == line.trim_end()), "spaces at the end of a line");
    // The title of a scene without one is the name of its file.
    assert!(said.stdout.starts_with("scene\n"));
    let swept = Folder::with(GOOD).call(&["run", "scene.toml"]).ended(0);
    for words in ["±", "crack.speed [m/s]", "energy_release_rate [J/m²]", "sweep"] {
        assert!(swept.stdout.contains(words), "{words:?} is missing in\n{}", swept.stdout);
    }
}

#[test]
fn run_json_is_complete() {
    let folder = Folder::with(SINGLE);
    let json = folder.call(&["run", "scene.toml", "--json"]).ended(0).json();
    assert_eq!(json["exit_code"], 0);
    assert_eq!(json["accuracy"], 1e-9);
    assert_eq!(json["provenance"]["version"], env!("CARGO_PKG_VERSION"));
    assert!(!json["provenance"]["commit"].as_str().unwrap().is_empty());
    let hash = json["provenance"]["scene_sha256"].as_str().unwrap();
    assert!(hash.len() == 64 && hash.bytes().all(|byte| byte.is_ascii_hexdigit()), "{hash}");
    for block in ["effects", "method", "groups", "validity", "columns", "results"] {
        assert!(!json[block].as_array().unwrap().is_empty(), "{block}");
    }
    for effect in json["effects"].as_array().unwrap() {
        assert!(effect["on"].is_boolean() && effect["name"].is_string() && !effect["why"].as_str().unwrap().is_empty(), "{effect}");
    }
    for entry in json["validity"].as_array().unwrap() {
        assert!(["good", "caution", "not_judged"].contains(&entry["verdict"].as_str().unwrap()), "{entry}");
    }
    let row = &json["results"][0];
    assert_eq!(row["status"], "solved");
    for column in json["columns"].as_array().unwrap() {
        let value = &row["values"][column["name"].as_str().unwrap()];
        // A quantity of the other motion has no value.
        if !value.is_null() {
            assert!(value["value"].is_f64() && value["error"].is_f64() && value["unit"] == column["unit"], "{column} {value}");
            assert!(value["error"].as_f64().unwrap() <= 1e-9 * value["value"].as_f64().unwrap().abs().max(1.0));
        }
    }
    assert!(row["values"].as_object().unwrap().len() >= 9);
    assert_eq!(row["certificate"]["admissible"], true);
    for number in ["residual", "condition"] {
        assert!(row["certificate"][number].is_f64(), "{number}");
    }
    for counter in ["closure_evaluations", "kernel_evaluations", "linear_solves", "field_evaluations"] {
        assert_eq!(row["work"][counter], json["work"][counter]);
    }
    assert!(json["work"]["closure_evaluations"].as_u64().unwrap() > 0);
}

#[test]
fn the_hash_is_of_all_that_was_read() {
    let folder = Folder::with(GOOD);
    let hash = |arguments: &[&str]| {
        let all = [&["run", "scene.toml", "--json"], arguments].concat();
        folder.call(&all).ended(0).json()["provenance"]["scene_sha256"].as_str().unwrap().to_owned()
    };
    let plain = hash(&[]);
    assert_eq!(plain, hash(&[]));
    let set = hash(&["--set", "sweep.points=4"]);
    assert_ne!(plain, set);
    assert_ne!(set, hash(&["--set", "sweep.points=5"]));
    folder.write("scene.toml", GOOD.replace("poisson_ratio = 0.49", "file = \"rubber.toml\""));
    folder.write("rubber.toml", "[material]\npoisson_ratio = 0.49\n");
    let included = hash(&[]);
    folder.write("rubber.toml", "[material]\npoisson_ratio = 0.48\n");
    assert_ne!(included, hash(&[]));
}

#[test]
fn files_are_the_same_bytes_whenever_and_however_parallel() {
    let folder = Folder::with(&GOOD.replace("points = 3", "points = 400"));
    folder.call(&["run", "scene.toml", "--out", "first"]).ended(0);
    let first = folder.files("first");
    for (name, threads) in [("again", "0"), ("one", "1"), ("three", "3"), ("many", "16")] {
        answer(folder.command(&["run", "scene.toml", "--out", name]).env("RAYON_NUM_THREADS", threads)).ended(0);
        assert!(folder.files(name) == first, "{name} differs");
    }
    for name in ["summary.json", "states.csv", "fields.csv", "scene.toml", "report.html"] {
        assert!(first.contains_key(name), "{name} is missing in {:?}", first.keys());
    }
    assert!(!first.contains_key("journal.jsonl"));
    let json = folder.call(&["run", "scene.toml", "--json"]).ended(0);
    assert_eq!(json.stdout, folder.read("first/summary.json"), "--json prints summary.json");
}

#[test]
fn tables_name_every_unit() {
    let folder = Folder::with(GOOD);
    folder.call(&["run", "scene.toml", "--out", "DIR"]).ended(0);
    for name in ["states.csv", "fields.csv"] {
        let columns = table(&folder.read(&format!("DIR/{name}")));
        for (header, _) in &columns {
            assert!(
                ["theory", "contact", "state", "status", "reason"].contains(&header.as_str())
                    || (header.contains(" [") && header.ends_with(']')),
                "{header}"
            );
        }
    }
    let states = table(&folder.read("DIR/states.csv"));
    assert_eq!(cells(&states, "crack.speed [m/s]"), ["1e-6", "0.001", "1"]);
    assert_eq!(cells(&states, "status"), ["solved"; 3]);
    assert_eq!(cells(&states, "speed [m/s]"), cells(&states, "crack.speed [m/s]"));
    assert!(cells(&states, "energy_release_rate_error [J/m²]").iter().all(|cell| cell.parse::<f64>().unwrap() > 0.0));
    let fields = table(&folder.read("DIR/fields.csv"));
    assert_eq!(cells(&fields, "distance [m]").len(), 15);
    assert!(folder.read("DIR/scene.toml").ends_with(GOOD));
}

#[test]
fn the_written_scene_gives_the_same_run_again() {
    let folder = Folder::with(GOOD);
    folder.call(&["run", "scene.toml", "--set", "sweep.points=7", "--set", "title=a title with = and \"quotes\"", "--out", "DIR"]).ended(0);
    let written = folder.read("DIR/scene.toml");
    assert!(written.starts_with("# --set sweep.points=7\n# --set title=a title"), "{written}");
    assert!(folder.read("DIR/summary.json").contains(r#""title": "a title with = and \"quotes\"""#));
    folder.call(&["explain", "DIR/scene.toml"]).ended(0);
}

#[test]
fn a_load_outside_the_limits_has_no_state_and_names_the_limit() {
    // Opening: from Δγ to βΔγ with β = 100; closing: from Δγ/β to Δγ.
    for (motion, load, limit, words) in [
        ("opening", "0.5", 1.0, "below"),
        ("opening", "100.5", 100.0, "above"),
        ("closing", "0.0095", 0.01, "closes"),
        ("closing", "1.5", 1.0, "open"),
    ] {
        let folder = single_under_load(load);
        let motion = format!("crack.motion={motion}");
        let json = folder.call(&["run", "scene.toml", "--set", &motion, "--json"]).ended(3).json();
        let row = &json["results"][0];
        assert_eq!(row["status"], "no_such_state");
        assert_eq!(json["exit_code"], 3);
        assert!(row["values"].as_object().unwrap().is_empty() && row["certificate"].is_null(), "{row}");
        let reason = row["reason"].as_str().unwrap();
        assert!(reason.contains(words), "{reason}");
        let witness: f64 = reason.rsplit(" = ").next().unwrap().trim_end_matches(')').parse().unwrap();
        assert!((witness / limit - 1.0).abs() < 1e-12, "{reason}");
        let stated = row["witness"]["value"].as_f64().unwrap();
        assert!((stated / limit - 1.0).abs() < 1e-12 && row["witness"]["name"] == "G/work_of_adhesion", "{row}");
        let said = folder.call(&["run", "scene.toml", "--set", &motion, "--out", "DIR"]).ended(3);
        assert!(said.stdout.contains("no_such_state") && said.stdout.contains(words), "{}", said.stdout);
        assert!(folder.path("DIR/summary.json").is_file(), "what was found is written");
        std::fs::remove_dir_all(folder.path("DIR")).unwrap();
    }
    // Just inside the limits there is a state.
    for (motion, load) in [("opening", "1.0000001"), ("opening", "99.99999"), ("closing", "0.0100000001"), ("closing", "0.9999999")] {
        single_under_load(load).call(&["run", "scene.toml", "--set", &format!("crack.motion={motion}"), "--set", "accuracy=1e-4"]).ended(0);
    }
}

#[test]
fn an_elastic_crack_under_a_load_has_no_speed() {
    let folder = single_under_load("1");
    let scene = folder.read("scene.toml").replace("relaxed_modulus = \"1 MPa\"\n", "").replace("creep = ", "# ");
    folder.write("scene.toml", scene);
    let json = folder.call(&["run", "scene.toml", "--json"]).ended(3).json();
    assert_eq!(json["results"][0]["status"], "undefined");
    assert!(json["results"][0]["reason"].as_str().unwrap().contains("elastic"));
}

#[test]
fn an_accuracy_out_of_reach_is_flagged_and_the_values_are_given() {
    let folder = single_under_load("1.0000001");
    let json = folder.call(&["run", "scene.toml", "--set", "accuracy=1e-15", "--json", "--out", "DIR"]).ended(4).json();
    let row = &json["results"][0];
    assert_eq!((&row["status"], &json["exit_code"]), (&Value::from("inaccurate"), &Value::from(4)));
    assert!(row["reason"].as_str().unwrap().contains("above the wanted accuracy 1.0e-15"), "{row}");
    let speed = &row["values"]["speed"];
    assert!(speed["value"].as_f64().unwrap() > 0.0 && speed["error"].as_f64().unwrap() > 1e-15 * speed["value"].as_f64().unwrap());
    assert_eq!(cells(&table(&folder.read("DIR/states.csv")), "status"), ["inaccurate"]);
    folder.call(&["run", "scene.toml", "--set", "accuracy=1e-3"]).ended(0);
    assert!(folder.call(&["run", "scene.toml", "--set", "accuracy=1e-15"]).ended(4).stdout.contains("virtual_work: inaccurate"));
}

#[test]
fn a_sweep_gives_typed_rows_and_empty_cells() {
    let folder = single_under_load("2");
    let sweep = "sweep={ key = \"crack.energy_release_rate\", values = [0.5, 2, 50, 200] }";
    folder.call(&["run", "scene.toml", "--set", sweep, "--out", "DIR"]).ended(0);
    let states = table(&folder.read("DIR/states.csv"));
    let statuses = cells(&states, "status");
    assert_eq!(statuses, ["no_such_state", "solved", "solved", "no_such_state"]);
    for (header, column) in &states {
        for (cell, status) in column.iter().zip(statuses) {
            let described = ["crack.energy_release_rate [J/m²]", "theory", "status", "reason"].contains(&header.as_str());
            if status != "solved" && !described {
                assert!(cell.is_empty(), "{header} holds {cell} in a row {status}");
            }
        }
    }
    assert!(cells(&states, "reason")[0].contains("G/work_of_adhesion"));
    let summary: Value = serde_json::from_str(&folder.read("DIR/summary.json")).unwrap();
    assert_eq!((&summary["rows"]["solved"], &summary["rows"]["no_such_state"]), (&Value::from(2), &Value::from(2)));
    // Without any solved row the worst of them decides.
    let none = "sweep={ key = \"crack.energy_release_rate\", values = [0.5, 200] }";
    folder.call(&["run", "scene.toml", "--set", none]).ended(3);
}

#[test]
fn swept_values_that_contradict_the_scene_are_rows_wherever_they_stand() {
    for values in ["[\"1 MPa\", \"200 MPa\"]", "[\"200 MPa\", \"1 MPa\"]"] {
        let folder = Folder::with(SINGLE);
        let sweep = format!("sweep={{ key = \"material.relaxed_modulus\", values = {values} }}");
        folder.call(&["run", "scene.toml", "--set", &sweep, "--out", "DIR"]).ended(0);
        let states = table(&folder.read("DIR/states.csv"));
        let mut statuses = cells(&states, "status").to_vec();
        statuses.sort();
        assert_eq!(statuses, ["invalid", "solved"], "{values}");
        assert!(cells(&states, "reason").iter().any(|reason| reason.contains("`material.relaxed_modulus` (2e8) is above")));
    }
}

#[test]
fn sweeps_of_several_numbers_run_over_all_combinations() {
    let folder = Folder::with(SINGLE);
    folder.call(&["run", "scene.toml", "--out", "DIR", "--set", "sweep=[{ key = \"material.creep.0.retardation_time\", values = [\"1 s\", \"1 ms\"] }, { key = \"crack.speed\", from = \"1 mm/s\", to = \"3 mm/s\", points = 3, spacing = \"linear\" }]"]).ended(0);
    let states = table(&folder.read("DIR/states.csv"));
    assert_eq!(cells(&states, "material.creep.0.retardation_time [s]"), ["1", "1", "1", "0.001", "0.001", "0.001"]);
    assert_eq!(cells(&states, "crack.speed [m/s]"), ["0.001", "0.002", "0.003", "0.001", "0.002", "0.003"]);
    // A thousand times faster a material at a thousandth of the speed: not the same state, but a solved one.
    assert_eq!(cells(&states, "status"), ["solved"; 6]);
    // A count is swept in whole numbers.
    let folder = Folder::with(GOOD);
    folder
        .call(&["run", "scene.toml", "--out", "DIR", "--set", "sweep={ key = \"fields.points\", from = 2, to = 40, points = 5 }"])
        .ended(0);
    assert_eq!(cells(&table(&folder.read("DIR/states.csv")), "fields.points [1]"), ["2", "4", "9", "19", "40"]);
}

#[test]
fn every_speed_of_a_closing_cohesive_zone_is_solved() {
    // Its length runs past the one at rest before it shrinks: a bracket that trusts the limits loses slow tips.
    let folder = Folder::with(&SINGLE.replace("body =", "motion = \"closing\"\ntheories = [\"cohesive_zone\"]\nbody ="));
    let sweep = "sweep={ key = \"crack.speed\", from = 1e-14, to = 1e4, points = 73 }";
    folder.call(&["run", "scene.toml", "--set", sweep, "--out", "DIR"]).ended(0);
    let states = table(&folder.read("DIR/states.csv"));
    assert!(cells(&states, "status").iter().all(|status| status == "solved"), "{:?}", cells(&states, "status"));
    let ratio: Vec<f64> = cells(&states, "energy_release_rate_ratio [1]").iter().map(|cell| cell.parse().unwrap()).collect();
    // Rounding may hide the fall where the curve is flat, at both ends.
    assert!(ratio.windows(2).all(|pair| pair[1] <= pair[0] * (1.0 + 1e-12)), "{ratio:?}");
    assert!(ratio[0] > 0.999_99 && ratio[72] < 0.010_001, "{ratio:?}");
}

#[test]
fn a_viscous_material_is_solved() {
    let viscous =
        SINGLE.replace("relaxed_modulus = \"1 MPa\"\n", "viscosity = \"1 MPa s\"\n").replace("fraction = 1", "compliance = \"1 1/MPa\"");
    let folder = Folder::with(&viscous);
    let said = folder.call(&["run", "scene.toml", "--set", "adhesion.process_zone={ length = 1e-6 }"]).ended(0);
    assert!(said.stdout.contains("flow") && !said.stdout.contains("energy_release_rate"), "{}", said.stdout);
    folder.call(&["explain", "scene.toml"]).ended(0);
    // At rest it carries no load.
    let json = folder.call(&["run", "scene.toml", "--set", "crack.speed=0", "--json"]).ended(3).json();
    assert_eq!(json["results"][0]["status"], "undefined");
}

#[test]
fn set_takes_toml_and_bare_texts() {
    let folder = Folder::with(SINGLE);
    let speed = |set: &str| {
        folder.call(&["run", "scene.toml", "--json", "--set", set]).ended(0).json()["results"][0]["values"]["speed"]["value"].clone()
    };
    for set in [
        "crack.speed=\"2 mm/s\"",
        "crack.speed=2 mm/s",
        "crack.speed=0.002",
        " crack.speed = 2e-3 ",
        "crack.speed='2 mm/s'",
        "crack.speed=2000 µm/s",
    ] {
        assert_eq!(speed(set), 0.002, "{set}");
    }
    // Minus zero is zero, and a title is one line.
    assert_eq!(speed("crack.speed=-0.0").to_string(), "0.0");
    assert!(folder.call(&["run", "scene.toml", "--set", "title=\"a\\nb\""]).ended(0).stdout.starts_with("a b\n───"));
    // The last one counts.
    let json = folder.call(&["run", "scene.toml", "--json", "--set", "crack.speed=1", "--set", "crack.speed=3"]).ended(0).json();
    assert_eq!(json["results"][0]["values"]["speed"]["value"], 3.0);
    // A material file by --set, and a key of it set anew.
    folder
        .write("soft.toml", "[material]\nrelaxed_modulus = 1e5\nglassy_modulus = 1e7\ncreep = [{ fraction = 1, retardation_time = 1 }]\n");
    folder.write("bare.toml", SINGLE.split_once("[adhesion]").map(|(_, rest)| format!("[material]\n[adhesion]{rest}")).unwrap());
    let file = |sets: &[&str]| {
        let all = sets.iter().flat_map(|set| ["--set", set]).collect::<Vec<_>>();
        folder.call(&[&["explain", "bare.toml", "--json"], all.as_slice()].concat()).ended(0).json()["groups"][0]["value"].clone()
    };
    // The relaxed modulus comes back through 1/E0, in a few roundings.
    let near = |modulus: Value, wanted: f64| (modulus.as_f64().unwrap() / wanted - 1.0).abs() < 1e-15;
    assert!(near(file(&["material.file=soft.toml"]), 1e5));
    assert!(near(file(&["material.file=\"soft.toml\"", "material.relaxed_modulus=2e5"]), 2e5));
    assert!(near(file(&["material={ file = \"soft.toml\" }"]), 1e5));
}

#[test]
fn explain_says_what_is_left_out_and_solves_nothing() {
    let folder = Folder::with(GOOD);
    let said = folder.call(&["explain", "scene.toml"]).ended(0);
    for words in [
        "steady crack",
        "3 states",
        "effects",
        "on   memory",
        "off  flow",
        "on   fields",
        "method",
        "virtual work, opening",
        "characteristic numbers",
        "predicted work",
        "15 field points",
    ] {
        assert!(said.stdout.contains(words), "{words:?} is missing in\n{}", said.stdout);
    }
    let json = folder.call(&["explain", "scene.toml", "--json"]).ended(0).json();
    for key in ["title", "problem", "states", "effects", "method", "groups", "predicted_work", "accuracy"] {
        assert!(!json[key].is_null(), "{key}");
    }
    // So it takes no time, however long the run would be.
    let long = folder.call(&["explain", "scene.toml", "--set", "sweep.points=1000000"]).ended(0);
    assert!(long.stdout.contains("1000000 states"));
    assert!(Folder::with(SINGLE).call(&["explain", "scene.toml"]).ended(0).stdout.contains(", 1 state, "));
    // The effects of the plan are those of the run.
    let run = folder.call(&["run", "scene.toml", "--json"]).ended(0).json();
    assert_eq!((&run["effects"], &run["method"], &run["groups"]), (&json["effects"], &json["method"], &json["groups"]));
}

#[test]
fn new_gives_scenes_that_run() {
    let folder = Folder::new();
    let list = folder.call(&["new"]).ended(0).stdout;
    for template in TEMPLATES {
        assert!(list.contains(template.name) && list.contains(template.meaning), "{list}");
        let printed = folder.call(&["new", template.name]).ended(0).stdout;
        assert_eq!(printed, template.text);
        let file = format!("{}.toml", template.name);
        let said = folder.call(&["new", template.name, "--out", &file]).ended(0).stdout;
        assert!(said.contains(&format!("viscotack run {file}")), "{said}");
        assert_eq!(folder.read(&file), template.text);
        folder.call(&["explain", &file]).ended(0);
        folder.call(&["run", &file, "--out", template.name]).ended(0);
        folder.call(&["cite", &file]).ended(0);
    }
}

/// The schema of the value under a catalogue path, through lists and alternatives.
fn schema_at<'a>(schema: &'a Value, path: &str) -> Option<&'a Value> {
    if path.is_empty() {
        return Some(schema);
    }
    if let Some(alternatives) = schema["anyOf"].as_array() {
        return alternatives.iter().find_map(|alternative| schema_at(alternative, path));
    }
    let (head, tail) = path.split_once('.').unwrap_or((path, ""));
    match head.strip_suffix("[]") {
        Some(name) => schema_at(&schema["properties"].get(name)?["items"], tail),
        None => schema_at(schema["properties"].get(head)?, tail),
    }
}

/// What a scene says that the schema does not allow: a small reading of the few words of JSON Schema that are used here.
fn objections(schema: &Value, value: &Node, path: &str) -> Vec<String> {
    if let Some(alternatives) = schema["anyOf"].as_array() {
        let all: Vec<_> = alternatives.iter().map(|alternative| objections(alternative, value, path)).collect();
        return if all.iter().any(Vec::is_empty) { Vec::new() } else { all.into_iter().flatten().collect() };
    }
    let written = value.written();
    if let Some(words) = schema["oneOf"].as_array() {
        let known = matches!(&value.value, Written::Text(text) if words.iter().any(|word| word["const"] == text.as_str()));
        return if known { Vec::new() } else { vec![format!("{path}: {written} is no word of the schema")] };
    }
    let kinds: Vec<&str> = match &schema["type"] {
        Value::String(kind) => vec![kind],
        Value::Array(kinds) => kinds.iter().filter_map(Value::as_str).collect(),
        other => panic!("{path}: type {other}"),
    };
    let fits = kinds.iter().any(|kind| match *kind {
        "object" => matches!(value.value, Written::Table(_)),
        "array" => matches!(value.value, Written::List(_)),
        "string" => matches!(value.value, Written::Text(_)),
        "integer" => matches!(value.value, Written::Number(number) if number.fract() == 0.0),
        "number" => matches!(value.value, Written::Number(_)),
        "boolean" => matches!(value.value, Written::Flag(_)),
        other => panic!("{path}: type {other}"),
    });
    if !fits {
        return vec![format!("{path}: {written} is no {kinds:?}")];
    }
    match &value.value {
        Written::Table(entries) => entries
            .iter()
            .flat_map(|entry| match schema["properties"].get(&entry.key) {
                Some(below) => objections(below, &entry.node, &format!("{path}.{}", entry.key)),
                None => vec![format!("{path}.{} is not in the schema", entry.key)],
            })
            .collect(),
        Written::List(items) => items.iter().flat_map(|item| objections(&schema["items"], item, path)).collect(),
        _ => Vec::new(),
    }
}

#[test]
fn the_schema_knows_every_key_and_every_shipped_scene() {
    let schema = Folder::new().call(&["schema"]).ended(0).json();
    assert_eq!(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
    for key in catalogue::keys() {
        let found = schema_at(&schema, key.path).unwrap_or_else(|| panic!("{} is not in the schema", key.path));
        assert!(found["description"].as_str().unwrap().starts_with(key.meaning), "{}", key.path);
    }
    for path in shipped_scenes() {
        let wrong = objections(&schema, &Document::load(&path).unwrap().root, "");
        assert!(wrong.is_empty(), "{}: {}", path.display(), wrong.join("; "));
    }
}

#[test]
fn cite_prints_the_papers_behind_a_scene() {
    let folder = Folder::with(GOOD);
    let all = folder.call(&["cite"]).ended(0).stdout;
    let used = folder.call(&["cite", "scene.toml"]).ended(0).stdout;
    let entries = |text: &str| text.matches("\n@").count() + usize::from(text.starts_with('@'));
    assert!(entries(&all) > entries(&used) && entries(&used) >= 1, "{used}");
    for line in used.lines() {
        assert!(all.contains(line), "{line}");
    }
    assert!(!used.to_lowercase().contains("persson"), "a paper that the scene does not use:\n{used}");
    folder.write("both.toml", GOOD.replace("[\"virtual_work\"]", "[\"virtual_work\", \"persson_brener\"]"));
    assert!(folder.call(&["cite", "both.toml"]).ended(0).stdout.to_lowercase().contains("persson"));
}

#[test]
fn completions_are_made_for_the_common_shells() {
    let folder = Folder::new();
    for (shell, words) in [("bash", "complete -F _viscotack"), ("zsh", "#compdef viscotack"), ("fish", "complete -c viscotack")] {
        let said = folder.call(&["completions", shell]).ended(0).stdout;
        assert!(said.contains(words), "{shell}");
        for command in ["run", "explain", "new", "schema", "cite"] {
            assert!(said.contains(command), "{shell} does not know {command}");
        }
    }
}

#[test]
fn help_and_version_are_printed() {
    let folder = Folder::new();
    let help = folder.call(&["--help"]).ended(0).stdout;
    for command in ["new", "run", "explain", "schema", "cite", "completions"] {
        assert!(help.contains(command), "{help}");
    }
    assert!(folder.call(&["--version"]).ended(0).stdout.starts_with(concat!("viscotack ", env!("CARGO_PKG_VERSION"), " (")));
    assert!(folder.call(&["run", "--help"]).ended(0).stdout.contains("--set"));
}

#[test]
fn every_shipped_scene_runs_and_is_explained() {
    for path in shipped_scenes() {
        let folder = Folder::new();
        let scene = path.to_str().unwrap();
        folder.call(&["explain", scene]).ended(0);
        folder.call(&["cite", scene]).ended(0);
        let sets = shortened(&path).iter().flat_map(|set| ["--set", set]);
        let said = folder.call(&["run", scene, "--out", "DIR"].into_iter().chain(sets).collect::<Vec<_>>());
        // A scene may be shipped to show a limit: then it says so.
        assert!([0, 3].contains(&said.code), "{scene}: {}\n{}", said.code, said.stderr);
        assert!(folder.path("DIR/summary.json").is_file() && folder.path("DIR/states.csv").is_file());
    }
}

#[cfg(unix)]
#[test]
fn a_reader_that_goes_away_is_no_error_and_a_full_disk_is() {
    use std::process::{Command, Stdio};
    let folder = Folder::with(&GOOD.replace("points = 3", "points = 50"));
    let mut child =
        Command::new(env!("CARGO_BIN_EXE_viscotack")).args(["schema"]).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success() && output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
    if let Ok(full) = std::fs::OpenOptions::new().write(true).open("/dev/full") {
        let output = Command::new(env!("CARGO_BIN_EXE_viscotack"))
            .current_dir(folder.path("."))
            .args(["run", "scene.toml", "--json"])
            .stdout(full)
            .stderr(Stdio::piped())
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(5));
        assert!(String::from_utf8_lossy(&output.stderr).contains("standard output cannot be written"));
    }
}

#[test]
fn a_single_state_ends_with_its_worst_theory() {
    // On the cliff of a closing crack the virtual-work theory has a residual in extended precision, Persson and Brener's has not.
    let folder = Folder::with(
        "units = \"reduced\"\naccuracy = 1e-10\n[material]\nglassy_modulus = 1e6\nrelaxation = [{ fraction = 1, relaxation_time = 1 }]\n\
         [adhesion]\n[crack]\nmotion = \"closing\"\ntheories = [\"virtual_work\", \"persson_brener\"]\nspeed = 3.18e-7\n",
    );
    let json = folder.call(&["run", "scene.toml", "--json"]).ended(4).json();
    assert_eq!((&json["results"][0]["status"], &json["results"][1]["status"]), (&Value::from("solved"), &Value::from("inaccurate")));
    // The same two rows in a sweep: each carries its status, and what misses the accuracy is counted.
    let said = folder.call(&["run", "scene.toml", "--set", "sweep={key=\"crack.speed\",values=[3.18e-7]}"]).ended(4);
    assert!(said.stderr.contains("exit code 4: of 2 states, 1 inaccurate"), "{}", said.stderr);
    assert!(said.stdout.contains("NOT known to the accuracy 1e-10: 1 of speed_exponent"), "{}", said.stdout);
}

#[test]
fn a_sliding_contact_is_printed_and_written_like_a_crack() {
    let folder = Folder::with(SLIDING);
    let said = folder.call(&["run", "scene.toml", "--out", "DIR"]).ended(0);
    assert!(said.stderr.is_empty(), "{}", said.stderr);
    for words in [
        "adhesive, partial: solved",
        "adhesiveless, partial: solved",
        "friction_coefficient ",
        " ± ",
        "certificate: admissible",
        "linear systems",
        "slope kΛ",
    ] {
        assert!(said.stdout.contains(words), "{words:?} is missing in\n{}", said.stdout);
    }
    let states = table(&folder.read("DIR/states.csv"));
    assert_eq!(cells(&states, "contact"), ["adhesive", "adhesiveless"]);
    assert_eq!(cells(&states, "state"), ["partial", "partial"]);
    assert_eq!(cells(&states, "mean_pressure [Pa]").len(), 2);
    assert_eq!(cells(&states, "trailing_energy_release_rate [J/m²]")[1], "", "no edge energy without adhesion");
    let fields = table(&folder.read("DIR/fields.csv"));
    let names: Vec<&str> = fields.iter().map(|column| column.0.as_str()).collect();
    assert_eq!(
        names,
        [
            "contact",
            "position [m]",
            "pressure [Pa]",
            "pressure_error [Pa]",
            "gap [m]",
            "gap_error [m]",
            "displacement [m]",
            "displacement_error [m]"
        ]
    );
    assert_eq!(cells(&fields, "contact").len(), 80);
    let json = folder.call(&["run", "scene.toml", "--json"]).ended(0).json();
    assert_eq!((&json["problem"], &json["accuracy"]), (&Value::from("steady sliding"), &Value::from(1e-6)));
    assert_eq!((&json["results"][0]["contact"], &json["results"][0]["state"]), (&Value::from("adhesive"), &Value::from("partial")));
    assert!(json["work"]["linear_solves"].as_u64().unwrap() > 0 && json["work"]["kernel_evaluations"] == 0);
    for row in json["results"].as_array().unwrap() {
        for (name, value) in row["values"].as_object().unwrap() {
            let (value, error) = (value["value"].as_f64().unwrap(), value["error"].as_f64().unwrap());
            assert!(value.is_finite() && error >= 0.0 && error.is_finite(), "{name}");
        }
    }
    // A summary of a crack has the theory there, and neither of these.
    let crack = Folder::with(SINGLE).call(&["run", "scene.toml", "--json"]).ended(0).json();
    assert_eq!(crack["results"][0]["theory"], "virtual_work");
    assert!(crack["results"][0]["contact"].is_null() && crack["results"][0]["state"].is_null());
}

#[test]
fn a_full_contact_is_a_result_and_names_the_limit_that_was_passed() {
    let folder = Folder::with(SLIDING);
    let arguments = ["run", "scene.toml", "--json", "--set", "sliding.contacts=[\"adhesive\"]", "--set", "sliding.mean_pressure=200 kPa"];
    let json = folder.call(&arguments).ended(0).json();
    let row = &json["results"][0];
    assert_eq!((&row["status"], &row["state"]), (&Value::from("solved"), &Value::from("full")));
    assert!(row["reason"].as_str().unwrap().starts_with("past "), "{row}");
    assert!(row["witness"]["value"].is_f64() && row["values"]["half_width"].is_null(), "{row}");
    assert!(row["values"]["friction_stress"]["value"].as_f64().unwrap() > 0.0);
    // Pulled off: no state, exit code 3; the same as one row of a sweep is no failure.
    let gone = ["run", "scene.toml", "--json", "--set", "sliding.contacts=[\"adhesive\"]", "--set", "sliding.mean_pressure=-40 kPa"];
    let json = folder.call(&gone).ended(3).json();
    assert_eq!(json["results"][0]["status"], "no_such_state");
    assert!(json["results"][0]["witness"]["value"].as_f64().unwrap() < 0.0);
    let sweep = "sweep={ key = \"sliding.mean_pressure\", values = [\"-40 kPa\", \"6 kPa\", \"200 kPa\"] }";
    let said = folder.call(&["run", "scene.toml", "--set", "sliding.contacts=[\"adhesive\"]", "--set", sweep, "--out", "DIR"]).ended(0);
    assert!(said.stdout.contains("1 of 3 rows full: past ") && said.stdout.contains("1 of 3 rows no_such_state"), "{}", said.stdout);
    assert_eq!(cells(&table(&folder.read("DIR/states.csv")), "state"), ["", "partial", "full"]);
}

#[test]
fn explain_of_a_sliding_contact_says_what_the_counter_body_does() {
    let folder = Folder::with(SLIDING);
    let said = folder.call(&["explain", "scene.toml"]).ended(0).stdout;
    for words in
        ["steady sliding", "on   adhesion", "on   adhesiveless twin", "off  elastic counter body", "Johnson's α", "80 field points"]
    {
        assert!(said.contains(words), "{words:?} is missing in\n{said}");
    }
    let body = "sliding.counter_body={ modulus = \"3 GPa\", poisson_ratio = 0.3 }";
    let said = folder.call(&["explain", "scene.toml", "--set", body]).ended(0).stdout;
    assert!(said.contains("only its relaxed modulus matters"), "{said}");
    let cited = folder.call(&["cite", "scene.toml"]).ended(0).stdout;
    assert!(cited.contains("Johnson1995") && cited.contains("Westergaard1939") && !cited.contains("Schapery"), "{cited}");
}

/// Every row reaches the user, however many: on the screen as JSON, and in `states.csv`. `summary.json` says which it leaves out.
#[test]
fn every_row_of_a_long_sweep_is_given() {
    let folder = Folder::with(SINGLE);
    for (rows, omitted) in [(65, None), (10_001, Some(10_001))] {
        let sweep = format!("sweep={{ key = \"crack.speed\", from = \"1 µm/s\", to = \"1 m/s\", points = {rows} }}");
        let out = format!("of_{rows}");
        let said = folder.call(&["run", "scene.toml", "--json", "--set", &sweep, "--out", &out]).ended(0).json();
        let given = said["results"].as_array().unwrap();
        assert_eq!(given.len(), rows);
        let columns = table(&folder.read(&format!("{out}/states.csv")));
        let speeds: Vec<f64> = cells(&columns, "speed [m/s]").iter().map(|cell| cell.parse().unwrap()).collect();
        let same = given.iter().zip(&speeds).all(|(row, speed)| {
            let printed = row["values"]["speed"]["value"].as_f64().unwrap();
            (printed / speed - 1.0).abs() < 1e-15
        });
        assert!(same && speeds.len() == rows);
        let summary: Value = serde_json::from_str(&folder.read(&format!("{out}/summary.json"))).unwrap();
        assert_eq!(summary["rows"]["omitted"].as_u64(), omitted);
        assert_eq!(summary["results"].as_array().unwrap().len(), if omitted.is_some() { 0 } else { rows });
        assert!(said["rows"]["omitted"].is_null() && said["rows"]["total"].as_u64() == Some(rows as u64));
    }
}
