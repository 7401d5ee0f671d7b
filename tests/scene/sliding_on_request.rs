//! Source: issue "Sliding branches", parts 3, 4 and 5: columns on request, works of both edges and by speed, in scenes; README.
//!
//! Goal: what [adhesion] says of the works is what the rows are of, what `sliding.columns` asks for is there and nothing else, and SI rows obey dimensional analysis.
//!
//! Parameters: moduli, lengths, times and speeds that are no units, ν = 0.4, two retardation times; every task; a cylinder.
//!
//! Oracle: rows of plain scenes with the same works as constants; the scaling relations of the problem (any length, pressure or time unit), whose missing
//! sensitivities (load, speed, wavelength, amplitude) are differences of plain scenes; the message of each wrong scene.
//!
//! Tolerance: the bounds of both between two solutions; 1e-6 for sums with differences of scenes at accuracy 1e-10 and steps of 1 %.
#![allow(clippy::unwrap_used, clippy::panic, clippy::float_cmp, missing_docs)]

use std::collections::HashMap;
use std::path::Path;
use viscotack::Estimate;
use viscotack_program::outcome::{Row, Status};
use viscotack_program::plan::Plan;
use viscotack_program::scene::{Document, Scene, read};

type Values = HashMap<&'static str, Estimate>;

fn document(text: &str, folder: &Path) -> Document {
    let mut document = Document::parse("test.toml", text.to_owned(), folder).unwrap_or_else(|error| panic!("{}", error.rendered()));
    read::resolve_includes(&mut document).unwrap_or_else(|error| panic!("{}", error.rendered()));
    document
}

fn parsed(text: &str) -> Scene {
    read::read(&document(text, Path::new("."))).unwrap_or_else(|error| panic!("{}\n{text}", error.rendered()))
}

fn rows(text: &str) -> Vec<(Row, Values)> {
    let plan = Plan::new(&parsed(text)).unwrap();
    let columns = plan.columns();
    plan.solve(0, &[])
        .into_iter()
        .map(|row| {
            assert_eq!(row.values.len(), columns.len(), "{text}");
            let values = columns.iter().zip(&row.values).filter_map(|(column, value)| Some((column.name, (*value)?))).collect();
            (row, values)
        })
        .collect()
}

fn solved(text: &str) -> Values {
    let (row, values) = rows(text).remove(0);
    assert_eq!(row.status, Status::Solved, "{:?} {:?}\n{text}", row.labels, row.reason);
    values
}

fn refusal(text: &str) -> String {
    let mut document = match Document::parse("test.toml", text.to_owned(), Path::new(".")) {
        Ok(document) => document,
        Err(error) => return error.rendered(),
    };
    let error = read::resolve_includes(&mut document).err().or_else(|| read::read(&document).err());
    error.unwrap_or_else(|| panic!("no error\n{text}")).rendered()
}

/// Every number of an SI scene that an output may depend on.
#[derive(Clone, Copy)]
struct Inputs {
    modulus: f64,
    time: f64,
    wavelength: f64,
    amplitude: f64,
    works: [f64; 2],
    zone: f64,
    speed: f64,
    load: f64,
}

const INPUTS: Inputs =
    Inputs { modulus: 1.3e6, time: 0.02, wavelength: 7e-5, amplitude: 2e-6, works: [0.014, 0.009], zone: 1.7e-7, speed: 1e-4, load: 9e3 };

fn material(inputs: Inputs) -> String {
    let Inputs { modulus, time, .. } = inputs;
    format!(
        "accuracy = 1e-10\n[material]\nrelaxed_modulus = {modulus:e}\nglassy_modulus = {:e}\npoisson_ratio = 0.4\n\
         creep = [{{ fraction = 0.3, retardation_time = {time:e} }}, {{ fraction = 0.7, retardation_time = {:e} }}]\n",
        12.0 * modulus,
        0.1 * time
    )
}

fn scene(inputs: Inputs, works: &str, rest: &str) -> String {
    let Inputs { wavelength, amplitude, zone, speed, .. } = inputs;
    format!(
        "{}[adhesion]\n{works}\nprocess_zone = {{ length = {zone:e} }}\n[sliding]\nwave = {{ wavelength = {wavelength:e}, amplitude = {amplitude:e} }}\n\
         speed = {speed:e}\n{rest}\n",
        material(inputs)
    )
}

