//! What `explain` predicts is what a run then costs, and what is left out costs nothing.
//!
//! Contract: the design's "predicted cost", and "a table that is absent is an effect that is not simulated".
//! Goal: the predicted numbers of balances, kernel evaluations, linear systems and field points against the counters of the run; counters of left-out
//! effects are zero.
//! Parameters: every shipped scene, long ones with fewer cycles; and crossings of motion, body, control, process-zone law, theory, material and accuracy.
//! Oracle: the counters that the run itself keeps.
//! Tolerance: a factor of 3 for the iterative parts (the number of Newton steps depends on the state), none for field points and zeros.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use crate::command_support;

use command_support::{DELAYED, GOOD, SINGLE, SLIDING, shipped_scenes, shortened};
use std::path::Path;
use viscotack_program::outcome::{Outcome, Work};
use viscotack_program::plan::{self, Plan};
use viscotack_program::scene::{Document, Scene, read};

/// What a scene was predicted to cost, and its outcome.
fn solved(mut document: Document, sets: &[&str]) -> (Work, Outcome) {
    read::resolve_includes(&mut document).unwrap();
    for set in sets {
        document.set(set).unwrap();
    }
    let scene: Scene = read::read(&document).unwrap_or_else(|error| panic!("{}", error.rendered()));
    let predicted = Plan::new(&scene).unwrap().predicted_work();
    (predicted, plan::run(&document, &scene, Vec::new(), None, &|_| {}).unwrap())
}

fn parsed(text: &str) -> Document {
    Document::parse("scene.toml", text.to_owned(), Path::new(".")).unwrap()
}

fn work(text: &str, sets: &[&str]) -> Work {
    solved(parsed(text), sets).1.work()
}

/// What is wrong with a prediction; nothing if it is good.
fn misprediction(predicted: Work, outcome: &Outcome) -> Option<String> {
    let counted = outcome.work();
    // States that turn out not to exist are found out by a comparison, before any work: they cannot be predicted and are taken out.
    let (all, valued) = (outcome.rows.len() as u64, outcome.rows.iter().filter(|row| row.status.has_values()).count() as u64);
    let near = |predicted: u64, counted: u64| {
        let predicted = (predicted * valued).div_ceil(all);
        predicted <= 3 * counted && counted <= 3 * predicted
    };
    let good = near(predicted.closure_evaluations, counted.closure_evaluations)
        && near(predicted.kernel_evaluations, counted.kernel_evaluations)
        && near(predicted.linear_solves, counted.linear_solves)
        && (predicted.field_evaluations * valued).div_ceil(all) == counted.field_evaluations;
    (!good).then(|| format!("predicted {predicted:?}, counted {counted:?}, {valued} of {all} rows have values"))
}

