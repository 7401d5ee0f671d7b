//! Liquids (relaxed modulus 0) where the theory allows them: under a sliding wave, and under an adhesive sphere.
//!
//! Source: Westergaard (1939) and Johnson, *Contact Mechanics* (1985), section 13.2;
//! the complex modulus of Maxwell and Burgers materials; Johnson, Kendall and Roberts (1971).
//! Goal: what is the limit of solids is solved, with its error; what has no limit is refused with the reason and a remedy that works.
//! Oracle: the closed forms of full contact (friction Λ²k² Im E*/4) and of fast sliding (Westergaard with E∞), JKR of a contact that has had no time to flow;
//! solids of ever softer rest, whose difference falls with their relaxed modulus.
//! Tolerance: the stated bounds; 1 % of JKR, as a process zone is not zero; 2e-3 of Westergaard at kvρ = 1e4.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, missing_docs)]

use crate::command_support;

use command_support::Folder;
use serde_json::Value;
use std::f64::consts::{PI, TAU};

fn run(text: &str) -> Value {
    Folder::with(text).call(&["run", "scene.toml", "--json"]).ended(0).json()
}

fn cell(json: &Value, column: &str) -> (f64, f64) {
    let value = &json["results"][0]["values"][column];
    (value["value"].as_f64().unwrap_or_else(|| panic!("no {column} in {json}")), value["error"].as_f64().unwrap())
}

fn wave(material: &str, speed: f64, pressure: f64, rest: &str) -> String {
    format!(
        "accuracy = 1e-6\n[material]\npoisson_ratio = 0.4\n{material}\n{rest}\n[sliding]\nspeed = {speed}\nmean_pressure = {pressure}\n[sliding.wave]\nwavelength = 1e-4\namplitude = 1e-6\n"
    )
}

const MAXWELL: &str = "relaxed_modulus = 0\nrelaxation = [{ modulus = 1.3e6, relaxation_time = 0.1 }]";
const BURGERS: &str = "glassy_modulus = 2e6\nviscosity = 4e5\ncreep = [{ compliance = 8e-7, retardation_time = 0.02 }]";

#[test]
fn a_wave_in_full_contact_has_the_friction_of_the_complex_modulus() {
    let wavenumber = TAU / 1e-4;
    let omega = wavenumber * 1e-3;
    let stiffening = 1.0 / (1.0 - 0.16);
    let maxwell = 1.3e6 * (omega * 0.1) / (1.0 + (omega * 0.1_f64).powi(2));
    // Burgers: J* = 1/E∞ + J1/(1 + iωθ) + 1/(iωη).
    let x = omega * 0.02;
    let (real, imaginary) = (5e-7 + 8e-7 / (1.0 + x * x), -8e-7 * x / (1.0 + x * x) - 1.0 / (omega * 4e5));
    let burgers = -imaginary / (real * real + imaginary * imaginary);
    for (material, loss) in [(MAXWELL, maxwell), (BURGERS, burgers)] {
        let (friction, bound) = cell(&run(&wave(material, 1e-3, 3e5, "")), "friction_stress");
        let right = 1e-12 * wavenumber * wavenumber * stiffening * loss / 4.0;
        assert!((friction - right).abs() <= bound + 1e-9 * right, "{friction:e} ± {bound:e} instead of {right:e}");
        assert!(bound < 1e-6 * right);
    }
}

#[test]
fn a_liquid_under_a_fast_wave_is_glassy_and_any_is_the_limit_of_solids() {
    // kvρ = 6e3: glassy. sin²(ka/2) = p̄/p*, p* = πE*Λ/λ.
    let full = PI * 1.3e6 / (1.0 - 0.16) * 1e-6 / 1e-4;
    let right = 1e-4 / PI * (4e3 / full).sqrt().asin();
    let (width, _) = cell(&run(&wave(MAXWELL, 1.0, 4e3, "")), "half_width");
    assert!((width / right - 1.0).abs() < 2e-3, "{width:e} {right:e}");
    // Slower: a solid of 1/1000 of the modulus at rest lies off by about that much, one of a tenth of it by a tenth.
    for adhesion in ["", "[adhesion]\nwork_of_adhesion = 1e-3\nprocess_zone = { length = 1e-7 }"] {
        let liquid = run(&wave(MAXWELL, 1e-3, 3e3, adhesion));
        let solid = |relaxed: f64| {
            run(&wave(&MAXWELL.replace("relaxed_modulus = 0", &format!("relaxed_modulus = {relaxed}")), 1e-3, 3e3, adhesion))
        };
        let [soft, softer] = [1e3, 1e2].map(solid);
        for column in ["half_width", "friction_stress", "penetration"] {
            let (value, bound) = cell(&liquid, column);
            let [far, near] = [&soft, &softer].map(|solid| cell(solid, column).0 - value);
            assert!((far / near - 10.0).abs() < 0.1, "{column}: {far:e} {near:e}");
            // One more order by hand.
            let line = value + near + (near - far) / 9.0;
            assert!((line - value).abs() <= bound + 2e-3 * near.abs(), "{column}: {line:e} {value:e} {bound:e}");
        }
    }
}