fn per_edge([trailing, leading]: [f64; 2]) -> String {
    format!("trailing_work_of_adhesion = {trailing:e}\nleading_work_of_adhesion = {leading:e}")
}

fn state(inputs: Inputs, rest: &str) -> String {
    scene(inputs, &per_edge(inputs.works), &format!("mean_pressure = {:e}\n{rest}", inputs.load))
}

#[test]
fn columns_are_there_on_request_only() {
    let names =
        |text: &str| -> Vec<&'static str> { Plan::new(&parsed(text)).unwrap().columns().iter().map(|column| column.name).collect() };
    let plain = |rest: &str| scene(INPUTS, "work_of_adhesion = 0.01", rest);
    let load = "mean_pressure = 9e3";
    assert_eq!(names(&plain(load)).len(), 20);
    assert_eq!(names(&plain(&format!("{load}\nframe_stiffness = 1e9"))).len(), 21);
    assert_eq!(names(&plain("[sliding.strength]")).len(), 14);
    assert_eq!(names(&plain("[sliding.branch]\nparameter = \"half_width\"")).len(), 21);
    for (asked, of_state, of_strength, of_branch) in [
        ("friction_parts", Some(3), None, Some(3)),
        ("elastic_reference_contact", Some(4), Some(6), None),
        ("sensitivities", Some(15), Some(20), None),
    ] {
        let with = |rest: &str| plain(&format!("columns = [\"{asked}\"]\n{rest}"));
        for (rest, base, more) in
            [(load, 20, of_state), ("[sliding.strength]", 14, of_strength), ("[sliding.branch]\nparameter = \"half_width\"", 21, of_branch)]
        {
            match more {
                Some(more) => assert_eq!(names(&with(rest)).len(), base + more, "{asked} {rest}"),
                None => assert!(refusal(&with(rest)).contains(asked), "{asked} {rest}"),
            }
        }
    }
    assert_eq!(names(&state(INPUTS, "")).len(), 22);
    let work = |rest: &str| {
        let found = solved(&plain(rest));
        found.len()
    };
    assert_eq!(work(load), 20);
}