#[test]
fn every_shipped_scene_costs_what_is_predicted() {
    let mut wrong = Vec::new();
    for path in shipped_scenes() {
        let (predicted, outcome) = solved(Document::load(&path).unwrap(), shortened(&path));
        wrong.extend(misprediction(predicted, &outcome).map(|failure| format!("{}: {failure}", path.display())));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_kind_of_scene_costs_what_is_predicted() {
    let mut wrong = Vec::new();
    let mut cases = 0;
    for motion in ["opening", "closing"] {
        for theory in ["virtual_work", "persson_brener", "cohesive_zone"] {
            for zone in ["growing", "constant", "schapery", "length"] {
                if (zone == "schapery" && (motion == "opening" || theory == "persson_brener"))
                    || (zone == "length" && theory == "cohesive_zone")
                {
                    continue;
                }
                for control in ["speed", "energy_release_rate", "rest"] {
                    for accuracy in ["1e-3", "1e-9", "1e-13"] {
                        for material in ["one", "five", "elastic"] {
                            if material == "elastic" && control == "energy_release_rate" {
                                continue;
                            }
                            let closing = if motion == "closing" { ("0.011", "0.99") } else { ("1.01", "90") };
                            let (key, from, to) = match control {
                                "speed" => ("speed", "1e-9", "1e3"),
                                "rest" => ("speed", "0", "0"),
                                _ => ("energy_release_rate", closing.0, closing.1),
                            };
                            let terms = match material {
                                "one" => "creep = [{ fraction = 1, retardation_time = 1 }]",
                                "five" => {
                                    "creep = [{ fraction = 0.2, retardation_time = 1 }, { fraction = 0.2, retardation_time = 0.1 }, { fraction = 0.2, retardation_time = 1e-3 }, { fraction = 0.2, retardation_time = 1e-4 }, { fraction = 0.2, retardation_time = 1e-6 }]"
                                }
                                _ => "",
                            };
                            let glassy = if material == "elastic" { "1e6" } else { "1e8" };
                            let zone_keys = if zone == "length" {
                                "length = 1e-6".to_owned()
                            } else {
                                format!("cohesive_stress = 1e6, law = \"{zone}\"")
                            };
                            let text = format!(
                                "accuracy = {accuracy}\n[material]\nrelaxed_modulus = 1e6\nglassy_modulus = {glassy}\n{terms}\n[adhesion]\nwork_of_adhesion = 1\n\
                                 process_zone = {{ {zone_keys} }}\n[crack]\nmotion = \"{motion}\"\nbody = \"two_halves\"\nplane = \"stress\"\n\
                                 theories = [\"{theory}\"]\n{key} = 1\n[sweep]\nkey = \"crack.{key}\"\nfrom = {from}\nto = {to}\npoints = 25\nspacing = \"{}\"\n",
                                if control == "rest" { "linear" } else { "logarithmic" },
                            );
                            let (predicted, outcome) = solved(parsed(&text), &[]);
                            cases += 1;
                            let name = format!("{motion} {theory} {zone} {control} {accuracy} {material}");
                            if std::env::var_os("SHOW_WORK").is_some() {
                                println!(
                                    "{name}: {} balances a state",
                                    outcome.work().closure_evaluations as f64 / outcome.rows.len() as f64
                                );
                            }
                            wrong.extend(misprediction(predicted, &outcome).map(|failure| format!("{name}: {failure}")));
                        }
                    }
                }
            }
        }
    }
    assert!(cases > 200, "{cases}");
    assert!(wrong.is_empty(), "{} of {cases}\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn every_kind_of_history_costs_what_is_predicted() {
    let mut wrong = Vec::new();
    let ways = [
        ("held", "stress_intensity = \"2.6 kPa √m\"", "hold = 12"),
        ("ramp", "stress_intensity = \"2 kPa √m\"", "stress_intensity = \"3 kPa √m\"\nduration = 9"),
        ("cycles", "stress_intensity = \"1 kPa √m\"", "cycles = 20\nperiod = 0.5\nlower = \"0.6 kPa √m\"\nupper = \"3.4 kPa √m\""),
        ("square", "stress_intensity = \"1 kPa √m\"", "cycles = 9\nperiod = 2\nlower = 0\nupper = \"2.8 kPa √m\"\nwave = \"square\""),
    ];
    for (name, first, second) in ways {
        for law in ["growing", "constant"] {
            for creep in [
                "[{ fraction = 1, retardation_time = 1 }]",
                "[{ fraction = 0.5, retardation_time = 1 }, { fraction = 0.5, retardation_time = 0.1 }]",
            ] {
                for accuracy in ["1e-2", "1e-4"] {
                    let text = DELAYED.replace("stress_intensity = \"3 kPa √m\"", first).replace("hold = \"2 s\"", second);
                    let sets =
                        [format!("adhesion.process_zone.law={law}"), format!("material.creep={creep}"), format!("accuracy={accuracy}")];
                    let sets: Vec<&str> = sets.iter().map(String::as_str).collect();
                    let (predicted, outcome) = solved(parsed(&text), &sets);
                    wrong.extend(misprediction(predicted, &outcome).map(|failure| format!("{name} {law} {creep} {accuracy}: {failure}")));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_kind_of_sliding_scene_costs_what_is_predicted() {
    let mut wrong = Vec::new();
    for contact in ["adhesive", "adhesiveless"] {
        for control in ["mean_pressure=6 kPa", "penetration=1 µm"] {
            for terms in [1, 3] {
                for speeds in ["[1e-6]", "[1e-4, 1e-2]", "[-1]"] {
                    let list: Vec<String> = (0..terms)
                        .map(|term| format!("{{ fraction = {}, retardation_time = {} }}", 1.0 / f64::from(terms), 10f64.powi(-2 - term)))
                        .collect();
                    let text = SLIDING.replace("mean_pressure = \"6 kPa\"\n", "");
                    let sets = [
                        format!("sliding.contacts=[\"{contact}\"]"),
                        format!("sliding.{control}"),
                        format!("material.creep=[{}]", list.join(", ")),
                        format!("sweep={{ key = \"sliding.speed\", values = {speeds} }}"),
                    ];
                    let sets: Vec<&str> = sets.iter().map(String::as_str).collect();
                    let (predicted, outcome) = solved(parsed(&text), &sets);
                    let name = format!("{contact} {control} {terms} terms {speeds}");
                    if std::env::var_os("SHOW_WORK").is_some() {
                        println!("{name}: predicted {predicted:?}, counted {:?}", outcome.work());
                    }
                    wrong.extend(misprediction(predicted, &outcome).map(|failure| format!("{name}: {failure}")));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn sliding_effects_left_out_cost_nothing() {
    let counted = work(SLIDING, &[]);
    assert_eq!((counted.kernel_evaluations, counted.field_evaluations), (0, 80));
    let without_fields = work(SLIDING.split("[fields]").next().unwrap(), &[]);
    assert_eq!((without_fields.field_evaluations, without_fields.linear_solves), (0, counted.linear_solves));
    let adhesiveless = work(SLIDING, &["sliding.contacts=[\"adhesiveless\"]"]);
    let adhesive = work(SLIDING, &["sliding.contacts=[\"adhesive\"]"]);
    let mut sum = adhesiveless;
    sum += adhesive;
    assert_eq!(sum, counted);
    // Each balance of an adhesive contact is as many linear systems; a crack has none.
    assert!(adhesive.linear_solves >= adhesive.closure_evaluations && work(SINGLE, &[]).linear_solves == 0);
}

#[test]
fn an_elastic_material_evaluates_no_kernel() {
    let elastic =
        SINGLE.replace("relaxed_modulus = \"1 MPa\"\n", "").replace("creep = [{ fraction = 1, retardation_time = \"1 s\" }]\n", "");
    let counted = work(&elastic, &["crack.theories=[\"virtual_work\", \"persson_brener\", \"cohesive_zone\"]"]);
    assert_eq!(counted.kernel_evaluations, 0);
    assert!(counted.closure_evaluations > 0);
    assert!(work(SINGLE, &[]).kernel_evaluations > 0);
}

#[test]
fn without_fields_no_field_is_evaluated() {
    let with = work(GOOD, &[]);
    let without = work(GOOD.split("[fields]").next().unwrap(), &[]);
    assert_eq!((with.field_evaluations, without.field_evaluations), (15, 0));
    assert_eq!((with.closure_evaluations, with.kernel_evaluations), (without.closure_evaluations, without.kernel_evaluations));
    assert_eq!(work(GOOD, &["crack.theories=[\"persson_brener\"]"]).field_evaluations, 0);
}

#[test]
fn a_theory_left_out_costs_nothing() {
    let of = |theories: &str| work(SINGLE, &[&format!("crack.theories=[{theories}]")]);
    let (one, two, three) = (of("\"virtual_work\""), of("\"persson_brener\""), of("\"cohesive_zone\""));
    let mut sum = one;
    sum += two;
    sum += three;
    assert_eq!(of("\"virtual_work\", \"persson_brener\", \"cohesive_zone\""), sum);
    assert_eq!(of("\"cohesive_zone\", \"virtual_work\""), {
        let mut pair = one;
        pair += three;
        pair
    });
    let predicted = |theories: &str| solved(parsed(SINGLE), &[&format!("crack.theories=[{theories}]")]).0.closure_evaluations;
    assert_eq!(predicted("\"virtual_work\", \"persson_brener\", \"cohesive_zone\""), 3 * predicted("\"virtual_work\""));
}

#[test]
fn kernels_count_the_terms() {
    let terms = |count: usize| {
        // Terms of one time are one term; of different times, as many as there are.
        let list: Vec<String> =
            (0..count).map(|term| format!("{{ compliance = 1e-8, retardation_time = {} }}", 10f64.powi(-(term as i32)))).collect();
        let text = SINGLE.replace("relaxed_modulus = \"1 MPa\"\n", "");
        let counted = work(&text, &[&format!("material.creep=[{}]", list.join(", "))]);
        assert_eq!(counted.kernel_evaluations % counted.closure_evaluations, 0);
        counted.kernel_evaluations / counted.closure_evaluations
    };
    assert_eq!([1, 2, 7, 20].map(terms), [1, 2, 7, 20]);
}

#[test]
fn a_sweep_costs_its_states_and_nothing_else() {
    let single: u64 = ["1e-6", "1e-3", "1"].iter().map(|speed| work(SINGLE, &[&format!("crack.speed={speed}")]).closure_evaluations).sum();
    let swept = work(SINGLE, &["sweep={ key = \"crack.speed\", values = [1e-6, 1e-3, 1] }"]).closure_evaluations;
    assert_eq!(single, swept);
}