#[test]
fn an_adhesive_liquid_sphere_is_pulled_off() {
    let scene = |duration: f64, modulus: &str| {
        format!(
            "accuracy = 1e-2\n[material]\npoisson_ratio = 0.5\n{modulus}\n[adhesion]\nwork_of_adhesion = 0.05\nprocess_zone = {{ length = 2e-7 }}\n[indentation]\nsphere = {{ radius = 1e-3 }}\ninstants = 2\n[[history]]\npenetration = -3e-5\nduration = {duration}\n"
        )
    };
    let pull_off = |json: &Value| {
        let rows = json["results"].as_array().unwrap();
        let row = rows.iter().find(|row| row["event"] == "largest_tension").unwrap();
        row["values"]["force"]["value"].as_f64().unwrap()
    };
    // No time to flow: JKR.
    let liquid = "relaxed_modulus = 0\nrelaxation = [{ modulus = 1e6, relaxation_time = 10 }]";
    let fast = pull_off(&run(&scene(1e-3, liquid)));
    assert!((fast / (-1.5 * PI * 0.05 * 1e-3) - 1.0).abs() < 0.02, "{fast:e}");
    // A solid of nearly no modulus at rest is the same when there is time.
    let slow = pull_off(&run(&scene(20.0, liquid)));
    let solid = pull_off(&run(&scene(20.0, &liquid.replace("relaxed_modulus = 0", "relaxed_modulus = 1e-2"))));
    assert!(slow < fast && (slow / solid - 1.0).abs() < 2e-2, "{slow:e} {solid:e} {fast:e}");
}

#[test]
fn what_a_liquid_cannot_have_is_refused_with_a_remedy() {
    let sphere = format!(
        "[material]\npoisson_ratio = 0.5\n{MAXWELL}\n[adhesion]\nwork_of_adhesion = 0.05\nprocess_zone = {{ length = 2e-6 }}\n[indentation]\nsphere = {{ radius = 1e-3 }}\nstart = \"relaxed\"\nforce = 0\n[[history]]\npenetration = -3e-5\nduration = 1\n"
    );
    let sliding = wave(MAXWELL, 1e-3, 3e3, "[adhesion]\nwork_of_adhesion = 1e-3\nprocess_zone = { cohesive_stress = 1e5 }");
    let cylinder =
        format!("[material]\npoisson_ratio = 0.4\n{MAXWELL}\n[sliding]\nspeed = 1e-3\nhalf_width = 1e-5\ncylinder = {{ radius = 1e-3 }}\n");
    for (text, says) in [
        (sphere, "use start = \"untouched\""),
        (sliding.clone(), "process_zone = { length"),
        (cylinder, "it is infinite; give a wave"),
        (wave(MAXWELL, 0.0, 3e3, ""), "give a speed"),
        (
            wave(MAXWELL, 1e-3, 3e3, "")
                .replace("mean_pressure = 3000", "[sliding.strength]")
                .replace("[sliding.wave]", "[adhesion]\nwork_of_adhesion = 1e-3\nprocess_zone = { length = 1e-7 }\n[sliding.wave]"),
            "sweep the load",
        ),
    ] {
        let answer = Folder::with(&text).call(&["run", "scene.toml"]).ended(2);
        assert!(answer.stderr.contains("liquid") || answer.stderr.contains("relaxed modulus E0 is 0"), "{}", answer.stderr);
        assert!(answer.stderr.contains(says), "{says}: {}", answer.stderr);
    }
    let mended = sliding.replace("cohesive_stress = 1e5", "length = 1e-7");
    Folder::with(&mended).call(&["run", "scene.toml"]).ended(0);
}