#[test]
fn rows_have_the_works_of_their_edges_and_speed() {
    let entry = |speed: f64, [trailing, leading]: [f64; 2]| {
        format!("{{ speed = {speed:e}, trailing_work_of_adhesion = {trailing:e}, leading_work_of_adhesion = {leading:e} }}")
    };
    // 1e-4 m/s is half way between 1e-6 and 1e-2 in its logarithm.
    let table = format!("[adhesion.by_speed]\ntable = [{}, {}]", entry(1e-6, [0.007, 0.01]), entry(1e-2, [0.028, 0.0081]));
    let folder = std::env::temp_dir().join(format!("viscotack-works-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(
        folder.join("works.csv"),
        "# a comment\n\nspeed, leading_work_of_adhesion,trailing_work_of_adhesion\n1 µm/s, 10 mJ/m², 0.007\r\n0.01, 0.0081, 28 mJ/m²\n",
    )
    .unwrap();
    let with_table = |by_speed: &str| {
        let base = scene(INPUTS, "", "mean_pressure = 9e3");
        let (head, tail) = base.split_once("[sliding]").unwrap();
        format!("{head}{by_speed}\n[sliding]{tail}")
    };
    let from_file = {
        let scene = read::read(&document(&with_table("[adhesion.by_speed]\nfile = \"works.csv\""), &folder)).unwrap();
        let plan = Plan::new(&scene).unwrap();
        let row = plan.solve(0, &[]).remove(0);
        plan.columns().iter().zip(&row.values).filter_map(|(column, value)| Some((column.name, (*value)?))).collect::<Values>()
    };
    // The same with decimal commas, units in the header, and a line that is none of the table.
    std::fs::write(
        folder.join("commas.csv"),
        "Klebstoff 7\nspeed (µm/s);leading work of adhesion (mJ/m²);trailing work of adhesion (mJ/m²)\n1,0;10,0;7,0\n10000;8,1;28,0\n",
    )
    .unwrap();
    let commas = read::read(&document(&with_table("[adhesion.by_speed]\nfile = \"commas.csv\""), &folder)).unwrap();
    assert!(commas.material.notes.iter().any(|note| note.contains("decimal commas")), "{:?}", commas.material.notes);
    assert!(commas.material.notes.iter().any(|note| note.contains("passed over")), "{:?}", commas.material.notes);
    let from_commas = {
        let plan = Plan::new(&commas).unwrap();
        let row = plan.solve(0, &[]).remove(0);
        plan.columns().iter().zip(&row.values).filter_map(|(column, value)| Some((column.name, (*value)?))).collect::<Values>()
    };
    std::fs::remove_dir_all(&folder).unwrap();
    // Γ₀(1 + (v/v₀)ⁿ) = 2.5 Γ₀ at v = 2.25 v₀ with n = ½.
    let law = |works: [f64; 2]| {
        let by_speed = "by_speed = { speed = 4.444444444444444e-5, exponent = 0.5 }";
        scene(INPUTS, &format!("{}\n{by_speed}", per_edge(works.map(|work| work / 2.5))), "mean_pressure = 9e3")
    };
    let constant = solved(&state(INPUTS, ""));
    for (name, found) in
        [("table", solved(&with_table(&table))), ("file", from_file), ("commas", from_commas), ("law", solved(&law(INPUTS.works)))]
    {
        for (column, expected) in &constant {
            let found = found.get(column).unwrap_or_else(|| panic!("{name}: no {column}"));
            let allowed = found.error + expected.error + 1e-12 * expected.value.abs();
            assert!((found.value - expected.value).abs() <= allowed, "{name}, {column}: {found:?} {expected:?}");
        }
    }
    assert!((constant["trailing_work_of_adhesion"].value - 0.014).abs() < 1e-16);
    assert!((constant["leading_work_of_adhesion"].value - 0.009).abs() < 1e-16);
    // Each release rate is in J/m² and falls short of the work of its own edge by what is not stored.
    for (edge, work) in [("trailing", 0.014), ("leading", 0.009)] {
        let release = constant.iter().find(|(name, _)| **name == format!("{edge}_energy_release_rate")).unwrap().1.value;
        let rest = constant.iter().find(|(name, _)| **name == format!("{edge}_nonconservative_work")).unwrap().1.value;
        assert!((release + rest - work).abs() < 1e-14, "{edge}");
    }
    let edges = (constant["trailing_energy_release_rate"].value - constant["leading_energy_release_rate"].value) / INPUTS.wavelength;
    assert!((constant["adhesive_friction_stress"].value - edges).abs() < 1e-9 * edges.abs());
}

#[test]
fn branches_and_strengths_have_the_works_of_their_speed() {
    let by_speed = "by_speed = { speed = 1e-4, exponent = 0.5 }";
    let along = scene(
        Inputs { speed: 0.0, ..INPUTS },
        &format!("work_of_adhesion = 0.006\n{by_speed}"),
        "mean_pressure = 9e3\n[sliding.branch]\nparameter = \"speed\"\nfrom = 1e-6\nto = 1e-3\npoints = 6",
    )
    .replace("speed = 0e0\n", "");
    let mut points = 0;
    for (row, values) in rows(&along) {
        assert!(row.status.has_values(), "{:?}", row.reason);
        let speed = values["speed"].value;
        let expected = 0.006 * (1.0 + (speed / 1e-4).sqrt());
        for name in ["work_of_adhesion", "leading_work_of_adhesion"] {
            assert!((values[name].value - expected).abs() <= values[name].error + 1e-13, "{name} at {speed}");
        }
        // Release rates in J/m² of the work at that speed.
        let release = values["trailing_energy_release_rate"].value + values["trailing_nonconservative_work"].value;
        assert!((release - expected).abs() < 1e-9 * expected, "{speed}: {release}");
        if row.label(3).is_empty() {
            let plain = solved(&scene(Inputs { speed, ..INPUTS }, &format!("work_of_adhesion = {expected:e}"), "mean_pressure = 9e3"));
            let (found, expected) = (values["half_width"], plain["half_width"]);
            assert!((found.value - expected.value).abs() <= found.error + expected.error + 1e-9 * expected.value, "{speed}");
            points += 1;
        }
    }
    assert!(points >= 5, "{points}");
    let strength = |works: &str| solved(&scene(INPUTS, works, "[sliding.strength]"));
    let (found, plain) = (strength(&format!("work_of_adhesion = 0.006\n{by_speed}")), strength("work_of_adhesion = 0.012"));
    for (name, expected) in &plain {
        let allowed = found[name].error + expected.error + 1e-12 * expected.value.abs();
        assert!((found[name].value - expected.value).abs() <= allowed, "{name}: {:?} {expected:?}", found[name]);
    }
}

/// The logarithmic derivative of outputs by one number of the scene, by differences of plain scenes.
fn by_differences(names: &[&'static str], of: impl Fn(f64) -> String) -> Vec<f64> {
    let at = |logarithm: f64| {
        let values = solved(&of(f64::exp(logarithm)));
        names.iter().map(|name| values[name].value.abs().ln()).collect::<Vec<f64>>()
    };
    let slope = |step: f64| at(step).iter().zip(at(-step)).map(|(after, before)| (after - before) / (2.0 * step)).collect::<Vec<f64>>();
    slope(0.01).into_iter().zip(slope(0.02)).map(|(near, far)| (4.0 * near - far) / 3.0).collect()
}

#[test]
fn sensitivities_of_a_scene_obey_dimensional_analysis() {
    let outputs = ["half_width", "friction_stress", "penetration"];
    let found = solved(&state(INPUTS, "columns = [\"sensitivities\"]"));
    let of = |output: &str, parameter: &str| {
        let name = format!("{output}_by_{parameter}");
        found.iter().find(|(column, _)| **column == name).unwrap_or_else(|| panic!("no {name}")).1.value
    };
    let by = |vary: fn(&mut Inputs, f64)| {
        by_differences(&outputs, |factor| {
            let mut inputs = INPUTS;
            vary(&mut inputs, factor);
            state(inputs, "")
        })
    };
    let speed = by(|inputs, factor| inputs.speed *= factor);
    let load = by(|inputs, factor| inputs.load *= factor);
    let wavelength = by(|inputs, factor| inputs.wavelength *= factor);
    let amplitude = by(|inputs, factor| inputs.amplitude *= factor);
    let modulus = by(|inputs, factor| inputs.modulus *= factor);
    let time = by(|inputs, factor| inputs.time *= factor);
    // How an output scales with the units of length, pressure and time.
    for (index, (output, length, pressure)) in
        [("half_width", 1.0, 0.0), ("friction_stress", 0.0, 1.0), ("penetration", 1.0, 0.0)].into_iter().enumerate()
    {
        let (zone, work, e0, tau) =
            (of(output, "process_zone"), of(output, "work_of_adhesion"), of(output, "relaxed_modulus"), of(output, "time"));
        for (name, sum, expected) in [
            ("times against the speed", tau, speed[index]),
            ("times themselves", tau, time[index]),
            ("E0 itself", e0, modulus[index]),
            ("unit of pressure", e0 + work + load[index], pressure),
            ("unit of length", zone + work + speed[index] + wavelength[index] + amplitude[index], length),
        ] {
            println!("{output}, {name}: {sum} {expected}");
            assert!((sum - expected).abs() < 1e-6, "{output}, {name}: {sum} instead of {expected}");
        }
    }
}

#[test]
fn sensitivities_of_strengths_obey_dimensional_analysis() {
    // What the half-width at pull-off can be known to.
    let text = |rest: &str| scene(INPUTS, &per_edge(INPUTS.works), rest).replace("accuracy = 1e-10", "accuracy = 1e-9");
    let found = solved(&text("columns = [\"sensitivities\"]\n[sliding.strength]"));
    let of = |name: &str| found.iter().find(|(column, _)| **column == name).unwrap_or_else(|| panic!("no {name}")).1;
    // No load is prescribed: pressures and works make up the unit of pressure.
    for (output, pressure) in [("pull_off_pressure", 1.0), ("snap_in_pressure", 1.0), ("separation_penetration", 0.0), ("toughness", 1.0)] {
        let (e0, work) = (of(&format!("{output}_by_relaxed_modulus")), of(&format!("{output}_by_work_of_adhesion")));
        assert!((e0.value + work.value - pressure).abs() <= e0.error + work.error + 1e-12, "{output}: {e0:?} {work:?}");
    }
    // An elastic solid knows neither β nor times.
    let elastic =
        text("columns = [\"sensitivities\"]\n[sliding.strength]").split("creep").next().unwrap().replace("glassy_modulus = 1.56e7\n", "")
            + text("columns = [\"sensitivities\"]\n[sliding.strength]").split_once("}]\n").unwrap().1;
    let found = solved(&elastic);
    assert!(!found.contains_key("pull_off_pressure_by_stiffening_ratio") && found["pull_off_pressure_by_time"].value == 0.0);
}

/// Johnson's pull-off as δ → 0, its derivative by the envelope: ∂ln|p|/∂ln Γ = ½ α√tan x/|p| with p = sin²x − α√tan x in units of p*.
#[test]
fn the_sensitivity_of_johnsons_pull_off_is_its_closed_form() {
    let work = 0.004_f64;
    let of_zone = |zone: f64| {
        let text = format!(
            "units = \"reduced\"\naccuracy = 1e-10\n[material]\nrelaxed_modulus = 1\n[adhesion]\nwork_of_adhesion = {work}\nprocess_zone = {{ length = {zone:e} }}\n\
             [sliding]\nwave = {{}}\nspeed = 1\ncolumns = [\"sensitivities\"]\n[sliding.strength]\n"
        );
        let found = solved(&text);
        [found["pull_off_pressure_by_work_of_adhesion"].value, found["pull_off_pressure_by_process_zone"].value]
    };
    let [coarse, middle, fine] = [4e-4, 2e-4, 1e-4].map(of_zone);
    let (first, second) = (2.0 * middle[0] - coarse[0], 2.0 * fine[0] - middle[0]);
    let found = (4.0 * second - first) / 3.0;
    let alpha = 2.0 * work.sqrt();
    let load = |x: f64| x.sin().powi(2) - alpha * x.tan().sqrt();
    // Its minimum by golden section.
    let (mut low, mut high) = (0.01_f64, 0.6_f64);
    for _ in 0..200 {
        let (one, two) = (high - 0.618_033_988_749_895 * (high - low), low + 0.618_033_988_749_895 * (high - low));
        if load(one) < load(two) { high = two } else { low = one }
    }
    let expected = 0.5 * alpha * low.tan().sqrt() / load(low).abs();
    println!("∂ln|p_out|/∂ln Γ: {found} against {expected}, and by δ {fine:?}");
    assert!((found - expected).abs() < 1e-7);
    // The process zone matters less the shorter it is, in proportion.
    assert!((fine[1] / middle[1] - 0.5).abs() < 0.01 && fine[1].abs() < 1e-3);
}

#[test]
fn parts_of_friction_add_up() {
    let found = solved(&state(INPUTS, "columns = [\"friction_parts\", \"elastic_reference_contact\"]"));
    let (all, edges, bulk) = (found["friction_stress"], found["adhesive_friction_stress"], found["bulk_friction_stress"]);
    assert!((all.value - edges.value - bulk.value).abs() < 1e-14 * all.value.abs());
    let share = found["edge_share"];
    assert!((share.value * all.value - edges.value).abs() < 1e-12 * all.value && share.error < 1e-6);
    let regime = found["regime"].value;
    assert_eq!(
        regime,
        if (1.0 - share.value).abs() <= 0.1 {
            1.0
        } else if share.value <= 0.1 {
            -1.0
        } else {
            0.0
        }
    );
    // |E(ω)| at ω = kv, by hand from the creep function.
    let omega = 2.0 * std::f64::consts::PI / INPUTS.wavelength * INPUTS.speed;
    let plane = 1.0 - 0.4 * 0.4;
    let (mut real, mut imaginary) = (1.0 / 12.0, 0.0);
    for (share, time) in [(0.3, 0.02), (0.7, 0.002)] {
        let (gained, x) = (share * (1.0 - 1.0 / 12.0), omega * time);
        real += gained / (1.0 + x * x);
        imaginary += gained * x / (1.0 + x * x);
    }
    let modulus = 1.3e6 / plane / f64::hypot(real, imaginary);
    assert!((found["dynamic_modulus"].value - modulus).abs() < 1e-12 * modulus);
    assert_eq!(found["elastic_mean_pressure"].value, found["mean_pressure"].value);
}

#[test]
fn wrong_works_are_refused_with_a_reason() {
    let load = "mean_pressure = 9e3";
    let with = |works: &str| refusal(&scene(INPUTS, works, load));
    for (works, reason) in [
        ("trailing_work_of_adhesion = 0.01", "`adhesion.leading_work_of_adhesion` is missing"),
        ("work_of_adhesion = 0.01\nleading_work_of_adhesion = 0.01", "exclude each other"),
        ("work_of_adhesion = 0.01\nby_speed = { speed = 1e-4 }", "`adhesion.by_speed.exponent` is missing"),
        ("work_of_adhesion = 0.01\nby_speed = { }", "is missing"),
        ("work_of_adhesion = 0.01\nby_speed = { speed = 1e-4, exponent = 0 }", "must be greater than 0"),
        (
            "work_of_adhesion = 0.01\nby_speed = { table = [{ speed = 1e-5, work_of_adhesion = 0.01 }, { speed = 1e-3, work_of_adhesion = 0.02 }] }",
            "the table holds the works themselves",
        ),
        (
            "by_speed = { table = [{ speed = 1e-3, work_of_adhesion = 0.01 }, { speed = 1e-5, work_of_adhesion = 0.02 }] }",
            "must grow from entry to entry",
        ),
        (
            "by_speed = { table = [{ speed = 1e-3, work_of_adhesion = 0.01 }, { speed = 1e-2, work_of_adhesion = 0.02 }] }",
            "lies outside the table",
        ),
        ("by_speed = { table = [{ speed = 1e-3, work_of_adhesion = 0.01 }] }", "cannot be used"),
        ("by_speed = { table = [] }", "empty list"),
        ("by_speed = { file = \"no_such_file.csv\" }", "cannot be read"),
    ] {
        let found = with(works);
        assert!(found.contains(reason), "{works}\n{found}");
    }
    let no_adhesion = refusal(&format!(
        "{}[sliding]\nwave = {{ wavelength = 7e-5, amplitude = 2e-6 }}\nspeed = 1e-4\nmean_pressure = 9e3\ncolumns = [\"sensitivities\"]\n",
        material(INPUTS)
    ));
    assert!(no_adhesion.contains("no [adhesion]"), "{no_adhesion}");
    let cohesive = scene(
        INPUTS,
        "work_of_adhesion = 0.01\nby_speed = { speed = 1e-4, exponent = 0.5 }",
        "mean_pressure = 9e3\n[sliding.branch]\nparameter = \"speed\"\nfrom = 1e-5\nto = 1e-3",
    )
    .replace("process_zone = { length = 1.7e-7 }", "process_zone = { cohesive_stress = 2e5 }")
    .replace("speed = 1e-4\nmean", "mean");
    assert!(refusal(&cohesive).contains("cohesive stress"), "{}", refusal(&cohesive));
    let cylinder = state(INPUTS, "columns = [\"elastic_reference_contact\"]")
        .replace("wave = { wavelength = 7e-5, amplitude = 2e-6 }", "cylinder = { radius = 1e-3 }")
        .replace("mean_pressure", "load_per_width");
    assert!(refusal(&cylinder).contains("wave number"), "{}", refusal(&cylinder));
}

#[test]
fn a_crack_of_given_speed_takes_the_work_at_that_speed() {
    let crack = |works: &str, motion: &str, control: &str| {
        format!(
            "{}[adhesion]\n{works}\nprocess_zone = {{ length = 1.7e-7 }}\n[crack]\nmotion = \"{motion}\"\nbody = \"against_rigid\"\nplane = \"strain\"\n{control}\n",
            material(INPUTS)
        )
    };
    let by_speed = "by_speed = { table = [{ speed = 1e-6, trailing_work_of_adhesion = 0.007, leading_work_of_adhesion = 0.01 }, { speed = 1e-2, trailing_work_of_adhesion = 0.028, leading_work_of_adhesion = 0.0081 }] }";
    for (motion, work) in [("opening", 0.014), ("closing", 0.009)] {
        let found = solved(&crack(by_speed, motion, "speed = 1e-4"));
        let plain = solved(&crack(&format!("work_of_adhesion = {work}"), motion, "speed = 1e-4"));
        for (name, expected) in &plain {
            assert!((found[name].value - expected.value).abs() <= 1e-12 * expected.value.abs(), "{motion} {name}");
        }
    }
    assert!(refusal(&crack(by_speed, "opening", "energy_release_rate = 0.1")).contains("crack.speed"));
    assert!(
        refusal(&crack("trailing_work_of_adhesion = 1\nleading_work_of_adhesion = 1", "opening", "speed = 1e-4"))
            .contains("sliding contact")
    );
}
